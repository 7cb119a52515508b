// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H

#include <CGAL/L0_resampling/internal/driver/run.h>
#include <CGAL/L0_resampling/internal/tiles/Tile_backend.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The usual scales of a cloud, from some of its regions.
/// \param points of the regions, in the unit of the input; used up
/// \param is_core called with a point in that unit: whether all that is near to it is among them
/// \param facts the frame and the extents
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

/// All facts of a cloud, as a call for all of it finds them.
/// \param points all of them, at least one; used up
/// \param parameters checked
/// \param points_in_cloud out: what is found of each point
template <typename ConcurrencyTag, typename FT>
Facts_of_cloud facts_of_points(Buffer<Vector>& points, const Parameters& parameters,
                               Any_solver<FT>& solver, Progress& progress, Report& report,
                               std::vector<Point_in_cloud>& points_in_cloud)
{
  Buffer<Local_vector> no_normals(points.get_allocator()), no_hints(points.get_allocator());
  Fact_finder<ConcurrencyTag, FT> finder(points, no_normals, no_hints, parameters, solver, progress,
                                         report);
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

/// What a tile adds to the sums over all tiles; nothing if none of its points are used.
/// \param points of the tile and its halo, at least one; used up
/// \param facts of the cloud, as far as they are known
/// \param parameters of the call for the whole cloud, checked
template <typename ConcurrencyTag, typename FT>
Share_of_tile share_of_tile(Buffer<Vector>& points, const Facts_of_cloud& facts,
                            const Parameters& parameters, const Room_of_tile& room,
                            Any_solver<FT>& solver, Progress& progress, Report& report)
{
  Buffer<Local_vector> no_normals(points.get_allocator()), no_hints(points.get_allocator());
  Tile_backend<ConcurrencyTag, FT> backend(facts, room, points, no_normals, no_hints, parameters,
                                           solver, progress, report);
  try
  {
    const Plan plan = plan_call(parameters, backend);
    if (plan.drops_outliers())
    {
      backend.begin_stage("find outliers", 0.4, backend.number_of_points());
      backend.drop_outliers(plan);
    }
    backend.begin_stage("areas", 0.3, backend.number_of_points());
    backend.sort_points(plan);
    Share_of_tile share = backend.share(plan);
    backend.end(plan);
    return share;
  }
  catch (const typename Tile_backend<ConcurrencyTag, FT>::No_samples&)
  {
    return {};
  }
}

/// The samples of a tile and of its halo.
template <typename FT>
struct Samples_of_tile
{
  Oriented_points<FT> points;
  Buffer<unsigned char> are_own; ///< whether the tile keeps each of them
  Buffer<Index> trees;           ///< samples of one have sides relative to each other
  Buffer<float> confidences;     ///< of their sides
};

/// Resamples a tile and its halo.
/// \param points of both, at least one; used up
/// \param facts of the cloud, as far as they are known
/// \param parameters of the call for the whole cloud, checked
template <typename ConcurrencyTag, typename FT>
Samples_of_tile<FT> resample_tile(Buffer<Vector>& points, const Facts_of_cloud& facts,
                                  const Parameters& parameters, const Room_of_tile& room,
                                  const Starts_of_tile& starts, Any_solver<FT>& solver,
                                  Progress& progress, Report& report)
{
  Buffer<Local_vector> no_normals(points.get_allocator()), no_hints(points.get_allocator());
  Tile_backend<ConcurrencyTag, FT> backend(facts, room, points, no_normals, no_hints, parameters,
                                           solver, progress, report);
  backend.set_starts(starts);
  try
  {
    run(plan_call(parameters, backend), backend);
  }
  catch (const typename Tile_backend<ConcurrencyTag, FT>::No_samples&)
  {}
  return {backend.take_result(), copy_of(backend.are_own()), copy_of(backend.trees()),
          copy_of(backend.confidences())};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H
