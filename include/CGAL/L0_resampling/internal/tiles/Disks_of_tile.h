// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DISKS_OF_TILE_H
#define CGAL_L0_RESAMPLING_INTERNAL_DISKS_OF_TILE_H

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Adds up areas of parts of a cloud.
/// \throws std::length_error if 64 bits do not hold the sum, which are 2^33 disks of the radius
inline std::uint64_t sum_of_areas(std::uint64_t a, std::uint64_t b)
{
  if (b > (std::numeric_limits<std::uint64_t>::max)() - a)
    throw std::length_error("l0_resample_tiles: 64 bits do not hold the area of so large a cloud");
  return a + b;
}

/// What areas are relative to, and how sums are built.
struct Disks_of_tile
{
  std::uint64_t units = 0; ///< `Facts_of_cloud::units_of_disks`, of the tile's own
  std::uint64_t number_of_thinned_blocks = 0; ///< blocks of its own cells that are not plain
  /// 1 if all points of the tile's own are outliers, else 0. None was dropped then, as they may be
  /// all of the cloud.
  std::uint64_t keeps_outliers = 0;
};

/// Those of a cloud.
inline Disks_of_tile add_up_disks(const std::vector<Disks_of_tile>& tiles)
{
  Disks_of_tile sum;
  sum.keeps_outliers = std::all_of(tiles.begin(), tiles.end(), [](const Disks_of_tile& tile) {
    return tile.keeps_outliers != 0;
  });
  for (const Disks_of_tile& tile : tiles)
    if (tile.keeps_outliers == sum.keeps_outliers)
    {
      sum.units = sum_of_areas(sum.units, tile.units);
      sum.number_of_thinned_blocks += tile.number_of_thinned_blocks;
    }
  return sum;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DISKS_OF_TILE_H
