// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/tile_files.h"

#include "tiles/Shard.h"
#include "tiles/Task_file.h"

#include <CGAL/L0_resampling/Tile_archive.h>

#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace l0_tool {

template <>
struct Is_plain<Summary_of_tile>
  : std::bool_constant<is_made_of(&Summary_of_tile::findings, &Summary_of_tile::seconds)>
{};
template <>
struct Is_plain<Moved_sample>
  : std::bool_constant<is_made_of(&Moved_sample::place, &Moved_sample::position,
                                  &Moved_sample::normal, &Moved_sample::mark)>
{};
namespace {

using CGAL::L0_resampling::read_tile_value;
using CGAL::L0_resampling::write_tile_value;

constexpr std::uint64_t begin_of_points = sizeof(std::uint64_t); // after their number

template <typename Value>
void write_value(const std::string& path, std::uint64_t key, const Value& value)
{
  Task_file_writer file(path, key);
  write_tile_value(file, value);
  file.commit();
}

template <typename Value>
Value read_value(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  return read_tile_value<Value>(file);
}

} // namespace

void write_facts(const std::string& path, std::uint64_t key, const Facts_of_run& facts)
{
  Task_file_writer file(path, key);
  file.write(facts.memory_of_tile);
  write_tile_value(file, facts.of_cloud);
  file.commit();
}

Facts_of_run read_facts(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  Facts_of_run facts;
  facts.memory_of_tile = file.read<std::uint64_t>();
  facts.of_cloud = read_tile_value<Tiled_on_cpu::Facts>(file);
  return facts;
}

void write_points_in_cloud(const std::string& path, std::uint64_t key,
                           const Tiled_on_cpu::Array<Tiled_on_cpu::Point_facts>& points)
{
  write_value(path, key, points);
}

Tiled_on_cpu::Array<Tiled_on_cpu::Point_facts> read_points_in_cloud(
  const std::string& path, std::uint64_t key,
  const std::vector<std::pair<std::uint64_t, std::uint64_t>>& ranges)
{
  const Task_file file(path, key);
  std::uint64_t number = 0;
  for (const auto& range : ranges)
    number += range.second;
  Tiled_on_cpu::Array<Tiled_on_cpu::Point_facts> points, of_range;
  points.reserve(static_cast<std::size_t>(number));
  for (const auto& [first, count] : ranges) {
    file.read_some(begin_of_points, first, count, of_range);
    points.insert(points.end(), of_range.begin(), of_range.end());
  }
  return points;
}

void write_neighbors(const std::string& path, std::uint64_t key,
                     const Tiled_on_cpu::Neighbors& found)
{
  write_value(path, key, found);
}

Tiled_on_cpu::Neighbor_counts read_neighbor_counts(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  file.skip_all<float>();
  return read_tile_value<Tiled_on_cpu::Neighbor_counts>(file);
}

Tiled_on_cpu::Array<float> read_scales(const std::string& path, std::uint64_t key)
{
  return read_value<Tiled_on_cpu::Array<float>>(path, key);
}

void write_medians(const std::string& path, std::uint64_t key, const Tiled_on_cpu::Medians& medians)
{
  write_value(path, key, medians);
}

Tiled_on_cpu::Medians read_medians(const std::string& path, std::uint64_t key)
{
  return read_value<Tiled_on_cpu::Medians>(path, key);
}

void write_points_of_tile(const std::string& path, std::uint64_t key,
                          const Tiled_on_cpu::Points& points)
{
  Task_file_writer file(path, key);
  write_tile_value(file, points.disks); // once more, for who reads nothing else
  write_tile_value(file, points);
  file.commit();
}

Tiled_on_cpu::Disks read_disks(const std::string& path, std::uint64_t key)
{
  return read_value<Tiled_on_cpu::Disks>(path, key);
}

Tiled_on_cpu::Points read_points_of_tile(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  read_tile_value<Tiled_on_cpu::Disks>(file);
  return read_tile_value<Tiled_on_cpu::Points>(file);
}

void write_share(const std::string& path, std::uint64_t key, const Tiled_on_cpu::Share& share)
{
  write_value(path, key, share);
}

Tiled_on_cpu::Share read_share(const std::string& path, std::uint64_t key)
{
  return read_value<Tiled_on_cpu::Share>(path, key);
}

void write_starts(const std::string& path, std::uint64_t key, const Tiled_on_cpu::Sums& sums,
                  const std::vector<Tiled_on_cpu::Share>& shares)
{
  Task_file_writer file(path, key);
  write_tile_value(file, sums);
  for (const Tiled_on_cpu::Share& share : shares)
    write_tile_value(file, share.runs);
  file.commit();
}

Tiled_on_cpu::Sums read_sums(const std::string& path, std::uint64_t key)
{
  return read_value<Tiled_on_cpu::Sums>(path, key);
}

std::vector<Tiled_on_cpu::Run> read_starts(const std::string& path, std::uint64_t key,
                                           std::size_t tile)
{
  Task_file file(path, key);
  read_tile_value<Tiled_on_cpu::Sums>(file);
  for (std::size_t before = 0; before < tile; ++before)
    file.skip_all<Tiled_on_cpu::Run>();
  std::vector<Tiled_on_cpu::Run> runs;
  file.read_all(runs);
  return runs;
}

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
  write_tile_value(file, input.viewpoint);
  file.write_all(blocks);
  write_properties(input.properties, file);
  file.commit();
}

Counted_input read_counts(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  const int exponent = file.read<int>();
  const auto low = file.read<std::array<double, 3>>(), high = file.read<std::array<double, 3>>();
  const std::uint64_t number_of_dropped = file.read<std::uint64_t>();
  const auto viewpoint = read_tile_value<std::optional<std::array<double, 3>>>(file);
  std::vector<std::pair<Block, std::uint64_t>> blocks;
  std::vector<Block_run> all;
  file.read_all(all);
  blocks.reserve(all.size());
  for (const Block_run& counted : all)
    blocks.emplace_back(counted.block, counted.count);
  return {Tile_counts(exponent, blocks, low, high), number_of_dropped, viewpoint,
          read_properties(file)};
}

void write_found(const std::string& path, std::uint64_t key,
                 const std::vector<Tile_sample>& samples, const Found_in_tile& found)
{
  Task_file_writer file(path, key);
  file.write_all(samples);
  file.write(found.summary);
  file.write_all(found.outliers);
  file.write_all(found.evidence);
  file.write_all(found.near_border);
  file.write_all(found.beyond_border);
  write_tile_value(file, found.unoriented);
  file.commit();
}

Found_in_tile read_found(const std::string& path, std::uint64_t key, bool with_border)
{
  Task_file file(path, key);
  file.skip_all<Tile_sample>();
  Found_in_tile found;
  found.summary = file.read<Summary_of_tile>();
  file.skip_all<std::array<double, 3>>();
  file.read_all(found.evidence);
  if (with_border) {
    file.read_all(found.near_border);
    file.read_all(found.beyond_border);
  }
  return found;
}

std::vector<std::array<double, 3>> read_outliers(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  file.skip_all<Tile_sample>();
  file.read<Summary_of_tile>();
  std::vector<std::array<double, 3>> outliers;
  file.read_all(outliers);
  return outliers;
}

Unoriented_samples read_unoriented(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  file.skip_all<Tile_sample>();
  file.read<Summary_of_tile>();
  file.skip_all<std::array<double, 3>>();
  file.skip_all<double>();
  file.skip_all<Tile_sample>();
  file.skip_all<Tile_sample>();
  return read_tile_value<Unoriented_samples>(file);
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

namespace {

/// \param file before the signs then
Signs_of_tiles read_summaries(Task_file& file)
{
  Signs_of_tiles result;
  file.read_all(result.summaries);
  result.seams = file.read<Seam_report>();
  return result;
}

} // namespace

Signs_of_tiles read_signs(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  Signs_of_tiles result = read_summaries(file);
  for (std::size_t tile = 0; tile < result.summaries.size(); ++tile)
    file.read_all(result.signs.emplace_back());
  return result;
}

Signs_of_tiles read_summaries(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  return read_summaries(file);
}

std::vector<signed char> read_signs_of_tile(const std::string& path, std::uint64_t key,
                                            std::size_t tile)
{
  Task_file file(path, key);
  read_summaries(file);
  for (std::size_t before = 0; before < tile; ++before)
    file.skip_all<signed char>();
  std::vector<signed char> signs;
  file.read_all(signs);
  return signs;
}

void write_moved(const std::string& path, std::uint64_t key,
                 const std::vector<std::vector<Moved_sample>>& moved)
{
  Task_file_writer file(path, key);
  for (const std::vector<Moved_sample>& of_tile : moved)
    file.write_all(of_tile);
  file.commit();
}

std::vector<Moved_sample> read_moved_of_tile(const std::string& path, std::uint64_t key,
                                             std::size_t tile)
{
  Task_file file(path, key);
  for (std::size_t before = 0; before < tile; ++before)
    file.skip_all<Moved_sample>();
  std::vector<Moved_sample> moved;
  file.read_all(moved);
  return moved;
}

} // namespace l0_tool
