// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The tasks of `Tile_tasks` that write results, and what is said of these.

#include "basis/messages.h"
#include "formats/write_points.h"
#include "tasks/report_json.h"
#include "tasks/resample.h"
#include "tasks/run.h"
#include "tiles/Tile_rows.h"
#include "tiles/Tile_tasks.h"
#include "tiles/Tiles_of_run.h"
#include "tiles/tile_files.h"

#include <CGAL/l0_resample_tiles.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

namespace fs = std::filesystem;
using CGAL::L0_resampling::Report;
using Tiles_on_cpu = Tiles_of_run<CGAL::Parallel_if_available_tag>;
using Json = nlohmann::ordered_json;

/// Of the whole cloud.
Report report_of(const Tiled_on_cpu& resampling, const Signs_of_tiles& all)
{
  Tile_findings findings;
  for (const Summary_of_tile& summary : all.summaries)
    findings += summary.findings;
  return resampling.report(findings);
}

} // namespace

std::vector<std::string> Tile_tasks::warnings_of(const Input_properties& properties,
                                                 const Report& report) const
{
  std::vector<std::string> lines = properties.warnings;
  for (std::string& line : lines_of_warnings(on_one_line(m_command.output_directory), report))
    lines.push_back(std::move(line));
  return lines;
}

Remarks_on_run Tile_tasks::remarks() const
{
  Tiles_on_cpu tiles(*this, [](double) {});
  tiles.cut();
  tiles.take_sums();
  return {warnings_of(tiles.properties(),
                      report_of(tiles.resampling, read_summaries(file_of("stitch", 0), m_key))),
          tiles.input().viewpoint};
}

void Tile_tasks::write(std::size_t tile) const
{
  const Summary_of_tile summary = read_summaries(file_of("stitch", 0), m_key).summaries[tile];
  const Counted_input input = read_counts(file_of("blocks", 0), m_key);
  Tile_rows rows(m_key, input.properties.table(), finds_creases());
  rows.add(file_of("solve", tile), file_of("carry", tile),
           read_signs_of_tile(file_of("stitch", 0), m_key, tile),
           std::size_t(summary.findings.number_of_output_points), moved_samples(tile));
  write_point_rows(result_of(tile), m_options.output_format, rows, input.properties.las,
                   input.viewpoint);
}

void Tile_tasks::merge() const
{
  const Signs_of_tiles all = read_signs(file_of("stitch", 0), m_key);
  const Counted_input input = read_counts(file_of("blocks", 0), m_key);
  Tile_rows rows(m_key, input.properties.table(), finds_creases());
  for (std::size_t tile = 0; tile < all.signs.size(); ++tile)
    rows.add(file_of("solve", tile), file_of("carry", tile), all.signs[tile],
             std::size_t(all.summaries[tile].findings.number_of_output_points),
             moved_samples(tile));
  write_point_rows(m_command.merged_output, *format_of(m_command.merged_output), rows,
                   input.properties.las, input.viewpoint, m_options.existing_file());
}

void Tile_tasks::write_outliers(std::size_t number_of_tiles) const
{
  Point_cloud cloud;
  cloud.las = read_counts(file_of("blocks", 0), m_key).properties.las;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
    for (const auto& [x, y, z] : read_outliers(file_of("solve", tile), m_key))
      cloud.points.emplace_back(x, y, z);
  write_point_cloud(m_options.outliers, *format_of(m_options.outliers), cloud);
}

void Tile_tasks::finish() const
{
  Tiles_on_cpu tiles(*this, [](double) {});
  tiles.cut();
  tiles.take_sums();
  const Tiled_on_cpu& resampling = tiles.resampling;
  const Signs_of_tiles all = read_summaries(file_of("stitch", 0), m_key);
  const double length = resampling.neighbor_radius();
  const Seam_report& seams = all.seams;
  Json json = {{"program", "l0_resample"},
               {"version", L0_RESAMPLE_VERSION},
               {"input_points", resampling.number_of_points()},
               {"dropped_points", tiles.input().number_of_dropped},
               {"output_points", resampling.number_of_samples()},
               {"outwards_assumed", are_outwards_assumed(m_options, tiles.input().viewpoint)},
               {"neighbor_radius", length},
               {"sample_spacing", resampling.sample_spacing()},
               {"overlap",
                {{"samples", seams.number_of_samples},
                 {"matches", seams.number_of_matches},
                 {"opposed", seams.number_of_opposed},
                 {"root_mean_square_distance",
                  seams.number_of_matches == 0
                    ? 0.
                    : std::sqrt(seams.sum_of_squared_distances / double(seams.number_of_matches))
                        * resampling.sample_spacing()}}},
               {"tiles", Json::array()}};
  const Report of_cloud = report_of(resampling, all);
  add_findings(of_cloud, json);
  for (std::size_t tile = 0; tile < all.summaries.size(); ++tile) {
    const CGAL::L0_resampling::Tile& of_tile = resampling.tiles()[tile];
    const Tile_findings& findings = all.summaries[tile].findings;
    const auto [low, high] = resampling.box_of_tile(tile);
    json["tiles"].push_back({{"file", fs::path(result_of(tile)).filename().string()},
                             {"low", low},
                             {"high", high},
                             {"input_points", of_tile.number_of_points},
                             {"input_points_with_halo", of_tile.number_of_points_with_halo},
                             {"outliers", findings.number_of_outliers},
                             {"output_points", findings.number_of_output_points},
                             {"seconds", all.summaries[tile].seconds}});
  }
  const std::vector<std::string> lines = warnings_of(tiles.properties(), of_cloud);
  if (!lines.empty())
    json["warnings"] = lines;
  json["run"] = m_description;
  if (!m_options.outliers.empty())
    write_outliers(all.summaries.size());
  write_text(index_file(), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  std::error_code error; // what is left is in nobody's way
  fs::remove_all(m_work, error);
}

} // namespace l0_tool
