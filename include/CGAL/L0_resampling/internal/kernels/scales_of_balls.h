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
#include <CGAL/L0_resampling/internal/kernels/deviation_in_ball.h>
#include <CGAL/L0_resampling/internal/kernels/sheet_of_ball.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
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
  const double minimum_count = share_of_sparse_points * median_count(balls);
  balls.erase(
    std::remove_if(balls.begin(), balls.end(),
                   [&](const Ball_of_points& ball) { return ball.count < minimum_count; }),
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

/// By how many standard errors the kurtosis of a ball has to be less than that of one sheet: fewer
/// where that of many others is less. A thousand balls tell of two sheets together what none of few
/// points tells alone. Those of the less variance are asked, as noise is read from these: what
/// bends and edges have raised the others.
inline double minimum_errors_among(const std::vector<Ball_of_points>& balls, double radius)
{
  const double middle = quantile(balls, 0.5,
                                 [](const Ball_of_points& ball) { return ball.variance; });
  std::vector<Ball_of_points> lower;
  std::copy_if(balls.begin(), balls.end(), std::back_inserter(lower),
               [&](const Ball_of_points& ball) { return ball.variance <= middle; });
  const double errors = quantile(lower, 0.5,
                                 [&](const Ball_of_points&ball) {
                                   const double by_small_number = 12 / (ball.count + 3);
                                   return (kurtosis_in_ball(ball.variance / square(radius))
                                           - by_small_number - ball.shape.single_sheet_index())
                                          / error_of_kurtosis(ball.count);
                                 }),
               by_chance = 0.15, certain = 0.7, least = 0.4;
  return minimum_errors_of_two_sheets
         - (minimum_errors_of_two_sheets - least)
             * as_share((errors - by_chance) / (certain - by_chance));
}

constexpr std::size_t number_of_balls = 1000; // about, of the smallest
constexpr double cell_size_of_scales = 0.25;  // in the radius that is guessed first
/// Of the balls, in cells.
constexpr std::array<int, 10> reaches_of_balls = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
constexpr int maximum_reach_of_balls = reaches_of_balls.back();

/// One of so many of the balls is looked at when they reach so far: larger ones overlap more, and
/// take longer.
constexpr std::size_t stride_at_reach(int reach)
{
  std::size_t stride = 1;
  for (int covered = 8; covered <= reach; covered *= 2)
    stride *= 2;
  return stride;
}

/// Balls of at least so many points, in the median, tell of noise.
constexpr double minimum_count_of_balls = 24;

/// Balls are large enough for noise once their radius is so many standard deviations of it.
constexpr double radius_of_balls_per_noise = 3.5;

/// Balls so many times as large tell what of the deviation grows with them.
constexpr double ratio_of_larger_balls = 2;

/// No more of the variance of balls is taken for what grows with them.
constexpr double maximum_share_of_growth = 0.3;

/// What the balls of one radius tell. Logarithms, as all is interpolated between radii.
struct Look_at_balls
{
  double radius, noise, spacing;
  double want_of_points; ///< of `minimum_count_of_balls` over the median count
  double excess;         ///< of `radius_of_balls_per_noise` times the noise over the radius
};

/// \param balls of one radius
/// \param median_count of these
inline Look_at_balls look_at(std::vector<Ball_of_points> balls, double radius, double median_count)
{
  const double pi = 3.141592653589793;
  drop_sparse_balls(balls);
  const double minimum_errors = minimum_errors_among(balls, radius);
  for (Ball_of_points& ball : balls)
    ball = with_one_sheet(ball, radius, minimum_errors);
  const double count = internal::median_count(balls),
               third_tenth = std::sqrt(
                 quantile(balls, 0.3, [](const Ball_of_points&ball) { return ball.variance; })),
               noise = noise_of_sheet(third_tenth / third_tenth_of_deviations(count), radius,
                                      count),
               spacing = radius * std::sqrt(pi / (std::max)(median_count_by_area(balls), 1.));
  const auto log_of = [](double x) {
    return std::log((std::max)(x, (std::numeric_limits<double>::min)()));
  };
  return {log_of(radius), log_of(noise), log_of(spacing),
          log_of(minimum_count_of_balls / (std::max)(median_count, 1.)),
          log_of(radius_of_balls_per_noise * noise / radius)};
}

/// Looks at balls of several radii, read at any place between the first and the last.
class Looks_at_balls
{
  std::vector<Look_at_balls> m_looks;

public:
  void add(const Look_at_balls& look) { m_looks.push_back(look); }
  double last() const { return double(m_looks.size() - 1); }

  /// \param place a number of a look, or one between two
  double at(double place, double Look_at_balls::*value) const
  {
    const std::size_t i = std::size_t(place), next = (std::min)(i + 1, m_looks.size() - 1);
    const double t = place - double(i);
    return (1 - t) * m_looks[i].*value + t * m_looks[next].*value;
  }

  /// The first place from `begin` on where the value is not above zero; the last if it is nowhere.
  double first_not_positive(double Look_at_balls::*value, double begin) const
  {
    double place = begin, before = at(begin, value);
    while (before > 0 && place < last())
    {
      const double next_place = std::floor(place) + 1, next = at(next_place, value);
      if (!(next > 0))
        return place + (next_place - place) * before / (before - next);
      place = next_place;
      before = next;
    }
    return place;
  }

  /// Where the noise is read.
  double place_of_noise() const
  {
    return first_not_positive(&Look_at_balls::excess,
                              first_not_positive(&Look_at_balls::want_of_points, 0));
  }

  /// Whether no larger balls are needed.
  bool reach_far_enough() const
  {
    const double certainly = 0.2;
    return !m_looks.empty() && m_looks.back().excess < -certainly
           && m_looks.back().want_of_points < -std::log(2.)
           && m_looks.back().radius
                >= at(place_of_noise(), &Look_at_balls::radius) + std::log(ratio_of_larger_balls);
  }

  /// The least noise that balls tell from a place on: smaller balls are filled by it, and what
  /// bends, edges and other sheets raise what larger ones have across their planes. A larger one
  /// that has less tells sheets apart which smaller ones do not.
  double minimum_noise_from(double place) const
  {
    double least = at(place, &Look_at_balls::noise);
    for (double next = place; next < last(); next = std::floor(next) + 1)
      least = (std::min)(least, noise_of_no_size(next));
    return (std::min)(least, m_looks.back().noise);
  }

private:
  /// What is left of the noise in a ball of no size, by the balls at a place and those
  /// `ratio_of_larger_balls` times as large; less is taken off if there are smaller ones only. What
  /// bends adds to the variance by the fourth power of the radius, and edges by the second about:
  /// growth by the third is what is not noise, as far as it does not explain too much.
  double noise_of_no_size(double place) const
  {
    const double radius = at(place, &Look_at_balls::radius),
                 noise = at(place, &Look_at_balls::noise),
                 larger = place_of_radius(radius + std::log(ratio_of_larger_balls), place),
                 ratio = std::exp(at(larger, &Look_at_balls::radius) - radius),
                 growth = std::exp(2 * (at(larger, &Look_at_balls::noise) - noise));
    if (!(growth > 1 && ratio > 1))
      return noise;
    const double certainty = as_share(2 * (ratio - 1) / (ratio_of_larger_balls - 1)),
                 grown = at_most((growth - 1) / (cube(ratio) - 1), maximum_share_of_growth);
    return noise + std::log(1 - certainty * grown) / 2;
  }

  /// The place of a radius from `begin` on; the last if it is none.
  double place_of_radius(double logarithm, double begin) const
  {
    double place = begin;
    while (place < last())
    {
      const double next_place = std::floor(place) + 1, before = at(place, &Look_at_balls::radius),
                   next = at(next_place, &Look_at_balls::radius);
      if (next >= logarithm)
        return place + (next_place - place) * (logarithm - before) / (next - before);
      place = next_place;
    }
    return place;
  }
};

/*!
Estimates the scales from plane fits around a thousand points, in balls of several radii. Noise is
read where 3.5 standard deviations of it are the radius, or where balls hold 24 points if they are
larger there, and what of it grows with the balls is taken off. Of the deviations the third tenth
counts, as edges, curvature, thin parts and other sheets only ever raise them.

No radius is chosen: everything is interpolated between radii, and what a ball has of other sheets
and of points off the surface is taken off by a weight, see `with_one_sheet()`. So the estimate is a
continuous function of the points.

\param cell_size the largest balls are `maximum_reach_of_balls` times as large
\param look_at_balls `look_at_balls(k, r)` returns the balls of radius r, which is k times the size
of a cell, around one of `stride_at_reach(k)` places, as a `std::vector<Ball_of_points>`, which
holds one at least
*/
template <typename LookAtBalls>
Scales scales_of_growing_balls(double cell_size, const LookAtBalls& look_at_balls)
{
  Looks_at_balls looks;
  for (const int reach : reaches_of_balls)
  {
    const double radius = reach * cell_size;
    std::vector<Ball_of_points> balls = look_at_balls(reach, radius);
    const double count = median_count(balls);
    if (count < minimum_count_of_balls / 3 && reach < maximum_reach_of_balls)
      continue;
    looks.add(look_at(std::move(balls), radius, count));
    if (looks.reach_far_enough())
      break;
  }
  const double place = looks.place_of_noise(),
               radius = std::exp(looks.at(place, &Look_at_balls::radius)),
               noise = std::exp(looks.minimum_noise_from(place)),
               spacing = std::exp(looks.at(place, &Look_at_balls::spacing));
  // the middle of the ball is off the sheet, as its points are
  const double share_in_ball = share_of_sheet_in_ball(std::sqrt(2.) * noise / radius);
  return {spacing * std::sqrt(share_in_ball), noise};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SCALES_OF_BALLS_H
