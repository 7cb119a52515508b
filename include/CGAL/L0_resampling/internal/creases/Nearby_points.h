// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEARBY_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEARBY_POINTS_H

#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Points in cells, for the few that creases have: those within a radius are called in the order
/// of their cells, and within a cell of their indices.
class Nearby_points
{
  using Cell = std::tuple<long, long, long>; // z first, so that cells along x follow each other

  const std::vector<Vector>& m_points; // the caller keeps them
  double m_cell_size;
  std::map<Cell, std::vector<std::size_t>> m_cells;

  long place(double coordinate) const { return long(std::floor(coordinate / m_cell_size)); }

public:
  Nearby_points(const std::vector<Vector>& points, double cell_size)
    : m_points(points), m_cell_size(cell_size)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      m_cells[{place(points[i].z()), place(points[i].y()), place(points[i].x())}].push_back(i);
  }

  /// Calls `f(i)` for each point nearer than `radius`.
  template <typename F>
  void for_each_near(const Vector& center, double radius, const F& f) const
  {
    const auto first = [&](int axis) { return place(center[axis] - radius); };
    const auto last = [&](int axis) { return place(center[axis] + radius); };
    for (long z = first(2); z <= last(2); ++z)
      for (long y = first(1); y <= last(1); ++y)
        for (auto cell = m_cells.lower_bound({z, y, first(0)}),
                  end = m_cells.upper_bound({z, y, last(0)});
             cell != end; ++cell)
          for (std::size_t i : cell->second)
            if ((m_points[i] - center).squaredNorm() < radius * radius)
              f(i);
  }

  bool has_near(const Vector& center, double radius) const
  {
    bool found = false;
    for_each_near(center, radius, [&](std::size_t) { found = true; });
    return found;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEARBY_POINTS_H
