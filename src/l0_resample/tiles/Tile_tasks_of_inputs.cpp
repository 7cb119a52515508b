// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The tasks of `Tile_tasks` that read the inputs, and what follows from these alone.

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "files/Output_file.h"
#include "formats/write_points.h"
#include "tasks/resample.h"
#include "tasks/tasks.h"
#include "tiles/Shard.h"
#include "tiles/Tile_rows.h"
#include "tiles/Tile_tasks.h"
#include "tiles/processor_of_tiles.h"
#include "tiles/tile_description.h"
#include "tiles/tile_files.h"

#include <CGAL/l0_resample_tiles.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

using CGAL::L0_resampling::Tiled_resampling;

/// That of the options, if they say anything of sides, or else the one that all files have.
void choose_viewpoint(const Command& command,
                      const std::vector<std::optional<std::array<double, 3>>>& of_files,
                      Counted_input& all)
{
  const Options& options = command.runs.front();
  const auto differs = [&](const auto& viewpoint) { return viewpoint != of_files.front(); };
  if (options.have_side())
    all.viewpoint = options.viewpoint;
  else if (std::none_of(of_files.begin(), of_files.end(), differs))
    all.viewpoint = of_files.front();
  else
    all.properties.warnings.push_back(
      command.output_directory
      + ": the files have different viewpoints, or some have none, and none is used; --viewpoint "
        "names one for all points");
}

} // namespace

/// \returns what is beside the points
Point_cloud Tile_tasks::read_input(std::size_t number, const On_point& f, std::uint64_t memory,
                                   const On_progress& on_progress) const
{
  const Options& options = m_command.runs[number];
  Read_options read_options = read_options_of(options);
  read_options.max_memory = memory;
  read_options.with_properties = carries_properties(m_command) || !options.classes.empty()
                                 || options.only_first_returns;
  read_options.on_point = [&](const Point& p, const Property_table& properties, const char* row) {
    f({p.x(), p.y(), p.z()}, properties, row);
  };
  return read_points(options.input, options.input_format, read_options, on_progress);
}

void Tile_tasks::count(std::size_t number, const On_progress& on_progress,
                       std::size_t at_once) const
{
  Counted_input input;
  const Point_cloud cloud = read_input(
    number,
    [&](const std::array<double, 3>& point, const Property_table&, const char*) {
      input.counts.add(point);
    },
    memory_for_points() / 2 / at_once, on_progress);
  input.number_of_dropped = cloud.number_of_dropped_points;
  input.viewpoint = cloud.viewpoint;
  if (carries_properties(m_command))
    input.properties = properties_of_input(m_command.runs[number].input, cloud,
                                           input.counts.number_of_points() > 0);
  write_counts(file_of("count", number), m_key, input);
}

void Tile_tasks::merge_counts() const
{
  Counted_input all;
  std::vector<std::optional<std::array<double, 3>>> viewpoints;
  for (std::size_t k = 0; k < m_command.runs.size(); ++k) {
    Counted_input input = read_counts(file_of("count", k), m_key);
    if (input.counts.number_of_points() > 0)
      viewpoints.push_back(input.viewpoint);
    all.counts.add(std::move(input.counts));
    all.number_of_dropped += input.number_of_dropped;
    add_input(input.properties, all.properties);
  }
  if (all.counts.number_of_points() == 0)
    throw Failure(INPUT_REFUSED, "--as-one: the files have no points");
  choose_inputs_of_bytes(all.properties);
  all.counts.finish();
  check_disk(all.counts.number_of_points(), all.properties);
  warn_of_left_out(all.properties);
  choose_viewpoint(m_command, viewpoints, all);
  write_counts(file_of("blocks", 0), m_key, all);
}

void Tile_tasks::warn_of_left_out(Input_properties& properties) const
{
  const auto warn = [&](const std::string& output, File_format format) {
    for (const std::string& name :
         properties_left_out(format, properties_of_samples(properties), properties.las))
      properties.warnings.push_back(output + ": the format has no place for the property "
                                    + printable(name));
  };
  warn(m_command.output_directory, m_options.output_format);
  if (!m_command.merged_output.empty())
    warn(m_command.merged_output, *format_of(m_command.merged_output));
}

void Tile_tasks::check_disk(std::uint64_t number_of_points,
                            const Input_properties& properties) const
{
  const std::uint64_t m = number_of_output_points(m_options, std::size_t(number_of_points));
  const Property_table table = properties.table();
  const auto of_results = [&](File_format format) {
    return maximum_file_size(format, m, properties_of_samples(properties), properties.las);
  };
  std::uint64_t of_point = sizeof(std::array<double, 3>); // in its shard
  if (table.row_size() > 0)
    of_point += sizeof(std::uint64_t) + table.row_size();
  // with those of the overlaps, of which there are fewer
  std::uint64_t of_sample = 2 * sizeof(Tile_sample) + table.row_size();
  run_on(m_options, [&](auto tag) {
    using Tiles = Tiled_resampling<decltype(tag)>;
    const std::uint64_t of_device = memory_of_device(m_options);
    if (Tiles::can_find_all_facts(number_of_points, m, memory_for_points(), of_device))
      of_point += sizeof(typename Tiles::Point_facts);
    else
      // with those of halos, mostly fewer
      of_point += 2 * Tiles::bytes_per_point_of_tile;
    if (Tiles::can_orient_at_once(m, (std::min)(memory_for_points(), of_device)))
      of_sample += sizeof(Tile_sample) + 1; // what its side follows from, and the side
  });
  check_writable(index_file(),
                 number_of_points * of_point + m * of_sample + of_results(m_options.output_format));
  if (!m_command.merged_output.empty())
    check_writable(m_command.merged_output, of_results(*format_of(m_command.merged_output)));
}

void Tile_tasks::shard(std::size_t number, const On_progress& on_progress,
                       std::size_t at_once) const
{
  const Counted_input all = read_counts(file_of("blocks", 0), m_key);
  const std::uint64_t memory = memory_for_points() / 2 / at_once;
  Row_converter row_of(all.properties, m_command.runs[number].input);
  Shard_writer shard(file_of("shard", number), file_of("rows", number), m_key, all.counts.lattice(),
                     all.properties.table().row_size(), memory);
  read_input(
    number,
    [&](const std::array<double, 3>& point, const Property_table& properties, const char* row) {
      shard.add(point, row_of(properties, row));
    },
    memory, on_progress);
  shard.commit();
}

} // namespace l0_tool
