// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_PLANE_FIT_CUH
#define CGAL_L0_CUDA_PLANE_FIT_CUH

#include "core/vectors.cuh"

#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>

#include <cfloat>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

struct Plane_fit
{
  float3 normal;
  unsigned number_of_points;
  double variance;  // of the points across it
  bool spans_plane; // whether the points determine it
};

__device__ inline float3 to_float(const Triple& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// Moments of points, relative to the center of their ball.
struct Moments
{
  static constexpr int size = 10;
  float values[size] = {}; // sum of the weights, x, y, z, xx, xy, xz, yy, yz, zz

  __device__ void add(float3 d, float weight = 1)
  {
    const float3 w = weight * d;
    const float products[size] = {weight,    w.x,       w.y,       w.z,       w.x * d.x,
                                  w.x * d.y, w.x * d.z, w.y * d.y, w.y * d.z, w.z * d.z};
    for (int i = 0; i < size; ++i)
      values[i] += products[i];
  }

  template <int lanes>
  __device__ void sum_over_group()
  {
    for (int i = 0; i < size; ++i)
      values[i] = group_sum<lanes>(values[i]);
  }

  __device__ Plane_moments<double> all() const
  {
    return {values[0], values[1], values[2], values[3], values[4],
            values[5], values[6], values[7], values[8], values[9]};
  }

  /// The plane of `fit_plane()` on the CPU, of points of equal weight.
  __device__ Plane_fit plane(float squared_radius) const
  {
    const Fitted_plane plane = all().plane(squared_radius, FLT_EPSILON);
    return {to_float(plane.normal), unsigned(values[0]), plane.variance, plane.spans_plane};
  }
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_PLANE_FIT_CUH
