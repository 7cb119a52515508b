// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_EIGEN_LEAST_SQUARES_SOLVER_TRAITS_H
#define CGAL_L0_RESAMPLING_EIGEN_LEAST_SQUARES_SOLVER_TRAITS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/L0_resampling/internal/energy/least_squares_rows.h>
#include <CGAL/L0_resampling/internal/energy/solver_settings.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

The paper's way: conjugate gradients for least squares on the rows \f$ A = \{A_f; A_r; A_n\} \f$ of
Eq. (11), here Eigen's, with a diagonal preconditioner. There for fidelity and comparison: in exact
arithmetic the rows of the fit term, which make up most of \f$ A \f$, add nothing to what the
collapsed form of `Quadratic_problem` knows.

\cgalModels{L0ResamplingSolverTraits}

\tparam FT_ `float` or `double`
*/
template <typename FT_ = double>
class Eigen_least_squares_solver_traits
{
  double m_tolerance;
  std::size_t m_maximum_number_of_iterations;

public:
  using FT = FT_;
  static constexpr bool needs_explicit_rows = true;

  /// \param tolerance when to stop: relative residual as in `L0ResamplingSolverTraits::solve()`
  /// \param maximum_number_of_iterations of one solve
  /// \throws std::invalid_argument if `tolerance` is not in (0, 1)
  explicit Eigen_least_squares_solver_traits(double tolerance = 1e-5,
                                             std::size_t maximum_number_of_iterations = 100)
    : m_tolerance(internal::checked_tolerance(tolerance)),
      m_maximum_number_of_iterations(maximum_number_of_iterations)
  {}

  /// Solves `problem`, from the initial guess `x`, which becomes the solution.
  /// \pre `problem.rows` is not null
  /// \throws Solver_error if a value is not finite; `x` is then as before
  Solver_report solve(const Quadratic_problem<FT>& problem,
                      Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>> x) const
  {
    using Vector = Eigen::Matrix<FT, Eigen::Dynamic, 1>;
    CGAL_precondition(problem.rows != nullptr);
    CGAL_precondition(std::size_t(x.size()) == 3 * problem.number_of_samples());
    const double rhs_norm = problem.right_hand_side.template cast<double>().norm();
    if (rhs_norm == 0)
    {
      x.setZero();
      return Solver_report();
    }
    const double scale = internal::residual_scale(problem, rhs_norm)
                         / rhs_norm; // Eigen measures by the norm
    const auto system = internal::least_squares_system(problem);

    Eigen::LeastSquaresConjugateGradient<std::decay_t<decltype(system.matrix)>> solver;
    // Below rounding, Eigen would go on from a residual of zero to a quotient of zeros; and its
    // square must be finite.
    const double relative_tolerance = (std::min)(m_tolerance * scale, 1.);
    solver.setTolerance((std::max)(FT(relative_tolerance), std::numeric_limits<FT>::epsilon()));
    constexpr std::size_t maximum_index = std::size_t((std::numeric_limits<Eigen::Index>::max)());
    solver.setMaxIterations(
      Eigen::Index((std::min)(m_maximum_number_of_iterations, maximum_index)));
    solver.compute(system.matrix);
    const Vector solution = solver.solveWithGuess(system.rhs, x);
    if (!solution.allFinite() || !std::isfinite(solver.error()))
      internal::throw_values_not_finite();

    Solver_report report;
    report.relative_residual = double(solver.error()) / scale;
    report.converged = report.relative_residual <= m_tolerance;
    // Eigen does not count the iteration in which it converges.
    report.iterations = std::size_t(solver.iterations())
                        + std::size_t(report.converged && solution != x);
    x = solution;
    return report;
  }
};

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template class Eigen_least_squares_solver_traits<double>;
#endif

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_EIGEN_LEAST_SQUARES_SOLVER_TRAITS_H
