// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TILE_FILES_H
#define L0_RESAMPLE_TILE_FILES_H

#include "tiles/Input_properties.h"
#include "tiles/Task_file.h"
#include "tiles/Tile_rows.h"

#include <CGAL/L0_resampling/Tiled_resampling.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// What tasks of `--as-one` leave to each other, in files of a run that has the number `key`.

namespace l0_tool {

using CGAL::L0_resampling::Seam_report;
using CGAL::L0_resampling::Tile_counts;
using CGAL::L0_resampling::Tile_findings;
using CGAL::L0_resampling::Tile_sample;
using CGAL::L0_resampling::Unoriented_samples;

/// Whose values are those of a device too.
using Tiled_on_cpu = CGAL::L0_resampling::Tiled_resampling<CGAL::Parallel_if_available_tag>;

/// The points of the inputs, by blocks.
struct Counted_input
{
  Tile_counts counts;
  std::uint64_t number_of_dropped = 0;            ///< of those that are not finite
  std::optional<std::array<double, 3>> viewpoint; ///< of a file; of the call, once all are counted
  Input_properties properties; ///< of those that samples get, and what else goes along
};

void write_counts(const std::string& path, std::uint64_t key, const Counted_input& input);
Counted_input read_counts(const std::string& path, std::uint64_t key);

/// What the tiles of a run follow from.
struct Facts_of_run
{
  Tiled_on_cpu::Facts of_cloud;
  std::uint64_t memory_of_tile; ///< in bytes
};

void write_facts(const std::string& path, std::uint64_t key, const Facts_of_run& facts);
Facts_of_run read_facts(const std::string& path, std::uint64_t key);

/// What is known of each point, if all facts are.
void write_points_in_cloud(const std::string& path, std::uint64_t key,
                           const Tiled_on_cpu::Array<Tiled_on_cpu::Point_facts>& points);
/// \param ranges of points: the first, and how many
Tiled_on_cpu::Array<Tiled_on_cpu::Point_facts> read_points_in_cloud(
  const std::string& path, std::uint64_t key,
  const std::vector<std::pair<std::uint64_t, std::uint64_t>>& ranges);

/// What a tile finds of the scales and neighbors of its points.
void write_neighbors(const std::string& path, std::uint64_t key,
                     const Tiled_on_cpu::Neighbors& found);
Tiled_on_cpu::Neighbor_counts read_neighbor_counts(const std::string& path, std::uint64_t key);
Tiled_on_cpu::Array<float> read_scales(const std::string& path, std::uint64_t key);

/// What all tiles have found of these together.
void write_medians(const std::string& path, std::uint64_t key,
                   const Tiled_on_cpu::Medians& medians);
Tiled_on_cpu::Medians read_medians(const std::string& path, std::uint64_t key);

/// What a tile finds of its points.
void write_points_of_tile(const std::string& path, std::uint64_t key,
                          const Tiled_on_cpu::Points& points);
Tiled_on_cpu::Disks read_disks(const std::string& path, std::uint64_t key);
Tiled_on_cpu::Points read_points_of_tile(const std::string& path, std::uint64_t key);

/// What a tile counts.
void write_share(const std::string& path, std::uint64_t key, const Tiled_on_cpu::Share& share);
Tiled_on_cpu::Share read_share(const std::string& path, std::uint64_t key);

/// What all tiles have counted, and what comes before the runs of each.
void write_starts(const std::string& path, std::uint64_t key, const Tiled_on_cpu::Sums& sums,
                  const std::vector<Tiled_on_cpu::Share>& shares);
Tiled_on_cpu::Sums read_sums(const std::string& path, std::uint64_t key);
std::vector<Tiled_on_cpu::Run> read_starts(const std::string& path, std::uint64_t key,
                                           std::size_t tile);

struct Summary_of_tile
{
  Tile_findings findings;
  double seconds;
};

/// What a tile has found, beside the samples that it keeps, which come first in its file.
struct Found_in_tile
{
  std::vector<Tile_sample> near_border, beyond_border;
  std::vector<double> evidence;
  Unoriented_samples unoriented;
  std::vector<std::array<double, 3>> outliers;
  Summary_of_tile summary;
};

void write_found(const std::string& path, std::uint64_t key,
                 const std::vector<Tile_sample>& samples, const Found_in_tile& found);
/// \param with_border whether to read the samples there
/// \returns without outliers, and what is to be oriented
Found_in_tile read_found(const std::string& path, std::uint64_t key, bool with_border);
std::vector<std::array<double, 3>> read_outliers(const std::string& path, std::uint64_t key);
Unoriented_samples read_unoriented(const std::string& path, std::uint64_t key);

/// What all tiles say together.
struct Signs_of_tiles
{
  std::vector<std::vector<signed char>> signs; ///< of each tile and tree
  std::vector<Summary_of_tile> summaries;
  Seam_report seams;
};

void write_signs(const std::string& path, std::uint64_t key, const Signs_of_tiles& signs);
Signs_of_tiles read_signs(const std::string& path, std::uint64_t key);
/// \returns without the signs
Signs_of_tiles read_summaries(const std::string& path, std::uint64_t key);
std::vector<signed char> read_signs_of_tile(const std::string& path, std::uint64_t key,
                                            std::size_t tile);

/// The samples of each tile that creases move.
void write_moved(const std::string& path, std::uint64_t key,
                 const std::vector<std::vector<Moved_sample>>& moved);
std::vector<Moved_sample> read_moved_of_tile(const std::string& path, std::uint64_t key,
                                             std::size_t tile);

} // namespace l0_tool

#endif // L0_RESAMPLE_TILE_FILES_H
