// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_ORIENT_MEASURED_NORMALS_CUH
#define CGAL_L0_CUDA_ORIENT_MEASURED_NORMALS_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// `orient_normals()` of points as they were measured, as on the CPU.
/// \param noise_of_heights as on the CPU
/// \param samples whose normals' fourth numbers are free
/// \param mean_normals out: as on the CPU, but on the sides of the normals or opposite
void orient_measured_normals(const Execution_context& context, const double (&low)[3],
                             const double (&high)[3], unsigned number_of_neighbors, double spacing,
                             double noise_of_heights, const Side_hints& hints,
                             const Samples& samples, Sample_counts* counts, float3* mean_normals);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_ORIENT_MEASURED_NORMALS_CUH
