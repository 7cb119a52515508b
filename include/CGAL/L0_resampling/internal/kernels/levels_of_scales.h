// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_LEVELS_OF_SCALES_H
#define CGAL_L0_RESAMPLING_INTERNAL_LEVELS_OF_SCALES_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// The scale of a point is its radius, per r_p. Points of similar scales share the cells of a level.

/// Levels are numbered from 0. Cells of one are \f$ \sqrt 2 \f$ times as large as those of the one
/// before.
constexpr int number_of_levels = 16;

/// The level of scale 1, whose cells are as large as the grid says.
constexpr int level_of_one = 10;

/// The least and the largest scale: all have a level.
constexpr float minimum_scale = 0x1p-5f, maximum_scale = 5.6f;

/// How many levels up and down a query looks: to scales of a third and of three times its own.
/// Within four radii scales differ by less, see `slope_of_scales`.
constexpr int levels_in_reach = 3;

/// The size of the cells of a level, per that of those of scale 1.
CGAL_L0_HOST_DEVICE inline double size_of_cells(int level)
{
  const int steps = level - level_of_one;
  return std::ldexp(steps % 2 == 0 ? 1 : 1.4142135623730951, (steps - (steps & 1)) / 2);
}

/// The level whose cells are at least as large as the scale, and the smallest such.
CGAL_L0_HOST_DEVICE inline int level_of_scale(double scale)
{
  int level = 0;
  double size = size_of_cells(0), next_size = size_of_cells(1);
  while (level + 1 < number_of_levels && size < scale)
  {
    const double size_after_next = 2 * size;
    size = next_size;
    next_size = size_after_next;
    ++level;
  }
  return level;
}

/// The least, the middle and the largest scale of a cloud.
struct Range_of_scales
{
  float least = 1, median = 1, largest = 1;

  /// Whether all scales are 1, so that no point needs one of its own.
  bool is_one() const { return least == 1 && largest == 1; }
};

/// The scales of some points or samples, which are all 1 if none are given.
struct Scales_view
{
  const float* values = nullptr;

  CGAL_L0_HOST_DEVICE float operator[](std::uint64_t i) const { return values ? values[i] : 1.f; }

  /// Of a pair: within reach of each other they differ little.
  CGAL_L0_HOST_DEVICE float squared_of_pair(std::uint64_t i, std::uint64_t k) const
  {
    return values ? values[i] * values[k] : 1.f;
  }
  CGAL_L0_HOST_DEVICE float smaller_of_pair(std::uint64_t i, std::uint64_t k) const
  {
    return !values ? 1.f : values[i] < values[k] ? values[i] : values[k];
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_LEVELS_OF_SCALES_H
