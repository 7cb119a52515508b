// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MINIMIZATION_STEP_H
#define CGAL_L0_RESAMPLING_INTERNAL_MINIMIZATION_STEP_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/energy/Fit_rows.h>
#include <CGAL/L0_resampling/internal/energy/pair_terms.h>
#include <CGAL/L0_resampling/internal/kernels/negligible_displacement.h>
#include <CGAL/L0_resampling/internal/kernels/shrinkage.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

inline Iteration_report iteration_report(const Minimization_parameters& p, const Turn& turn,
                                         const Energy_sums& sums, std::size_t number_of_pairs,
                                         const Solver_report& solver)
{
  Iteration_report report;
  report.penalty = turn.penalty;
  report.regularized = turn.regularizes;
  report.fit_energy = sums.fit / p.squared_radius;
  report.regularization_energy = sums.regularization / p.squared_radius;
  report.normal_energy = turn.penalty * sums.squared_normal_misfit / p.squared_radius;
  report.sparsity_energy = p.normal_weight * p.sparsity_unit * p.sparsity_unit
                           * double(sums.number_of_active_pairs) / p.squared_radius;
  report.active_pair_share = number_of_pairs
                               ? double(sums.number_of_active_pairs) / double(number_of_pairs)
                               : 0;
  report.solver = solver;
  return report;
}

/// Lines 2 to 4 of Algorithm 1, and the arrays they work on from turn to turn.
template <typename ConcurrencyTag, typename SolverTraits>
class Minimization_step
{
  using FT = typename SolverTraits::FT;
  using Local_vector = Eigen::Matrix<FT, 3, 1>;

  const Minimization_parameters& m_parameters;
  SolverTraits& m_solver;
  Progress& m_progress;
  Buffer<FT> m_pair_weights, m_normal_offsets;
  Buffer<Local_vector> m_right_hand_side, m_displacements;
  double m_right_hand_side_scale = negligible_displacement; // the largest of the turns so far

public:
  Minimization_step(const Minimization_parameters& parameters, SolverTraits& solver,
                    Progress& progress, const Counting_allocator<Vector>& allocator)
    : m_parameters(parameters), m_solver(solver), m_progress(progress), m_pair_weights(allocator),
      m_normal_offsets(allocator), m_right_hand_side(allocator), m_displacements(allocator)
  {}

  /// Moves the samples to the minimum of Eq. (10).
  /// \param normal_spreads `sum_normal_spreads()`
  /// \param fit_rows the fit rows of Eq. (11), for solvers that need them; may be empty for others
  /// \returns the terms of Eq. (7) after line 2 and what the solver did
  Iteration_report operator()(const Turn& turn, const Neighborhoods& neighbors,
                              const Buffer<Upper_triangle<FT>>& normal_spreads,
                              const Fit_rows& fit_rows, Samples<FT>& samples)
  {
    const Minimization_parameters& p = m_parameters;
    const std::size_t m = samples.positions.size(), number_of_pairs = neighbors.indices.size();
    const Range_of_pairs range = {p.range_of_pairs, view_of_scales(samples.scales),
                                  view_of_scales(samples.spreading_radii)};
    m_right_hand_side.resize(m);
    fill_buffer(m, Local_vector(Local_vector::Zero()), m_displacements);
    resize_to_overwrite(m_solver.needs_explicit_rows ? number_of_pairs : 0, m_normal_offsets);
    resize_to_overwrite(number_of_pairs, m_pair_weights);

    // Line 4, of the iteration before or of "Initialize"
    if (!turn.regularizes)
      fill_buffer(number_of_pairs, FT(0), m_pair_weights);
    else
    {
      Buffer<FT> density_weights(m, samples.positions.get_allocator());
      update_weights<ConcurrencyTag>(samples.positions, samples.normals, neighbors,
                                     p.mean_number_of_neighbors > 0
                                       ? p.mean_number_of_neighbors
                                       : double(number_of_pairs) / double(m),
                                     p.squared_bandwidth, p.squared_radius, square(p.maximum_jump),
                                     range, p.regularization_weight, density_weights,
                                     m_pair_weights);
    }
    m_progress.advance(0);

    // Line 2: Eq. (8), (9). Beyond these bounds one term of Eq. (7) is lost in the rounding of the
    // others, whatever the penalty.
    const FT bounded_penalty = FT((std::min)((std::max)(turn.penalty, 1e-15), 1e15));
    const double threshold = shrinkage_threshold(p.normal_weight, turn.penalty, p.sparsity_unit,
                                                 p.maximum_jump);
    const Energy_sums sums = shrink_normal_offsets<ConcurrencyTag, FT>(
      samples, neighbors, m_pair_weights, bounded_penalty,
      Shrunk_jumps<FT>(threshold, p.half_width_of_shrinkage), range, m_right_hand_side,
      m_normal_offsets);
    m_progress.advance(0);

    // Line 3: Eq. (10), for the displacements
    const double scale_so_far = m_right_hand_side_scale;
    m_right_hand_side_scale = (std::max)(scale_so_far, std::sqrt(sums.squared_right_hand_side));
    Explicit_rows<FT> rows;
    if constexpr (std::is_same<FT, double>::value) // as all solvers that need them
      rows = fit_rows.view(samples.positions, m_normal_offsets);
    const Quadratic_problem<FT> problem{{samples.fit_weights.data(), Eigen::Index(m)},
                                        neighbors.view(),
                                        {coordinates(samples.normals), 3, Eigen::Index(m)},
                                        {m_pair_weights.data(), Eigen::Index(number_of_pairs)},
                                        {coordinates(m_right_hand_side), 3, Eigen::Index(m)},
                                        bounded_penalty,
                                        {normal_spreads.front().data(), 6, Eigen::Index(m)},
                                        m_solver.needs_explicit_rows ? &rows : nullptr,
                                        scale_so_far,
                                        samples.positions.get_allocator().counter,
                                        p.low_end_of_spectrum(turn)};
    const Solver_report solver_report = m_solver.solve(
      problem, Eigen::Map<Eigen::Matrix<FT, Eigen::Dynamic, 1>>(coordinates(m_displacements),
                                                                Eigen::Index(3 * m)));
    for_each_block<ConcurrencyTag>(m, samples_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        samples.positions[i] += m_displacements[i].template cast<double>();
    });
    m_progress.advance(1);
    return iteration_report(p, turn, sums, number_of_pairs, solver_report);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MINIMIZATION_STEP_H
