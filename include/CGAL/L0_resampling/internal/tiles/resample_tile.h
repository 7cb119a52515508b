// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H

#include <CGAL/L0_resampling/internal/tiles/Tile_backend.h>
#include <CGAL/L0_resampling/internal/driver/run.h>

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
/// \param facts all but the scales
template <typename ConcurrencyTag>
Scales scales_of_regions(Buffer<Vector>& points, const std::function<bool(const Vector&)>& is_core,
                         const Cloud_facts& facts, Progress& progress)
{
  Working_frame frame;
  frame.enter<ConcurrencyTag>(points);
  const Facts of_cloud = {std::size_t(facts.number_of_points),
                          std::ldexp(facts.box_diagonal, frame.exponent()),
                          std::ldexp(facts.robust_diagonal, frame.exponent()), frame.exponent()};
  const double radius = paper_radius(of_cloud);
  return estimate_scales<ConcurrencyTag, Local>(
    points, radius, [&](const Vector& p) { return is_core(frame.leave(p * radius)); }, progress);
}

/// What the blocks of a tile add to the sums over all blocks.
/// \param points of the tile and its halo, at least one; used up
/// \param parameters checked; `number_of_output_points` is about that of the tile and its halo
/// \param blocks sorted
template <typename ConcurrencyTag, typename FT>
std::vector<Block_share> shares_of_tile(Buffer<Vector>& points, const Cloud_facts& facts,
                                        const Parameters& parameters, const Block_lattice& lattice,
                                        const std::vector<Block>& blocks, Any_solver<FT>& solver,
                                        Progress& progress, Report& report)
{
  Buffer<Local_vector> no_normals(points.get_allocator()), no_hints(points.get_allocator());
  Tile_backend<ConcurrencyTag, FT> backend(facts, points, no_normals, no_hints, parameters, solver,
                                           progress, report);
  const Plan plan = plan_call(parameters, backend);
  if (plan.drops_outliers())
  {
    backend.begin_stage("find outliers", 0.4, backend.number_of_points());
    backend.drop_outliers(plan);
  }
  backend.begin_stage("areas", 0.3, backend.number_of_points());
  backend.sort_points(plan);
  const std::vector<Block_share> shares = backend.shares_of_blocks(plan, lattice, blocks);
  backend.end(plan);
  return shares;
}

/// The samples of a tile and of its halo.
template <typename FT>
struct Samples_of_tile
{
  Oriented_points<FT> points;
  Buffer<Index> blocks;      ///< where each has started, among those of the call
  Buffer<Index> trees;       ///< samples of one have sides relative to each other
  Buffer<float> confidences; ///< of their sides
};

/// Resamples a tile and its halo.
/// \param points of both, at least one; used up
/// \param parameters checked; `number_of_output_points` is the sum of `samples.numbers`, above 0
template <typename ConcurrencyTag, typename FT>
Samples_of_tile<FT> resample_tile(Buffer<Vector>& points, const Cloud_facts& facts,
                                  const Parameters& parameters, const Samples_of_blocks& samples,
                                  Any_solver<FT>& solver, Progress& progress, Report& report)
{
  Buffer<Local_vector> no_normals(points.get_allocator()), no_hints(points.get_allocator());
  Tile_backend<ConcurrencyTag, FT> backend(facts, points, no_normals, no_hints, parameters, solver,
                                           progress, report);
  backend.set_samples_of_blocks(samples);
  run(plan_call(parameters, backend), backend);
  Samples_of_tile<FT> result{backend.take_result(), copy_of(backend.blocks()),
                             copy_of(backend.trees()), copy_of(backend.confidences())};
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_H
