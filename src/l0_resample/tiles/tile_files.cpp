// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/tile_files.h"

#include "tiles/Shard.h"
#include "tiles/Task_file.h"

#include <array>
#include <cstddef>
#include <utility>

namespace l0_tool {

void write_counts(const std::string& path, std::uint64_t key, const Counted_input& input)
{
  std::vector<Block_run> blocks;
  for (const auto& [block, count] : input.counts.blocks())
    blocks.push_back({block, 0, count});
  Task_file_writer file(path, key);
  file.write(input.counts.lattice().exponent());
  file.write(input.counts.low());
  file.write(input.counts.high());
  file.write(input.number_of_dropped);
  file.write_all(blocks);
  file.commit();
}

Counted_input read_counts(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  const int exponent = file.read<int>();
  const auto low = file.read<std::array<double, 3>>(), high = file.read<std::array<double, 3>>();
  const std::uint64_t number_of_dropped = file.read<std::uint64_t>();
  std::vector<std::pair<Block, std::uint64_t>> blocks;
  for (const Block_run& counted : file.read_all<Block_run>())
    blocks.emplace_back(counted.block, counted.count);
  return {Block_counts(exponent, blocks, low, high), number_of_dropped};
}

void write_found(const std::string& path, std::uint64_t key,
                 const std::vector<Tile_sample>& samples, const Found_in_tile& found)
{
  Task_file_writer file(path, key);
  file.write_all(samples);
  file.write(found.summary);
  file.write_all(found.evidence);
  file.write_all(found.near_border);
  file.write_all(found.beyond_border);
  file.commit();
}

Found_in_tile read_found(const std::string& path, std::uint64_t key, bool with_border)
{
  Task_file file(path, key);
  file.seek(sizeof(std::uint64_t) + file.read<std::uint64_t>() * sizeof(Tile_sample));
  Found_in_tile found;
  found.summary = file.read<Summary_of_tile>();
  found.evidence = file.read_all<double>();
  if (with_border) {
    found.near_border = file.read_all<Tile_sample>();
    found.beyond_border = file.read_all<Tile_sample>();
  }
  return found;
}

void write_signs(const std::string& path, std::uint64_t key, const Signs_of_tiles& signs)
{
  Task_file_writer file(path, key);
  file.write_all(signs.summaries);
  file.write(signs.seams);
  for (const std::vector<signed char>& of_tile : signs.signs)
    file.write_all(of_tile);
  file.commit();
}

Signs_of_tiles read_signs(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  Signs_of_tiles result;
  result.summaries = file.read_all<Summary_of_tile>();
  result.seams = file.read<Seam_report>();
  for (std::size_t tile = 0; tile < result.summaries.size(); ++tile)
    result.signs.push_back(file.read_all<signed char>());
  return result;
}

} // namespace l0_tool
