// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TILE_FILES_H
#define L0_RESAMPLE_TILE_FILES_H

#include "tiles/Input_properties.h"
#include "tiles/Task_file.h"

#include <CGAL/L0_resampling/internal/tiles/Block_counts.h>
#include <CGAL/L0_resampling/internal/tiles/Neighbors_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Points_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/stitch_tiles.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// What tasks of `--as-one` leave to each other, in files of a run that has the number `key`.

namespace l0_tool {

using CGAL::L0_resampling::internal::Block_counts;
using CGAL::L0_resampling::internal::Buffer;
using CGAL::L0_resampling::internal::Disks_of_tile;
using CGAL::L0_resampling::internal::Facts_of_cloud;
using CGAL::L0_resampling::internal::Medians_of_cloud;
using CGAL::L0_resampling::internal::Neighbor_counts;
using CGAL::L0_resampling::internal::Neighbors_of_tile;
using CGAL::L0_resampling::internal::Point_in_cloud;
using CGAL::L0_resampling::internal::Points_of_tile;
using CGAL::L0_resampling::internal::Run_of_cells;
using CGAL::L0_resampling::internal::Seam_report;
using CGAL::L0_resampling::internal::Share_of_tile;
using CGAL::L0_resampling::internal::Starts_of_runs;
using CGAL::L0_resampling::internal::Sums_of_tiles;
using CGAL::L0_resampling::internal::Tile_sample;
using CGAL::L0_resampling::internal::Unoriented_samples;

/// The points of the inputs, by blocks.
struct Counted_input
{
  Block_counts counts;
  std::uint64_t number_of_dropped = 0; ///< of those that are not finite
  Input_properties properties;         ///< of those that samples get, and what else goes along
};

void write_counts(const std::string& path, std::uint64_t key, const Counted_input& input);
Counted_input read_counts(const std::string& path, std::uint64_t key);

/// What the tiles of a run follow from.
struct Facts_of_run
{
  Facts_of_cloud of_cloud;
  std::uint64_t memory_of_tile; ///< in bytes
};

void write_facts(const std::string& path, std::uint64_t key, const Facts_of_run& facts);
Facts_of_run read_facts(const std::string& path, std::uint64_t key);

/// What is known of each point, if all facts are.
void write_points_in_cloud(const std::string& path, std::uint64_t key,
                           const Buffer<Point_in_cloud>& points);
/// \param ranges of points: the first, and how many
Buffer<Point_in_cloud> read_points_in_cloud(
  const std::string& path, std::uint64_t key,
  const std::vector<std::pair<std::uint64_t, std::uint64_t>>& ranges);

/// What a tile finds of the scales and neighbors of its points.
void write_neighbors(const std::string& path, std::uint64_t key, const Neighbors_of_tile& found);
Neighbor_counts read_neighbor_counts(const std::string& path, std::uint64_t key);
Buffer<float> read_scales(const std::string& path, std::uint64_t key);

/// What all tiles have found of these together.
void write_medians(const std::string& path, std::uint64_t key, const Medians_of_cloud& medians);
Medians_of_cloud read_medians(const std::string& path, std::uint64_t key);

/// What a tile finds of its points.
void write_points_of_tile(const std::string& path, std::uint64_t key, const Points_of_tile& points);
Disks_of_tile read_disks(const std::string& path, std::uint64_t key);
Points_of_tile read_points_of_tile(const std::string& path, std::uint64_t key);

/// What a tile counts.
void write_share(const std::string& path, std::uint64_t key, const Share_of_tile& share);
Share_of_tile read_share(const std::string& path, std::uint64_t key);

/// What all tiles have counted, and what comes before the runs of each.
void write_starts(const std::string& path, std::uint64_t key, const Sums_of_tiles& sums,
                  const std::vector<Share_of_tile>& shares);
Sums_of_tiles read_sums(const std::string& path, std::uint64_t key);
Starts_of_runs read_starts(const std::string& path, std::uint64_t key, std::size_t tile);

struct Summary_of_tile
{
  std::uint64_t number_of_samples, number_of_outliers;
  double seconds;
};

template <>
struct Is_plain<Tile_sample>
  : std::bool_constant<is_made_of(&Tile_sample::position, &Tile_sample::normal, &Tile_sample::tree)>
{};

/// What a tile has found, beside the samples that it keeps, which come first in its file.
struct Found_in_tile
{
  std::vector<Tile_sample> near_border, beyond_border;
  std::vector<double> evidence;
  Unoriented_samples unoriented;
  Summary_of_tile summary;
};

void write_found(const std::string& path, std::uint64_t key,
                 const std::vector<Tile_sample>& samples, const Found_in_tile& found);
/// \param with_border whether to read the samples there
/// \returns without what is to be oriented
Found_in_tile read_found(const std::string& path, std::uint64_t key, bool with_border);
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

} // namespace l0_tool

#endif // L0_RESAMPLE_TILE_FILES_H
