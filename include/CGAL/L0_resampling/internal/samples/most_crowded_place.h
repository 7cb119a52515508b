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

#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

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
  const double cell_size = (std::max)(radius, smallest_cell_size);
  const Sorted_queries sorted(ConcurrencyTag(), points, Cell_sizes(cell_size));
  Buffer<Index> numbers = filled_buffer(points.size(), Index(0), points.get_allocator());
  const Local squared_radius = Local(radius * radius);
  const auto make_visitor = [&]() {
    return [&](const Search_grid_3::Range& queries, const Local_points<Local>& candidates,
               const Vector& origin) {
      for (Index q = queries.first; q < queries.second; ++q)
      {
        const Local_vector center = (sorted.points[q] - origin).template cast<Local>();
        Index number = 0;
        for (std::size_t k = 0; k < candidates.indices.size(); ++k)
        {
          const Local dx = candidates.x[k] - center[0], dy = candidates.y[k] - center[1],
                      dz = candidates.z[k] - center[2];
          number += Index(dx * dx + dy * dy + dz * dz < squared_radius);
        }
        numbers[q] = number * candidates.stride;
      }
    };
  };
  for_each_cell<Local, ConcurrencyTag>(sorted.grid, sorted.points, sorted.grid, sorted.points,
                                       cells_in_reach(radius, cell_size), progress, make_visitor);
  return sorted
    .points[std::size_t(std::max_element(numbers.begin(), numbers.end()) - numbers.begin())];
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MOST_CROWDED_PLACE_H
