// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SEEDS_OF_SCALES_H
#define CGAL_L0_RESAMPLING_INTERNAL_SEEDS_OF_SCALES_H

#include <CGAL/L0_resampling/internal/kernels/Morton_points.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/kernels/scales_of_balls.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// What the points around a seed of the field of scales tell, see `scale_field.h`.

/// One of so many points is a seed, and within so many of the nearest points the spacing and the
/// noise there are looked for.
constexpr int points_of_seed = 24;

/// The balls around a seed: the first holds a few more than `points_of_seed`, each other is twice
/// as large as the one before. They tell the noise, and how far it is correlated.
constexpr int balls_of_seed = 4;
constexpr double first_ball_of_seed = 1.12;

/// How many such balls, from the first on, are asked for the least that spans a surface.
constexpr int balls_of_span = 6;

/// Deviations of fewer balls than this that grow as those of correlated noise do lie between noise
/// and a surface that bends.
constexpr int minimum_number_of_balls_of_correlated_noise = 2;

/// From ball to ball the deviation grows by nothing where noise is that of each point alone, and by
/// an octave and more where the surface bends. Growth between these two, in octaves, is that of
/// correlated noise.
constexpr float minimum_growth_of_correlated_noise = 0.25f,
                maximum_growth_of_correlated_noise = 0.7f;

/// Noise that is less of the first ball, in the median, has no effect on the radius. In a ball that
/// is not flat the deviation grows because the ball does.
constexpr float minimum_deviation_of_correlated_noise = 0.06f;

/// Of how many seeds the growth is looked at, at most.
constexpr std::uint64_t maximum_number_of_seeds_of_growth = 4096;

/// The noise, per radius, up to which the first ball tells of correlated noise.
constexpr double maximum_noise_of_flat_ball = 0.16;

/// What is known at a seed of the points around it.
struct Seed
{
  double reach; ///< of its `points_of_seed` nearest points, or farther for a surface
  double deviations[balls_of_seed]; ///< of one sheet across the planes of its balls, lengths
  double certainty; ///< that it lies in a surface, in [0, 1]: in the plane of a flat first ball
  double span;      ///< the radius from which on the points of a ball tell the normal of a surface
  double certainty_of_span; ///< in [0, 1]
};

/// The noise that a ball of a seed tells.
/// \param ball its number
/// \param third_tenth of the deviations of seeds around
CGAL_L0_HOST_DEVICE inline double noise_of_ball(int ball, double radius, double third_tenth)
{
  const double n = points_of_seed * square(first_ball_of_seed * (1 << ball));
  return radius > 0 ? noise_of_sheet(third_tenth / third_tenth_of_deviations(n), radius, n) : 0;
}

/// The distance of the k-th nearest point of a point, k being `points_of_seed`.
template <typename Team>
CGAL_L0_HOST_DEVICE double reach_of_nearest(const Team& team, const Morton_points& points,
                                            std::uint64_t i)
{
  constexpr int k = points_of_seed;
  using Nearest = typename Team::template Sorted_numbers<double, k>; // squared distances
  const double* const p = points.xyz + 3 * i;
  Nearest next(team);
  // those next to it in the order are near, and tell how far the others may be
  const std::uint64_t first = i < std::uint64_t(k) ? 0 : i - k,
                      end = i + k < points.size ? i + k + 1 : points.size;
  for (std::uint64_t begin = first; begin < end; begin += Team::number_of_threads)
  {
    const std::uint64_t j = begin + std::uint64_t(team.lane());
    const bool is_other = j < end && j != i;
    next.add_if_small(is_other ? points.squared_distance(p, j) : 0, is_other);
  }
  const int last = next.size() - 1;
  if (last < 0)
    return 0;
  double distance = std::sqrt(next[last]);
  if (next.size() < k)
    return distance;
  // Where the order leaps, that is far, and very many points are nearer. Some of them, first, tell
  // how near the others have to be.
  const std::uint64_t few = 64, all = (std::numeric_limits<std::uint64_t>::max)();
  for (const std::uint64_t most_of_cell : {few, all})
  {
    Nearest nearest(team);
    const bool are_all_looked_at =
      points.visit_ball(team, p, distance * (1 + 1e-9), most_of_cell,
                        [&](std::uint64_t j, double squared_distance, bool is_inside) {
                          nearest.add_if_small(squared_distance, is_inside && j != i);
                        });
    if (nearest.size() == k)
      distance = std::sqrt(nearest[k - 1]);
    if (are_all_looked_at)
      break;
  }
  return distance;
}

/// Of a cell of more points in a ball of a seed some are looked at.
constexpr std::uint64_t maximum_number_of_points_of_cell = 16;

/// The moments of the points in a ball of a seed, relative to the seed.
template <typename Team>
CGAL_L0_HOST_DEVICE Plane_moments<double> moments_around(const Team& team,
                                                         const Morton_points& points,
                                                         const double* p, double radius)
{
  Plane_moments<double> own;
  points.visit_ball(team, p, radius, maximum_number_of_points_of_cell,
                    [&](std::uint64_t j, double, bool is_inside) {
                      const double* const q = points.xyz + 3 * j;
                      if (is_inside)
                        own.add(q[0] - p[0], q[1] - p[1], q[2] - p[2], 1);
                    });
  return own.transformed<double>([&](double sum) { return team.sum(sum); });
}

/// The heights of the points in a ball of a seed, relative to the seed.
template <typename Team>
CGAL_L0_HOST_DEVICE Height_moments<double> heights_around(const Team& team,
                                                          const Morton_points& points,
                                                          const double* p, double radius,
                                                          const Triple& normal)
{
  Height_moments<double> own;
  points.visit_ball(team, p, radius, maximum_number_of_points_of_cell,
                    [&](std::uint64_t j, double, bool is_inside) {
                      const double* const q = points.xyz + 3 * j;
                      if (is_inside)
                        own.add(dot(normal, {q[0] - p[0], q[1] - p[1], q[2] - p[2]}), 1);
                    });
  return {team.sum(own.first), team.sum(own.second), team.sum(own.third), team.sum(own.fourth)};
}

/// How far points span a surface and not a line, in [0, 1]: by the second of their variances per
/// the first, which is 0.28 at the border of a surface and more inside.
CGAL_L0_HOST_DEVICE inline double certainty_of_surface(const Plane_moments<double>& moments)
{
  const double surely_surface = 0.2, rounding = 1e-12;
  if (!(moments.sum > 0))
    return 0;
  const Eigen_decomposition eigen = moments.eigen_decomposition();
  return eigen.values[1] > rounding * eigen.values[2]
           ? as_share(eigen.values[1] / (surely_surface * eigen.values[2]))
           : 0;
}

/// Which of some balls, each twice as large as the one before, is the first of a kind, in the mean.
struct First_of_balls
{
  double doublings = 0, left = 1;

  CGAL_L0_HOST_DEVICE void add(int ball, double certainty)
  {
    doublings += left * certainty * ball;
    left *= 1 - certainty;
  }
};

/*!
Makes the reach of a seed so large that its balls span a surface, and finds its span. The nearest
points of one on a scan line are all of that line. The first ball that spans a surface, of balls
that are doubled, decides; where there is none, as on a wire, balls do not grow. For the span points
count the less the farther off they are, as in the kernels that use the radius: a line that a ball
just touches would tell the normal by its noise alone.
*/
template <typename Team>
CGAL_L0_HOST_DEVICE void grow_to_surface(const Team& team, const Morton_points& points,
                                         const double* p, Seed& seed)
{
  const double first_radius = first_ball_of_seed * seed.reach;
  First_of_balls spanning, telling;
  for (int ball = 0; ball < balls_of_span; ++ball)
  {
    const bool grows = ball < balls_of_seed && spanning.left > 0;
    if (!grows && !(telling.left > 0))
      break;
    const double radius = first_radius * (1 << ball);
    Plane_moments<double> all, weighted;
    points.visit_ball(team, p, radius, maximum_number_of_points_of_cell,
                      [&](std::uint64_t j, double squared_distance, bool is_inside) {
                        if (!is_inside)
                          return;
                        const double* const q = points.xyz + 3 * j;
                        const double dx = q[0] - p[0], dy = q[1] - p[1], dz = q[2] - p[2];
                        all.add(dx, dy, dz, 1);
                        weighted.add(dx, dy, dz, square(1 - squared_distance / square(radius)));
                      });
    const auto of_team = [&](const Plane_moments<double>& own) {
      return own.transformed<double>([&](double sum) { return team.sum(sum); });
    };
    if (grows)
      spanning.add(ball, certainty_of_surface(of_team(all)));
    telling.add(ball, certainty_of_surface(of_team(weighted)));
  }
  const double certainty = 1 - telling.left;
  seed.reach *= std::exp2(spanning.doublings);
  seed.span = first_radius * std::exp2(certainty > 0 ? telling.doublings / certainty : 0);
  seed.certainty_of_span = certainty;
}

/// That a point lies in the plane of the points in a ball, in [0, 1]: points of a crowd fill the
/// ball, and the nearest points of one that is off a surface are all to one side.
/// \param height of the mean of the points over the point
CGAL_L0_HOST_DEVICE inline double certainty_of_plane(double deviation, double height, double radius)
{
  if (!(radius > 0))
    return 0;
  const auto certainty_below = [&](double length) {
    return as_share(2.5 - length / (0.1 * radius));
  };
  return certainty_below(deviation) * certainty_below(std::abs(height));
}

/// \param i of the point that the seed is
template <typename Team>
CGAL_L0_HOST_DEVICE Seed seed_at(const Team& team, const Morton_points& points, std::uint64_t i)
{
  const double* const p = points.xyz + 3 * i;
  Seed seed;
  seed.reach = reach_of_nearest(team, points, i);
  grow_to_surface(team, points, p, seed);
  for (int ball = 0; ball < balls_of_seed; ++ball)
  {
    const double radius = first_ball_of_seed * seed.reach * (1 << ball);
    const Plane_moments<double> moments = moments_around(team, points, p, radius);
    const Fitted_plane plane = moments.plane(radius * radius, 1e-12);
    const Height_moments<double> heights = heights_around(team, points, p, radius, plane.normal);
    const Ball_of_points all = ball_of_points(moments.sum, 1, plane.variance, heights);
    // of a ball so large that the cubes of its variances are no numbers, nothing is known
    const double variance = with_one_sheet(all, radius).variance;
    seed.deviations[ball] = variance > 0 && variance <= radius * radius ? std::sqrt(variance) : 0;
    if (ball == 0)
      seed.certainty = certainty_of_plane(seed.deviations[0], heights.first / moments.sum, radius);
  }
  return seed;
}

/// Of some seeds, which one of so many seeds are: how their deviations grow from ball to ball, and
/// the first of them per radius.
struct Growth_of_deviations
{
  float flatness;
  float octaves[balls_of_seed - 1];
};

CGAL_L0_HOST_DEVICE inline Growth_of_deviations growth_at(const Seed& seed)
{
  Growth_of_deviations growth;
  growth.flatness = seed.reach > 0 ? float(seed.deviations[0] / (first_ball_of_seed * seed.reach))
                                   : 0;
  for (int ball = 0; ball + 1 < balls_of_seed; ++ball)
    growth.octaves[ball] = seed.deviations[ball] > 0
                             ? float(std::log2(seed.deviations[ball + 1] / seed.deviations[ball]))
                             : maximum_growth_of_correlated_noise + 1;
  return growth;
}

/// One of how many seeds is looked at for the growth.
inline std::uint64_t stride_of_growth(std::uint64_t number_of_seeds)
{
  return (number_of_seeds + maximum_number_of_seeds_of_growth - 1)
         / maximum_number_of_seeds_of_growth;
}

/// How much larger all radii are to be, as the noise of neighboring points is correlated, such as
/// the depth steps of structured light: a ball over which it is correlated tells no more than a
/// point, and each doubling of such balls doubles the area.
inline double widening_by_correlation(const std::vector<Growth_of_deviations>& growths)
{
  const auto median = [&](const auto& number_of) {
    std::vector<float> numbers;
    for (const Growth_of_deviations& growth : growths)
      numbers.push_back(number_of(growth));
    const auto middle = numbers.begin() + std::ptrdiff_t(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
  };
  if (growths.empty())
    return 1;
  const float flatness = median([](const Growth_of_deviations& growth) { return growth.flatness; });
  if (flatness < minimum_deviation_of_correlated_noise
      || noise_of_ball(0, 1, flatness) > maximum_noise_of_flat_ball)
    return 1;
  int number_of_balls = 0;
  for (; number_of_balls + 1 < balls_of_seed; ++number_of_balls)
  {
    const float octaves = median(
      [&](const Growth_of_deviations& growth) { return growth.octaves[number_of_balls]; });
    if (octaves < minimum_growth_of_correlated_noise
        || octaves > maximum_growth_of_correlated_noise)
      break;
  }
  return number_of_balls < minimum_number_of_balls_of_correlated_noise
           ? 1
           : std::exp2(0.5 * number_of_balls);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SEEDS_OF_SCALES_H
