// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_MORTON_PLACES_CUH
#define CGAL_L0_CUDA_MORTON_PLACES_CUH

#include "driver/stages.cuh"

#include <CGAL/L0_resampling/internal/kernels/Morton_points.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// The places of points. The arrays are taken from the scratch arena. Waits for the device.
Morton_points places_of(const Execution_context& context, const Positions& positions,
                        const Morton_cells& cells);

/// Every `stride`-th place, in arrays from the scratch arena.
Morton_points one_of_places(const Execution_context& context, const Morton_points& places,
                            unsigned stride);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_MORTON_PLACES_CUH
