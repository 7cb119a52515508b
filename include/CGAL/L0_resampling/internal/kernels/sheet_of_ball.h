// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SHEET_OF_BALL_H
#define CGAL_L0_RESAMPLING_INTERNAL_SHEET_OF_BALL_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Height_moments.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the points in a ball around one of them tell of the scales.
struct Ball_of_points
{
  double count;
  double variance; ///< across the plane of least variance
  Shape_of_heights shape;
};

/// \param n number of points that were looked at
/// \param stride of so many points in the ball one was
/// \param variance of those n across their plane of least variance
/// \param heights of those n over it
CGAL_L0_HOST_DEVICE inline Ball_of_points ball_of_points(double n, double stride, double variance,
                                                         const Height_moments<double>& heights)
{
  return {n * stride,
          n > 3 ? variance * n / (n - 3) : variance, // the plane took three degrees of freedom
          heights.shape(n)};
}

/// The standard error of the kurtosis of a normal distribution in a sample of n.
CGAL_L0_HOST_DEVICE inline double error_of_kurtosis(double n)
{
  return std::sqrt(24 / at_least(n, 9.));
}

/// The kurtosis of the heights of a sheet in a ball: less than 3, as the ball cuts off the noisiest
/// points, down to that of a filled ball.
/// \param variance of these heights, per squared radius
CGAL_L0_HOST_DEVICE inline double kurtosis_in_ball(double variance)
{
  return 3 - 6. / 7 * as_share(5 * variance);
}

/*!
The variance of a sheet without points that fill its ball, such as outliers. These have the variance
\f$ r^2/5 \f$ and the fourth moment \f$ 3 r^4 / 35 \f$, so that the kurtosis of all tells their
share; it counts as far as chance does not explain it, and takes off three quarters at most from few
points, as one of them that lies far off is no share.
*/
CGAL_L0_HOST_DEVICE inline double variance_without_outliers(const Ball_of_points& ball,
                                                            double radius)
{
  const double index = ball.shape.single_sheet_index(), all = ball.variance / square(radius),
               filled = 1. / 5, fourth = index * square(all),
               certainty = as_share((index - kurtosis_in_ball(all))
                                    / (1.5 * error_of_kurtosis(ball.count)));
  if (!(certainty > 0))
    return ball.variance;
  double low = all * at_most(6 / ball.count, 0.25), high = all;
  for (int step = 0; step < 40; ++step)
  {
    const double sheet = (low + high) / 2, share = as_share((all - sheet) / (filled - sheet));
    const bool has_tails = (1 - share) * kurtosis_in_ball(sheet) * square(sheet) + share * (3. / 35)
                           > fourth;
    (has_tails ? low : high) = sheet;
  }
  return ball.variance + certainty * (high * square(radius) - ball.variance);
}

/*!
How far the heights of a ball are those of two sheets, in [0, 1]: their kurtosis is less than that
of one sheet by more than chance explains, and either sheet ends inside the ball. If not, it is the
kurtosis of a ball that noise fills.

\param minimum_errors by how many standard errors the kurtosis has to be less
*/
CGAL_L0_HOST_DEVICE inline double certainty_of_two_sheets(const Ball_of_points& ball,
                                                          const Two_sheets& sheets, double radius,
                                                          double minimum_errors)
{
  const double minimum_number_of_points = 20,
               maximum_number_of_points = 350; // more differ by more than chance
  if (ball.count < minimum_number_of_points)
    return 0;
  const double n = ball.count < maximum_number_of_points ? ball.count : maximum_number_of_points,
               errors = (3 - ball.shape.single_sheet_index()) / error_of_kurtosis(n),
               noise = std::sqrt(sheets.noise * ball.variance), p = sheets.larger_sheet,
               way_to_smaller = std::sqrt((1 - sheets.noise) * ball.variance * p
                                          / at_least(1 - p, 1e-6)),
               room = noise > 0 ? (radius - way_to_smaller) / noise : radius;
  const double inside = as_share((room - 1.9) / 0.6);
  return square(inside) * (3 - 2 * inside) / (1 + std::exp(-4 * (errors - minimum_errors)));
}

/// Where nothing is known of other balls.
constexpr double minimum_errors_of_two_sheets = 1.8;

/// The ball with the points of one sheet of the surface only, as far as its heights tell.
/// \param minimum_errors see `certainty_of_two_sheets()`; for the number of points it is that of a
/// ball alone, as what bends has such a kurtosis too
CGAL_L0_HOST_DEVICE inline Ball_of_points with_one_sheet(
  const Ball_of_points& ball, double radius, double minimum_errors = minimum_errors_of_two_sheets)
{
  const Two_sheets sheets = two_sheets_of(ball.shape);
  const double of_ball = certainty_of_two_sheets(ball, sheets, radius,
                                                 minimum_errors_of_two_sheets),
               of_noise = certainty_of_two_sheets(ball, sheets, radius, minimum_errors);
  return {ball.count * (1 - of_ball * (1 - sheets.larger_sheet)),
          variance_without_outliers(ball, radius) * (1 - of_noise * (1 - sheets.noise)),
          ball.shape};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SHEET_OF_BALL_H
