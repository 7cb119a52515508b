// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_TEST_POINTS_IN_MEMORY_H
#define L0_TEST_POINTS_IN_MEMORY_H

#include "test_support.h"

#include <CGAL/l0_resample_tiles.h>

#include <array>
#include <cstddef>
#include <vector>

namespace test {

using Place = std::array<double, 3>;

/// A model of `L0ResamplingTileSource`.
struct Points_in_memory
{
  std::vector<Place> points;

  template <typename F>
  void for_each_point(const CGAL::L0_resampling::Source_box& box, const F& f) const
  {
    for (const Place& p : points)
    {
      bool is_inside = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        is_inside = is_inside && p[axis] >= box.low[axis] && p[axis] < box.high[axis];
      if (is_inside)
        f(p);
    }
  }
};

} // namespace test

#endif // L0_TEST_POINTS_IN_MEMORY_H
