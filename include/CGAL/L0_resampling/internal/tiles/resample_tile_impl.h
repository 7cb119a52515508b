// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_IMPL_H

#include <CGAL/L0_resampling/internal/cloud/find_outliers.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/driver/Cpu_points.h>
#include <CGAL/L0_resampling/internal/driver/run.h>
#include <CGAL/L0_resampling/internal/tiles/Fact_finder.h>
#include <CGAL/L0_resampling/internal/tiles/Tile_backend.h>
#include <CGAL/L0_resampling/internal/tiles/Tile_point_finder.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

template <typename ConcurrencyTag, typename FT>
Facts_of_cloud facts_of_points(Buffer<Vector>& points, const Parameters& parameters,
                               Any_solver<FT>& solver, Progress& progress, Report& report,
                               Buffer<Point_in_cloud>& points_in_cloud)
{
  Fact_finder<ConcurrencyTag, FT> finder(points, parameters, solver, progress, report);
  Plan plan = plan_call(parameters, finder);
  if (plan.drops_outliers())
  {
    finder.begin_stage("find outliers", 0.4, finder.number_of_points());
    finder.drop_outliers(plan);
  }
  finder.begin_stage("areas", 0.3, 3 * finder.number_of_points());
  finder.sort_points(plan);
  finder.weigh_density(plan);
  choose_samples(plan, finder);
  finder.end(plan);
  points_in_cloud = finder.take_points();
  return finder.facts();
}

template <typename ConcurrencyTag>
Neighbors_of_tile find_neighbors_of_tile(Buffer<Vector>& points, const Facts_of_cloud& facts,
                                         const Parameters& parameters, const Own_blocks& own,
                                         Progress& progress, Report& report)
{
  const std::size_t points_per_block = 65536;
  Neighbors_of_tile found;
  const Buffer<unsigned char> are_own = own.flags_of<ConcurrencyTag>(points);
  Cpu_points<ConcurrencyTag> all(points, progress, report, facts);
  const Plan plan = plan_call(parameters, all);
  found.scales = std::move(all.scales());
  if (plan.follows_scales)
    found.counts += block_sum<ConcurrencyTag>(
      points.size(), points_per_block, [&](std::size_t begin, std::size_t end) {
        Neighbor_counts counts;
        for (std::size_t i = begin; i < end; ++i)
          if (are_own[i])
            counts.add_scale(found.scales.empty() ? 1 : found.scales[i]);
        return counts;
      });
  if (plan.drops_outliers())
  {
    all.begin_stage("neighbors", 0.9, points.size());
    for_each_number_of_neighbors<Local, ConcurrencyTag>(
      points, plan.radius, view_of_scales(found.scales), progress, [&](Index i, double number) {
        if (are_own[i])
          found.counts.neighbors.add(number);
      });
  }
  return found;
}

template <typename ConcurrencyTag, typename FT>
Points_of_tile find_points_of_tile(Buffer<Vector>& points, Buffer<float> scales,
                                   const Facts_of_cloud& facts, const Parameters& parameters,
                                   const Own_blocks& own, Any_solver<FT>& solver,
                                   Progress& progress, Report& report)
{
  Buffer<unsigned char> are_own = own.flags_of<ConcurrencyTag>(points);
  Tile_point_finder<ConcurrencyTag, FT> finder(facts, std::move(are_own), points, std::move(scales),
                                               parameters, solver, progress, report);
  const Plan plan = plan_call(parameters, finder);
  finder.share_runs(plan, own);
  if (plan.drops_outliers())
  {
    finder.begin_stage("find outliers", 0.4, finder.number_of_points());
    finder.drop_outliers(plan);
  }
  finder.begin_stage("areas", 0.3, finder.number_of_points());
  finder.sort_points(plan);
  Points_of_tile found = finder.find(plan);
  finder.end(plan);
  return found;
}

template <typename ConcurrencyTag, typename FT>
Samples_of_tile<FT> resample_tile(Buffer<Vector>& points, const Buffer<Point_in_cloud>& known,
                                  const Facts_of_cloud& facts, bool finds_sides,
                                  const Parameters& parameters, Any_solver<FT>& solver,
                                  Progress& progress, Report& report)
{
  Buffer<Local_vector> no_normals(points.get_allocator()), no_hints(points.get_allocator());
  Tile_backend<ConcurrencyTag, FT> backend(facts, known, finds_sides, points, no_normals, no_hints,
                                           parameters, solver, progress, report);
  run(plan_call(parameters, backend), backend);
  return backend.take_found();
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_IMPL_H
