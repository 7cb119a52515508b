// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_BLOCK_CHEBYSHEV_SOLVER_TRAITS_H
#define CGAL_L0_RESAMPLING_BLOCK_CHEBYSHEV_SOLVER_TRAITS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/L0_resampling/internal/energy/Matrix_free_solver.h>
#include <CGAL/L0_resampling/internal/kernels/chebyshev_steps.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

The default solver: Chebyshev's semi-iteration on \f$ Hx = g \f$ of `Quadratic_problem`, which never
forms \f$ H \f$, preconditioned by its 3 x 3 diagonal blocks \f$ D_i \f$.

The number of steps, and the coefficients of each, depend on the weights \f$ \alpha \f$ and
\f$ \beta \f$ and on the tolerance, but not on any sum over the samples. So what one part of a
cloud looks like has no influence on the samples of another part, beyond the reach of the steps: not
on a single bit. The residual is found for the report only.

Where few points hold many samples, the steps may not reach the tolerance, and the report says so;
`Block_conjugate_gradient_solver_traits` does.

The result is bitwise the same for `Sequential_tag` and for `Parallel_tag` with any number of
threads.

`solve()` takes arrays of 17 numbers a sample, booked with the problem's `memory`, and gives them
back at its end.

\cgalModels{L0ResamplingSolverTraits}

\tparam FT_ `float` or `double`
\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
*/
template <typename FT_ = double, typename ConcurrencyTag = Sequential_tag>
class Block_chebyshev_solver_traits
#ifndef DOXYGEN_RUNNING
  : private internal::Matrix_free_solver<FT_, ConcurrencyTag>
#endif
{
  using Base = internal::Matrix_free_solver<FT_, ConcurrencyTag>;
  using Base::direction;
  using Base::for_each_block;
  using Base::m_blocks;
  using Base::m_directions;
  using Base::m_maximum_number_of_iterations;
  using Base::m_residuals;
  using Base::m_tolerance;
  using Base::sum_over_blocks;

public:
  using FT = FT_;
  static constexpr bool needs_explicit_rows = false;
  static constexpr double default_tolerance = internal::default_chebyshev_tolerance;
  /// What `solve()` books for each sample.
  static constexpr std::size_t bytes_per_sample = 17 * sizeof(FT);

  /// \param tolerance the relative residual to reach from an initial guess of zero, which decides
  /// how many steps are taken
  /// \param maximum_number_of_iterations of one solve
  /// \throws std::invalid_argument if `tolerance` is not in (0, 1)
  explicit Block_chebyshev_solver_traits(
    double tolerance = default_tolerance,
    std::size_t maximum_number_of_iterations = internal::maximum_number_of_chebyshev_steps)
    : Base(tolerance, maximum_number_of_iterations)
  {}

  /// Solves `problem`, from the initial guess `x`, which becomes the solution. The residual of the
  /// report is the one that the recurrence keeps.
  /// \throws Solver_error if a value is not finite; `x` is then unspecified
  Solver_report solve(const Quadratic_problem<FT>& problem,
                      Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>> x);

private:
  struct Start_sums
  {
    double squared_rhs = 0;              // g^T g
    std::size_t number_of_non_zeros = 0; // of the initial guess

    Start_sums& operator+=(const Start_sums& other)
    {
      squared_rhs += other.squared_rhs;
      number_of_non_zeros += other.number_of_non_zeros;
      return *this;
    }
  };

  /// D, r = g, and the initial guess as the first direction.
  Start_sums start(const Quadratic_problem<FT>& problem, const FT* x, std::size_t begin,
                   std::size_t end)
  {
    const FT* const rhs = problem.right_hand_side.data();
    Start_sums sums;
    for (std::size_t i = begin; i < end; ++i)
    {
      m_blocks[i] = internal::diagonal_block(problem, i);
      FT* const p = direction(i);
      p[3] = p[7] = 0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        p[c] = x[3 * i + c];
        m_residuals[3 * i + c] = rhs[3 * i + c];
        sums.squared_rhs += double(rhs[3 * i + c]) * double(rhs[3 * i + c]);
        sums.number_of_non_zeros += x[3 * i + c] != 0;
      }
      internal::complete_direction(problem, i, p);
    }
    return sums;
  }

  /// r -= H p
  /// \returns r^T r
  double subtract_product(const Quadratic_problem<FT>& problem)
  {
    const auto of_block = [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t i = begin; i < end; ++i)
      {
        FT own[3], of_others[3];
        internal::multiply_block(m_blocks[i], direction(i), own);
        internal::multiply_couplings(problem, m_directions.data(), i, of_others);
        FT* const r = &m_residuals[3 * i];
        for (std::size_t c = 0; c < 3; ++c)
        {
          r[c] -= own[c] - of_others[c];
          sum += double(r[c]) * double(r[c]);
        }
      }
      return sum;
    };
    return sum_over_blocks(problem.number_of_samples(), of_block);
  }

  /// p = keep p + gain D^{-1} r, x += p
  void take_step(const Quadratic_problem<FT>& problem, FT keep, FT gain, FT* x, std::size_t begin,
                 std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      FT z[3];
      internal::solve_block(m_blocks[i], &m_residuals[3 * i], z);
      FT* const p = direction(i);
      for (std::size_t c = 0; c < 3; ++c)
      {
        p[c] = keep * p[c] + gain * z[c];
        x[3 * i + c] += p[c];
      }
      internal::complete_direction(problem, i, p);
    }
  }
};

#ifndef DOXYGEN_RUNNING
// not inline, so that programs that link with the compiled library do not instantiate it
template <typename FT_, typename ConcurrencyTag>
Solver_report Block_chebyshev_solver_traits<FT_, ConcurrencyTag>::solve(
  const Quadratic_problem<FT>& problem, Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>> x)
{
  const std::size_t m = problem.number_of_samples();
  CGAL_precondition(std::size_t(x.size()) == 3 * m);
  const typename Base::Arrays_of_one_solve arrays(*this, m, false, problem.memory);

  const Start_sums sums = sum_over_blocks(m, [&](std::size_t begin, std::size_t end) {
    return start(problem, x.data(), begin, end);
  });
  if (!std::isfinite(sums.squared_rhs))
    internal::throw_values_not_finite();
  if (sums.squared_rhs == 0)
  {
    x.setZero();
    return Solver_report();
  }

  double squared_residual = sums.squared_rhs;
  if (sums.number_of_non_zeros > 0)
    squared_residual = subtract_product(problem);
  Solver_report report;
  report.iterations = internal::number_of_chebyshev_steps(problem.low_end_of_spectrum, m_tolerance,
                                                          m_maximum_number_of_iterations);
  internal::Chebyshev_steps steps(problem.low_end_of_spectrum);
  for (std::size_t step = 0; step < report.iterations; ++step, steps.advance())
  {
    for_each_block(m, [&](std::size_t begin, std::size_t end) {
      take_step(problem, FT(steps.keep), FT(steps.gain), x.data(), begin, end);
    });
    squared_residual = subtract_product(problem);
  }
  if (!std::isfinite(squared_residual))
    internal::throw_values_not_finite();
  report.relative_residual = std::sqrt(squared_residual)
                             / internal::residual_scale(problem, std::sqrt(sums.squared_rhs));
  report.converged = report.relative_residual <= m_tolerance;
  return report;
}
#endif

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template class Block_chebyshev_solver_traits<float, Sequential_tag>;
extern template class Block_chebyshev_solver_traits<double, Sequential_tag>;
#ifdef CGAL_LINKED_WITH_TBB
extern template class Block_chebyshev_solver_traits<float, Parallel_tag>;
extern template class Block_chebyshev_solver_traits<double, Parallel_tag>;
#endif
#endif

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_BLOCK_CHEBYSHEV_SOLVER_TRAITS_H
