// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_SHARD_H
#define L0_RESAMPLE_SHARD_H

#include "tiles/Task_file.h"

#include <CGAL/L0_resampling/Tile_counts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace l0_tool {

using CGAL::L0_resampling::Block;
using CGAL::L0_resampling::Block_lattice;

/// Where points of a block stand in a shard.
struct Block_run
{
  Block block;
  std::uint64_t first, count;
};

template <>
struct Is_plain<Block_run>
  : std::bool_constant<is_made_of(&Block_run::block, &Block_run::first, &Block_run::count)>
{};

/// Writes the points of an input sorted by blocks: in runs, each of as many points as memory holds.
/// What goes along with the points is in a file of its own, which only the task `carry` reads: for
/// each point the number that it has in the input, in 8 bytes, and its row of properties.
class Shard_writer
{
  Task_file_writer m_file;
  std::unique_ptr<Task_file_writer> m_file_of_rows; // if there are properties
  Block_lattice m_lattice;
  std::size_t m_row_size, m_maximum_number_of_points;
  // Of a run, in the order of the input
  std::vector<std::array<double, 3>> m_points;
  std::vector<std::uint32_t> m_block_numbers; // of the points
  std::vector<char> m_rows;
  std::map<Block, std::uint32_t> m_blocks; // and the number of each, as they came
  std::vector<std::uint32_t> m_counts;     // of the points in them
  Block m_last_block = {};
  std::vector<Block_run> m_runs;
  std::uint64_t m_number_of_points = 0;

  static constexpr std::size_t bytes_per_point = sizeof(std::array<double, 3>)
                                                 + 2 * sizeof(std::uint32_t); // and its row

  void write_run();

public:
  /// Of a run. Longer ones would hardly be read any faster.
  static constexpr std::uint64_t maximum_bytes = std::uint64_t(1) << 30;

  /// \param path_of_rows not used if these are empty
  /// \param row_size of the properties of a point, in bytes
  /// \param bytes that a run may take, of which it takes no more than `maximum_bytes`
  Shard_writer(const std::string& path, const std::string& path_of_rows, std::uint64_t key,
               const Block_lattice& lattice, std::size_t row_size, std::uint64_t bytes);

  /// \param row of `row_size` bytes
  void add(const std::array<double, 3>& point, const std::vector<char>& row);
  void commit();
};

/// The points of all shards of a run: a model of `L0ResamplingTileSource`, for several threads at
/// once.
class Shards
{
  struct Shard
  {
    std::unique_ptr<Task_file> file;
    std::vector<Block_run> runs; // sorted by block
  };

  Block_lattice m_lattice;
  std::vector<Shard> m_shards;

public:
  Shards(const std::vector<std::string>& paths, std::uint64_t key, const Block_lattice& lattice);

  /// \param box whose sides are sides of blocks
  template <typename Box, typename F>
  void for_each_point(const Box& box, const F& f) const
  {
    const Block low = m_lattice.block_of(box.low), end = m_lattice.block_of(box.high);
    if (low[0] >= end[0] || low[1] >= end[1] || low[2] >= end[2])
      return;
    for (const Shard& shard : m_shards)
      for_each_run(shard, low, end, [&](const std::vector<std::array<double, 3>>& points) {
        for (const std::array<double, 3>& point : points)
          f(point);
      });
  }

  std::size_t size() const { return m_shards.size(); }

  /// Calls `f(run, points)` for each run of a shard in blocks that are asked for.
  /// \param low the first of these blocks in lexicographic order, and `last` the last
  template <typename IsWanted, typename F>
  void for_each_run_of(std::size_t shard, const Block& low, const Block& last,
                       const IsWanted& is_wanted, const F& f) const
  {
    std::vector<std::array<double, 3>> points;
    for (auto run = first_run(m_shards[shard].runs, low);
         run != m_shards[shard].runs.end() && !(last < run->block); ++run)
      if (is_wanted(run->block)) {
        read(*run, m_shards[shard], points);
        f(*run, points);
      }
  }

private:
  template <typename F>
  static void for_each_run(const Shard& shard, const Block& low, const Block& end, const F& f)
  {
    std::vector<std::array<double, 3>> points;
    const Block last = {end[0] - 1, end[1] - 1, end[2] - 1};
    for (auto run = first_run(shard.runs, low); run != shard.runs.end() && run->block <= last;
         ++run) {
      const Block& block = run->block;
      if (block[1] < low[1] || block[1] > last[1] || block[2] < low[2] || block[2] > last[2])
        continue;
      read(*run, shard, points);
      f(points);
    }
  }

  static std::vector<Block_run>::const_iterator first_run(const std::vector<Block_run>& runs,
                                                          const Block& low);
  static void read(const Block_run& run, const Shard& shard,
                   std::vector<std::array<double, 3>>& points);
};

} // namespace l0_tool

#endif // L0_RESAMPLE_SHARD_H
