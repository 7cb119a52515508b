// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_COUNTED_CLOUD_H
#define CGAL_L0_RESAMPLING_INTERNAL_COUNTED_CLOUD_H

#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/Tile_counts.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>
#include <CGAL/L0_resampling/internal/tiles/Tiling.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A cloud that is not in memory: how many points each block has, and what that tells.
class Counted_cloud
{
  Block_lattice m_lattice;
  std::vector<std::pair<Block, std::uint64_t>> m_blocks;
  std::array<double, 3> m_low, m_high;
  std::uint64_t m_number_of_points;

public:
  explicit Counted_cloud(Tile_counts counts)
  {
    counts.finish();
    m_lattice = counts.lattice();
    m_blocks = counts.blocks();
    m_low = counts.low();
    m_high = counts.high();
    m_number_of_points = counts.number_of_points();
  }

  const Block_lattice& lattice() const { return m_lattice; }
  const std::vector<std::pair<Block, std::uint64_t>>& blocks() const { return m_blocks; }
  std::uint64_t number_of_points() const { return m_number_of_points; }
  const std::array<double, 3>& low() const { return m_low; }
  const std::array<double, 3>& high() const { return m_high; }

  /// So many blocks around a tile hold what is within a length of it.
  std::int64_t halo_in_blocks(double length) const
  {
    const double roundings = 1 + 1e-6, most = 1e6; // no tile is as wide
    return std::int64_t(std::ceil((std::min)(length * roundings / m_lattice.side(), most)));
  }

  /// Of all blocks; there is one at least.
  Block_box box() const
  {
    Block_box box = {m_blocks.front().first, m_blocks.front().first};
    for (const auto& [block, count] : m_blocks)
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        box.low[axis] = (std::min)(box.low[axis], block[axis]);
        box.high[axis] = (std::max)(box.high[axis], block[axis]);
      }
    return box;
  }

  Source_box source_box(const Block_box& box) const { return source_box_of(m_lattice, box); }

  /// Appends the points of some blocks.
  template <typename Source>
  void read(const Source& source, const Block_box& box, Buffer<Vector>& points) const
  {
    source.for_each_point(source_box(box), [&](const std::array<double, 3>& p) {
      points.push_back(Vector(p[0], p[1], p[2]));
    });
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_COUNTED_CLOUD_H
