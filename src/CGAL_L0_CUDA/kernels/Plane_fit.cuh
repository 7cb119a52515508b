// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_PLANE_FIT_CUH
#define CGAL_L0_CUDA_PLANE_FIT_CUH

#include "core/vectors.cuh"

#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>

#include <cfloat>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

__device__ inline float3 to_float(const Triple& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// The moments of all threads of a group.
template <int lanes>
__device__ Plane_moments<double> sum_of_group(const Plane_moments<float>& moments)
{
  return moments.transformed<double>([](float sum) { return group_sum<lanes>(sum); });
}

/// A point of a ball, as the one at the center sees it.
/// \param d relative to the center
__device__ inline Seen_point<float> seen_point(const float3& d, const float3& normal,
                                               const float3& own_normal)
{
  return {d.x, d.y, d.z, normal.x, normal.y, normal.z, own_normal.x, own_normal.y, own_normal.z};
}

/// The plane of `fit_plane()` on the CPU, of points of equal weight.
__device__ inline Fitted_plane plane_through(const Plane_moments<double>& moments,
                                             float squared_radius)
{
  return moments.plane(squared_radius, FLT_EPSILON);
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_PLANE_FIT_CUH
