// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SYMMETRIC_EIGEN_H
#define CGAL_L0_RESAMPLING_INTERNAL_SYMMETRIC_EIGEN_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A symmetric 3 x 3 matrix.
struct Symmetric_matrix
{
  double xx, xy, xz, yy, yz, zz;
};

struct Triple
{
  double x, y, z;
};

/// The eigenvalues of a symmetric 3 x 3 matrix, and the eigenvector that a plane is fitted with.
struct Eigen_decomposition
{
  double values[3];       // ascending
  Triple smallest_vector; // of unit length, of any sign
};

CGAL_L0_HOST_DEVICE inline Triple operator+(const Triple& a, const Triple& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

CGAL_L0_HOST_DEVICE inline Triple operator*(double factor, const Triple& v)
{
  return {factor * v.x, factor * v.y, factor * v.z};
}

CGAL_L0_HOST_DEVICE inline double dot(const Triple& a, const Triple& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

CGAL_L0_HOST_DEVICE inline Triple cross(const Triple& a, const Triple& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

CGAL_L0_HOST_DEVICE inline Triple normalized(const Triple& v)
{
  return 1 / std::sqrt(dot(v, v)) * v;
}

CGAL_L0_HOST_DEVICE inline Triple multiply(const Symmetric_matrix& a, const Triple& v)
{
  return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.xy * v.x + a.yy * v.y + a.yz * v.z,
          a.xz * v.x + a.yz * v.y + a.zz * v.z};
}

/// The inverse times the determinant.
CGAL_L0_HOST_DEVICE inline Symmetric_matrix adjugate(const Symmetric_matrix& a)
{
  return {a.yy * a.zz - a.yz * a.yz, a.xz * a.yz - a.xy * a.zz, a.xy * a.yz - a.xz * a.yy,
          a.xx * a.zz - a.xz * a.xz, a.xy * a.xz - a.xx * a.yz, a.xx * a.yy - a.xy * a.xy};
}

/// The unit vector that a - value I takes to zero, where the value is no double one: the longest
/// cross product of two rows.
CGAL_L0_HOST_DEVICE inline Triple eigenvector_of_single_value(const Symmetric_matrix& a,
                                                              double value)
{
  const Triple rows[3] = {
    {a.xx - value, a.xy, a.xz}, {a.xy, a.yy - value, a.yz}, {a.xz, a.yz, a.zz - value}};
  Triple longest = cross(rows[0], rows[1]);
  const Triple second = cross(rows[1], rows[2]), third = cross(rows[2], rows[0]);
  if (dot(second, second) > dot(longest, longest))
    longest = second;
  if (dot(third, third) > dot(longest, longest))
    longest = third;
  return normalized(longest);
}

CGAL_L0_HOST_DEVICE inline Triple any_orthogonal(const Triple& v)
{
  return normalized(std::abs(v.x) > std::abs(v.y) ? Triple{-v.z, 0, v.x} : Triple{0, v.z, -v.y});
}

/// The roots of the characteristic polynomial by Cardano's formula, after shifting and scaling,
/// which loses no digits that matter here (Eberly, A robust eigensolver for 3 x 3 symmetric
/// matrices). The vector that belongs to the value furthest from the others comes first: it is well
/// determined; the smallest one is that, or is found in the plane across it, where any basis will
/// do if the other two values are equal.
CGAL_L0_HOST_DEVICE inline Eigen_decomposition decompose(const Symmetric_matrix& matrix)
{
  const auto larger = [](double a, double b) { return a < b ? b : a; };
  Eigen_decomposition result = {{0, 0, 0}, {0, 0, 1}};
  const double shift = (matrix.xx + matrix.yy + matrix.zz) / 3;
  Symmetric_matrix a = {matrix.xx - shift, matrix.xy, matrix.xz,
                        matrix.yy - shift, matrix.yz, matrix.zz - shift};
  const double scale = larger(larger(larger(std::abs(a.xx), std::abs(a.yy)), std::abs(a.zz)),
                              larger(larger(std::abs(a.xy), std::abs(a.xz)), std::abs(a.yz)));
  // What follows takes the trace for zero, which the rounding of the shift is not, beside nearly
  // equal values
  if (!(scale > 1e-14 * std::abs(shift)))
  {
    result.values[0] = result.values[1] = result.values[2] = shift;
    return result;
  }
  const double inverse = 1 / scale;
  a = {a.xx * inverse, a.xy * inverse, a.xz * inverse,
       a.yy * inverse, a.yz * inverse, a.zz * inverse};

  const double p = std::sqrt(
    (a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz)) / 6);
  const double determinant = a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.xz)
                             + a.xz * (a.xy * a.yz - a.yy * a.xz);
  const double ratio = determinant / (2 * p * p * p), half_determinant = ratio < -1  ? -1
                                                                         : ratio > 1 ? 1
                                                                                     : ratio;
  // cos(angle + 2/3 pi) by the sum of angles, as one cosine and a root cost less than two cosines
  const double cosine = std::cos(std::acos(half_determinant) / 3),
               sine = std::sqrt(larger(1 - cosine * cosine, 0.));
  const double half_root_of_three = 0.86602540378443865;
  const double largest = 2 * p * cosine,
               smallest = -2 * p * (cosine / 2 + half_root_of_three * sine),
               middle = -(largest + smallest);
  result.values[0] = smallest * scale + shift;
  result.values[1] = middle * scale + shift;
  result.values[2] = largest * scale + shift;

  if (half_determinant < 0) // the smallest value is the furthest from the middle one
  {
    result.smallest_vector = eigenvector_of_single_value(a, smallest);
    return result;
  }
  const Triple across = eigenvector_of_single_value(a, largest);
  const Triple u = any_orthogonal(across), v = cross(across, u);
  const Triple au = multiply(a, u), av = multiply(a, v);
  const double uu = dot(u, au) - smallest, uv = dot(u, av), vv = dot(v, av) - smallest;
  // the longer row of the 2 x 2 matrix, turned by a right angle
  const double x = std::abs(uu) > std::abs(vv) ? -uv : vv,
               y = std::abs(uu) > std::abs(vv) ? uu : -uv;
  result.smallest_vector = x * x + y * y > 0
                             ? normalized({x * u.x + y * v.x, x * u.y + y * v.y, x * u.z + y * v.z})
                             : u;
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SYMMETRIC_EIGEN_H
