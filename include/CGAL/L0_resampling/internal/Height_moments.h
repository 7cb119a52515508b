// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_HEIGHT_MOMENTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_HEIGHT_MOMENTS_H

#include <CGAL/L0_resampling/internal/host_device.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The moments of the heights of points over a plane, up to the fourth, and whether they tell of one sheet or of two.
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

  /// Pearson's \f$ \beta_2 - \beta_1 \f$, kurtosis less squared skewness: 3 for one sheet with Gaussian noise, about 2.5 for points that fill a ball, and 1,
  /// the least there is, for two sheets without noise, whatever their shares. 3 where all heights are equal.
  /// \param n number of points
  /// \pre `S` is a number
  CGAL_L0_HOST_DEVICE double single_sheet_index(double n) const
  {
    const double a = first / n, b = second / n, c = third / n, d = fourth / n, variance = b - a * a;
    if (!(variance > 1e-12 * b))
      return 3;
    const double skewness = c - 3 * a * b + 2 * a * a * a, tails = d - 4 * a * c + 6 * a * a * b - 3 * a * a * a * a;
    return tails / (variance * variance) - skewness * skewness / (variance * variance * variance);
  }
};

/// Two equal sheets at \f$ \pm t/2 \f$ with Gaussian noise: the share of the noise in the variance of all, from their index, which then is
/// \f$ 3 - 2 (t^2/4 / \mathrm{variance})^2 \f$.
CGAL_L0_HOST_DEVICE inline double share_of_noise(double single_sheet_index)
{
  const double distance = 3 - single_sheet_index, share = distance > 0 ? 1 - std::sqrt(distance / 2) : 1;
  return share > 0 ? share : 0;
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
