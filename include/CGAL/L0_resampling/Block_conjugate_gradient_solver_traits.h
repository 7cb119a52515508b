// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_BLOCK_CONJUGATE_GRADIENT_SOLVER_TRAITS_H
#define CGAL_L0_RESAMPLING_BLOCK_CONJUGATE_GRADIENT_SOLVER_TRAITS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/L0_resampling/internal/energy/Matrix_free_solver.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

Conjugate gradients on \f$ Hx = g \f$ of `Quadratic_problem`, which never form \f$ H \f$,
preconditioned by its 3 x 3 diagonal blocks \f$ D_i \f$. They adapt to the spectrum of the problem,
and so reach small tolerances, and weights far from the defaults, in few iterations. In return, each
iteration takes two sums over all samples, so that each sample has an influence on all others.

The result is bitwise the same for `Sequential_tag` and for `Parallel_tag` with any number of
threads.

`solve()` takes arrays of 20 numbers a sample, booked with the problem's `memory`, and gives them
back at its end.

\cgalModels{L0ResamplingSolverTraits}

\tparam FT_ `float` or `double`
\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
*/
template <typename FT_ = double, typename ConcurrencyTag = Sequential_tag>
class Block_conjugate_gradient_solver_traits
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
  using Base::m_products;
  using Base::m_residuals;
  using Base::m_tolerance;
  using Base::sum_over_blocks;

public:
  using FT = FT_;
  static constexpr bool needs_explicit_rows = false;
  /// What `solve()` books for each sample.
  static constexpr std::size_t bytes_per_sample = 20 * sizeof(FT);

  /// \param tolerance when to stop: relative residual as in `L0ResamplingSolverTraits::solve()`
  /// \param maximum_number_of_iterations of one solve
  /// \throws std::invalid_argument if `tolerance` is not in (0, 1)
  explicit Block_conjugate_gradient_solver_traits(double tolerance = 1e-5,
                                                  std::size_t maximum_number_of_iterations = 100)
    : Base(tolerance, maximum_number_of_iterations)
  {}

  /// Solves `problem`, from the initial guess `x`, which becomes the solution. The residual of the
  /// report is the one that the recurrence keeps.
  /// \throws Solver_error if a value is not finite; `x` is then unspecified
  Solver_report solve(const Quadratic_problem<FT>& problem,
                      Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>> x)
  {
    const std::size_t m = problem.number_of_samples();
    CGAL_precondition(std::size_t(x.size()) == 3 * m);
    const typename Base::Arrays_of_one_solve arrays(*this, m, true, problem.memory);

    for_each_block(m, [&](std::size_t begin, std::size_t end) { start(problem, begin, end); });
    const bool starts_at_zero =
      0 == sum_over_blocks(m, [&](std::size_t begin, std::size_t end) {
        return (x.segment(Eigen::Index(3 * begin), Eigen::Index(3 * (end - begin))).array()
                != FT(0))
          .count();
      });
    if (!starts_at_zero)
    {
      for_each_block(m, [&](std::size_t begin, std::size_t end) {
        update_directions(problem, x.data(), FT(0), begin, end);
      });
      sum_over_blocks(m, [&](std::size_t begin, std::size_t end) {
        return multiply(problem, begin, end);
      });
    }
    Sums sums = sum_over_blocks(m, [&](std::size_t begin, std::size_t end) {
      return compute_residuals(problem, starts_at_zero, begin, end);
    });
    if (!std::isfinite(sums.rhs) || !std::isfinite(sums.residual))
      internal::throw_values_not_finite();
    if (sums.rhs == 0)
    {
      x.setZero();
      return Solver_report();
    }

    Solver_report report;
    const double scale = internal::residual_scale(problem, std::sqrt(sums.rhs));
    const double squared_limit = m_tolerance * m_tolerance * scale * scale;
    double previous_energy = 0;
    while (sums.residual > squared_limit && report.iterations < m_maximum_number_of_iterations)
    {
      const FT ratio = report.iterations == 0 ? FT(0) : FT(sums.energy / previous_energy);
      for_each_block(m, [&](std::size_t begin, std::size_t end) {
        update_directions(problem, m_products.data(), ratio, begin, end);
      });
      const Curvatures curvatures = sum_over_blocks(m, [&](std::size_t begin, std::size_t end) {
        return multiply(problem, begin, end);
      });
      if (!std::isfinite(curvatures.full))
        internal::throw_values_not_finite();
      // H is positive definite, but near the rounding of its terms a step could go anywhere.
      if (curvatures.full <= 100 * std::numeric_limits<FT>::epsilon() * curvatures.diagonal)
        break;

      previous_energy = sums.energy;
      const FT step = FT(sums.energy / curvatures.full);
      sums = sum_over_blocks(m, [&](std::size_t begin, std::size_t end) {
        return take_step(step, x.data(), begin, end);
      });
      ++report.iterations;
      if (!std::isfinite(sums.residual))
        internal::throw_values_not_finite();
    }
    report.relative_residual = std::sqrt(sums.residual) / scale;
    report.converged = sums.residual <= squared_limit;
    return report;
  }

private:
  /// Sums over samples, in `double` whatever `FT` is.
  struct Sums
  {
    double rhs = 0;      // g^T g
    double residual = 0; // r^T r
    double energy = 0;   // r^T D^{-1} r

    Sums& operator+=(const Sums& other)
    {
      rhs += other.rhs;
      residual += other.residual;
      energy += other.energy;
      return *this;
    }
  };

  struct Curvatures
  {
    double full = 0;     // p^T H p
    double diagonal = 0; // p^T D p

    Curvatures& operator+=(const Curvatures& other)
    {
      full += other.full;
      diagonal += other.diagonal;
      return *this;
    }
  };

  /// D, and p = 0
  void start(const Quadratic_problem<FT>& problem, std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      std::fill_n(direction(i), internal::numbers_of_direction, FT(0));
      m_blocks[i] = internal::diagonal_block(problem, i);
    }
  }

  /// r = g - H x and z = D^{-1} r
  Sums compute_residuals(const Quadratic_problem<FT>& problem, bool starts_at_zero,
                         std::size_t begin, std::size_t end)
  {
    const FT* const rhs = problem.right_hand_side.data();
    Sums sums;
    for (std::size_t i = begin; i < end; ++i)
    {
      for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      {
        sums.rhs += double(rhs[c]) * double(rhs[c]);
        m_residuals[c] = starts_at_zero ? rhs[c] : rhs[c] - m_products[c];
      }
      precondition(i, sums);
    }
    return sums;
  }

  /// z = D^{-1} r, in place of the product that is used up, and the sums over r and z.
  void precondition(std::size_t i, Sums& sums)
  {
    const FT* const r = &m_residuals[3 * i];
    FT* const z = &m_products[3 * i];
    internal::solve_block(m_blocks[i], r, z);
    for (std::size_t c = 0; c < 3; ++c)
    {
      sums.residual += double(r[c]) * double(r[c]);
      sums.energy += double(r[c]) * double(z[c]);
    }
  }

  /// p = source + ratio * p
  void update_directions(const Quadratic_problem<FT>& problem, const FT* source, FT ratio,
                         std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      FT* const p = direction(i);
      for (std::size_t c = 0; c < 3; ++c)
        p[c] = source[3 * i + c] + ratio * p[c];
      internal::complete_direction(problem, i, p);
    }
  }

  /// The product H p.
  Curvatures multiply(const Quadratic_problem<FT>& problem, std::size_t begin, std::size_t end)
  {
    Curvatures curvatures;
    for (std::size_t i = begin; i < end; ++i)
    {
      FT of_others[3];
      internal::multiply_couplings(problem, m_directions.data(), i, of_others);
      const FT* const pi = direction(i);
      FT* const product = &m_products[3 * i];
      internal::multiply_block(m_blocks[i], pi, product);
      for (std::size_t c = 0; c < 3; ++c)
      {
        curvatures.diagonal += double(pi[c]) * double(product[c]);
        product[c] -= of_others[c];
        curvatures.full += double(pi[c]) * double(product[c]);
      }
    }
    return curvatures;
  }

  /// x += step * p, r -= step * H p, z = D^{-1} r
  Sums take_step(FT step, FT* x, std::size_t begin, std::size_t end)
  {
    Sums sums;
    for (std::size_t i = begin; i < end; ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        x[3 * i + c] += step * direction(i)[c];
        m_residuals[3 * i + c] -= step * m_products[3 * i + c];
      }
      precondition(i, sums);
    }
    return sums;
  }
};

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template class Block_conjugate_gradient_solver_traits<float, Sequential_tag>;
extern template class Block_conjugate_gradient_solver_traits<double, Sequential_tag>;
#ifdef CGAL_LINKED_WITH_TBB
extern template class Block_conjugate_gradient_solver_traits<float, Parallel_tag>;
extern template class Block_conjugate_gradient_solver_traits<double, Parallel_tag>;
#endif
#endif

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_BLOCK_CONJUGATE_GRADIENT_SOLVER_TRAITS_H
