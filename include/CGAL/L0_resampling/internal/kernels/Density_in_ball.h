// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DENSITY_IN_BALL_H
#define CGAL_L0_RESAMPLING_INTERNAL_DENSITY_IN_BALL_H

#include <CGAL/L0_resampling/internal/core/weights.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The points of a ball: how many they are, and the sum of their weights of Eq. (2).
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Density_in_ball
{
  S count = S(), sum = S();

  /// That of one point, which may be outside.
  template <typename T>
  CGAL_L0_HOST_DEVICE static Density_in_ball of_point(const S& squared_distance, T squared_radius,
                                                      T squared_bandwidth)
  {
    return {where_less(squared_distance, squared_radius, S(T(1))),
            where_less(squared_distance, squared_radius,
                       gaussian_weight(squared_distance, squared_bandwidth))};
  }

  CGAL_L0_HOST_DEVICE Density_in_ball& operator+=(const Density_in_ball& other)
  {
    count += other.count;
    sum += other.sum;
    return *this;
  }

  /// Without the point in the middle, which thinning may have left out already.
  /// \pre `S` is a number
  CGAL_L0_HOST_DEVICE Density_in_ball of_others() const
  {
    const S self = count > 0 ? S(1) : S(0);
    return {count - self, at_least(sum - self, S(0))};
  }
};

/// \f$ v_j \f$ and \f$ w_i \f$ of Eq. (5): at least 1, which they are where nobody has a neighbor.
/// \param sum of the weights of the neighbors
/// \param mean_number_of_neighbors of all points or samples
template <typename T, typename Mean>
CGAL_L0_HOST_DEVICE inline auto density_weight(T sum, Mean mean_number_of_neighbors)
{
  return mean_number_of_neighbors > 0 ? 1 + sum / mean_number_of_neighbors : 1;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DENSITY_IN_BALL_H
