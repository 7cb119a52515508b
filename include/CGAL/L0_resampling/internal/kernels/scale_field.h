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
/// as large as the one before. The first two tell the noise, all together how far it is correlated.
constexpr int balls_of_seed = 4;
constexpr int balls_of_noise = 2;
constexpr double first_ball_of_seed = 1.12;

/// From ball to ball the deviation grows by nothing where noise is that of each point alone, and by
/// an octave and more where the surface bends. Growth between these two, in octaves, is that of
/// correlated noise.
constexpr float least_growth_of_correlated_noise = 0.25f, largest_growth_of_correlated_noise = 0.7f;

/// Noise that is less of the first ball, in the median, has no effect on the radius. In a ball that
/// is not flat the deviation grows because the ball does.
constexpr float least_deviation_of_correlated_noise = 0.06f;

/// Of how many seeds the growth is looked at, at most.
constexpr std::uint64_t most_seeds_of_growth = 4096;

/// The noise, per radius, up to which a ball is flat; from twice as much on it is filled.
constexpr double largest_noise_of_flat_ball = 0.16;

/// How fast the field may change, per way: the balls of neighbors are to agree.
constexpr double slope_of_scales = 0.1;

/// Radii of its own from the middle of the cloud to a point, at most: cells have numbers of 20
/// bits.
constexpr double farthest_radii = 1 << 18;

/// How often the slope is limited by what lies around: each time by what is in reach of the groups.
constexpr int sweeps_over_seeds = 8;

/// Of how many seeds of a cell a group is made, and how many limit a scale, about, at most.
constexpr std::uint64_t most_seeds_of_cell = 8, most_limits_of_cell = 32;

/// Scales within this factor of 1 are 1: so far those of an even cloud differ by chance, and by its
/// edges.
constexpr double indifferent_scale = 1.4;

/// Up to how many of the seeds may have another scale than 1 in a cloud of one radius: as many
/// points are left out at either end where the extent of the cloud is measured.
inline std::size_t most_seeds_by_chance(std::size_t number_of_seeds)
{
  return margin_of_extent(number_of_seeds);
}

/// What is known at a seed of the points around it.
struct Seed
{
  double reach;                     ///< of its `points_of_seed` nearest points
  double deviations[balls_of_seed]; ///< across the planes of its balls, lengths
};

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

/// \param i of the point that the seed is
template <typename Team>
CGAL_L0_HOST_DEVICE Seed seed_at(const Team& team, const Morton_points& points, std::uint64_t i)
{
  const std::uint64_t most_of_cell = 16;
  const double* const p = points.xyz + 3 * i;
  Seed seed;
  seed.reach = reach_of_nearest(team, points, i);
  for (int ball = 0; ball < balls_of_seed; ++ball)
  {
    const double radius = first_ball_of_seed * seed.reach * (1 << ball);
    Plane_moments<double> own;
    points.visit_ball(team, p, radius, most_of_cell, [&](std::uint64_t j, double, bool is_inside) {
      if (!is_inside)
        return;
      const double* const q = points.xyz + 3 * j;
      own.add(q[0] - p[0], q[1] - p[1], q[2] - p[2], 1);
    });
    const Plane_moments<double> all = own.transformed<double>(
      [&](double sum) { return team.sum(sum); });
    const double n = all.sum, variance = all.plane(radius * radius, 1e-12).variance;
    seed.deviations[ball] = std::sqrt(n > 3 ? variance * n / (n - 3) : variance);
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
      || sheet_of_deviations(flatness).noise > largest_noise_of_flat_ball)
    return 1;
  int number_of_balls = 0;
  for (; number_of_balls + 1 < balls_of_seed; ++number_of_balls)
  {
    const float octaves = median(
      [&](const Growth_of_deviations& growth) { return growth.octaves[number_of_balls]; });
    if (octaves < least_growth_of_correlated_noise || octaves > largest_growth_of_correlated_noise)
      break;
  }
  // one ball alone lies between noise and a surface that bends
  return number_of_balls < balls_of_noise ? 1 : std::exp2(0.5 * number_of_balls);
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

/// What the whole cloud has, by which places of it are measured.
struct Usual_scales
{
  double radius; ///< r_p, of scale 1
  double spacing;
  double noise;
  double reach; ///< of the `points_of_seed` nearest points of a point of such a sheet

  Usual_scales(double radius_of_one, double spacing_of_cloud, double noise_of_cloud)
    : radius(radius_of_one), spacing(spacing_of_cloud), noise(noise_of_cloud), reach(0)
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

/// How much larger than r_p the radius around a seed is to be, by the spacing and the noise that
/// the seeds around it know.
/// \param seeds the seeds as points
/// \param widening of all radii, as noise is correlated
template <typename Team>
CGAL_L0_HOST_DEVICE double wanted_scale(const Team& team, const Morton_points& seeds,
                                        const Seed* known, const Usual_scales& usual,
                                        double widening, std::uint64_t i)
{
  using Numbers = Numbers_of_seeds<Team>;
  static_assert(balls_of_noise == 2, "one list of numbers for each ball");
  Numbers reaches(team), deviations[balls_of_noise] = {Numbers(team), Numbers(team)};
  const auto add = [&](std::uint64_t j, bool is_there) {
    const Seed seed = known[is_there ? j : i];
    reaches.add_if_room(seed.reach, is_there);
    for (int ball = 0; ball < balls_of_noise; ++ball)
      deviations[ball].add_if_room(seed.deviations[ball], is_there);
  };
  add(i, team.lane() == 0); // of those around it not all may be looked at
  seeds.visit_ball(team, seeds.xyz + 3 * i, radius_of_group(known[i]), most_seeds_of_cell,
                   [&](std::uint64_t j, double, bool is_inside) { add(j, is_inside); });
  const double reach = quantile<Team>(reaches, 0.5), first_radius = first_ball_of_seed * reach;
  double noises[balls_of_noise];
  for (int ball = 0; ball < balls_of_noise; ++ball)
  {
    const double radius = first_radius * (1 << ball),
                 deviation = radius > 0 ? quantile<Team>(deviations[ball], 0.3) / radius : 0;
    noises[ball] = radius * sheet_of_deviations(deviation).noise;
  }
  // Of a surface that bends or ends, or of a crowd, the deviation grows as the ball does: what is
  // left of it in a ball of no size is noise. But a ball that noise fills, or that the noise of the
  // whole cloud would fill, tells nothing of it.
  const double left = at_least((4 * square(noises[0]) - square(noises[1])) / 3, 0.),
               flat = largest_noise_of_flat_ball * first_radius,
               filled = flat > 0 ? as_share(at_least(noises[0], usual.noise) / flat - 1) : 1;
  return wanted_radius(usual.spacing * reach / usual.reach,
                       std::sqrt((1 - filled) * left + filled * square(usual.noise)))
         * widening / usual.radius;
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
                     scales.add_if_room(wanted[is_inside ? j : i], is_inside);
                   });
  return beyond_chance(quantile<Team>(scales, 0.5));
}

/// How far the place of a seed reaches: as far as its share of the points.
CGAL_L0_HOST_DEVICE inline double reach_of_seed(const Seed& seed) { return seed.reach; }

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

/// The scale at any place: the least that a seed around it allows.
/// \param reaches of the seeds: to the others of their groups
template <typename Team>
CGAL_L0_HOST_DEVICE float scale_at(const Team& team, const Morton_points& seeds,
                                   const double* reaches, const double* scales, double radius,
                                   const double* p)
{
  const std::uint64_t place = seeds.lower_bound(seeds.cells.code(p));
  std::uint64_t near = place < seeds.size ? place : seeds.size - 1;
  if (near > 0 && seeds.squared_distance(p, near - 1) < seeds.squared_distance(p, near))
    --near;
  const double distance = std::sqrt(seeds.squared_distance(p, near));
  double least = scales[near] + slope_of_scales * distance / radius;
  seeds.visit_ball(team, p, distance + 2 * reaches[near], most_limits_of_cell,
                   [&](std::uint64_t j, double squared_distance, bool is_inside) {
                     if (!is_inside)
                       return;
                     const double beyond = std::sqrt(squared_distance) - 2 * reaches[j],
                                  limit = scales[j]
                                          + (beyond > 0 ? slope_of_scales * beyond / radius : 0);
                     least = limit < least ? limit : least;
                   });
  least = team.least(least);
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
