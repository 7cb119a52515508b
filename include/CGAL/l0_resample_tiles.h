// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLE_TILES_H
#define CGAL_L0_RESAMPLE_TILES_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Tiled_resampling.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgL0ResamplingRef

resamples a cloud that does not fit into memory, tile by tile; see
`CGAL::L0_resampling::Tiled_resampling` for programs that store what is in between.

\tparam ConcurrencyTag as for `CGAL::l0_resample_point_set()`. With `CUDA_tag`, tiles are resampled
on the current device, whose free memory limits them too, as its named parameter `maximum_memory`
does
\param source model of `L0ResamplingTileSource`
\param sink model of `L0ResamplingTileSink`: `sink.put(tile, result)` stores a
`CGAL::L0_resampling::Tile_result`, `sink.get(tile)` gives it back, and `sink.finish(tile, samples)`
takes the samples of a tile with normals on their sides
\param maximum_memory of a tile, in bytes
\param np see `CGAL::L0_resampling::Tiled_resampling`; `number_of_output_points` has to be given.
`crease_output_iterator` and `corner_output_iterator` get the creases and corners of the whole
cloud, for `CGAL::Simple_cartesian<double>`: points of the result are numbered tile after tile;
`resampling_report` gets `Tiled_resampling::report()`, for `warnings()`

\throws std::bad_alloc if the memory does not suffice for a single tile
\throws std::length_error if the surface has more area than 64 bits count, that of 2^33 disks of the
neighbor radius
\throws CGAL::L0_resampling::Device_error with `CUDA_tag`, if there is no usable device, or it fails
*/
template <typename ConcurrencyTag, typename Source, typename Sink,
          typename NamedParameters = parameters::Default_named_parameters>
void l0_resample_tiles(const Source& source, Sink& sink, std::uint64_t maximum_memory,
                       const NamedParameters& np)
{
  using namespace L0_resampling;
  using Tiles = Tiled_resampling<ConcurrencyTag>;
  L0_resampling::Tile_counts counts;
  const double infinity = std::numeric_limits<double>::infinity();
  source.for_each_point(Source_box{{-infinity, -infinity, -infinity},
                                   {infinity, infinity, infinity}},
                        [&](const std::array<double, 3>& point) { counts.add(point); });
  if (counts.number_of_points() == 0)
    return;
  Tiles tiles(std::move(counts), np);
  const std::uint64_t device_memory = Tiles::device_memory();
  tiles.find_facts(source, maximum_memory, device_memory);
  const auto& kept = tiles.points_in_cloud();
  const std::uint64_t memory = maximum_memory - kept.size() * sizeof(kept[0]);
  tiles.make_tiles((std::min)(memory, device_memory));
  tiles.choose_how_to_orient((std::min)(memory, device_memory));
  const std::size_t number_of_tiles = tiles.tiles().size();
  if (!tiles.has_all_facts())
  {
    // found again for each step: there may be no room for what is found of all points
    typename Tiles::Neighbor_counts neighbors;
    for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
      neighbors += tiles.find_neighbors_of_tile(tile, source).counts;
    tiles.set_medians(neighbors.medians());
    std::vector<typename Tiles::Disks> disks;
    for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
      disks.push_back(tiles.find_points_of_tile(tile, source).disks);
    tiles.set_disks(Tiles::add_up_disks(disks));
    std::vector<typename Tiles::Share> shares;
    for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
    {
      typename Tiles::Points points = tiles.find_points_of_tile(tile, source);
      shares.push_back(tiles.share_of_tile(points));
    }
    tiles.set_shares(std::move(shares));
  }
  std::vector<std::vector<double>> evidence;
  L0_resampling::Tile_findings findings;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    Tile_result result = tiles.resample_tile(tile, source);
    evidence.push_back(result.evidence);
    findings += result.findings;
    sink.put(tile, std::move(result));
  }
  std::vector<std::vector<signed char>> signs;
  if (tiles.orients_at_once())
  {
    std::vector<Unoriented_samples> unoriented;
    for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
      unoriented.push_back(sink.get(tile).unoriented);
    Report unwanted_report;
    signs = tiles.sides(std::move(unoriented), unwanted_report);
  }
  else
  {
    Stitching stitching = tiles.stitching(evidence);
    if (!tiles.are_sides_given())
      stitching.add_overlaps(tiles, sink);
    signs = stitching.signs();
  }
  const auto samples_of = [&](std::size_t tile) {
    std::vector<Tile_sample> samples = sink.get(tile).samples;
    for (Tile_sample& sample : samples)
      for (float& coordinate : sample.normal)
        coordinate = tiles.are_sides_given() || signs[tile][sample.tree] > 0 ? coordinate
                                                                             : -coordinate;
    return samples;
  };
  typename Tiles::Creases creases;
  if (tiles.finds_creases())
    creases = tiles.find_creases(samples_of);
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    std::vector<Tile_sample> samples = samples_of(tile);
    if (tiles.finds_creases())
      Tiles::move_samples(creases, tile, samples);
    sink.finish(tile, samples);
  }
  Tiles::write_creases(creases, np);
  if (Report* const report = L0_resampling::internal::report_of_call(np))
    *report = tiles.report(findings);
}

} // namespace CGAL

#endif // CGAL_L0_RESAMPLE_TILES_H
