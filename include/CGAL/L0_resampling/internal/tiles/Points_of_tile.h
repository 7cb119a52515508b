// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_TILE_H
#define CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_TILE_H

#include <CGAL/L0_resampling/internal/cloud/areas_of_points.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>
#include <CGAL/L0_resampling/internal/kernels/levels_of_scales.h>
#include <CGAL/L0_resampling/internal/samples/initialize_samples.h>
#include <CGAL/L0_resampling/internal/tiles/Disks_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Runs_of_cells.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the first stages find of the points of a tile and its halo, before it is known where
/// samples start.
struct Points_of_tile
{
  struct Run
  {
    std::uint64_t key;       ///< `Search_grid_3::key_of_run()`
    std::uint64_t end;       ///< in `order`; the next run begins there
    std::uint64_t neighbors; ///< of its points, in the balls of the normal filter
  };

  Disks_of_tile disks;
  /// In their first order, but for indices, samples and areas: outliers stand for nothing.
  Buffer<Point_in_cloud> points;
  Buffer<Index> order; ///< those that are used, in the order of the whole cloud, run by run
  // Of these:
  Buffer<unsigned char> are_distinct; ///< whether each is the first at its place
  Buffer<unsigned char> are_first;    ///< whether each is the first in its cell
  Buffer<Points_of_ball> balls;       ///< `balls_of_points()`
  std::vector<Run> runs;

  static constexpr std::size_t bytes_per_point = sizeof(Point_in_cloud) + sizeof(Index) + 2
                                                 + sizeof(Points_of_ball);

  /// Notes the areas that the points stand for.
  /// \param of_cloud what `add_up_disks()` says
  /// \param radius of the disk at scale 1
  /// \param number_of_samples of the cloud
  /// \returns what the tile adds to the sums over all tiles
  Share_of_tile share(const Disks_of_tile& of_cloud, double radius, std::size_t number_of_samples)
  {
    if (disks.keeps_outliers > of_cloud.keeps_outliers)
      drop_all();
    const Areas_of_cells areas(radius, of_cloud.units, number_of_samples);
    Share_of_tile share;
    share.area_per_unit = Areas::area_per_unit_of(radius);
    std::uint64_t k = 0;
    for (const Run& run : runs)
    {
      Sums_over_points sums;
      bool has_own = false;
      while (k < run.end)
      {
        const std::uint64_t first = k;
        do
          ++k;
        while (k < run.end && are_first[k] == 0);
        const std::uint64_t units = areas.units_of_each(&balls[first], k - first,
                                                        level_of_scale(points[order[first]].scale));
        for (std::uint64_t i = first; i < k; ++i)
        {
          Point_in_cloud& point = points[order[i]];
          point.units = units;
          has_own = has_own || point.is_own != 0;
          const bool is_distinct = are_distinct[i] != 0;
          sums += {is_distinct ? units : 0, 1, is_distinct, units, 0};
        }
      }
      sums.neighbors = run.neighbors;
      share.runs.push_back({run.key, has_own ? sums : Sums_over_points()});
    }
    return share;
  }

  /// Once the areas were noted: the points, with their place in the order of the cloud and the
  /// samples that start on them.
  /// \param starts what comes before the runs
  /// \param starts_evenly by area, and not as the points do
  Buffer<Point_in_cloud> placed(const Run_prefix_sums& starts, std::uint64_t number_of_samples,
                                std::uint64_t seed, bool starts_evenly) &&
  {
    Buffer<std::uint64_t> units;
    units.reserve(order.size());
    for (const Index i : order)
      units.push_back(points[i].units);
    Sources sources;
    Buffer<Index> distinct;
    auto start = starts.runs.begin();
    std::uint64_t next = 0;
    for (const Run& run : runs)
    {
      const std::uint64_t first = std::exchange(next, run.end);
      while (start != starts.runs.end() && start->key < run.key)
        ++start;
      if (start == starts.runs.end() || start->key != run.key)
        continue;
      distinct.clear();
      for (std::uint64_t k = first; k < run.end; ++k)
      {
        points[order[k]].index = Index(start->sums.points + (k - first));
        if (are_distinct[k] != 0)
          distinct.push_back(Index(k));
      }
      if (starts_evenly)
        add_sources_by_area(distinct, units, start->sums.units, starts.all.units, number_of_samples,
                            seed, sources);
      else
        add_sources_by_points(distinct, start->sums.distinct, starts.all.distinct,
                              number_of_samples, seed, sources);
    }
    for (const Buffer<Index>* list : {&sources.on_points, &sources.near_points})
      for (const Index source : *list)
        ++points[order[source]].number_of_samples;
    return std::move(points);
  }

private:
  void drop_all()
  {
    for (const Index i : order)
      points[i].units = 0;
    order.clear();
    runs.clear();
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_TILE_H
