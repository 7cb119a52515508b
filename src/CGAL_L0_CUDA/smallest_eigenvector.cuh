// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_SMALLEST_EIGENVECTOR_CUH
#define CGAL_L0_CUDA_SMALLEST_EIGENVECTOR_CUH

#include "vectors.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

struct Symmetric_matrix
{
  double xx, xy, xz, yy, yz, zz;
};

struct Eigen_decomposition
{
  double values[3];          // ascending
  double3 smallest_vector;   // of unit length, of any sign
};

__device__ inline double3 multiply(const Symmetric_matrix& a, double3 v)
{
  return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z, a.xz * v.x + a.yz * v.y + a.zz * v.z};
}

__device__ inline double3 normalized(double3 v) { return rsqrt(dot(v, v)) * v; }

/// The unit vector that a - value I takes to zero, where the value is no double one: the longest cross product of two rows.
__device__ inline double3 eigenvector_of_single_value(const Symmetric_matrix& a, double value)
{
  const double3 rows[3] = {{a.xx - value, a.xy, a.xz}, {a.xy, a.yy - value, a.yz}, {a.xz, a.yz, a.zz - value}};
  double3 longest = cross(rows[0], rows[1]);
  const double3 second = cross(rows[1], rows[2]), third = cross(rows[2], rows[0]);
  if (dot(second, second) > dot(longest, longest))
    longest = second;
  if (dot(third, third) > dot(longest, longest))
    longest = third;
  return normalized(longest);
}

__device__ inline double3 any_orthogonal(double3 v)
{
  return normalized(fabs(v.x) > fabs(v.y) ? double3{-v.z, 0, v.x} : double3{0, v.z, -v.y});
}

/// The roots of the characteristic polynomial by Cardano's formula, after shifting and scaling, which loses no digits that matter here
/// (Eberly, A robust eigensolver for 3 x 3 symmetric matrices). The vector that belongs to the value furthest from the others comes first: it is well
/// determined; the smallest one is that, or is found in the plane across it, where any basis will do if the other two values are equal.
__device__ inline Eigen_decomposition decompose(const Symmetric_matrix& matrix)
{
  Eigen_decomposition result = {{0, 0, 0}, {0, 0, 1}};
  const double shift = (matrix.xx + matrix.yy + matrix.zz) / 3;
  Symmetric_matrix a = {matrix.xx - shift, matrix.xy, matrix.xz, matrix.yy - shift, matrix.yz, matrix.zz - shift};
  const double scale = fmax(fmax(fmax(fabs(a.xx), fabs(a.yy)), fabs(a.zz)), fmax(fmax(fabs(a.xy), fabs(a.xz)), fabs(a.yz)));
  if (!(scale > 0))
  {
    result.values[0] = result.values[1] = result.values[2] = shift;
    return result;
  }
  const double inverse = 1 / scale;
  a = {a.xx * inverse, a.xy * inverse, a.xz * inverse, a.yy * inverse, a.yz * inverse, a.zz * inverse};

  const double p = sqrt((a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz)) / 6);
  const double determinant = a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.xz) + a.xz * (a.xy * a.yz - a.yy * a.xz);
  const double half_determinant = fmin(fmax(determinant / (2 * p * p * p), -1.), 1.);
  const double angle = acos(half_determinant) / 3;
  const double two_thirds_pi = 2.0943951023931953;
  const double largest = 2 * p * cos(angle), smallest = 2 * p * cos(angle + two_thirds_pi), middle = -(largest + smallest);
  result.values[0] = smallest * scale + shift;
  result.values[1] = middle * scale + shift;
  result.values[2] = largest * scale + shift;

  if (half_determinant < 0)   // the smallest value is the furthest from the middle one
  {
    result.smallest_vector = eigenvector_of_single_value(a, smallest);
    return result;
  }
  const double3 across = eigenvector_of_single_value(a, largest);
  const double3 u = any_orthogonal(across), v = cross(across, u);
  const double3 au = multiply(a, u), av = multiply(a, v);
  const double uu = dot(u, au) - smallest, uv = dot(u, av), vv = dot(v, av) - smallest;
  // the longer row of the 2 x 2 matrix, turned by a right angle
  const double x = fabs(uu) > fabs(vv) ? -uv : vv, y = fabs(uu) > fabs(vv) ? uu : -uv;
  result.smallest_vector = x * x + y * y > 0 ? normalized(x * u + y * v) : u;
  return result;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_SMALLEST_EIGENVECTOR_CUH
