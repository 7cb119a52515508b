// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_PLANE_FITS_CUH
#define CGAL_L0_CUDA_PLANE_FITS_CUH

#include "driver/stages.cuh"

#include <CGAL/L0_resampling/internal/kernels/scales_of_balls.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Fits planes anew to a few points, in balls of any size.
/// \param open the points, by their place in the grid
void refit_planes_of(const Execution_context& context, const Cell_grid& grid, const unsigned* open,
                     unsigned number_of_open, double radius, float4* normals,
                     unsigned char* is_degenerate);

/// As `estimate_scales()` on the CPU. Lengths in the frame. Waits for the device.
Scales estimate_scales(const Execution_context& context, const Positions& positions,
                       const double (&low)[3], const double (&high)[3], double initial_radius);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_PLANE_FITS_CUH
