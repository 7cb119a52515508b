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

/// The point that has most of the others within `radius`. A mean of points could lie where there
/// are none.
/// \param points at least one
/// \param smallest_cell_size of a grid of them
template <typename ConcurrencyTag>
Vector most_crowded_place(const Buffer<Vector>& points, double radius, double smallest_cell_size,
                          Progress& progress)
{
  const Sorted_queries sorted(ConcurrencyTag(), points,
                              Cell_sizes((std::max)(radius, smallest_cell_size)));
  Buffer<Index> numbers(points.size(), points.get_allocator());
  Buffer<Local> weights(points.size(), points.get_allocator()); // nobody asks for them
  sum_weights_in_balls<ConcurrencyTag>(sorted.grid, sorted.points, radius, Local(radius * radius),
                                       progress, numbers, weights);
  return sorted
    .points[std::size_t(std::max_element(numbers.begin(), numbers.end()) - numbers.begin())];
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MOST_CROWDED_PLACE_H
