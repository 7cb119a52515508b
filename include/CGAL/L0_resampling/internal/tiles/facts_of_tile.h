// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_TILE_H
#define CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_TILE_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/kernels/scale_field.h>
#include <CGAL/L0_resampling/internal/tiles/Own_blocks.h>
#include <CGAL/L0_resampling/internal/tiles/Ranks_of_runs.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// What a tile finds in each pass over a cloud that is not in memory, in which its facts are found.
// Parameters are the same in all of them: the points of the tile and around it, in the unit of the
// input, which are used up; the blocks whose points are its own; and the facts that were found in
// the passes before.

/// The places that balls are laid around, and those of the field of scales.
struct Places_of_tile
{
  std::vector<Run_of_places> of_balls, of_field; ///< of runs with points of its own
  /// Codes of its own points in the outermost runs, which collect what lies beyond.
  std::vector<std::uint64_t> outermost;
};

template <typename ConcurrencyTag>
Places_of_tile count_places(Buffer<Vector>& points, const Own_blocks& own,
                            const Facts_of_cloud& facts);

/// A place that balls are laid around, by its rank among all such places.
struct Ball_sample
{
  std::uint64_t rank;
  std::array<Ball_of_points, reaches_of_balls.size()> balls;

  /// Whether the call in memory looks at the ball of this reach.
  /// \param stride of the smallest balls
  bool has_ball(std::size_t reach, std::uint64_t stride) const
  {
    return rank % (stride * stride_at_reach(reaches_of_balls[reach])) == 0;
  }
};

/// The balls of the scales, in runs with points of the tile's own.
/// \param of_balls the ranks of what `count_places()` has found
/// \param number_of_reaches so many of the first ones, which have to be within the halo
template <typename ConcurrencyTag>
std::vector<Ball_sample> look_at_balls(Buffer<Vector>& points, const Own_blocks& own,
                                       const Facts_of_cloud& facts, const Ranks_of_runs& of_balls,
                                       std::size_t number_of_reaches, Progress& progress);

/// A seed of the field of scales.
struct Placed_seed
{
  std::uint64_t code;
  Seed seed;
};

/// The seeds in runs with points of the tile's own.
/// \param of_field the ranks of what `count_places()` has found
template <typename ConcurrencyTag>
std::vector<Placed_seed> look_at_seeds(Buffer<Vector>& points, const Own_blocks& own,
                                       const Facts_of_cloud& facts, const Ranks_of_runs& of_field,
                                       Progress& progress);

/// The seeds among the outermost places, which no tile has: found among these alone.
/// \param codes ascending, all different
template <typename ConcurrencyTag>
std::vector<Placed_seed> seeds_of_outermost(const std::vector<std::uint64_t>& codes,
                                            const Facts_of_cloud& facts,
                                            const Ranks_of_runs& of_field, Progress& progress);

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_TILE_H
