// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_CONNECTED_PARTS_CUH
#define CGAL_L0_CUDA_CONNECTED_PARTS_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Says of each point whether it is kept: whether its part of the cloud, where cells that touch
/// hang together, has a share of as many points as the median ball. As `sizes_of_parts()` on the
/// CPU.
/// \param list which entries of `is_kept` are those of the points
/// \param frame of the cells
/// \param median of the numbers of points in balls, on the device
void keep_large_parts(const Execution_context& context, const Positions& points,
                      const unsigned* list, const Cell_frame& frame, const unsigned* median,
                      double share_of_part, unsigned char* is_kept);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_CONNECTED_PARTS_CUH
