// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_TILE_RESULT_H
#define CGAL_L0_RESAMPLING_TILE_RESULT_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/Tile_findings.h>
#include <CGAL/L0_resampling/Tile_stitching.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// What a tile gives.
struct Tile_result
{
  std::vector<Tile_sample> samples;       ///< those that the tile keeps
  std::vector<Tile_sample> near_border;   ///< those of them that are near to other tiles
  std::vector<Tile_sample> beyond_border; ///< the same of its halo, which others keep
  std::vector<double> evidence;           ///< of each tree: for the sides of its samples
  /// If sides are found for all tiles at once: what they follow from. Each of these is a tree.
  Unoriented_samples unoriented;
  std::vector<std::array<double, 3>> outliers; ///< those of its points that were left out
  Tile_findings findings;
  Report report; ///< with its halo: how long stages took, for instance
};

namespace internal {

/// \param margin by which the box is larger on each side, or smaller if it is negative
inline bool is_within(const Tile_sample& sample, const Source_box& box, double margin)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (sample.position[axis] < box.low[axis] - margin
        || sample.position[axis] > box.high[axis] + margin)
      return false;
  return true;
}

/// What `share_out_samples()` shares out.
template <typename FT>
struct Found_samples
{
  const Samples_of_tile<FT>& of_tile;
  const Buffer<std::array<double, 3>>& positions; ///< in the unit of the input
  Source_box box;                                 ///< of the tile
  /// How near to the border of the box samples are compared with those of other tiles.
  double overlap_width;
};

/// Shares out the samples that a tile has found: those that it keeps, those of them that are near
/// to its border, and those beyond.
/// \param tree_of called with a sample and whether the tile keeps it: the number of its tree
/// \param result out
template <typename FT, typename TreeOf>
void share_out_samples(const Found_samples<FT>& found, const TreeOf& tree_of, Tile_result& result)
{
  const auto& [samples, positions, box, overlap_width] = found;
  result.samples.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const auto& normal = samples.points.normals[i];
    Tile_sample sample = {positions[i], {normal[0], normal[1], normal[2]}, 0};
    const bool is_kept = samples.are_own[i] != 0;
    if (!is_kept && !is_within(sample, box, overlap_width))
      continue;
    sample.tree = tree_of(i, is_kept);
    if (!is_kept)
    {
      result.beyond_border.push_back(sample);
      continue;
    }
    if (!is_within(sample, box, -overlap_width))
      result.near_border.push_back(sample);
    result.samples.push_back(sample);
  }
}

constexpr std::uint32_t no_number = (std::numeric_limits<std::uint32_t>::max)();

/// Of a tile: nothing turns its samples.
constexpr std::uint32_t number_of_known_sides = 0;

/// If the tile has found sides: trees are numbered as they come, after that of known sides.
template <typename FT>
void take_oriented_samples(const Found_samples<FT>& found, Tile_result& result)
{
  std::vector<std::uint32_t> numbers(found.positions.size(), no_number); // of the trees
  result.evidence.push_back(0);
  const auto tree_of = [&](std::size_t i, bool is_kept) {
    const Index tree = found.of_tile.trees[i];
    if (tree == tree_of_known_sides)
    {
      result.evidence[number_of_known_sides] += is_kept ? 1 : 0;
      return number_of_known_sides;
    }
    std::uint32_t& number = numbers[tree];
    if (number == no_number)
    {
      number = std::uint32_t(result.evidence.size());
      result.evidence.push_back(0);
    }
    if (is_kept)
      result.evidence[number] += double(found.of_tile.confidences[i]) - 0.5;
    return number;
  };
  share_out_samples(found, tree_of, result);
}

/// If sides are found for all tiles at once: each tree is a sample. After that of known sides,
/// those come that the tile keeps, and then those that others keep and samples of this tile follow.
template <typename FT>
void take_unoriented_samples(const Found_samples<FT>& found, Tile_result& result)
{
  std::vector<Tile_sample>& own = result.unoriented.own;
  std::vector<Tile_sample>& elsewhere = result.unoriented.leaders_elsewhere;
  const Buffer<Tile_sample>& trees = found.of_tile.unoriented;
  std::vector<std::uint32_t> numbers(trees.size(), no_number);
  for (std::size_t tree = 0; tree < trees.size(); ++tree)
    if (found.of_tile.are_trees_own[tree] != 0)
    {
      own.push_back(trees[tree]);
      numbers[tree] = std::uint32_t(own.size());
    }
  const auto tree_of = [&](std::size_t i, bool is_kept) -> std::uint32_t {
    const std::size_t tree = found.of_tile.trees[i];
    if (!is_kept || tree == tree_of_known_sides)
      return number_of_known_sides;
    if (numbers[tree] == no_number)
    {
      elsewhere.push_back(trees[tree]);
      numbers[tree] = std::uint32_t(own.size() + elsewhere.size());
    }
    return numbers[tree];
  };
  share_out_samples(found, tree_of, result);
  for (Tile_sample& sample : result.near_border)
    sample.tree = number_of_known_sides; // these are compared by their places only
  result.evidence.push_back(0);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILE_RESULT_H
