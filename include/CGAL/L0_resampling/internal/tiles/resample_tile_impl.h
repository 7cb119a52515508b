// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_IMPL_H

#include <CGAL/L0_resampling/internal/driver/run.h>
#include <CGAL/L0_resampling/internal/tiles/Fact_finder.h>
#include <CGAL/L0_resampling/internal/tiles/Share_finder.h>
#include <CGAL/L0_resampling/internal/tiles/Tile_backend.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

template <typename ConcurrencyTag>
Scales scales_of_regions(Buffer<Vector>& points, const std::function<bool(const Vector&)>& is_core,
                         const Facts_of_cloud& facts, Progress& progress)
{
  Working_frame frame;
  frame.enter<ConcurrencyTag>(points, *facts.frame);
  const double radius = paper_radius(*facts.extents);
  return estimate_scales<ConcurrencyTag, Local>(
    points, radius, [&](const Vector& p) { return is_core(frame.leave(p * radius)); }, progress);
}

template <typename ConcurrencyTag, typename FT>
Facts_of_cloud facts_of_points(Buffer<Vector>& points, const Parameters& parameters,
                               Any_solver<FT>& solver, Progress& progress, Report& report,
                               std::vector<Point_in_cloud>& points_in_cloud)
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

/// Calls the stages that find what a tile adds to the sums over all tiles, and then `f(plan)`.
/// \returns nothing if none of the points are used
template <typename Finder, typename F>
Share_of_tile find_share(const Parameters& parameters, Finder& finder, const F& f)
{
  const Plan plan = plan_call(parameters, finder);
  if (plan.drops_outliers())
  {
    finder.begin_stage("find outliers", 0.4, finder.number_of_points());
    finder.drop_outliers(plan);
  }
  finder.begin_stage("areas", 0.3, finder.number_of_points());
  finder.sort_points(plan);
  Share_of_tile share = finder.share(plan);
  f(plan);
  finder.end(plan);
  return share;
}

template <typename ConcurrencyTag, typename FT>
Share_of_tile share_of_tile(Buffer<Vector>& points, const Facts_of_cloud& facts,
                            const Parameters& parameters, const Room_of_tile& room,
                            Any_solver<FT>& solver, Progress& progress, Report& report)
{
  Share_finder<ConcurrencyTag, FT> finder(facts, room, points, parameters, solver, progress,
                                          report);
  return find_share(parameters, finder, [](const Plan&) {});
}

template <typename ConcurrencyTag, typename FT>
std::vector<Point_in_cloud> points_of_tile(Buffer<Vector>& points, const Facts_of_cloud& facts,
                                           const Parameters& parameters, const Room_of_tile& room,
                                           const Starts_of_runs& starts, Any_solver<FT>& solver,
                                           Progress& progress, Report& report)
{
  Share_finder<ConcurrencyTag, FT> finder(facts, room, points, parameters, solver, progress,
                                          report);
  find_share(parameters, finder, [&](const Plan& plan) { finder.place_points(plan, starts); });
  return finder.take_points();
}

template <typename ConcurrencyTag, typename FT>
Samples_of_tile<FT> resample_tile(Buffer<Vector>& points, const std::vector<Point_in_cloud>& known,
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
