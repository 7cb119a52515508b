// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/tile_files.h"

#include "tiles/Shard.h"
#include "tiles/Task_file.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace l0_tool {
namespace {

namespace internal = CGAL::L0_resampling::internal;
using internal::Histogram;
using internal::Scale_field;

/// How often a number of a histogram was there.
struct Count_of_number
{
  double number;
  std::uint64_t count;
};

} // namespace

template <>
struct Is_plain<Count_of_number>
  : std::bool_constant<is_made_of(&Count_of_number::number, &Count_of_number::count)>
{};
template <>
struct Is_plain<internal::Scales>
  : std::bool_constant<is_made_of(&internal::Scales::spacing, &internal::Scales::noise)>
{};
template <>
struct Is_plain<internal::Range_of_scales>
  : std::bool_constant<is_made_of(&internal::Range_of_scales::least,
                                  &internal::Range_of_scales::median,
                                  &internal::Range_of_scales::largest)>
{};
template <>
struct Is_plain<internal::Morton_cells>
  : std::bool_constant<is_made_of(&internal::Morton_cells::size)>
{};
template <>
struct Is_plain<Point_in_cloud>
  : std::bool_constant<is_made_of(&Point_in_cloud::units, &Point_in_cloud::index,
                                  &Point_in_cloud::number_of_samples, &Point_in_cloud::scale,
                                  &Point_in_cloud::is_own)>
{};
template <>
struct Is_plain<Disks_of_tile>
  : std::bool_constant<is_made_of(&Disks_of_tile::units, &Disks_of_tile::number_of_others,
                                  &Disks_of_tile::keeps_outliers)>
{};
template <>
struct Is_plain<internal::Spread_in_ball>
  : std::bool_constant<is_made_of(&internal::Spread_in_ball::minors,
                                  &internal::Spread_in_ball::trace)>
{};
template <>
struct Is_plain<internal::Points_of_ball>
  : std::bool_constant<is_made_of(&internal::Points_of_ball::count,
                                  &internal::Points_of_ball::spread)>
{};
template <>
struct Is_plain<Points_of_tile::Run>
  : std::bool_constant<is_made_of(&Points_of_tile::Run::key, &Points_of_tile::Run::end,
                                  &Points_of_tile::Run::neighbors)>
{};
template <>
struct Is_plain<internal::Sums_over_points>
  : std::bool_constant<is_made_of(
      &internal::Sums_over_points::units, &internal::Sums_over_points::points,
      &internal::Sums_over_points::distinct, &internal::Sums_over_points::units_of_all,
      &internal::Sums_over_points::neighbors)>
{};
template <>
struct Is_plain<Run_of_cells>
  : std::bool_constant<is_made_of(&Run_of_cells::key, &Run_of_cells::sums)>
{};
template <>
struct Is_plain<Sums_of_tiles>
  : std::bool_constant<is_made_of(&Sums_of_tiles::disks, &Sums_of_tiles::sums,
                                  &Sums_of_tiles::area)>
{};
template <>
struct Is_plain<Summary_of_tile>
  : std::bool_constant<is_made_of(&Summary_of_tile::number_of_samples,
                                  &Summary_of_tile::number_of_outliers, &Summary_of_tile::seconds)>
{};
template <>
struct Is_plain<Seam_report>
  : std::bool_constant<is_made_of(&Seam_report::number_of_samples, &Seam_report::number_of_matches,
                                  &Seam_report::number_of_opposed,
                                  &Seam_report::sum_of_squared_distances)>
{};

namespace {

constexpr std::uint64_t begin_of_points = sizeof(std::uint64_t); // after their number

template <typename T>
void write_optional(Task_file_writer& file, const std::optional<T>& value)
{
  file.write(value.has_value());
  if (value)
    file.write(*value);
}

template <typename T>
void read_optional(Task_file& file, std::optional<T>& value)
{
  if (file.read<bool>())
    value = file.read<T>();
}

/// Calls `f` for each number of the extents, in one order: in memory there is a gap between them.
template <typename Facts, typename F>
void for_each_extent(Facts& extents, const F& f)
{
  f(extents.number_of_points);
  f(extents.box_diagonal);
  f(extents.robust_diagonal);
  f(extents.exponent_of_input);
  f(extents.scales);
}

/// Calls `f` for each other fact that is plain data, in one order.
template <typename Facts, typename F>
void for_each_plain_fact(Facts& facts, const F& f)
{
  f(facts.scales);
  f(facts.range_of_scales);
  f(facts.median_number_of_neighbors);
  f(facts.mean_number_of_neighbors);
  f(facts.has_plain_blocks);
  f(facts.units_of_disks);
  f(facts.area);
  f(facts.units_of_starts);
  f(facts.number_of_points);
  f(facts.number_of_places);
}

/// \param field none if it is null
void write_field(const Scale_field* field, Task_file_writer& file)
{
  file.write(field != nullptr);
  if (!field)
    return;
  const internal::Morton_points seeds = field->seeds.view();
  file.write(seeds.cells);
  file.write(field->radius);
  file.write_all(seeds.codes, std::size_t(seeds.size));
  file.write_all(field->scales.data(), field->scales.size());
  file.write_all(field->reaches.data(), field->reaches.size());
}

std::shared_ptr<const Scale_field> read_field(Task_file& file)
{
  if (!file.read<bool>())
    return nullptr;
  const auto cells = file.read<internal::Morton_cells>();
  const auto radius = file.read<double>();
  internal::Buffer<std::uint64_t> codes;
  internal::Buffer<double> scales, reaches;
  file.read_all(codes);
  file.read_all(scales);
  file.read_all(reaches);
  return std::make_shared<const Scale_field>(
    Scale_field{internal::Morton_places(cells, std::move(codes)), radius, std::move(scales),
                std::move(reaches)});
}

void write_histogram(const Histogram& histogram, Task_file_writer& file)
{
  std::vector<Count_of_number> counts;
  for (const auto& [number, count] : histogram.counts())
    counts.push_back({number, count});
  file.write_all(counts);
}

Histogram read_histogram(Task_file& file)
{
  std::vector<Count_of_number> counts;
  file.read_all(counts);
  Histogram histogram;
  for (const auto& [number, count] : counts)
    histogram.add(number, count);
  return histogram;
}

} // namespace

void write_facts(const std::string& path, std::uint64_t key, const Facts_of_run& facts)
{
  Task_file_writer file(path, key);
  file.write(facts.memory_of_tile);
  const internal::Vector& origin = facts.of_cloud.frame->origin;
  file.write(facts.of_cloud.frame->exponent);
  file.write(std::array<double, 3>{origin[0], origin[1], origin[2]});
  for_each_extent(*facts.of_cloud.extents, [&](const auto& extent) { file.write(extent); });
  for_each_plain_fact(facts.of_cloud, [&](const auto& fact) { write_optional(file, fact); });
  write_field(facts.of_cloud.field.get(), file);
  file.commit();
}

Facts_of_run read_facts(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  Facts_of_run facts;
  facts.memory_of_tile = file.read<std::uint64_t>();
  const int exponent = file.read<int>();
  const auto origin = file.read<std::array<double, 3>>();
  facts.of_cloud.frame = internal::Place_of_frame{exponent, internal::Vector(origin.data())};
  for_each_extent(facts.of_cloud.extents.emplace(),
                  [&](auto& extent) { extent = file.read<std::decay_t<decltype(extent)>>(); });
  for_each_plain_fact(facts.of_cloud, [&](auto& fact) { read_optional(file, fact); });
  facts.of_cloud.field = read_field(file);
  return facts;
}

void write_points_in_cloud(const std::string& path, std::uint64_t key,
                           const internal::Buffer<Point_in_cloud>& points)
{
  Task_file_writer file(path, key);
  file.write_all(points);
  file.commit();
}

internal::Buffer<Point_in_cloud> read_points_in_cloud(
  const std::string& path, std::uint64_t key,
  const std::vector<std::pair<std::uint64_t, std::uint64_t>>& ranges)
{
  const Task_file file(path, key);
  std::uint64_t number = 0;
  for (const auto& range : ranges)
    number += range.second;
  internal::Buffer<Point_in_cloud> points, of_range;
  points.reserve(static_cast<std::size_t>(number));
  for (const auto& [first, count] : ranges) {
    file.read_some(begin_of_points, first, count, of_range);
    points.insert(points.end(), of_range.begin(), of_range.end());
  }
  return points;
}

void write_neighbors(const std::string& path, std::uint64_t key, const Neighbors_of_tile& found)
{
  Task_file_writer file(path, key);
  file.write_all(found.scales);
  file.write(found.counts.least_scale);
  file.write(found.counts.largest_scale);
  write_histogram(found.counts.scales, file);
  write_histogram(found.counts.neighbors, file);
  file.commit();
}

Neighbor_counts read_neighbor_counts(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  file.skip_all<float>();
  Neighbor_counts counts;
  counts.least_scale = file.read<float>();
  counts.largest_scale = file.read<float>();
  counts.scales = read_histogram(file);
  counts.neighbors = read_histogram(file);
  return counts;
}

Buffer<float> read_scales(const std::string& path, std::uint64_t key)
{
  Buffer<float> scales;
  Task_file(path, key).read_all(scales);
  return scales;
}

void write_medians(const std::string& path, std::uint64_t key, const Medians_of_cloud& medians)
{
  Task_file_writer file(path, key);
  write_optional(file, medians.scales);
  write_optional(file, medians.number_of_neighbors);
  file.commit();
}

Medians_of_cloud read_medians(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  Medians_of_cloud medians;
  read_optional(file, medians.scales);
  read_optional(file, medians.number_of_neighbors);
  return medians;
}

void write_points_of_tile(const std::string& path, std::uint64_t key, const Points_of_tile& points)
{
  Task_file_writer file(path, key);
  file.write(points.disks);
  file.write_all(points.points);
  file.write_all(points.order);
  file.write_all(points.are_distinct);
  file.write_all(points.are_first);
  file.write_all(points.balls);
  file.write_all(points.runs);
  file.commit();
}

Disks_of_tile read_disks(const std::string& path, std::uint64_t key)
{
  return Task_file(path, key).read<Disks_of_tile>();
}

Points_of_tile read_points_of_tile(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  Points_of_tile points;
  points.disks = file.read<Disks_of_tile>();
  file.read_all(points.points);
  file.read_all(points.order);
  file.read_all(points.are_distinct);
  file.read_all(points.are_first);
  file.read_all(points.balls);
  file.read_all(points.runs);
  return points;
}

void write_share(const std::string& path, std::uint64_t key, const Share_of_tile& share)
{
  Task_file_writer file(path, key);
  file.write(share.area_per_unit);
  file.write_all(share.runs);
  file.commit();
}

Share_of_tile read_share(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  Share_of_tile share;
  share.area_per_unit = file.read<double>();
  file.read_all(share.runs);
  return share;
}

void write_starts(const std::string& path, std::uint64_t key, const Sums_of_tiles& sums,
                  const std::vector<Share_of_tile>& shares)
{
  Task_file_writer file(path, key);
  file.write(sums);
  for (const Share_of_tile& share : shares)
    file.write_all(share.runs);
  file.commit();
}

Sums_of_tiles read_sums(const std::string& path, std::uint64_t key)
{
  return Task_file(path, key).read<Sums_of_tiles>();
}

Starts_of_runs read_starts(const std::string& path, std::uint64_t key, std::size_t tile)
{
  Task_file file(path, key);
  Starts_of_runs starts;
  starts.all = file.read<Sums_of_tiles>().sums;
  for (std::size_t before = 0; before < tile; ++before)
    file.skip_all<Run_of_cells>();
  file.read_all(starts.runs);
  return starts;
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
  std::vector<std::pair<Block, std::uint64_t>> blocks;
  std::vector<Block_run> all;
  file.read_all(all);
  blocks.reserve(all.size());
  for (const Block_run& counted : all)
    blocks.emplace_back(counted.block, counted.count);
  return {Block_counts(exponent, blocks, low, high), number_of_dropped, read_properties(file)};
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
  file.write_all(found.unoriented.own);
  file.write_all(found.unoriented.leaders_elsewhere);
  file.commit();
}

Found_in_tile read_found(const std::string& path, std::uint64_t key, bool with_border)
{
  Task_file file(path, key);
  file.skip_all<Tile_sample>();
  Found_in_tile found;
  found.summary = file.read<Summary_of_tile>();
  file.read_all(found.evidence);
  if (with_border) {
    file.read_all(found.near_border);
    file.read_all(found.beyond_border);
  }
  return found;
}

Unoriented_samples read_unoriented(const std::string& path, std::uint64_t key)
{
  Task_file file(path, key);
  file.skip_all<Tile_sample>();
  file.read<Summary_of_tile>();
  file.skip_all<double>();
  file.skip_all<Tile_sample>();
  file.skip_all<Tile_sample>();
  Unoriented_samples unoriented;
  file.read_all(unoriented.own);
  file.read_all(unoriented.leaders_elsewhere);
  return unoriented;
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

} // namespace l0_tool
