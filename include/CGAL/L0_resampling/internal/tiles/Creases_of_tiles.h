// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CREASES_OF_TILES_H
#define CGAL_L0_RESAMPLING_INTERNAL_CREASES_OF_TILES_H

#include <CGAL/L0_resampling/Tile_stitching.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/creases/Placed_creases.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The creases of a cloud. Its samples are numbered tile after tile.
struct Creases_of_tiles
{
  Placed_creases placed;
  std::vector<std::size_t> first_samples; ///< of the tiles, and the number of all

  /// Calls `f(sample, place)` for each sample of a tile that was moved, with its place there.
  template <typename F>
  void for_each_moved(std::size_t tile, const F& f) const
  {
    const auto first_from = [&](std::size_t number) {
      return std::partition_point(placed.moved.begin(), placed.moved.end(),
                                  [&](const Sample_beside_crease& sample) {
                                    return sample.number < number;
                                  });
    };
    for (auto sample = first_from(first_samples[tile]), end = first_from(first_samples[tile + 1]);
         sample != end; ++sample)
      f(*sample, sample->number - first_samples[tile]);
  }
};

/// Makes a vector all samples of a tile, with normals on their sides.
using Samples_of_tiles = Function_view<std::size_t, std::vector<Tile_sample>&>;

/// Finds the creases of all tiles: the same as of all samples at once, to the bit. It holds those
/// of one tile and around it at a time.
/// \param spacing `spacing_of_creases()`
template <typename ConcurrencyTag>
Creases_of_tiles find_creases_of_tiles(std::size_t number_of_tiles, double spacing,
                                       const Samples_of_tiles& samples_of, Progress& progress,
                                       Memory_counter& memory);

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CREASES_OF_TILES_H
