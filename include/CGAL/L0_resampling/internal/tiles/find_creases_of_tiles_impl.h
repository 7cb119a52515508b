// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_OF_TILES_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_OF_TILES_IMPL_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/creases/find_creases_impl.h>
#include <CGAL/L0_resampling/internal/tiles/Creases_of_tiles.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

template <typename ConcurrencyTag>
Creases_of_tiles find_creases_of_tiles(std::size_t number_of_tiles, double spacing,
                                       const Samples_of_tiles& samples_of, Progress& progress,
                                       Memory_counter& memory)
{
  using Box = Eigen::AlignedBox3d;
  const double reach = 1.001 * reach_of_crease_point * spacing; // with roundings
  Creases_of_tiles found{{}, {0}};
  std::vector<Tile_sample> samples;
  const auto place_of = [](const Tile_sample& sample) { return Vector(sample.position.data()); };
  std::vector<Box> boxes(number_of_tiles); // around the samples, which do not stay in their tiles
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    samples_of(tile, samples);
    for (const Tile_sample& sample : samples)
      boxes[tile].extend(place_of(sample));
    found.first_samples.push_back(found.first_samples.back() + samples.size());
  }

  if (!(spacing > 0))
    return found;
  Seen_creases seen;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    if (boxes[tile].isEmpty())
      continue;
    const Box around((boxes[tile].min)() - Vector::Constant(reach),
                     (boxes[tile].max)() + Vector::Constant(reach));
    Buffer<Vector> positions(&memory);
    Buffer<Eigen::Vector3f> normals(&memory);
    const auto add_samples_of = [&](std::size_t any) {
      samples_of(any, samples);
      for (const Tile_sample& sample : samples)
        if (around.contains(place_of(sample)))
        {
          positions.push_back(place_of(sample));
          normals.emplace_back(sample.normal.data());
        }
    };
    add_samples_of(tile);
    const std::size_t number_of_own = positions.size();
    for (std::size_t other = 0; other < number_of_tiles; ++other)
      if (other != tile && around.intersects(boxes[other]))
        add_samples_of(other);
    progress.begin_stage("creases", 0.9 / double(number_of_tiles), 2 * positions.size());
    see_creases<ConcurrencyTag>(positions, normals, number_of_own, spacing, progress, seen);
  }

  Crease_frame frame{Vector::Zero(), spacing};
  const Crease_lines lines = join_crease_points<ConcurrencyTag>(
    points_in_one_frame(std::move(seen), frame));
  Samples_beside_creases beside(lines, frame);
  progress.begin_stage("points on creases", 0.1, number_of_tiles);
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    samples_of(tile, samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
      beside.add(found.first_samples[tile] + i, place_of(samples[i]),
                 Eigen::Vector3f(samples[i].normal.data()).cast<double>());
    progress.advance(1);
  }
  found.placed = std::move(beside).place();
  progress.end_stage();
  return found;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_OF_TILES_IMPL_H
