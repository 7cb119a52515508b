// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_PLANE_FIT_CUH
#define CGAL_L0_CUDA_PLANE_FIT_CUH

#include "smallest_eigenvector.cuh"

#include <CGAL/L0_resampling/internal/Parameters.h>

#include <cfloat>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

struct Plane_fit
{
  float3 normal;
  unsigned number_of_points;
  double variance;             // of the points across it
  long long spans_plane;       // whether the points determine it; as long, so that there is no gap in what is copied
};

/// Moments of points, relative to the center of their ball.
struct Moments
{
  static constexpr int size = 10;
  float values[size] = {};   // sum of the weights, x, y, z, xx, xy, xz, yy, yz, zz

  __device__ void add(float3 d, float weight = 1)
  {
    const float3 w = weight * d;
    const float products[size] = {weight, w.x, w.y, w.z, w.x * d.x, w.x * d.y, w.x * d.z, w.y * d.y, w.y * d.z, w.z * d.z};
    for (int i = 0; i < size; ++i)
      values[i] += products[i];
  }

  template <int lanes>
  __device__ void sum_over_group()
  {
    for (int i = 0; i < size; ++i)
      values[i] = group_sum<lanes>(values[i]);
  }

  /// Of the covariance matrix.
  __device__ Eigen_decomposition eigen_decomposition() const
  {
    const double n = values[0], x = values[1] / n, y = values[2] / n, z = values[3] / n;
    return decompose({values[4] / n - x * x, values[5] / n - x * y, values[6] / n - x * z, values[7] / n - y * y, values[8] / n - y * z,
                      values[9] / n - z * z});
  }

  /// The plane of `fit_plane()` on the CPU, of points of equal weight.
  __device__ Plane_fit plane(float squared_radius) const
  {
    Plane_fit fit = {{0, 0, 1}, unsigned(values[0]), 0, false};
    if (values[0] < 2)
      return fit;
    const Eigen_decomposition eigen = eigen_decomposition();
    // what rounding leaves of a variance across a line
    const double rounding = 16 * double(FLT_EPSILON) * fmax(eigen.values[2], double(squared_radius) * 1e-6);
    if (!(eigen.values[2] > rounding))
      return fit;
    fit.normal = to_float(eigen.smallest_vector);
    fit.spans_plane = eigen.values[1] > rounding && fit.number_of_points >= fewest_points_of_plane;
    fit.variance = fmax(eigen.values[0], 0.);
    return fit;
  }
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_PLANE_FIT_CUH
