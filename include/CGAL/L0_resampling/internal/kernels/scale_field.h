// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SCALE_FIELD_H
#define CGAL_L0_RESAMPLING_INTERNAL_SCALE_FIELD_H

#include <CGAL/L0_resampling/internal/kernels/Morton_points.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/kernels/levels_of_scales.h>
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

// The field of scales: how much larger the radius is to be around a point than r_p. It is estimated
// at seeds, every `points_of_seed`-th point in Morton order, and read everywhere.

/// One of so many points is a seed, and within so many of the nearest points the spacing and the
/// noise there are looked for.
constexpr int points_of_seed = 24;

/// How many seeds around a seed decide together, about.
constexpr double seeds_of_group = 32;

/// The balls around a seed: the first holds a few more than `points_of_seed`, each other is twice
/// as large as the one before. They tell the noise, and how far it is correlated.
constexpr int balls_of_seed = 4;
constexpr double first_ball_of_seed = 1.12;

/// Deviations of fewer balls than this that grow as those of correlated noise do lie between noise
/// and a surface that bends.
constexpr int fewest_balls_of_correlated_noise = 2;

/// From ball to ball the deviation grows by nothing where noise is that of each point alone, and by
/// an octave and more where the surface bends. Growth between these two, in octaves, is that of
/// correlated noise.
constexpr float least_growth_of_correlated_noise = 0.25f, largest_growth_of_correlated_noise = 0.7f;

/// Noise that is less of the first ball, in the median, has no effect on the radius. In a ball that
/// is not flat the deviation grows because the ball does.
constexpr float least_deviation_of_correlated_noise = 0.06f;

/// Of how many seeds the growth is looked at, at most.
constexpr std::uint64_t most_seeds_of_growth = 4096;

/// The noise, per radius, up to which the first ball tells of correlated noise.
constexpr double largest_noise_of_flat_ball = 0.16;

/// How fast the field may change, per way: the balls of neighbors are to agree. Between the rings
/// of a scanner that turns, the spacing rises by 0.2 of the way and more; where scales rise faster,
/// the balls of outliers grow until they hold enough of their like.
constexpr double slope_of_scales = 0.2;

/// Radii of its own from the middle of the cloud to a point, at most: cells have numbers of 20
/// bits.
constexpr double farthest_radii = 1 << 18;

/// How often the slope is limited by what lies around: each time by what is in reach of the groups.
constexpr int sweeps_over_seeds = 8;

/// Of how many seeds of a cell a group is made, and how many limit a scale, about, at most.
constexpr std::uint64_t most_seeds_of_cell = 32, most_limits_of_cell = 32;

/// Scales within this factor of 1 are 1: so far those of an even cloud differ by chance, and by its
/// edges.
constexpr double indifferent_scale = 1.4;

/// What is known at a seed of the points around it.
struct Seed
{
  double reach; ///< of its `points_of_seed` nearest points, or farther for a surface
  double deviations[balls_of_seed]; ///< of one sheet across the planes of its balls, lengths
  double certainty; ///< that it lies in a surface, in [0, 1]: in the plane of a flat first ball
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
constexpr std::uint64_t most_points_of_cell = 16;

/// The moments of the points in a ball of a seed, relative to the seed.
template <typename Team>
CGAL_L0_HOST_DEVICE Plane_moments<double> moments_around(const Team& team,
                                                         const Morton_points& points,
                                                         const double* p, double radius)
{
  Plane_moments<double> own;
  points.visit_ball(team, p, radius, most_points_of_cell,
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
  points.visit_ball(team, p, radius, most_points_of_cell,
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
  const double surely_surface = 0.2;
  if (!(moments.sum > 2))
    return 0;
  const Eigen_decomposition eigen = moments.eigen_decomposition();
  return eigen.values[2] > 0 ? as_share(eigen.values[1] / (surely_surface * eigen.values[2])) : 0;
}

/*!
How much larger the balls of a seed have to be to span a surface. The nearest points of one on a
scan line are all of that line. The first ball that spans a surface, of balls that are doubled,
decides; where there is none, as on a wire, balls do not grow.
*/
template <typename Team>
CGAL_L0_HOST_DEVICE double growth_to_surface(const Team& team, const Morton_points& points,
                                             const double* p, double first_radius)
{
  double doublings = 0, left = 1;
  for (int ball = 0; ball < balls_of_seed && left > 0; ++ball)
  {
    const double certainty = certainty_of_surface(
      moments_around(team, points, p, first_radius * (1 << ball)));
    doublings += left * certainty * ball;
    left *= 1 - certainty;
  }
  return std::exp2(doublings);
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
  seed.reach *= growth_to_surface(team, points, p, first_ball_of_seed * seed.reach);
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
                             : largest_growth_of_correlated_noise + 1;
  return growth;
}

/// One of how many seeds is looked at for the growth.
inline std::uint64_t stride_of_growth(std::uint64_t number_of_seeds)
{
  return (number_of_seeds + most_seeds_of_growth - 1) / most_seeds_of_growth;
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
  if (flatness < least_deviation_of_correlated_noise
      || noise_of_ball(0, 1, flatness) > largest_noise_of_flat_ball)
    return 1;
  int number_of_balls = 0;
  for (; number_of_balls + 1 < balls_of_seed; ++number_of_balls)
  {
    const float octaves = median(
      [&](const Growth_of_deviations& growth) { return growth.octaves[number_of_balls]; });
    if (octaves < least_growth_of_correlated_noise || octaves > largest_growth_of_correlated_noise)
      break;
  }
  return number_of_balls < fewest_balls_of_correlated_noise ? 1 : std::exp2(0.5 * number_of_balls);
}

/// Numbers of a few seeds, the first in their order.
template <typename Team>
using Numbers_of_seeds = typename Team::template Sorted_numbers<double, 64>;

template <typename Team>
CGAL_L0_HOST_DEVICE double quantile(const Numbers_of_seeds<Team>& numbers, double share)
{
  return numbers[int(share * (numbers.size() - 1))];
}

CGAL_L0_HOST_DEVICE inline double radius_of_group(const Seed& seed)
{
  return seed.reach * std::sqrt(seeds_of_group);
}

/// Whether a seed decides with another: around a sparse one there may be many of a dense surface,
/// which know nothing of how sparse it is. One that lies off all surfaces is not asked.
CGAL_L0_HOST_DEVICE inline bool is_alike(const Seed& own, const Seed& other)
{
  const double largest_ratio = std::exp2(1 + 9 * (1 - own.certainty));
  return own.reach <= largest_ratio * other.reach && other.reach <= largest_ratio * own.reach;
}

/// What the whole cloud has, by which places of it are measured.
struct Usual_scales
{
  double radius;           ///< r_p, of scale 1
  double estimated_radius; ///< what spacing and noise want: r_p, unless the caller has chosen it
  double spacing;
  double noise;
  bool is_noise_known; ///< by the caller: then it is not looked for
  double reach;        ///< of the `points_of_seed` nearest points of a point of such a sheet

  Usual_scales(double radius_of_one, double radius_of_estimate, double spacing_of_cloud,
               double noise_of_cloud, bool is_noise_of_caller = false)
    : radius(radius_of_one), estimated_radius(radius_of_estimate), spacing(spacing_of_cloud),
      noise(noise_of_cloud), is_noise_known(is_noise_of_caller), reach(0)
  {
    const double pi = 3.141592653589793;
    const auto count = [&](double r) {
      return pi * square(r / spacing) * share_of_sheet_in_ball(noise / r);
    };
    double low = 0, high = spacing;
    while (count(high) < points_of_seed)
      high *= 2;
    for (int step = 0; step < 50; ++step)
    {
      const double middle = (low + high) / 2;
      (count(middle) < points_of_seed ? low : high) = middle;
    }
    reach = high;
  }
};

/*!
The noise around a seed. As in `scales_of_growing_balls()` it is read where
`radius_of_balls_per_noise` deviations of it are the radius, or in the first ball. Whether a ball is
so large it tells itself if it is flat; if not, the one twice as large does, as a ball that noise
fills tells nothing. Of a surface that bends or ends, or of a crowd, the deviation grows as the ball
does: what is left of it in a ball of no size is noise, but not less than half, as edges come into
the larger balls all at once. Where all balls are too small, the noise is that of the whole cloud.

\param noises that the balls of the seeds around tell
*/
CGAL_L0_HOST_DEVICE inline double noise_of_balls(const double (&noises)[balls_of_seed],
                                                 double first_radius, double usual_noise)
{
  if (!(first_radius > 0))
    return usual_noise;
  const int last = balls_of_seed - 2;
  const auto excess = [&](int ball) {
    const double radius = first_radius * (1 << ball), in_flat_ball = 0.22, in_filled_ball = 0.32,
                 filled = as_share((noises[ball] / radius - in_flat_ball)
                                   / (in_filled_ball - in_flat_ball)),
                 noise = noises[ball] + filled * (noises[ball + 1] - noises[ball]);
    return std::log(radius_of_balls_per_noise * at_least(noise / radius, 1e-100));
  };
  double place = 0, left = excess(0);
  for (int ball = 1; ball <= last && left > 0; ++ball)
  {
    const double next = excess(ball);
    place = next > 0 ? ball : ball - 1 + left / (left - next);
    left = next;
  }
  const double certainly_too_small = 0.7, uncertainty = as_share(left / certainly_too_small);
  const int ball = place < last ? int(place) : last - 1;
  const auto squared_noise = [&](int larger) {
    const double t = place - ball;
    return (1 - t) * square(noises[ball + larger]) + t * square(noises[ball + larger + 1]);
  };
  const double of_ball = squared_noise(0), of_no_size = (4 * of_ball - squared_noise(1)) / 3;
  return std::sqrt((1 - uncertainty) * at_least(of_no_size, of_ball / 2)
                   + uncertainty * square(usual_noise));
}

/// How much larger than r_p the radius around a seed is to be, by the spacing and the noise that
/// the seeds around it know: as many times as it is larger than that of the cloud, also where the
/// caller has chosen r_p.
/// \param seeds the seeds as points
/// \param widening of all radii, as noise is correlated
/// \param noise_ratio of the noise at the seed to that of the cloud, if the caller knows it
template <typename Team>
CGAL_L0_HOST_DEVICE double wanted_scale(const Team& team, const Morton_points& seeds,
                                        const Seed* known, const Usual_scales& usual,
                                        double widening, std::uint64_t i, float noise_ratio = 1)
{
  using Numbers = Numbers_of_seeds<Team>;
  static_assert(balls_of_seed == 4, "one list of numbers for each ball");
  Numbers reaches(team),
    deviations[balls_of_seed] = {Numbers(team), Numbers(team), Numbers(team), Numbers(team)};
  const auto add = [&](std::uint64_t j, bool is_there) {
    const Seed seed = known[is_there ? j : i];
    reaches.add_if_room(seed.reach, is_there);
    for (int ball = 0; ball < balls_of_seed; ++ball)
      deviations[ball].add_if_room(seed.reach > 0 ? seed.deviations[ball] / seed.reach : 0,
                                   is_there); // a filled ball has more if it is larger
  };
  add(i, team.lane() == 0); // of those around it not all may be looked at
  seeds.visit_ball(team, seeds.xyz + 3 * i, radius_of_group(known[i]), most_seeds_of_cell,
                   [&](std::uint64_t j, double, bool is_inside) {
                     add(j, is_inside && is_alike(known[i], known[j]));
                   });
  const double reach = quantile<Team>(reaches, 0.5), first_radius = first_ball_of_seed * reach;
  double noises[balls_of_seed];
  for (int ball = 0; ball < balls_of_seed; ++ball)
    noises[ball] = noise_of_ball(ball, first_radius * (1 << ball),
                                 reach * quantile<Team>(deviations[ball], 0.3));
  return wanted_radius(usual.spacing * reach / usual.reach,
                       usual.is_noise_known ? usual.noise * double(noise_ratio)
                                            : noise_of_balls(noises, first_radius, usual.noise))
         * widening / usual.estimated_radius;
}

/// The scale as far as chance does not explain it: 1 near 1, itself far from it, and something in
/// between on the way.
CGAL_L0_HOST_DEVICE inline double beyond_chance(double scale)
{
  const double logarithm = std::log(scale), size = std::abs(logarithm),
               zero_below = std::log(indifferent_scale), kept_from = 2 * zero_below;
  const double kept = size < kept_from ? as_share((size - zero_below) / zero_below) * kept_from
                                       : size;
  const double beyond = std::exp(logarithm < 0 ? -kept : kept);
  return beyond < least_scale ? least_scale : beyond > largest_scale ? largest_scale : beyond;
}

/// The scale of most seeds in the group of a seed: one alone may be wrong, and the least
/// decides for all around it.
template <typename Team>
CGAL_L0_HOST_DEVICE double scale_of_group(const Team& team, const Morton_points& seeds,
                                          const Seed* known, const double* wanted, std::uint64_t i)
{
  Numbers_of_seeds<Team> scales(team);
  scales.add_if_room(wanted[i], team.lane() == 0);
  seeds.visit_ball(team, seeds.xyz + 3 * i, radius_of_group(known[i]), most_seeds_of_cell,
                   [&](std::uint64_t j, double, bool is_inside) {
                     scales.add_if_room(wanted[is_inside ? j : i],
                                        is_inside && is_alike(known[i], known[j]));
                   });
  return beyond_chance(quantile<Team>(scales, 0.5));
}

/// The scale at a seed once those around it limit how fast it rises from them.
template <typename Team>
CGAL_L0_HOST_DEVICE double limited_scale(const Team& team, const Morton_points& seeds,
                                         const Seed* known, const double* scales, double radius,
                                         std::uint64_t i)
{
  double least = scales[i];
  seeds.visit_ball(team, seeds.xyz + 3 * i, radius_of_group(known[i]), most_limits_of_cell,
                   [&](std::uint64_t j, double squared_distance, bool is_inside) {
                     if (!is_inside)
                       return;
                     const double limit = scales[j]
                                          + slope_of_scales * std::sqrt(squared_distance) / radius;
                     least = limit < least ? limit : least;
                   });
  return team.least(least);
}

/// The scale at a seed, and how far it reaches.
struct Scale_of_seed
{
  double scale;
  double reach;  ///< to the others of its group
  double within; ///< so far from the seed, no other allows less
};

/// \param scales of the seeds, once they are limited
template <typename Team>
CGAL_L0_HOST_DEVICE Scale_of_seed scale_of_seed(const Team& team, const Morton_points& seeds,
                                                const Seed* known, const double* scales,
                                                std::uint64_t i)
{
  const double scale = scales[i], reach = known[i].reach, within = 2 * reach;
  bool is_least = true;
  // all that `scale_at()` looks at from there
  const bool are_all_looked_at =
    seeds.visit_ball(team, seeds.xyz + 3 * i, 2 * within + 2 * reach, most_limits_of_cell,
                     [&](std::uint64_t j, double, bool is_inside) {
                       is_least = is_least && !(is_inside && scales[j] < scale);
                     });
  return {scale, reach, are_all_looked_at && team.all(is_least) ? within : -1};
}

/// The scale at any place: the least that a seed around it allows.
template <typename Team>
CGAL_L0_HOST_DEVICE float scale_at(const Team& team, const Morton_points& seeds,
                                   const Scale_of_seed* scales, double radius, const double* p)
{
  const std::uint64_t place = seeds.lower_bound(seeds.cells.code(p));
  std::uint64_t near = place < seeds.size ? place : seeds.size - 1;
  if (near > 0 && seeds.squared_distance(p, near - 1) < seeds.squared_distance(p, near))
    --near;
  const double distance = std::sqrt(seeds.squared_distance(p, near));
  double least = scales[near].scale;
  if (distance > scales[near].within)
  {
    least += slope_of_scales * distance / radius;
    seeds.visit_ball(team, p, distance + 2 * scales[near].reach, most_limits_of_cell,
                     [&](std::uint64_t j, double squared_distance, bool is_inside) {
                       if (!is_inside)
                         return;
                       const double beyond = std::sqrt(squared_distance) - 2 * scales[j].reach,
                                    limit = scales[j].scale
                                            + (beyond > 0 ? slope_of_scales * beyond / radius : 0);
                       least = limit < least ? limit : least;
                     });
    least = team.least(least);
  }
  // so far from the middle that cells of its own scale could not be numbered
  for (int axis = 0; axis < 3; ++axis)
  {
    const double of_number = std::abs(p[axis]) / (radius * farthest_radii);
    least = of_number > least ? of_number : least;
  }
  least = least > largest_scale ? double(largest_scale) : least;
  return float(least);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SCALE_FIELD_H
