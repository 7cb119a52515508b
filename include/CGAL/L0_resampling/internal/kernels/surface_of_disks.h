// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SURFACE_OF_DISKS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SURFACE_OF_DISKS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Quadric_moments.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The radii of the balls that surfaces are fitted in, in units of the refinement, each
/// 1.8 times the one before, so that one is at most a third off the best.
constexpr int number_of_fit_scales = 5;
CGAL_L0_HOST_DEVICE inline double radius_of_fit(int scale)
{
  const double radii[number_of_fit_scales] = {3, 5.5, 10, 18, 32};
  return radii[scale];
}

/// From this scale on disks are merged.
constexpr int first_scale_of_merged_disks = 2;

/// 1 - cosine of 35 degrees: disks whose normals differ by more are of another face.
constexpr float opening_of_face = 0.18084796f;

/// How far off the surface of the next smaller ball disks may be, in standard deviations of the
/// heights of disks, and in radii of the ball. At 0.54 of it their weights are a half.
constexpr double residual_per_deviation = 6, residual_per_radius = 0.02;

/// The heights of disks are not taken to be more exact than this, per unit of the refinement.
constexpr double minimum_deviation_of_disk = 0.03;

/// A surface \f$ h = c + s_u u + s_v v + c_{uu} u^2 + c_{uv} uv + c_{vv} v^2 \f$ over the tangent
/// plane of a sample, and the variances of c and of the mean of the slopes.
struct Surface_of_disks
{
  float height = 0, slope_u = 0, slope_v = 0, uu = 0, uv = 0, vv = 0;
  float height_variance = 0, slope_variance = 0; ///< both positive, or both 0

  CGAL_L0_HOST_DEVICE bool is_determined() const { return slope_variance > 0; }
};

/// The surfaces of one scale at a sample.
struct Surfaces_of_scale
{
  Surface_of_disks plane, quadric;

  /// What the fit in the next larger ball starts from.
  /// \param scale of these surfaces
  /// \param before what their own fit started from
  CGAL_L0_HOST_DEVICE Surface_of_disks prediction(int scale, const Surface_of_disks& before) const
  {
    return scale > 0 && quadric.is_determined() ? quadric : plane.is_determined() ? plane : before;
  }
};

/// A disk of a ball, as the sample in the middle sees it.
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Seen_disk
{
  S u, v, h; ///< where its points are, in the frame of the sample
  S cosine_with_u, cosine_with_v, cosine_with_normal; ///< of its normal with the axes of the frame
  S squared_distance;                                 ///< of the disk itself
};

/*!
How much a disk counts in a fit,
\f$ w = (1 - l^2/R^2)_+^2 (1 - (1 - c)/(1 - \cos 35^\circ))_+^2 (1 - \rho^2/H^2)_+^2 \f$: c is the
cosine of the angle between its normal and that of the surface of the next smaller ball at its
place, whichever side they point to, \f$ \rho \f$ its distance from that surface.
*/
template <typename T>
struct Weight_in_fit
{
  T per_squared_radius, per_squared_residual;

  CGAL_L0_HOST_DEVICE Weight_in_fit(double radius, double deviation)
    : per_squared_radius(T(1 / square(radius))),
      per_squared_residual(
        T(1 / square(residual_per_deviation * deviation + residual_per_radius * radius)))
  {}

  template <typename S>
  CGAL_L0_HOST_DEVICE S operator()(const S& squared_distance, const S& cosine,
                                   const S& squared_residual) const
  {
    using std::abs;
    const T per_opening = T(1) / T(opening_of_face);
    const S near = at_least(S(T(1) - squared_distance * per_squared_radius), T(0)),
            along = at_least(S(T(1) - (T(1) - abs(cosine)) * per_opening), T(0)),
            on_surface = at_least(S(T(1) - squared_residual * per_squared_residual), T(0)),
            product = S(near * along) * on_surface;
    return product * product;
  }

  /// \param s the surface of the next smaller ball
  template <typename S>
  CGAL_L0_HOST_DEVICE S operator()(const Seen_disk<S>& disk, const Surface_of_disks& s) const
  {
    using std::sqrt;
    const S slope_u = S(s.slope_u) + disk.u * (2 * s.uu) + disk.v * s.uv,
            slope_v = S(s.slope_v) + disk.u * s.uv + disk.v * (2 * s.vv),
            residual = disk.h - s.height - disk.u * (S(s.slope_u) + disk.u * s.uu + disk.v * s.uv)
                       - disk.v * (S(s.slope_v) + disk.v * s.vv),
            inverse = S(T(1)) / (S(T(1)) + slope_u * slope_u + slope_v * slope_v),
            cosine = (disk.cosine_with_normal - slope_u * disk.cosine_with_u
                      - slope_v * disk.cosine_with_v)
                     * sqrt(inverse);
    return (*this)(disk.squared_distance, cosine, S(residual * residual * inverse));
  }
};

/// Sums over the disks of a ball, lengths in units of its radius.
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Moments_of_disks
{
  static constexpr int number_of_unknowns = 6, number_of_products = 15;

  S products[number_of_products] =
    {}; ///< \f$ \sum w W u^a v^b \f$ up to the fourth degree, degree by degree, each by falling a
  S squared_products[number_of_products] = {}; ///< the same of \f$ w^2 W \f$
  S heights[number_of_unknowns] = {};          ///< \f$ \sum w W h u^a v^b \f$ up to the second
  S number = S();                              ///< of disks

  Moments_of_disks() = default;

  /// \param convert from one sum to another
  template <typename Other, typename F>
  CGAL_L0_HOST_DEVICE Moments_of_disks(const Moments_of_disks<Other>& moments, const F& convert)
  {
    for (int k = 0; k < number_of_products; ++k)
      products[k] = convert(moments.products[k]);
    for (int k = 0; k < number_of_products; ++k)
      squared_products[k] = convert(moments.squared_products[k]);
    for (int k = 0; k < number_of_unknowns; ++k)
      heights[k] = convert(moments.heights[k]);
    number = convert(moments.number);
  }

  /// \param weight w
  /// \param information W
  CGAL_L0_HOST_DEVICE void add(const S& u, const S& v, const S& h, const S& weight,
                               const S& information)
  {
    S terms[number_of_products];
    terms[0] = weight * information;
    for (int degree = 1; degree <= 4; ++degree)
    {
      const int first = degree * (degree + 1) / 2, first_below = first - degree;
      for (int k = 0; k < degree; ++k)
        terms[first + k] = terms[first_below + k] * u;
      terms[first + degree] = terms[first - 1] * v;
    }
    for (int k = 0; k < number_of_products; ++k)
      products[k] += terms[k];
    for (int k = 0; k < number_of_products; ++k)
      squared_products[k] += terms[k] * weight;
    for (int k = 0; k < number_of_unknowns; ++k)
      heights[k] += terms[k] * h;
    number += where_less(S(-weight), 0.f, S(1.f));
  }

  /// The weighted least squares fit of the first `n` unknowns: 3 for a plane, 6 for a quadric.
  /// \param radius R
  /// \param squared_noise of a point
  /// \pre `S` is a number
  template <int n>
  CGAL_L0_HOST_DEVICE Surface_of_disks surface(double radius, double squared_noise) const
  {
    const int powers_of_v[number_of_unknowns] = {0, 0, 1, 0, 1, 2},
              degrees[number_of_unknowns] = {0, 1, 1, 2, 2, 2};
    const double minimum_number_of_disks = n == 3 ? 5 : 10, minimum_number_of_points = 3;
    Surface_of_disks surface;
    if (number < minimum_number_of_disks || products[0] < minimum_number_of_points)
      return surface;
    const auto index = [&](int i, int j) {
      const int degree = degrees[i] + degrees[j];
      return degree * (degree + 1) / 2 + powers_of_v[i] + powers_of_v[j];
    };
    double matrix[n][n] = {}, solutions[4][n] = {{}, {1}, {0, 1}, {0, 0, 1}};
    for (int i = 0; i < n; ++i)
    {
      solutions[0][i] = heights[i];
      for (int j = 0; j <= i; ++j)
        matrix[i][j] = products[index(i, j)] * (i == j ? 1 + 1e-6 : 1);
    }
    if (!solve_positive_definite(matrix, solutions))
      return surface;
    double variances[3];
    for (int m = 0; m < 3; ++m)
    {
      const double(&x)[n] = solutions[m + 1];
      variances[m] = 0;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          variances[m] += x[i] * x[j] * squared_products[index(i, j)];
    }
    // the disks of a ball that is hardly larger than they are tell much the same
    const double of_ball = square(radius) / 8,
                 of_point = squared_noise * of_ball / (of_ball + squared_noise),
                 height_variance = variances[0] * of_point;
    if (!(height_variance > 0 && height_variance <= squared_noise))
      return surface;
    const double(&c)[n] = solutions[0];
    surface.height = float(c[0] * radius);
    surface.slope_u = float(c[1]);
    surface.slope_v = float(c[2]);
    if constexpr (n == 6)
    {
      surface.uu = float(c[3] / radius);
      surface.uv = float(c[4] / radius);
      surface.vv = float(c[5] / radius);
    }
    const double slope_variance = (variances[1] + variances[2]) / 2 * of_point / square(radius);
    const auto is_number = [](double variance) {
      return variance > (std::numeric_limits<float>::min)()
             && variance < (std::numeric_limits<float>::max)();
    };
    if (is_number(height_variance) && is_number(slope_variance))
    {
      surface.height_variance = float(height_variance);
      surface.slope_variance = float(slope_variance);
    }
    return surface;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SURFACE_OF_DISKS_H
