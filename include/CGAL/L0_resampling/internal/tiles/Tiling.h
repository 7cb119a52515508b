// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TILING_H
#define CGAL_L0_RESAMPLING_INTERNAL_TILING_H

#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/Tile_counts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The same box in the unit of the input.
inline Source_box source_box_of(const Block_lattice& lattice, const Block_box& box)
{
  Source_box source;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    source.low[axis] = double(box.low[axis]) * lattice.side();
    source.high[axis] = double(box.high[axis] + 1) * lattice.side();
  }
  return source;
}

/// What a tile and its halo take: for each point, and for the samples among them. How many these
/// are is not known before the tiles are: as many as their share of all points says, or, if samples
/// are even, as their share of the area, whichever is more.
struct Bytes_of_tile
{
  double per_point;            ///< with its share of the samples
  double per_point_alone = 0;  ///< without samples
  double per_area = 0;         ///< of the samples, for each unit of `area_of()`
  double per_point_before = 0; ///< before there are samples

  /// Of a block with so many points, roughly: a block that is full of a surface has as much as any
  /// other, and one with a few outliers little.
  static double area_of(std::uint64_t number_of_points)
  {
    return double((std::min)(number_of_points, std::uint64_t(16)));
  }

  /// \param of_samples bytes of all samples of the cloud
  /// \param are_even whether they are spread by area, and not as the points
  static Bytes_of_tile of_cloud(const std::vector<std::pair<Block, std::uint64_t>>& blocks,
                                double per_point, double of_samples, bool are_even)
  {
    double number_of_points = 0, area = 0;
    for (const auto& [block, count] : blocks)
    {
      number_of_points += double(count);
      area += area_of(count);
    }
    Bytes_of_tile bytes = {per_point + of_samples / number_of_points};
    if (are_even)
    {
      bytes.per_point_alone = per_point;
      bytes.per_area = of_samples / area;
    }
    return bytes;
  }

  double operator()(double number_of_points, double area) const
  {
    return (std::max)({number_of_points * per_point,
                       number_of_points * per_point_alone + area * per_area,
                       number_of_points * per_point_before});
  }
};

/// Splits the blocks that hold points into boxes, each of which with its halo takes no more than a
/// task may. Boxes are halved by points across their longest axis.
class Tiling
{
  using Counted_block = std::pair<Block, std::uint64_t>;

  const std::vector<Counted_block>& m_blocks;
  std::int64_t m_halo;
  Bytes_of_tile m_bytes_of;
  double m_maximum_bytes;
  std::vector<Tile> m_tiles;
  double m_minimum_limit = 0;

  Tile tile_of(const std::vector<std::size_t>& own) const
  {
    Tile tile = {{m_blocks[own.front()].first, m_blocks[own.front()].first}, 0, 0};
    for (const std::size_t i : own)
    {
      const auto& [block, count] = m_blocks[i];
      tile.number_of_points += count;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        tile.box.low[axis] = (std::min)(tile.box.low[axis], block[axis]);
        tile.box.high[axis] = (std::max)(tile.box.high[axis], block[axis]);
      }
    }
    const Block_box reach = tile.box.grown(m_halo);
    for (const auto& [block, count] : m_blocks)
      tile.number_of_points_with_halo += reach.contains(block) ? count : 0;
    return tile;
  }

  double bytes_of(const Tile& tile) const
  {
    const Block_box reach = tile.box.grown(m_halo);
    double area = 0;
    for (const auto& [block, count] : m_blocks)
      area += reach.contains(block) ? Bytes_of_tile::area_of(count) : 0;
    return m_bytes_of(double(tile.number_of_points_with_halo), area);
  }

  void split(std::vector<std::size_t> own)
  {
    const Tile tile = tile_of(own);
    std::size_t axis = 0;
    const auto length = [&](std::size_t a) { return tile.box.high[a] - tile.box.low[a]; };
    for (std::size_t other = 1; other < 3; ++other)
      if (length(other) > length(axis))
        axis = other;
    const double bytes = bytes_of(tile);
    if (bytes <= m_maximum_bytes || length(axis) == 0)
    {
      m_minimum_limit = (std::max)(m_minimum_limit, bytes);
      m_tiles.push_back(tile);
      return;
    }
    // the first layer of the upper half
    const auto place = [&](std::size_t i) { return m_blocks[i].first[axis]; };
    std::sort(own.begin(), own.end(), [&](std::size_t a, std::size_t b) {
      return place(a) != place(b) ? place(a) < place(b) : a < b;
    });
    std::uint64_t sum = 0;
    std::size_t k = 0;
    while (2 * sum < tile.number_of_points)
      sum += m_blocks[own[k++]].second;
    std::int64_t layer = place(own[k - 1]) + 1;
    layer = (std::min)(layer, tile.box.high[axis]);
    const auto middle = std::partition_point(own.begin(), own.end(),
                                             [&](std::size_t i) { return place(i) < layer; });
    std::vector<std::size_t> lower(own.begin(), middle), upper(middle, own.end());
    own = {};
    std::sort(lower.begin(), lower.end());
    split(std::move(lower));
    std::sort(upper.begin(), upper.end());
    split(std::move(upper));
  }

public:
  /// \param blocks sorted, at least one; outlives this object
  /// \param halo in blocks
  Tiling(const std::vector<Counted_block>& blocks, std::int64_t halo, const Bytes_of_tile& bytes_of,
         double maximum_bytes)
    : m_blocks(blocks), m_halo(halo), m_bytes_of(bytes_of), m_maximum_bytes(maximum_bytes)
  {
    std::vector<std::size_t> all(blocks.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    split(std::move(all));
  }

  const std::vector<Tile>& tiles() const { return m_tiles; }

  /// Of the largest tile with its halo: more than the limit if a single block takes more.
  double maximum_bytes_of_tile() const { return m_minimum_limit; }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TILING_H
