// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_REGIONS_OF_BLOCKS_H
#define CGAL_L0_RESAMPLING_INTERNAL_REGIONS_OF_BLOCKS_H

#include <CGAL/L0_resampling/internal/tiles/Tiling.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Regions all over a cloud: blocks in their middle, and all blocks around these.
class Regions_of_blocks
{
  const std::vector<std::pair<Block, std::uint64_t>>& m_blocks;
  std::vector<unsigned char> m_are_middle, m_are_read;
  std::uint64_t m_number_of_points = 0;

  void add_around(std::size_t middle, std::uint64_t most_points)
  {
    const Block_box around = Block_box{m_blocks[middle].first, m_blocks[middle].first}.grown(1);
    std::vector<std::size_t> places;
    std::uint64_t number_of_new = 0;
    for (std::size_t b = 0; b < m_blocks.size(); ++b)
      if (around.contains(m_blocks[b].first) && !m_are_read[b])
      {
        places.push_back(b);
        number_of_new += m_blocks[b].second;
      }
    if (m_number_of_points > 0 && m_number_of_points + number_of_new > most_points)
      return;
    m_number_of_points += number_of_new;
    m_are_middle[middle] = 1;
    for (const std::size_t b : places)
      m_are_read[b] = 1;
  }

public:
  static constexpr std::uint64_t number_of_regions = 64;

  /// \param blocks sorted, with their numbers of points; outlive this object
  /// \param most_points of all regions, if that is not less than one has
  Regions_of_blocks(const std::vector<std::pair<Block, std::uint64_t>>& blocks,
                    std::uint64_t most_points)
    : m_blocks(blocks), m_are_middle(blocks.size(), 0), m_are_read(blocks.size(), 0)
  {
    std::uint64_t n = 0;
    for (const auto& [block, count] : blocks)
      n += count;
    // the block of one in so many points, so that places count by their points
    const std::uint64_t stride = (std::max)(n / number_of_regions, std::uint64_t(1));
    std::uint64_t sum = 0, next = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      sum += blocks[b].second;
      if (next >= sum)
        continue;
      add_around(b, most_points);
      next = (sum / stride + 1) * stride;
    }
  }

  std::uint64_t number_of_points() const { return m_number_of_points; }
  bool is_read(std::size_t b) const { return m_are_read[b] != 0; }

  bool is_in_middle(const Block& block) const
  {
    const auto place = std::lower_bound(m_blocks.begin(), m_blocks.end(), block,
                                        [](const auto& counted, const Block& other) {
                                          return counted.first < other;
                                        });
    return place != m_blocks.end() && place->first == block
           && m_are_middle[std::size_t(place - m_blocks.begin())] != 0;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_REGIONS_OF_BLOCKS_H
