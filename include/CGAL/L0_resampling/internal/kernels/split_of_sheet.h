// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SPLIT_OF_SHEET_H
#define CGAL_L0_RESAMPLING_INTERNAL_SPLIT_OF_SHEET_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/random_bits.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Quadric_moments.h>
#include <CGAL/L0_resampling/internal/kernels/scale_field.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The ball in which points are looked at that may be of two sheets, in units of the refinement,
/// and a smaller one, which has to find the same: a thickness does not depend on the ball, as what
/// bends and edges do.
constexpr double radius_of_split = 12, inner_share_of_split = 0.6;

/// The points are shared by wider disks before: noise that is larger than that of the cloud is not
/// to be cut off, as then the points look like those of two sheets.
constexpr double widening_of_split = 2;

/// Disks of either sheet: not steeper, and no further off, in standard deviations of the noise.
constexpr float minimum_cosine_of_sheets = 0.85f;
constexpr double maximum_height_of_sheets = 3.5;

/// The excess of the variance of two sheets over that of the noise, per that. It is a quarter of
/// their squared distance.
constexpr double minimum_excess_of_sheets = 0.12, maximum_excess_of_sheets = 3.2;

/// Sheets are further apart than this, in units of the refinement: noise of exact points need not
/// be Gaussian, and may be more than was estimated.
constexpr double minimum_distance_of_sheets = 0.5;

/// Flags of samples of one sheet around a sample: within how many units, how many of them flagged.
constexpr double radius_of_majority = 3, share_of_majority = 0.7;
constexpr double radius_of_region = 16, share_of_region = 0.6, share_of_sure_ones = 0.85;
constexpr float minimum_cosine_of_majority = 0.8f;

/// Sums over the disks of either sheet, places within the tangent plane in units of the ball.
template <typename S>
struct Moments_of_sheets
{
  Quadric_moments<S> heights;                   ///< of the means of the points of the disks
  S spread = S();                               ///< of the points of a disk about their mean
  S squared_heights = S(), fourth_powers = S(); ///< of the points over the disks

  CGAL_L0_HOST_DEVICE void add(const S& u, const S& v, const S& height, const S& own_spread,
                               const S& squared_height, const S& fourth_power, const S& weight)
  {
    heights.add(u, v, height, weight);
    spread += weight * own_spread;
    squared_heights += weight * squared_height;
    fourth_powers += weight * fourth_power;
  }

  /// The same sums as other numbers.
  template <typename S2, typename F>
  CGAL_L0_HOST_DEVICE Moments_of_sheets<S2> transformed(const F& f) const
  {
    Moments_of_sheets<S2> other;
    other.heights = Quadric_moments<S2>(heights, f);
    other.spread = f(spread);
    other.squared_heights = f(squared_heights);
    other.fourth_powers = f(fourth_powers);
    return other;
  }
};

/// How the points of a ball scatter about a quadric.
struct Scatter_in_ball
{
  double variance = 0; ///< 0 if it is not known
  double deviation_of_variance = 0;
  double middle = 0; ///< of the points, over the sample
  double kurtosis = 3;

  /// \param squared_noise of the cloud
  CGAL_L0_HOST_DEVICE Scatter_in_ball(const Moments_of_sheets<double>& sums, double squared_noise)
  {
    const double weight = sums.heights.products[0], minimum_number_of_points = 20;
    if (weight < minimum_number_of_points || !(sums.squared_heights > 0))
      return;
    const Fitted_quadric fit = sums.heights.quadric();
    if (!fit.is_determined)
      return;
    variance = sums.spread / weight + fit.variance;
    deviation_of_variance = at_least(variance, squared_noise) * std::sqrt(1.5 / weight);
    middle = fit.height;
    kurtosis = sums.fourth_powers * weight / square(sums.squared_heights);
  }

  /// 1 unless the tails are heavier than those of noise by more than chance.
  CGAL_L0_HOST_DEVICE double certainty_of_noise() const
  {
    const double by_chance = 3.2, certain = 3.6;
    return as_share((certain - kurtosis) / (certain - by_chance));
  }

  /// Of the noise, where a kurtosis below that of chance says that there are two sheets: then it is
  /// \f$ 3 - 2 e^2 / V^2 \f$, e what their distance adds to the variance V.
  CGAL_L0_HOST_DEVICE double variance_of_one_sheet() const
  {
    const double by_chance = 0.1, certain = 0.4, below = 3 - kurtosis,
                 certainty = as_share((below - by_chance) / (certain - by_chance));
    return variance * (1 - certainty * std::sqrt(at_least(below, 0) / 2));
  }
};

/// Whether the points around a sample are of two sheets that it lies between.
struct Split_of_sheet
{
  float half_distance = 0; ///< of the two; 0 if it is one
  float middle = 0;        ///< of the two, over the sample
  bool is_sure = false;

  Split_of_sheet() = default;
  CGAL_L0_HOST_DEVICE Split_of_sheet(const Scatter_in_ball& ball, const Scatter_in_ball& inner,
                                     double squared_noise, double unit)
  {
    const double excess = ball.variance - squared_noise,
                 inner_excess = inner.variance - squared_noise,
                 difference = std::abs(inner_excess - excess);
    const bool is_thick = inner_excess > 0 && excess > minimum_excess_of_sheets * squared_noise
                          && excess > 4 * ball.deviation_of_variance
                          && excess < maximum_excess_of_sheets * squared_noise
                          && 4 * excess > square(minimum_distance_of_sheets * unit)
                          && square(ball.middle) < 4 * squared_noise;
    // Noise that is larger here than elsewhere has the kurtosis of noise.
    if (!is_thick || !(ball.kurtosis < 3 - square(excess / ball.variance))
        || !(difference < 0.25 * excess + 2 * inner.deviation_of_variance))
      return;
    half_distance = float(std::sqrt(excess));
    middle = float(ball.middle);
    is_sure = difference < 0.1 * excess + 0.7 * inner.deviation_of_variance;
  }
};

/// Of the noise around a sample to that of the cloud, as far as they differ by more than chance.
/// What grows with the ball is no noise, and neither are heavier tails than those of noise: some of
/// the points there are of something else, such as the other side of a thin wall.
CGAL_L0_HOST_DEVICE inline float noise_ratio(const Scatter_in_ball& ball,
                                             const Scatter_in_ball& inner,
                                             const Split_of_sheet& split, double noise)
{
  if (!(ball.variance > 0) || !(inner.variance > 0) || split.half_distance > 0)
    return 1;
  const double of_ball = ball.variance_of_one_sheet(), of_inner = inner.variance_of_one_sheet(),
               inner_area = square(inner_share_of_split),
               of_no_size = of_inner - inner_area / (1 - inner_area) * (of_ball - of_inner),
               least = of_inner / 2,
               variance = of_ball < of_inner   ? of_ball
                          : of_no_size < least ? least
                                               : of_no_size;
  if (!(variance > 0))
    return 1;
  const double ratio = beyond_chance(std::sqrt(variance) / noise);
  return float(ratio > 1 ? 1 + (ratio - 1) * ball.certainty_of_noise() * inner.certainty_of_noise()
                         : ratio);
}

/// Random bits of a place, in units of r_p. They are those of a cell around it, which roundings
/// hardly ever move a sample out of, and which is so small that neighbors are not in one.
CGAL_L0_HOST_DEVICE inline std::uint64_t bits_of_place(const double* xyz)
{
  const double cells_per_radius = 256;
  std::uint64_t bits = 0;
  for (int axis = 0; axis < 3; ++axis)
    bits = random_bits(bits, std::uint64_t(std::int64_t(std::floor(cells_per_radius * xyz[axis]))));
  return bits;
}

/// The side that a sample begins on: 1 or -1, or 0 if it is of one sheet.
CGAL_L0_HOST_DEVICE inline signed char first_side(const Split_of_sheet& split, const double* xyz)
{
  if (!(split.half_distance > 0))
    return 0;
  return bits_of_place(xyz) >> 63 ? 1 : -1;
}

/// How often sides are balanced: about half of the samples at a time, so that neighbors do not
/// change together for ever.
constexpr int number_of_balances = 16;

CGAL_L0_HOST_DEVICE inline bool is_balanced_in(int turn, const double* xyz)
{
  return (bits_of_place(xyz) >> turn & 1) != 0;
}

/// Within how many units sides are balanced.
constexpr double radius_of_balance = 2;

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SPLIT_OF_SHEET_H
