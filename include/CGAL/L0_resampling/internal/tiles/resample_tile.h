// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/Tile_stitching.h>
#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/driver/Oriented_points.h>
#include <CGAL/L0_resampling/internal/energy/Any_solver.h>
#include <CGAL/L0_resampling/internal/tiles/Neighbors_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Own_blocks.h>
#include <CGAL/L0_resampling/internal/tiles/Points_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Samples_to_orient.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// All facts of a cloud, as a call for all of it finds them.
/// \param points all of them, at least one; used up
/// \param parameters checked
/// \param points_in_cloud out: what is found of each point
template <typename ConcurrencyTag, typename FT>
Facts_of_cloud facts_of_points(Buffer<Vector>& points, const Parameters& parameters,
                               Any_solver<FT>& solver, Progress& progress, Report& report,
                               Buffer<Point_in_cloud>& points_in_cloud);

/// The scales of the points of a tile and its halo, and the neighbors of its own.
/// \param points of the tile and its halo, at least one; used up
/// \param facts of the cloud, as far as they are known
/// \param parameters of the call for the whole cloud, checked
/// \param own the blocks of the tile
template <typename ConcurrencyTag>
Neighbors_of_tile find_neighbors_of_tile(Buffer<Vector>& points, const Facts_of_cloud& facts,
                                         const Parameters& parameters, const Own_blocks& own,
                                         Progress& progress, Report& report);

/// What is found of these points once the medians are known, and before it is known where samples
/// start. Parameters are the same, but for one.
/// \param scales those that were found; if there are none, they are found once more
template <typename ConcurrencyTag, typename FT>
Points_of_tile find_points_of_tile(Buffer<Vector>& points, Buffer<float> scales,
                                   const Facts_of_cloud& facts, const Parameters& parameters,
                                   const Own_blocks& own, Any_solver<FT>& solver,
                                   Progress& progress, Report& report);

/// The samples of a tile and of its halo.
template <typename FT>
struct Samples_of_tile
{
  Oriented_points<FT> points;
  Buffer<unsigned char> are_own;       ///< whether the tile keeps each of them
  Buffer<Index> trees;                 ///< samples of one have sides relative to each other
  Buffer<float> confidences;           ///< of their sides; none if these are not found
  Buffer<Tile_sample> unoriented;      ///< then: each tree, which is a sample
  Buffer<unsigned char> are_trees_own; ///< likewise: whether the tile keeps it
};

/// Whether a sample of a tile, or of its halo, starts on one of the points.
inline bool are_there_starts(const Buffer<Point_in_cloud>& points)
{
  return std::any_of(points.begin(), points.end(),
                     [](const Point_in_cloud& point) { return point.number_of_samples > 0; });
}

/// Those of the points that are the tile's own, and outliers.
/// \param known of each point
inline std::vector<std::array<double, 3>> own_outliers(const Buffer<Vector>& points,
                                                       const Buffer<Point_in_cloud>& known)
{
  std::vector<std::array<double, 3>> outliers;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i].is_own && known[i].units == 0)
      outliers.push_back({points[i][0], points[i][1], points[i][2]});
  return outliers;
}

/// Resamples a tile and its halo.
/// \param points of both; used up
/// \param known of each point; samples start on some
/// \param facts of the cloud, as far as they are known
/// \param finds_sides if not, each sample is a tree
/// \param parameters of the call for the whole cloud, checked
template <typename ConcurrencyTag, typename FT>
Samples_of_tile<FT> resample_tile(Buffer<Vector>& points, const Buffer<Point_in_cloud>& known,
                                  const Facts_of_cloud& facts, bool finds_sides,
                                  const Parameters& parameters, Any_solver<FT>& solver,
                                  Progress& progress, Report& report);

/// Turns the normals of the samples of all tiles, as a call for the whole cloud does.
/// \param plan of the cloud, with the spacing of its samples
/// \param parameters of the call for the whole cloud, checked
template <typename ConcurrencyTag>
void orient_tiles(const Facts_of_cloud& facts, const Plan& plan, const Parameters& parameters,
                  Progress& progress, Samples_to_orient& samples);

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H
