// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_BLOCKS_OF_TILE_H
#define CGAL_L0_RESAMPLING_INTERNAL_BLOCKS_OF_TILE_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>
#include <CGAL/L0_resampling/internal/tiles/Counted_cloud.h>
#include <CGAL/L0_resampling/internal/tiles/Tiling.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The blocks of a tile and its halo.
class Blocks_of_tile
{
  const Counted_cloud& m_cloud;
  const Tile& m_tile;
  Block_box m_reach;

  /// Calls `f(block, count, first)` for each block in their order, with the number of its points
  /// and of those in all blocks of the cloud before.
  template <typename F>
  void for_each(const F& f) const
  {
    std::uint64_t first = 0;
    for (const auto& [block, count] : m_cloud.blocks())
    {
      if (m_reach.contains(block))
        f(block, count, first);
      first += count;
    }
  }

public:
  Blocks_of_tile(const Counted_cloud& cloud, const Tile& tile, std::int64_t halo)
    : m_cloud(cloud), m_tile(tile), m_reach(tile.box.grown(halo))
  {}

  std::size_t number_of_points() const { return std::size_t(m_tile.number_of_points_with_halo); }

  /// Appends all points at once, in the order of the source.
  template <typename Source>
  void read_at_once(const Source& source, Buffer<Vector>& points) const
  {
    points.reserve(number_of_points());
    m_cloud.read(source, m_reach, points);
  }

  /// The same, block by block: in the order of `ranges()`.
  template <typename Source>
  void read_by_blocks(const Source& source, Buffer<Vector>& points) const
  {
    points.reserve(number_of_points());
    for_each([&](const Block& block, std::uint64_t, std::uint64_t) {
      m_cloud.read(source, {block, block}, points);
    });
    if (points.size() != number_of_points())
      throw std::invalid_argument("l0_resample_tiles: the source has changed");
  }

  /// Where the points stand among those of the cloud, block after block: the first of each block,
  /// and how many these are.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges() const
  {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges;
    for_each([&](const Block&, std::uint64_t count, std::uint64_t first) {
      ranges.emplace_back(first, count);
    });
    return ranges;
  }

  /// Notes which of the points, in the order of `ranges()`, the tile keeps the samples of.
  void mark_own(Buffer<Point_in_cloud>& points) const
  {
    auto point = points.begin();
    for_each([&](const Block& block, std::uint64_t count, std::uint64_t) {
      const bool is_own = m_tile.box.contains(block);
      for (const auto end = point + std::ptrdiff_t(count); point != end; ++point)
        point->is_own = is_own;
    });
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_BLOCKS_OF_TILE_H
