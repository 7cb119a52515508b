// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_HEIGHT_MOMENTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_HEIGHT_MOMENTS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the distribution of heights looks like, whatever their mean and variance: Pearson's
/// \f$ \beta_1 \f$ and \f$ \beta_2 \f$.
struct Shape_of_heights
{
  double squared_skewness, kurtosis;

  /// \f$ \beta_2 - \beta_1 \f$: 3 for one sheet with Gaussian noise, 15/7 for points that fill a
  /// ball, more for a sheet among these, and 1, the least there is, for two sheets without noise,
  /// whatever their shares.
  CGAL_L0_HOST_DEVICE double single_sheet_index() const { return kurtosis - squared_skewness; }
};

/// The moments of the heights of points over a plane, up to the fourth.
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Height_moments
{
  S first = S(), second = S(), third = S(), fourth = S();

  /// \param inside 1 for a point that counts, 0 for another
  CGAL_L0_HOST_DEVICE void add(const S& height, const S& inside)
  {
    const S h = inside * height, square = h * height;
    first += h;
    second += square;
    third += square * height;
    fourth += square * square;
  }

  /// That of Gaussian noise where all heights are equal.
  /// \param n number of points
  /// \pre `S` is a number
  CGAL_L0_HOST_DEVICE Shape_of_heights shape(double n) const
  {
    const double a = first / n, b = second / n, c = third / n, d = fourth / n, variance = b - a * a;
    if (!(variance > 1e-12 * b))
      return {0, 3};
    const double skewness = c - 3 * a * b + 2 * a * a * a,
                 tails = d - 4 * a * c + 6 * a * a * b - 3 * a * a * a * a;
    return {skewness * skewness / (variance * variance * variance), tails / (variance * variance)};
  }
};

/// What two sheets with the same Gaussian noise are made of.
struct Two_sheets
{
  double noise;        ///< share in the variance of all
  double larger_sheet; ///< share of the points
};

/*!
The two sheets that heights of such a shape are of. If they hold the shares p and q of the points,
and the share x of the variance is that of the distance of the sheets, then
\f$ \beta_1 = x^3 (1/pq - 4) \f$ and \f$ \beta_2 - 3 = x^2 (1/pq - 6) \f$, so that
\f$ 2 x^3 + (\beta_2 - 3) x = \beta_1 \f$. That has one root above 0, which is at most 1 since
\f$ \beta_2 \ge \beta_1 + 1 \f$.
*/
CGAL_L0_HOST_DEVICE inline Two_sheets two_sheets_of(const Shape_of_heights& shape)
{
  double low = 0, high = 1;
  for (int step = 0; step < 40; ++step)
  {
    const double x = (low + high) / 2;
    (2 * x * x * x + (shape.kurtosis - 3) * x < shape.squared_skewness ? low : high) = x;
  }
  const double inverse_product = 4 + shape.squared_skewness / (high * high * high);
  return {1 - high, (1 + std::sqrt(1 - 4 / inverse_product)) / 2};
}

/// The moments of all lanes.
template <typename L>
Height_moments<double> sum_of_lanes(const Height_moments<L>& m)
{
  return {m.first.sum(), m.second.sum(), m.third.sum(), m.fourth.sum()};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_HEIGHT_MOMENTS_H
