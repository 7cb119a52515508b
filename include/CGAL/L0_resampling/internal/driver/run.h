// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RUN_H
#define CGAL_L0_RESAMPLING_INTERNAL_RUN_H

#include <CGAL/L0_resampling/internal/kernels/chebyshev_steps.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Finds the facts of the cloud, plans the call, and makes r_p the unit of the backend's frame.

A backend is a processor and the arrays of one call on it: `Cpu_backend` or `cuda::Cuda_backend`.
Each stage is a member, which notes in `report()` what it finds. What throws, or asks the caller
whether to go on, is the backend's business too: `begin_stage()` and `end_turn()` do.
*/
template <typename Backend>
Plan plan_call(const Parameters& parameters, Backend& backend)
{
  backend.begin_stage("sort points", 0.05, 1);
  Facts facts = backend.find_facts();
  if (rules_of(parameters.method).estimates_scales)
    facts.scales = backend.estimate_scales(paper_radius(facts));
  Plan plan = make_plan(parameters, facts);
  Range_of_scales range;
  if (plan.follows_scales)
    range = backend.estimate_scale_field(facts.robust_diagonal,
                                         reference_scales(parameters, plan, facts));
  plan.maximum_radius = range.largest;
  plan.minimization.coupling = coupling_of_radii(range.largest / range.least);
  backend.set_unit(plan.unit);
  report_radii(plan, range, backend.frame(), backend.report());
  if (plan.is_noise_known)
    backend.report().estimated_noise = parameters.noise;
  return plan;
}

/// Section 3.1 and Eq. (5): which points are used, in which order, their normals and weights.
template <typename Backend>
void prepare_points(const Plan& plan, Backend& backend)
{
  if (plan.drops_outliers())
  {
    backend.begin_stage("find outliers", 0.05, backend.number_of_points());
    backend.drop_outliers(plan);
    backend.begin_stage("sort points", 0.05, 1);
  }
  backend.sort_points(plan);
  if constexpr (Backend::foresees_memory) // if not, it knows from the numbers of points
    backend.refuse_too_little_memory(plan);

  const std::size_t n = backend.number_of_points();
  if (!backend.are_all_normals_given())
  {
    backend.begin_stage("PCA normals", 0.1, n);
    backend.estimate_pca_normals(plan);
  }
  backend.take_given_normals();
  const std::size_t number_of_passes = plan.number_of_filter_passes;
  backend.begin_stage("filter normals", 0.4, n * (number_of_passes + plan.number_of_refits));
  for (std::size_t pass = 0; pass < number_of_passes; ++pass)
  {
    if (plan.refits_before(pass))
      backend.refit_normals(plan);
    backend.filter_normals(plan, pass);
    backend.end_turn(pass, number_of_passes);
  }
  backend.begin_stage("density weights", 0.08, n);
  backend.weigh_density(plan);
}

/// Section 3.2: the first S. The area that the points stand for tells the spacing of the samples.
template <typename Backend>
void choose_samples(Plan& plan, Backend& backend)
{
  const std::size_t m = plan.number_of_samples;
  backend.begin_stage("initial samples", 0.02,
                      m + (plan.uses_areas ? backend.number_of_points() : 0));
  if (plan.uses_areas)
  {
    plan.set_sample_spacing(std::sqrt(backend.total_area(plan) / double(m)));
    backend.report().sample_spacing = backend.frame().length_of_input(plan.sample_spacing);
  }
  backend.choose_samples(plan);
}

/// Section 3.3: Eq. (6) by Algorithm 1, with the original and self neighbors of the start.
template <typename Backend>
void minimize_from_start(const Plan& plan, Backend& backend)
{
  const std::size_t m = backend.number_of_samples();
  const std::vector<Turn> turns = plan.minimization.turns();
  backend.begin_stage("original neighbors", 0.1, m);
  backend.collapse_fit_term(plan);
  if constexpr (Backend::may_need_explicit_rows)
    if (backend.needs_explicit_rows())
    {
      // Section 4.1. Merging changes the rows of Eq. (11) and not the collapsed terms, so only
      // such solvers need Algorithm 2.
      backend.begin_stage("fit rows", 0.1, 2 * m);
      backend.gather_fit_rows(plan);
    }
  backend.release_points();

  backend.begin_stage("self neighbors", 0.03, 2 * m);
  backend.sort_samples(plan);
  backend.find_self_neighbors(plan);
  backend.begin_stage("L0 minimization", 0.12, turns.size());
  for (const Turn& turn : turns)
  {
    backend.minimize_once(plan, turn);
    backend.end_turn(turn.number, turns.size());
  }
  backend.release_neighbors();
}

/// Eq. (6) by Algorithm 1 as the default method runs it: every turn looks for the neighbors anew
/// where the samples are now, fits to compatible points only, and spreads the samples within the
/// surface. Ends on the fitted surface.
template <typename Backend>
void minimize_with_refinement(const Plan& plan, Backend& backend)
{
  const std::vector<Turn> turns = plan.minimization.turns();
  backend.begin_stage("L0 minimization", 0.32,
                      (3 * turns.size() + 1) * backend.number_of_samples());
  for (const Turn& turn : turns)
  {
    backend.sort_samples(plan);
    backend.fit_compatible_points(plan, false);
    backend.find_self_neighbors(plan);
    backend.minimize_once(plan, turn);
    backend.repel_tangentially(plan);
    backend.end_turn(turn.number, turns.size());
  }
  backend.fit_compatible_points(plan, true);
  backend.take_fitted_positions();
  backend.release_neighbors();
}

/// What the default method adds: samples as disks that the points scatter about, surfaces fitted to
/// disks in balls of several sizes, and their mean by risk. Sides may be found before or after it.
template <typename Backend>
void refine_samples(const Plan& plan, Backend& backend)
{
  backend.begin_stage("refine samples", 0.3,
                      (number_of_refinements * (2 * number_of_fit_scales + number_of_clearances + 3)
                       + 6 + std::size_t(plan.finds_deviations))
                        * backend.number_of_samples());
  backend.begin_refinement();
  backend.spread_samples(plan);
  backend.split_sheets(plan);
  for (int round = 0; round < number_of_refinements; ++round)
  {
    backend.spread_samples(plan);
    backend.share_points(plan);
    for (int scale = 0; scale < number_of_fit_scales; ++scale)
    {
      backend.fit_disks(scale);
      backend.weigh_by_risk(scale);
    }
    backend.take_mean_surfaces();
    for (int clearance = 0; clearance < number_of_clearances; ++clearance)
      backend.keep_clear_of_creases();
    if (plan.finds_deviations && round + 1 == number_of_refinements)
      backend.find_deviations();
    backend.end_turn(std::size_t(round), std::size_t(number_of_refinements));
  }
  backend.end_refinement();
}

/// Resamples: the stages of the paper, one after the other. The result is left in the backend.
/// \param plan for the points in the backend's frame; but for the spacing of the samples, if areas
/// tell it
template <typename Backend>
void run(Plan plan, Backend& backend)
{
  backend.begin(plan);
  prepare_points(plan, backend);
  choose_samples(plan, backend);
  if (plan.refines)
    minimize_with_refinement(plan, backend);
  else
    minimize_from_start(plan, backend);

  const std::size_t m = backend.number_of_samples();
  backend.begin_stage("orient normals", 0.1, m);
  backend.orient_normals(plan);
  if (plan.refines)
  {
    // not before the signs, which pass from face to face through normals that lean over the edge:
    // planes and quadrics leave none of these
    backend.begin_stage("project to local quadrics", 0.03, m);
    backend.project_to_local_quadrics(plan);
    if (plan.finds_deviations)
      backend.begin_deviations(plan);
    if (plan.has_disks_enough())
      refine_samples(plan, backend);
    backend.release_points();
  }
  if constexpr (Backend::finds_feature_confidences) // if not, whoever takes the result does
    if (plan.finds_feature_confidences)
    {
      backend.begin_stage("feature confidences", 0.05, m);
      backend.estimate_feature_confidences(plan);
    }
  backend.append_followers();
  backend.measure_extent(plan);
  backend.leave_frame();
  backend.end(plan);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RUN_H
