// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_EIGEN_CHOLESKY_SOLVER_TRAITS_H
#define CGAL_L0_RESAMPLING_EIGEN_CHOLESKY_SOLVER_TRAITS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/L0_resampling/internal/energy/normal_matrix.h>
#include <CGAL/L0_resampling/internal/energy/solver_settings.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

Sparse Cholesky factorization of \f$ A^T A \f$, one of the ways Section 3.3 of the paper names:
exact up to rounding, at a cost in time and memory that grows faster than the number of samples.

\cgalModels{L0ResamplingSolverTraits}

\tparam FT_ `float` or `double`
*/
template <typename FT_ = double>
class Eigen_cholesky_solver_traits
{
  double m_tolerance;

public:
  using FT = FT_;
  static constexpr bool needs_explicit_rows = false;

  /// A direct solver cannot be told when to stop: the tolerance only decides what the report calls
  /// converged.
  /// \throws std::invalid_argument if `tolerance` is not in (0, 1)
  explicit Eigen_cholesky_solver_traits(double tolerance = 1e-5)
    : m_tolerance(internal::checked_tolerance(tolerance))
  {}

  /// Solves `problem` and writes the solution to `x`; the initial guess does not matter.
  /// \throws Solver_error if a value is not finite or the factorization breaks down; `x` is then as
  /// before
  Solver_report solve(const Quadratic_problem<FT>& problem,
                      Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>> x) const
  {
    using Vector = Eigen::Matrix<FT, Eigen::Dynamic, 1>;
    using Matrix = internal::Normal_matrix<FT>;
    CGAL_precondition(std::size_t(x.size()) == 3 * problem.number_of_samples());
    const Eigen::Map<const Vector> rhs(problem.right_hand_side.data(), x.size());
    const double rhs_norm = rhs.template cast<double>().norm();
    if (!std::isfinite(rhs_norm))
      internal::throw_values_not_finite();
    if (rhs_norm == 0)
    {
      x.setZero();
      return Solver_report();
    }

    const Matrix matrix = internal::assemble_normal_matrix(problem);
    using Ordering = Eigen::AMDOrdering<typename Matrix::StorageIndex>;
    const Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Ordering> factorization(matrix);
    if (factorization.info() != Eigen::Success)
      throw Solver_error(
        "The Cholesky factorization broke down: the quadratic problem is not positive definite.");
    const Vector solution = factorization.solve(rhs);
    if (!solution.allFinite())
      internal::throw_values_not_finite();
    x = solution;

    Solver_report report;
    const Vector residual = rhs - matrix * solution;
    report.relative_residual = residual.template cast<double>().norm()
                               / internal::residual_scale(problem, rhs_norm);
    report.converged = report.relative_residual <= m_tolerance;
    return report;
  }
};

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template class Eigen_cholesky_solver_traits<double>;
#endif

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_EIGEN_CHOLESKY_SOLVER_TRAITS_H
