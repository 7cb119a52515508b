// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_TEST_POINTS_IN_MEMORY_H
#define L0_TEST_POINTS_IN_MEMORY_H

#include "test_support.h"

#include <CGAL/l0_resample_tiles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace test {

using Place = std::array<double, 3>;

/// A cloud as a source of tiles. Points come in the order that they were given in.
class Points_in_memory
{
  std::vector<std::size_t> m_by_x; // the indices of the points, by their first coordinate

public:
  const std::vector<Place> points;

  explicit Points_in_memory(std::vector<Place> places = {})
    : m_by_x(places.size()), points(std::move(places))
  {
    std::iota(m_by_x.begin(), m_by_x.end(), std::size_t(0));
    std::stable_sort(m_by_x.begin(), m_by_x.end(),
                     [&](std::size_t a, std::size_t b) { return points[a][0] < points[b][0]; });
  }

  template <typename F>
  void for_each_point(const CGAL::L0_resampling::Source_box& box, const F& f) const
  {
    const auto first_from = [&](double x) {
      return std::partition_point(m_by_x.begin(), m_by_x.end(),
                                  [&](std::size_t i) { return points[i][0] < x; });
    };
    std::vector<std::size_t> inside(first_from(box.low[0]), first_from(box.high[0]));
    const auto is_outside = [&](std::size_t i) {
      const Place& p = points[i];
      return p[1] < box.low[1] || p[1] >= box.high[1] || p[2] < box.low[2] || p[2] >= box.high[2];
    };
    inside.erase(std::remove_if(inside.begin(), inside.end(), is_outside), inside.end());
    std::sort(inside.begin(), inside.end());
    for (const std::size_t i : inside)
      f(points[i]);
  }
};

inline CGAL::L0_resampling::Tile_counts counts_of(const std::vector<Place>& points)
{
  CGAL::L0_resampling::Tile_counts counts;
  for (const Place& p : points)
    counts.add(p);
  return counts;
}

} // namespace test

#endif // L0_TEST_POINTS_IN_MEMORY_H
