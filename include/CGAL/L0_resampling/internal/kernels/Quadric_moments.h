// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_QUADRIC_MOMENTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_QUADRIC_MOMENTS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Solves a symmetric system by \f$ L D L^T \f$.
/// \param matrix its lower triangle; used up
/// \param right_sides in: B, a column each; out: the solutions
/// \returns whether the matrix is positive definite; if not, `right_sides` mean nothing
template <int n, int columns>
CGAL_L0_HOST_DEVICE inline bool solve_positive_definite(double (&matrix)[n][n],
                                                        double (&right_sides)[columns][n])
{
  for (int j = 0; j < n; ++j)
  {
    for (int k = 0; k < j; ++k)
      matrix[j][j] -= matrix[j][k] * matrix[j][k] * matrix[k][k];
    if (!(matrix[j][j] > 0))
      return false;
    for (int i = j + 1; i < n; ++i)
    {
      for (int k = 0; k < j; ++k)
        matrix[i][j] -= matrix[i][k] * matrix[j][k] * matrix[k][k];
      matrix[i][j] /= matrix[j][j];
    }
  }
  for (double(&x)[n] : right_sides)
  {
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < i; ++k)
        x[i] -= matrix[i][k] * x[k];
    for (int i = n; i-- > 0;)
    {
      x[i] /= matrix[i][i];
      for (int k = i + 1; k < n; ++k)
        x[i] -= matrix[k][i] * x[k];
    }
  }
  return true;
}

/// A quadric \f$ h = a + b^T (u, v) + \frac12 (u, v) C (u, v)^T \f$ through points.
struct Fitted_quadric
{
  bool is_determined;
  double height, slope_u, slope_v; ///< at the origin
  double variance;                 ///< of the points about it
  double leverage; ///< that of the height at the origin, per `variance` over the number of points
};

/// The weighted moments that a quadric over a tangent plane takes from points (u, v, h), with h
/// along the normal, and u and v in the plane (Cazals and Pouget 2005).
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Quadric_moments
{
  static constexpr int number_of_unknowns = 6, number_of_products = 15;

  S products[number_of_products] =
    {}; ///< \f$ \sum w u^a v^b \f$ up to the fourth degree, degree by degree, each by falling a
  S heights[number_of_unknowns] = {}; ///< \f$ \sum w h u^a v^b \f$ up to the second
  S squared_heights = S();

  Quadric_moments() = default;

  /// \param convert from one sum to another
  template <typename Other, typename F>
  CGAL_L0_HOST_DEVICE Quadric_moments(const Quadric_moments<Other>& moments, const F& convert)
  {
    for (int k = 0; k < number_of_products; ++k)
      products[k] = convert(moments.products[k]);
    for (int k = 0; k < number_of_unknowns; ++k)
      heights[k] = convert(moments.heights[k]);
    squared_heights = convert(moments.squared_heights);
  }

  CGAL_L0_HOST_DEVICE void add(const S& u, const S& v, const S& h, const S& weight)
  {
    S terms[number_of_products];
    terms[0] = weight;
    for (int degree = 1; degree <= 4; ++degree)
    {
      const int first = degree * (degree + 1) / 2, first_below = first - degree;
      for (int k = 0; k < degree; ++k)
        terms[first + k] = terms[first_below + k] * u;
      terms[first + degree] = terms[first - 1] * v;
    }
    for (int k = 0; k < number_of_products; ++k)
      products[k] += terms[k];
    for (int k = 0; k < number_of_unknowns; ++k)
      heights[k] += terms[k] * h;
    squared_heights += terms[0] * h * h;
  }

  /// Those that a plane takes from the points.
  CGAL_L0_HOST_DEVICE Plane_moments<S> plane_moments() const
  {
    return {products[0], products[1], products[2], heights[0], products[3],
            products[4], heights[1],  products[5], heights[2], squared_heights};
  }

  /// The least squares fit.
  /// \pre `S` is a number, the sum of the weights is positive, and u and v are of the order of 1
  CGAL_L0_HOST_DEVICE Fitted_quadric quadric() const
  {
    const int powers_of_v[number_of_unknowns] = {0, 0, 1, 0, 1, 2},
              degrees[number_of_unknowns] = {0, 1, 1, 2, 2, 2};
    const double number = products[0];
    double matrix[number_of_unknowns][number_of_unknowns] = {};
    double solutions[2][number_of_unknowns] = {{}, {1}};
    for (int i = 0; i < number_of_unknowns; ++i)
    {
      solutions[0][i] = heights[i];
      for (int j = 0; j <= i; ++j)
      {
        const int degree = degrees[i] + degrees[j];
        matrix[i][j] = products[degree * (degree + 1) / 2 + powers_of_v[i] + powers_of_v[j]];
      }
    }
    // what points leave open that stand in one or two rows is as small as can be: slopes, and the
    // entries of the second derivatives, of which two are that of uv
    const double ridge = 1e-6 * number;
    for (int i = 1; i < number_of_unknowns; ++i)
      matrix[i][i] += i == 4 ? ridge / 2 : ridge;
    if (!solve_positive_definite(matrix, solutions))
      return {false, 0, 0, 0, 0, 0};
    double squares = squared_heights;
    for (int i = 0; i < number_of_unknowns; ++i)
      squares -= solutions[0][i] * heights[i];
    return {true,
            solutions[0][0],
            solutions[0][1],
            solutions[0][2],
            squares < 0 ? 0 : squares / number,
            solutions[1][0] * number};
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_QUADRIC_MOMENTS_H
