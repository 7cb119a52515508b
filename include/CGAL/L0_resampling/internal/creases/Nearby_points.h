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
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Points in cells, for the few that creases have: those within a radius are called in the order
/// of their cells, and within a cell of their indices.
class Nearby_points
{
  using Cell = std::array<long, 3>; // z first, so that cells along x follow each other
  using Point_in_cell = std::pair<Cell, std::size_t>;

  const std::vector<Vector>& m_points; // the caller keeps them
  double m_cell_size;
  std::vector<Point_in_cell> m_points_in_cells; // ascending

  long place(double coordinate) const { return long(std::floor(coordinate / m_cell_size)); }

public:
  Nearby_points(const std::vector<Vector>& points, double cell_size)
    : m_points(points), m_cell_size(cell_size)
  {
    m_points_in_cells.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      m_points_in_cells.push_back(
        {{place(points[i].z()), place(points[i].y()), place(points[i].x())}, i});
    std::sort(m_points_in_cells.begin(), m_points_in_cells.end());
  }

  /// Calls `f(i)` for each point nearer than `radius`.
  template <typename F>
  void for_each_near(const Vector& center, double radius, const F& f) const
  {
    const auto first = [&](int axis) { return place(center[axis] - radius); };
    const auto last = [&](int axis) { return place(center[axis] + radius); };
    for (long z = first(2); z <= last(2); ++z)
      for (long y = first(1); y <= last(1); ++y)
      {
        const Cell last_of_row = {z, y, last(0)};
        for (auto i = std::lower_bound(m_points_in_cells.begin(), m_points_in_cells.end(),
                                       Point_in_cell({z, y, first(0)}, 0));
             i != m_points_in_cells.end() && i->first <= last_of_row; ++i)
          if ((m_points[i->second] - center).squaredNorm() < radius * radius)
            f(i->second);
      }
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
