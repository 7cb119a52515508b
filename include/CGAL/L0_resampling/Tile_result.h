// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TILE_RESULT_H
#define CGAL_L0_RESAMPLING_TILE_RESULT_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>
#include <CGAL/L0_resampling/internal/tiles/stitch_tiles.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// A point of the result, as a tile has found it. `Tiled_resampling::sides()` or `stitching()` says
/// whether its normal has to be turned.
using Tile_sample = internal::Tile_sample;

/// \ingroup PkgL0ResamplingRef
/// What a tile gives.
struct Tile_result
{
  std::vector<Tile_sample> samples;       ///< those that the tile keeps
  std::vector<Tile_sample> near_border;   ///< those of them that are near to other tiles
  std::vector<Tile_sample> beyond_border; ///< the same of its halo, which others keep
  std::vector<double> evidence;           ///< of each tree: for the sides of its samples
  /// If sides are found for all tiles at once: what they follow from. Each of these is a tree.
  internal::Unoriented_samples unoriented;
  Report report;
};

namespace internal {

/// `Tiled_resampling::Cancelled`
struct Tiles_cancelled
{};

/// \param margin by which the box is larger on each side, or smaller if it is negative
inline bool is_within(const Tile_sample& sample, const Source_box& box, double margin)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (sample.position[axis] < box.low[axis] - margin
        || sample.position[axis] > box.high[axis] + margin)
      return false;
  return true;
}

/// Shares out the samples that a tile has found.
/// \param positions of the samples, in the unit of the input
/// \param box of the tile
/// \param overlap_width how near to the border of the box samples are compared with those of other
/// tiles
/// \param result out
template <typename FT>
void take_samples_of_tile(const Samples_of_tile<FT>& samples,
                          const Buffer<std::array<double, 3>>& positions, const Source_box& box,
                          double overlap_width, Tile_result& result)
{
  constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  const bool are_sides_found = samples.unoriented.empty();
  std::vector<Tile_sample>& own = result.unoriented.own;
  std::vector<Tile_sample>& elsewhere = result.unoriented.leaders_elsewhere;
  result.samples.reserve(positions.size());
  std::vector<std::uint32_t> numbers(positions.size(), none); // of the trees
  for (std::size_t tree = 0; tree < samples.unoriented.size(); ++tree)
    if (samples.are_trees_own[tree] != 0)
    {
      numbers[tree] = std::uint32_t(own.size());
      own.push_back(samples.unoriented[tree]);
    }
  if (!are_sides_found)
    result.evidence.push_back(0); // samples near the border are of one tree
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const auto& normal = samples.points.normals[i];
    Tile_sample sample = {positions[i], {normal[0], normal[1], normal[2]}, 0};
    const bool is_kept = samples.are_own[i] != 0;
    if (!is_kept && !is_within(sample, box, overlap_width))
      continue;
    std::uint32_t& number = numbers[samples.trees[i]];
    if (are_sides_found)
    {
      if (number == none)
      {
        number = std::uint32_t(result.evidence.size());
        result.evidence.push_back(0);
      }
      sample.tree = number;
    }
    if (!is_kept)
    {
      result.beyond_border.push_back(sample);
      continue;
    }
    if (!is_within(sample, box, -overlap_width))
      result.near_border.push_back(sample);
    if (are_sides_found)
      result.evidence[number] += double(samples.confidences[i]) - 0.5;
    else
    {
      if (number == none)
      {
        number = std::uint32_t(own.size() + elsewhere.size());
        elsewhere.push_back(samples.unoriented[samples.trees[i]]);
      }
      sample.tree = number;
    }
    result.samples.push_back(sample);
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILE_RESULT_H
