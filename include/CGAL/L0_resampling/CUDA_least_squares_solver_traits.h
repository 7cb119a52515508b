// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_CUDA_LEAST_SQUARES_SOLVER_TRAITS_H
#define CGAL_L0_RESAMPLING_CUDA_LEAST_SQUARES_SOLVER_TRAITS_H

#ifndef CGAL_L0_LINKED_WITH_CUDA
#error "CUDA_least_squares_solver_traits.h needs CUDA: link with CGAL::L0_CUDA_support"
#endif

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

The paper's way on its own hardware: conjugate gradients for least squares on the rows \f$ A = \{A_f; A_r; A_n\} \f$ of
Eq. (11), with cuSPARSE and cuBLAS. `CGAL::L0_CUDA_support` brings the definitions.

\cgalModels{L0ResamplingSolverTraits}

\tparam FT_ `float` or `double`
*/
template <typename FT_ = double>
class CUDA_least_squares_solver_traits
{
public:
  using FT = FT_;
  static constexpr bool needs_explicit_rows = true;

  /// \throws std::invalid_argument if `tolerance` is not in (0, 1)
  explicit CUDA_least_squares_solver_traits(double tolerance = 1e-5, std::size_t maximum_number_of_iterations = 100);

  /// Solves `problem`, from the initial guess `x`, which becomes the solution.
  /// \pre `problem.rows` is not null
  /// \throws Solver_error if a value is not finite; `x` is then as before
  /// \throws Device_error if there is no usable device, or it failed
  /// \throws std::bad_alloc if the device has no memory for A
  Solver_report solve(const Quadratic_problem<FT>& problem, Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>> x) const;

private:
  double m_tolerance;
  std::size_t m_maximum_number_of_iterations;
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_CUDA_LEAST_SQUARES_SOLVER_TRAITS_H
