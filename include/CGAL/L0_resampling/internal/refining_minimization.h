// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_REFINING_MINIMIZATION_H
#define CGAL_L0_RESAMPLING_INTERNAL_REFINING_MINIMIZATION_H

#include <CGAL/L0_resampling/internal/alternating_minimization.h>
#include <CGAL/L0_resampling/internal/fit_compatible_points.h>
#include <CGAL/L0_resampling/internal/refit_sample_normals.h>
#include <CGAL/L0_resampling/internal/tangential_repulsion.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the default method adds to Algorithm 1.
struct Refinement_parameters
{
  double
    /// in place of r_p/2, so that a sample has neighbors at any number of samples
    self_neighbor_radius;
  double spreading_radius;               ///< of the samples that repel each other; no smaller
  double spacing;                        ///< of an even set of that many samples
  std::size_t number_of_repulsion_steps; ///< after each turn
  Sample_refit_kernel refit_kernel;
  std::size_t number_of_sample_refits; ///< after each fit
};

/// What happened in a minimization.
struct Refinement_counts
{
  std::size_t number_of_self_neighbor_pairs; ///< ordered, in the last turn
  std::size_t number_of_lonely_samples;      ///< without compatible points in the last fit
};

/// The fit term of the default method as rows: one a sample.
inline Fit_rows collapsed_fit_rows(const Samples<double>& samples)
{
  Fit_rows rows{Buffer<std::size_t>(samples.positions.size() + 1, 0,
                                    samples.positions.get_allocator()),
                samples.fit_centroids, samples.fit_weights};
  for (std::size_t i = 0; i < rows.offsets.size(); ++i)
    rows.offsets[i] = i;
  return rows;
}

/*!
Algorithm 1 as the default method runs it: every turn looks for the neighbors anew where the samples
are now, fits to compatible points only, corrects normals by the samples around, and spreads the
samples within the surface. Ends on the fitted surface.

\param input the points to fit to
\param samples positions and normals in and out; the order changes
\param reports out: one for each value of the penalty
*/
template <typename ConcurrencyTag, typename T, typename SolverTraits>
Refinement_counts minimize_with_refinement(const Minimization_parameters& p,
                                           const Refinement_parameters& refinement,
                                           const Fit_input<T>& input, SolverTraits& solver,
                                           Progress& progress,
                                           Samples<typename SolverTraits::FT>& samples,
                                           std::vector<Iteration_report>& reports)
{
  const auto allocator = samples.positions.get_allocator();
  // the neighbors that repel each other, where they are others than those that the energy couples
  const bool spreads_wider = !samples.scales.empty();
  const double cell_size = (std::max)(input.grid.cell_size(), spreads_wider
                                                                ? refinement.spreading_radius
                                                                : refinement.self_neighbor_radius);
  using Local_vector = typename Samples<typename SolverTraits::FT>::Local_vector;
  fill_buffer(samples.positions.size(), Local_vector(Local_vector::Zero()),
              samples.outward_directions);
  fill_buffer(samples.positions.size(), typename SolverTraits::FT(0), samples.fit_variances);
  Minimization_step<ConcurrencyTag, SolverTraits> step(p, solver, progress, allocator);
  Fit_rows fit_rows{Buffer<std::size_t>(allocator), Buffer<Vector>(allocator),
                    Buffer<double>(allocator)};
  Buffer<Upper_triangle<typename SolverTraits::FT>> normal_spreads(allocator);

  Neighborhoods neighbors{Buffer<std::size_t>(allocator), Buffer<Index>(allocator)};
  for (double penalty : p.penalties())
  {
    release(neighbors.offsets);
    release(neighbors.indices);
    fit_compatible_points<ConcurrencyTag>(input, progress, samples);
    apply_order(Search_grid_3::sorted_order<ConcurrencyTag>(samples.positions, cell_size), samples);
    const Search_grid_3 grid(samples.positions, cell_size);
    const Range_of_pairs range = {refinement.self_neighbor_radius, view_of_scales(samples.scales)};
    neighbors = find_self_neighbors<ConcurrencyTag>(grid, samples.positions, range, progress);
    refit_sample_normals<ConcurrencyTag>(refinement.refit_kernel, neighbors,
                                         refinement.number_of_sample_refits, samples);
    if constexpr (std::is_same<typename SolverTraits::FT,
                               double>::value) // as all solvers that need rows
      if (solver.needs_explicit_rows)
        fit_rows = collapsed_fit_rows(samples);

    sum_normal_spreads<ConcurrencyTag>(samples.normals, neighbors, normal_spreads);
    const Buffer<Vector> places = copy_of(samples.positions);
    reports.push_back(step(penalty, true, neighbors, normal_spreads, fit_rows, samples));
    const auto repel = [&](const Neighborhoods& others, double radius) {
      repel_tangentially<ConcurrencyTag>(others, places, radius, refinement.spacing, input.radius,
                                         refinement.number_of_repulsion_steps, samples);
    };
    if (spreads_wider)
      repel(find_self_neighbors<ConcurrencyTag>(grid, places, {refinement.spreading_radius, {}},
                                                progress),
            refinement.spreading_radius);
    else
      repel(neighbors, refinement.self_neighbor_radius);
  }

  const std::size_t number_of_lonely_samples =
    fit_compatible_points<ConcurrencyTag>(input, progress, samples);
  samples.positions = copy_of(samples.fit_centroids);
  refit_sample_normals<ConcurrencyTag>(refinement.refit_kernel, neighbors,
                                       refinement.number_of_sample_refits, samples);
  return {neighbors.indices.size(), number_of_lonely_samples};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_REFINING_MINIMIZATION_H
