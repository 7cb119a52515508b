// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MOST_CROWDED_PLACE_H
#define CGAL_L0_RESAMPLING_INTERNAL_MOST_CROWDED_PLACE_H

#include <CGAL/L0_resampling/internal/cloud/density_weights.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A point, and how many there are within a radius, itself included.
struct Crowded_place
{
  Vector center = Vector::Zero();
  std::size_t number_of_points = 0;

  /// Whether more points are there, or as many, and its coordinates come first.
  bool comes_before(const Crowded_place& other) const
  {
    if (number_of_points != other.number_of_points)
      return number_of_points > other.number_of_points;
    return std::lexicographical_compare(center.begin(), center.end(), other.center.begin(),
                                        other.center.end());
  }
};

/// Of the first points, the one that has most of the others within `radius`. A mean of points could
/// lie where there are none.
/// \param number_of_first points that may be it; if there are none, the place has no points
/// \param minimum_cell_size of a grid of them
template <typename ConcurrencyTag>
Crowded_place most_crowded_place(const Buffer<Vector>& points, std::size_t number_of_first,
                                 double radius, double minimum_cell_size, Progress& progress)
{
  Crowded_place most;
  if (number_of_first == 0)
    return most;
  const Sorted_queries sorted(ConcurrencyTag(), points,
                              Cell_sizes((std::max)(radius, minimum_cell_size)));
  Buffer<Index> numbers(points.size(), points.get_allocator());
  Buffer<Local> weights(points.size(), points.get_allocator()); // nobody asks for them
  sum_weights_in_balls<ConcurrencyTag>(sorted.grid, sorted.points, radius, Local(radius * radius),
                                       progress, numbers, weights);
  for_each_in_order(points.size(), [&](std::size_t k) {
    const Crowded_place place = {sorted.points[k], std::size_t(numbers[k]) + 1};
    if (sorted.order[k] < number_of_first && place.comes_before(most))
      most = place;
  });
  return most;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MOST_CROWDED_PLACE_H
