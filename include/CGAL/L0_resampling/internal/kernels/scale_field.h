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
#include <CGAL/L0_resampling/internal/kernels/levels_of_scales.h>
#include <CGAL/L0_resampling/internal/kernels/scales_of_balls.h>
#include <CGAL/L0_resampling/internal/kernels/seeds_of_scales.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// The field of scales: how much larger the radius is to be around a point than r_p. It is estimated
// at seeds, every `points_of_seed`-th point in Morton order, and read everywhere.

/// How many seeds around a seed decide together, about.
constexpr double seeds_of_group = 32;

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
constexpr std::uint64_t maximum_number_of_seeds_of_cell = 32, maximum_number_of_limits_of_cell = 32;

/// Scales within this factor of 1 are 1: so far those of an even cloud differ by chance, and by its
/// edges.
constexpr double indifferent_scale = 1.4;

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
  const double maximum_ratio = std::exp2(1 + 9 * (1 - own.certainty));
  return own.reach <= maximum_ratio * other.reach && other.reach <= maximum_ratio * own.reach;
}

/// What the whole cloud has, by which places of it are measured.
struct Reference_scales
{
  double radius;           ///< r_p, of scale 1
  double estimated_radius; ///< what spacing and noise want: r_p, unless the caller has chosen it
  double spacing;
  double noise;
  bool is_noise_known; ///< by the caller: then it is not looked for
  double reach;        ///< of the `points_of_seed` nearest points of a point of such a sheet

  Reference_scales(double radius_of_one, double radius_of_estimate, double spacing_of_cloud,
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
                                        const Seed* known, const Reference_scales& usual,
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
  seeds.visit_ball(team, seeds.xyz + 3 * i, radius_of_group(known[i]),
                   maximum_number_of_seeds_of_cell, [&](std::uint64_t j, double, bool is_inside) {
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
  return beyond < minimum_scale ? minimum_scale : beyond > maximum_scale ? maximum_scale : beyond;
}

/// The scale of most seeds in the group of a seed: one alone may be wrong, and the least
/// decides for all around it.
template <typename Team>
CGAL_L0_HOST_DEVICE double scale_of_group(const Team& team, const Morton_points& seeds,
                                          const Seed* known, const double* wanted, std::uint64_t i)
{
  Numbers_of_seeds<Team> scales(team);
  scales.add_if_room(wanted[i], team.lane() == 0);
  seeds.visit_ball(team, seeds.xyz + 3 * i, radius_of_group(known[i]),
                   maximum_number_of_seeds_of_cell, [&](std::uint64_t j, double, bool is_inside) {
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
  seeds.visit_ball(team, seeds.xyz + 3 * i, radius_of_group(known[i]),
                   maximum_number_of_limits_of_cell,
                   [&](std::uint64_t j, double squared_distance, bool is_inside) {
                     if (!is_inside)
                       return;
                     const double limit = scales[j]
                                          + slope_of_scales * std::sqrt(squared_distance) / radius;
                     least = limit < least ? limit : least;
                   });
  return team.least(least);
}

/*!
The scale at a seed by which its balls span a surface. The spacing along a line tells nothing of how
far the next one is, nor do the seeds that limit it: they are of the same line, or of denser ones.
Most seeds of the group decide, each as far as it lies in a surface and knows its span.

\param scales of the seeds, once they are limited
\param estimated_radius see `Reference_scales`: one that the caller has chosen keeps its ratio
*/
template <typename Team>
CGAL_L0_HOST_DEVICE double spanning_scale(const Team& team, const Morton_points& seeds,
                                          const Seed* known, const double* scales,
                                          double estimated_radius, std::uint64_t i)
{
  Numbers_of_seeds<Team> factors(team);
  const auto add = [&](std::uint64_t j, bool is_there) {
    const Seed& seed = known[is_there ? j : i];
    const double ratio = seed.span / (scales[is_there ? j : i] * estimated_radius);
    factors.add_if_room(ratio > 1 ? std::pow(ratio, seed.certainty * seed.certainty_of_span) : 1,
                        is_there);
  };
  add(i, team.lane() == 0);
  seeds.visit_ball(team, seeds.xyz + 3 * i, radius_of_group(known[i]),
                   maximum_number_of_seeds_of_cell, [&](std::uint64_t j, double, bool is_inside) {
                     add(j, is_inside && is_alike(known[i], known[j]));
                   });
  const double scale = scales[i] * quantile<Team>(factors, 0.5);
  return scale < maximum_scale ? scale : maximum_scale;
}

/// The scale at a seed, and how far it reaches.
struct Scale_of_seed
{
  double scale;
  double reach;  ///< to the others of its group
  double within; ///< so far from the seed, no other allows less
};

/// \param scales of the seeds
template <typename Team>
CGAL_L0_HOST_DEVICE Scale_of_seed scale_of_seed(const Team& team, const Morton_points& seeds,
                                                const Seed* known, const double* scales,
                                                std::uint64_t i)
{
  const double scale = scales[i], reach = known[i].reach, within = 2 * reach;
  bool is_least = true;
  // all that `scale_at()` looks at from there
  const bool are_all_looked_at = seeds.visit_ball(team, seeds.xyz + 3 * i, 2 * within + 2 * reach,
                                                  maximum_number_of_limits_of_cell,
                                                  [&](std::uint64_t j, double, bool is_inside) {
                                                    is_least = is_least
                                                               && !(is_inside && scales[j] < scale);
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
    seeds.visit_ball(team, p, distance + 2 * scales[near].reach, maximum_number_of_limits_of_cell,
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
  least = least > maximum_scale ? double(maximum_scale) : least;
  return float(least);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SCALE_FIELD_H
