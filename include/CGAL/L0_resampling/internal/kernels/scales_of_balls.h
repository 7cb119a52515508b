// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SCALES_OF_BALLS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SCALES_OF_BALLS_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/kernels/Height_moments.h>
#include <CGAL/L0_resampling/internal/kernels/deviation_in_ball.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// How far apart the points lie within the surface, and how far off it. Lengths.
struct Scales
{
  double spacing; ///< square root of the area a place
  double noise;   ///< standard deviation across the surface
};

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

/// \param value of a ball
template <typename Value>
double quantile(const std::vector<Ball_of_points>& balls, double share, const Value& value)
{
  std::vector<double> values;
  for (const Ball_of_points& ball : balls)
    values.push_back(value(ball));
  const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

inline double median_count(const std::vector<Ball_of_points>& balls)
{
  return quantile(balls, 0.5, [](const Ball_of_points& ball) { return ball.count; });
}

/// What few points have across their plane tells no noise.
inline void drop_sparse_balls(std::vector<Ball_of_points>& balls)
{
  const double least_count = share_of_sparse_points * median_count(balls);
  balls.erase(std::remove_if(balls.begin(), balls.end(),
                             [&](const Ball_of_points& ball) { return ball.count < least_count; }),
              balls.end());
}

/// Around half of the surface balls hold fewer points than this. Each ball stands for the area that
/// its points have in the mean: samples are spread by area, and a sparse part of it shall count for
/// as much as a dense one of its size, though it has fewer points.
inline double median_count_by_area(std::vector<Ball_of_points> balls)
{
  std::sort(balls.begin(), balls.end(),
            [](const Ball_of_points& a, const Ball_of_points& b) { return a.count < b.count; });
  const auto area = [](const Ball_of_points& ball) { return 1 / (std::max)(ball.count, 1.); };
  double whole = 0, part = 0;
  for (const Ball_of_points& ball : balls)
    whole += area(ball);
  for (const Ball_of_points& ball : balls)
  {
    part += area(ball);
    if (part >= whole / 2)
      return ball.count;
  }
  return balls.back().count;
}

/// \param radius of the balls
inline Scales scales_of_balls(const std::vector<Ball_of_points>& balls, double radius)
{
  const double pi = 3.141592653589793;
  return {radius * std::sqrt(pi / (std::max)(median_count_by_area(balls), 1.)),
          std::sqrt(
            quantile(balls, 0.3, [](const Ball_of_points& ball) { return ball.variance; }))};
}

constexpr std::size_t number_of_balls = 1000; // about
constexpr double cell_size_of_scales = 0.25;  // in the radius that is guessed first
/// Of the balls, in cells.
constexpr std::array<int, 10> reaches_of_balls = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
constexpr int largest_reach_of_balls = reaches_of_balls.back();

/*!
Estimates the scales from plane fits around a thousand points, in balls that grow until their points
lie in a plane rather than fill the ball: until the standard deviation across it is surely below
what it is in a filled ball. That deviation tells the noise, see `sheet_of_deviations()`, and the
number of points gives the spacing, which is that of the middle of the surface. Of the deviations
the third tenth counts: edges, curvature, thin parts and outliers only ever raise them, and the more
the larger the balls are; so the balls should not grow for longer than they have to.

Balls that hold two sheets, as those of a thin plate do, would grow for ever and find its thickness.
They are known by `single_sheet_index()`; then the noise and the number of points are those of one
sheet.

\param cell_size the largest balls are `largest_reach_of_balls` times as large
\param look_at_balls `look_at_balls(k, r)` returns the balls of radius r, which is k times the size
of a cell, as a `std::vector<Ball_of_points>`, which holds one at least
*/
template <typename LookAtBalls>
Scales scales_of_growing_balls(double cell_size, const LookAtBalls& look_at_balls)
{
  const double fewest_points = 30, surely_flat = 0.15;
  Scales scales{cell_size, 0};
  for (const int reach : reaches_of_balls)
  {
    const double radius = reach * cell_size;
    std::vector<Ball_of_points> balls = look_at_balls(reach, radius);
    if (median_count(balls) < fewest_points && reach < largest_reach_of_balls)
      continue;
    drop_sparse_balls(balls);
    scales = scales_of_balls(balls, radius);
    const double index = quantile(balls, 0.5, [](const Ball_of_points& ball) {
      return ball.shape.single_sheet_index();
    });
    if (scales.noise > surely_flat * radius && index < largest_index_of_two_sheets)
    {
      for (Ball_of_points& ball : balls)
      {
        const Two_sheets sheets = two_sheets_of(ball.shape);
        ball.variance *= sheets.noise;
        ball.count *= sheets.larger_sheet;
      }
      return scales_of_balls(balls, radius);
    }
    if (scales.noise < largest_deviation_of_sheet(median_count(balls)) * radius)
    {
      const Sheet_in_ball sheet = sheet_of_deviations(scales.noise / radius);
      return {scales.spacing * std::sqrt(sheet.share_of_points), sheet.noise * radius};
    }
  }
  return scales;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SCALES_OF_BALLS_H
