// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/write_creases.h"
#include "tasks/resample.h"
#include "tiles/Tile_rows.h"
#include "tiles/Tile_tasks.h"
#include "tiles/Tiles_of_run.h"
#include "tiles/tile_files.h"

#include <CGAL/l0_resample_tiles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

using Tiles_on_cpu = Tiles_of_run<CGAL::Parallel_if_available_tag>;

/// Of each tile, without marks.
std::vector<std::vector<Moved_sample>> moved_samples_of(const Tiled_on_cpu::Creases& creases)
{
  std::vector<std::vector<Moved_sample>> moved(creases.first_samples.size() - 1);
  for (std::size_t tile = 0; tile < moved.size(); ++tile)
    creases.for_each_moved(tile, [&](const auto& sample, std::size_t place) {
      const auto &p = sample.position, &n = sample.normal;
      moved[tile].push_back(
        {place, {p[0], p[1], p[2]}, {float(n[0]), float(n[1]), float(n[2])}, 0});
    });
  return moved;
}

/// The creases and corners, with those points only that they have moved.
Resampled_points points_of_creases(const Tiled_on_cpu::Creases& creases,
                                   const std::vector<std::vector<Moved_sample>>& moved)
{
  Resampled_points result;
  std::vector<std::size_t> numbers; // of the points
  for (std::size_t tile = 0; tile < moved.size(); ++tile)
    for (const Moved_sample& sample : moved[tile]) {
      numbers.push_back(creases.first_samples[tile] + sample.place);
      result.points.push_back(oriented_point(sample));
    }
  Tiled_on_cpu::write_creases(
    creases, CGAL::parameters::crease_output_iterator(std::back_inserter(result.creases))
               .corner_output_iterator(std::back_inserter(result.corners)));
  const auto renumber = [&](std::size_t& point) {
    point = std::size_t(std::lower_bound(numbers.begin(), numbers.end(), point) - numbers.begin());
  };
  for (Crease& crease : result.creases)
    for (std::size_t& point : crease.points)
      renumber(point);
  for (Crease_corner& corner : result.corners)
    renumber(corner.point);
  return result;
}

} // namespace

Property_table Tile_tasks::properties_of_samples(const Input_properties& properties) const
{
  return finds_creases() ? with_marks(properties.table()) : properties.table();
}

std::vector<Moved_sample> Tile_tasks::moved_samples(std::size_t tile) const
{
  return finds_creases() ? read_moved_of_tile(file_of("creases", 0), m_key, tile)
                         : std::vector<Moved_sample>();
}

void Tile_tasks::find_creases(const On_progress& on_progress) const
{
  Tiles_on_cpu tiles(*this, on_progress);
  tiles.cut();
  tiles.take_sums();
  const std::vector<std::vector<signed char>> signs = read_signs(file_of("stitch", 0), m_key).signs;
  const Tiled_on_cpu::Creases creases = tiles.resampling.find_creases([&](std::size_t tile) {
    std::vector<Tile_sample> samples;
    Task_file(file_of("solve", tile), m_key).read_all(samples);
    for (Tile_sample& sample : samples)
      for (float& coordinate : sample.normal)
        coordinate *= float(signs[tile][sample.tree]);
    return samples;
  });
  std::vector<std::vector<Moved_sample>> moved = moved_samples_of(creases);
  const Resampled_points result = points_of_creases(creases, moved);
  write_creases(m_options.creases, *crease_format_of(m_options.creases), result);
  const std::vector<float> marks = marks_of_creases(result);
  auto mark = marks.begin(); // as these, of all tiles one after the other
  for (std::vector<Moved_sample>& of_tile : moved)
    for (Moved_sample& sample : of_tile)
      sample.mark = std::uint32_t(*mark++);
  write_moved(file_of("creases", 0), m_key, moved);
}

} // namespace l0_tool
