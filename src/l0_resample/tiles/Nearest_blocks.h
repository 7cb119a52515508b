// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_NEAREST_BLOCKS_H
#define L0_RESAMPLE_NEAREST_BLOCKS_H

#include <CGAL/L0_resampling/Tile_counts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace l0_tool {

using CGAL::L0_resampling::Block;
using CGAL::L0_resampling::Block_box;

/// Tells by the numbers of points alone which blocks of a cloud can hold one of the points nearest
/// to a place. Lengths are in sides of blocks.
class Nearest_blocks
{
  using Counted_block = std::pair<Block, std::uint64_t>;

  const std::vector<Counted_block>& m_blocks;
  std::uint64_t m_number_of_nearest;
  std::uint64_t m_number_of_points = 0;

  /// Of any place of one block and any of the other.
  static double square_of_largest_distance(const Block& a, const Block& b)
  {
    double sum = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
      const double distance = double(std::abs(a[axis] - b[axis]) + 1);
      sum += distance * distance;
    }
    return sum;
  }

  static double square_of_least_distance(const Block& a, const Block& b)
  {
    double sum = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
      const double distance = double((std::max)(std::abs(a[axis] - b[axis]) - 1, std::int64_t(0)));
      sum += distance * distance;
    }
    return sum;
  }

  /// The first block from `block` on, in lexicographic order, that the box can hold.
  static Block next_in_box(Block block, const Block_box& box)
  {
    for (std::size_t axis = 1; axis < block.size(); ++axis) {
      if (block[axis] >= box.low[axis] && block[axis] <= box.high[axis])
        continue;
      if (block[axis] > box.high[axis]) {
        ++block[axis - 1];
        if (axis == 2 && block[1] > box.high[1]) {
          ++block[0];
          block[1] = box.low[1];
        }
      }
      for (std::size_t rest = axis; rest < block.size(); ++rest)
        block[rest] = box.low[rest];
      break;
    }
    return block;
  }

  /// Calls `f(i)` for each block in the box.
  template <typename F>
  void for_each_in(const Block_box& box, const F& f) const
  {
    const auto from = [&](const Block& block) {
      return std::partition_point(m_blocks.begin(), m_blocks.end(),
                                  [&](const Counted_block& b) { return b.first < block; });
    };
    for (auto it = from(box.low); it != m_blocks.end() && it->first[0] <= box.high[0];)
      if (box.contains(it->first))
        f(std::size_t(it++ - m_blocks.begin()));
      else
        it = from(next_in_box(it->first, box));
  }

  std::uint64_t number_of_points_in(const Block_box& box) const
  {
    std::uint64_t number = 0;
    for_each_in(box, [&](std::size_t i) { number += m_blocks[i].second; });
    return number;
  }

  /// The square of a distance within which each place of the block has all of its nearest points.
  double square_of_reach(const Block& block) const
  {
    std::int64_t margin = 0;
    while (number_of_points_in(Block_box{block, block}.grown(margin)) < m_number_of_nearest)
      margin = (std::max)(2 * margin, std::int64_t(1));
    // In that box there are enough, though nearer ones may be outside of it.
    std::priority_queue<std::pair<double, std::uint64_t>> nearest; // blocks, the farthest first
    std::uint64_t number = 0;
    for_each_in(Block_box{block, block}.grown(radius_of_box(margin)), [&](std::size_t i) {
      nearest.emplace(square_of_largest_distance(block, m_blocks[i].first), m_blocks[i].second);
      number += m_blocks[i].second;
      for (; number - nearest.top().second >= m_number_of_nearest; nearest.pop())
        number -= nearest.top().second;
    });
    return nearest.top().first;
  }

  /// In whole sides, at least.
  static std::int64_t radius_of_box(std::int64_t margin)
  {
    return std::int64_t(std::ceil(std::sqrt(3.) * double(margin + 1)));
  }

public:
  /// \param blocks that hold points, in lexicographic order; outlive this object
  Nearest_blocks(const std::vector<Counted_block>& blocks, std::uint64_t number_of_nearest)
    : m_blocks(blocks), m_number_of_nearest(number_of_nearest)
  {
    for (const auto& [block, count] : blocks)
      m_number_of_points += count;
  }

  /// Calls `f(i)` for each block that can hold one of the points nearest to a place in `block`, or
  /// one that is as far away as the last of them; for all if there are fewer points.
  template <typename F>
  void for_each(const Block& block, const F& f) const
  {
    if (m_number_of_points < m_number_of_nearest) {
      for (std::size_t i = 0; i < m_blocks.size(); ++i)
        f(i);
      return;
    }
    const double roundings = 1 + 1e-9, reach = square_of_reach(block) * roundings;
    const std::int64_t margin = 1 + std::int64_t(std::ceil(std::sqrt(reach)));
    for_each_in(Block_box{block, block}.grown(margin), [&](std::size_t i) {
      if (square_of_least_distance(block, m_blocks[i].first) <= reach)
        f(i);
    });
  }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_NEAREST_BLOCKS_H
