// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_CUDA_LEAST_SQUARES_SOLVER_TRAITS_H
#define CGAL_L0_RESAMPLING_CUDA_LEAST_SQUARES_SOLVER_TRAITS_H

#include <CGAL/license/L0_resampling.h>

#ifndef CGAL_L0_LINKED_WITH_CUDA
#error "CUDA_least_squares_solver_traits.h needs CUDA: link with CGAL::L0_CUDA_support"
#endif

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/L0_resampling/internal/device/cuda_answer.h>
#include <CGAL/L0_resampling/internal/device/cuda_interface.h>
#include <CGAL/L0_resampling/internal/energy/least_squares_rows.h>
#include <CGAL/L0_resampling/internal/energy/solver_settings.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

The paper's way on its own hardware: conjugate gradients for least squares on the rows
\f$ A = \{A_f; A_r; A_n\} \f$ of Eq. (11), without a preconditioner, with cuSPARSE and cuBLAS. The
stages run on the CPU; each solve brings \f$ A \f$ and \f$ A^T \f$ to the device. There for fidelity
and comparison, as `Eigen_least_squares_solver_traits` is.

\cgalModels{L0ResamplingSolverTraits}

\tparam FT_ `float` or `double`
*/
template <typename FT_ = double>
class CUDA_least_squares_solver_traits
{
public:
  using FT = FT_;
  static constexpr bool needs_explicit_rows = true;

  /// \param tolerance when to stop: relative residual as in `L0ResamplingSolverTraits::solve()`
  /// \param maximum_number_of_iterations of one solve
  /// \throws std::invalid_argument if `tolerance` is not in (0, 1)
  explicit CUDA_least_squares_solver_traits(double tolerance = 1e-5,
                                            std::size_t maximum_number_of_iterations = 100)
    : m_tolerance(internal::checked_tolerance(tolerance)),
      m_maximum_number_of_iterations(maximum_number_of_iterations)
  {}

  /// Solves `problem`, from the initial guess `x`, which becomes the solution.
  /// \pre `problem.rows` is not null
  /// \throws Solver_error if a value is not finite; `x` is then as before
  /// \throws Device_error if there is no usable device, or it failed
  /// \throws std::bad_alloc if the device has no memory for A
  Solver_report solve(const Quadratic_problem<FT>& problem,
                      Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>> x) const
  {
    CGAL_precondition(problem.rows != nullptr);
    CGAL_precondition(std::size_t(x.size()) == 3 * problem.number_of_samples());
    const double rhs_norm = problem.right_hand_side.template cast<double>().norm();
    const double scale = rhs_norm > 0 ? internal::residual_scale(problem, rhs_norm) / rhs_norm : 1;
    const auto system = internal::least_squares_system(problem);
    const std::decay_t<decltype(system.matrix)> transposed(system.matrix.transpose());
    Eigen::Matrix<FT, Eigen::Dynamic, 1> solution(x);
    internal::cuda::Least_squares_report device_report;
    internal::throw_if_failed(internal::cuda::solve_least_squares(
      view(system.matrix), view(transposed), system.rhs.data(), m_tolerance * scale,
      m_maximum_number_of_iterations, solution.data(), device_report));
    x = solution;
    Solver_report report;
    report.iterations = device_report.iterations;
    report.relative_residual = device_report.relative_residual / scale;
    report.converged = report.relative_residual <= m_tolerance;
    return report;
  }

private:
  template <typename Matrix>
  static internal::cuda::Sparse_matrix<FT> view(const Matrix& matrix)
  {
    static_assert(sizeof(typename Matrix::StorageIndex) == sizeof(long long),
                  "indices have 64 bits on both sides");
    return {static_cast<long long>(matrix.rows()), static_cast<long long>(matrix.cols()),
            reinterpret_cast<const long long*>(matrix.outerIndexPtr()),
            reinterpret_cast<const long long*>(matrix.innerIndexPtr()), matrix.valuePtr()};
  }

  double m_tolerance;
  std::size_t m_maximum_number_of_iterations;
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_CUDA_LEAST_SQUARES_SOLVER_TRAITS_H
