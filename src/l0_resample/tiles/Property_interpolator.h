// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PROPERTY_INTERPOLATOR_H
#define L0_RESAMPLE_PROPERTY_INTERPOLATOR_H

#include "basis/Property_table.h"
#include "tiles/Nearest_blocks.h"
#include "tiles/Shard.h"

#include <CGAL/L0_resampling/Tile_counts.h>
#include <CGAL/L0_resampling/Tile_stitching.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace l0_tool {

using CGAL::L0_resampling::Bytes_of_call;
using CGAL::L0_resampling::Tile_sample;

/*!
Gives samples the properties of the points near to them, as a call for all of the cloud in memory
does with all files one after the other: by the nearest points, wherever these are, and where
distances are equal, by their order in the files.
*/
class Property_interpolator
{
  using Counted_blocks = std::vector<std::pair<Block, std::uint64_t>>;

  const Shards& m_shards;
  std::vector<std::string> m_paths_of_rows; // of the shards
  std::uint64_t m_key;
  Block_lattice m_lattice;
  const Counted_blocks& m_blocks;
  Nearest_blocks m_nearest_blocks;
  Property_table m_properties; // without rows
  std::uint64_t m_memory;

  const std::vector<Tile_sample>* m_samples = nullptr;
  std::vector<std::pair<Block, std::uint32_t>> m_order; // of the samples, by blocks
  std::vector<char> m_result;                           // rows of all samples
  std::size_t m_number_done = 0;
  std::function<void(double)> m_on_progress;

  struct Points;

  void carry_to(std::size_t begin, std::size_t end);
  void carry_from(Points points, std::size_t begin, std::size_t end);
  std::size_t middle_of(std::size_t begin, std::size_t end) const;
  std::vector<char> blocks_near(std::size_t begin, std::size_t end) const;
  Points read(const std::vector<char>& wanted, std::size_t number_of_points) const;

public:
  /// What it holds for each point and sample at most.
  /// \param row_size of the properties, in bytes
  static Bytes_of_call bytes_of_call(std::size_t row_size)
  {
    return {88 + row_size, 160 + 2 * row_size};
  }

  /// \param shards outlive this object, and so do `blocks`
  /// \param paths_of_rows of the shards
  /// \param blocks that hold points, in their order
  /// \param properties without rows
  /// \param memory in bytes
  Property_interpolator(const Shards& shards, const std::vector<std::string>& paths_of_rows,
                        std::uint64_t key, const Block_lattice& lattice,
                        const Counted_blocks& blocks, const Property_table& properties,
                        std::uint64_t memory);

  /// \param on_progress gets the share that is done
  /// \returns the rows of all samples, in their order
  std::vector<char> carry(const std::vector<Tile_sample>& samples,
                          const std::function<void(double)>& on_progress);
};

} // namespace l0_tool

#endif // L0_RESAMPLE_PROPERTY_INTERPOLATOR_H
