// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/Any_solver.h>
#include <CGAL/L0_resampling/internal/Plan.h>
#include <CGAL/L0_resampling/internal/alternating_minimization.h>
#include <CGAL/L0_resampling/internal/choose_samples.h>
#include <CGAL/L0_resampling/internal/collapse_fit_term.h>
#include <CGAL/L0_resampling/internal/estimate_feature_confidences.h>
#include <CGAL/L0_resampling/internal/extents.h>
#include <CGAL/L0_resampling/internal/orient_normals.h>
#include <CGAL/L0_resampling/internal/prepare_points.h>
#include <CGAL/L0_resampling/internal/refining_minimization.h>
#include <CGAL/L0_resampling/internal/project_to_local_quadrics.h>
#include <CGAL/L0_resampling/internal/share_of_extent.h>
#include <CGAL/L0_resampling/internal/side_hints.h>
#include <CGAL/L0_resampling/internal/working_frame.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The result, in the coordinates of the input.
/// \tparam FT the number type of the solver
template <typename FT>
struct Oriented_points
{
  Buffer<Vector> positions;
  Buffer<Eigen::Matrix<FT, 3, 1>> normals; ///< of unit length but for rounding in `FT`
  Buffer<float> feature_confidences;       ///< in [0, 1], if they are asked for
};

/// Section 3.3: Eq. (6) by Algorithm 1, with the original and self neighbors of the start.
/// \param input used up
template <typename ConcurrencyTag, typename FT>
void minimize_from_start(const Plan& plan, const Followers& followers, Any_solver<FT>& solver,
                         Progress& progress, Report& report, Prepared_points& input,
                         Samples<FT>& samples)
{
  const auto allocator = samples.positions.get_allocator();
  const std::size_t m = samples.positions.size();
  Fit_rows fit_rows{Buffer<std::size_t>(allocator), Buffer<Vector>(allocator),
                    Buffer<double>(allocator)};
  {
    const Search_grid_3 sample_grid(samples.positions, plan.cell_size);
    progress.begin_stage("original neighbors", 0.1, m);
    report.number_of_lonely_samples = collapse_fit_term<ConcurrencyTag>(
      sample_grid, samples.positions, input.grid, input.points, input.density_weights, plan.radius,
      followers.numbers_of_samples, progress, samples.fit_weights, samples.fit_centroids);
    if constexpr (std::is_same<FT, double>::value) // as all solvers that need rows
      if (solver.needs_explicit_rows)
      {
        // Section 4.1. Merging changes the rows of Eq. (11) and not the collapsed terms, so only
        // such solvers need Algorithm 2.
        progress.begin_stage("fit rows", 0.1, 2 * m);
        fit_rows = gather_fit_rows<ConcurrencyTag>(sample_grid, samples.positions, input.grid,
                                                   input.points, input.density_weights, plan.radius,
                                                   plan.number_of_half_samplings, progress);
      }
    input.release_all();
  }

  progress.begin_stage("self neighbors", 0.03, 2 * m);
  const Neighborhoods neighbors = [&]() {
    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(samples.positions,
                                                                            plan.self_cell_size());
    apply_order<ConcurrencyTag>(order, samples);
    if (solver.needs_explicit_rows)
      apply_order(order, fit_rows);
    const Search_grid_3 grid(samples.positions, plan.self_cell_size());
    return find_self_neighbors<ConcurrencyTag>(grid, samples.positions,
                                               {plan.self_neighbor_radius, {}}, progress);
  }();
  report.number_of_self_neighbor_pairs = neighbors.indices.size();

  progress.begin_stage("L0 minimization", 0.2, plan.minimization.penalties().size());
  minimize_alternatingly<ConcurrencyTag>(plan.minimization, neighbors, fit_rows, solver, progress,
                                         samples, report.iterations);
}

/// Eq. (6) by Algorithm 1 as the default method runs it: neighbors and fit follow the samples.
/// \param input used up
template <typename ConcurrencyTag, typename FT>
void minimize_and_refine(const Plan& plan, Any_solver<FT>& solver, Progress& progress,
                         Report& report, Prepared_points& input, Samples<FT>& samples)
{
  progress.begin_stage("L0 minimization", 0.32,
                       (3 * plan.minimization.penalties().size() + 1) * samples.positions.size());
  const Fit_input<Local> fit_input{input.grid,
                                   input.points,
                                   input.normals,
                                   input.density_weights,
                                   plan.radius,
                                   square(plan.sheet_height),
                                   plan.compatible_bandwidth};
  const Refinement_parameters refinement{plan.self_neighbor_radius,
                                         plan.spreading_radius(),
                                         plan.sample_spacing,
                                         number_of_repulsion_steps,
                                         Sample_refit_kernel(plan.self_neighbor_radius,
                                                             plan.refit_bandwidth),
                                         number_of_sample_refits};
  const Refinement_counts counts = minimize_with_refinement<ConcurrencyTag>(
    plan.minimization, refinement, fit_input, solver, progress, samples, report.iterations);
  report.number_of_self_neighbor_pairs = counts.number_of_self_neighbor_pairs;
  report.number_of_lonely_samples = counts.number_of_lonely_samples;
  input.release_all();
}

/*!
Resamples: the stages of the paper, one after the other.

\param points the input, finite, at least one point; used up
\param given_normals unit or zero vectors, one a point, or none at all; used up
\param hints unit or zero vectors on the side that normals shall point to, or to the viewpoints of
the points, one a point, or none at all; used up
\param parameters checked; radii in the unit of the input
*/
template <typename ConcurrencyTag, typename FT>
Oriented_points<FT> resample(Buffer<Vector>& points, Buffer<Local_vector>& given_normals,
                             Buffer<Local_vector>& hints, const Parameters& parameters,
                             Any_solver<FT>& solver, Progress& progress, Report& report)
{
  const auto allocator = points.get_allocator();
  progress.begin_stage("sort points", 0.05, 1);
  Working_frame frame;
  frame.enter<ConcurrencyTag>(points);
  Buffer<float> scales(allocator);
  Plan plan = plan_and_scale<ConcurrencyTag>(parameters, points, frame, progress, report, scales);
  const Vector input_extent = trimmed_extent<ConcurrencyTag>(points);

  Samples<FT> samples(allocator);
  Followers followers(allocator);
  {
    Prepared_points input = prepare_points<ConcurrencyTag>(plan, points, scales, given_normals,
                                                           hints, progress, report);
    followers = choose_samples<ConcurrencyTag>(parameters, input, hints, progress, plan, samples);
    if (plan.refines)
      minimize_and_refine<ConcurrencyTag>(plan, solver, progress, report, input, samples);
    else
      minimize_from_start<ConcurrencyTag>(plan, followers, solver, progress, report, input,
                                          samples);
  }
  for (const Iteration_report& iteration : report.iterations)
    report.converged = report.converged && iteration.solver.converged;

  const std::size_t m = samples.positions.size();
  progress.begin_stage("orient normals", 0.1, m);
  const Orientation orientation = orient_normals<ConcurrencyTag>(
    samples.positions, parameters.number_of_orientation_neighbors, plan.sample_spacing,
    side_hints(parameters, frame, samples.positions, samples.hints), progress, samples.normals);
  report.oriented_share = orientation.oriented_share;
  report.hinted_share = orientation.hinted_share;

  if (plan.refines)
  {
    // not before the signs, which pass from face to face through normals that lean over the edge:
    // planes and quadrics leave none of these
    progress.begin_stage("project to local quadrics", 0.03, m);
    project_to_local_quadrics<ConcurrencyTag, Local>(
      {quadric_radius_factor * plan.radius, plan.compatible_bandwidth, square(plan.sheet_height)},
      plan.smallest_cell_size, progress, samples);
  }

  Buffer<float> feature_confidences(allocator);
  if (parameters.with_feature_confidences)
  {
    progress.begin_stage("feature confidences", 0.05, m);
    estimate_feature_confidences<ConcurrencyTag>(samples.positions, samples.normals,
                                                 plan.sample_spacing, plan.compatible_bandwidth,
                                                 progress, feature_confidences);
  }
  progress.end_stage();
  followers.append_values(samples.start_indices, samples.normals);
  followers.append_values(samples.start_indices, feature_confidences);
  followers.append_positions(samples.start_indices, samples.positions);
  const Vector result_extent = plain_extent(samples.positions);
  report.extent_share = share_of_extent(input_extent.data(), plan.noise, result_extent.data(),
                                        plan.sample_spacing);

  const std::size_t samples_per_task = 4096;
  for_each_block<ConcurrencyTag>(samples.positions.size(), samples_per_task,
                                 [&](std::size_t begin, std::size_t end) {
                                   for (std::size_t i = begin; i < end; ++i)
                                     samples.positions[i] = frame.leave(samples.positions[i]);
                                 });
  return {std::move(samples.positions), std::move(samples.normals), std::move(feature_confidences)};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H
