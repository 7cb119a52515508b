// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_EXTENT_CUH
#define CGAL_L0_CUDA_EXTENT_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// The frame that a cloud enters, before a radius is its unit, and the extent of the cloud there.
/// On the host.
struct Extent
{
  Frame frame;
  double low[3], high[3];                   // corners of the bounding box
  double low_of_input[3], high_of_input[3]; // the same, not in the frame
  double robust_diagonal;                   // as `robust_diagonal()` on the CPU
  double trimmed[3];                        // as `trimmed_extent()` on the CPU
};

/// The bounding box of points. Waits for the device.
/// \param points xyz interleaved
void find_box(const Execution_context& context, const double* points, unsigned size,
              double (&low)[3], double (&high)[3]);

/// How far points reach on each axis, as `plain_extent()` on the CPU. Waits for the device.
/// \param points xyz interleaved
void find_plain_extent(const Execution_context& context, const double* points, unsigned size,
                       double (&extent)[3]);

/// What `Working_frame::enter()`, `robust_diagonal()` and `trimmed_extent()` find on the CPU, to
/// the bit. Waits for the device.
Extent find_extent(const Execution_context& context, const double* points, unsigned size);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_EXTENT_CUH
