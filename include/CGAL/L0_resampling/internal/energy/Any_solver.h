// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ANY_SOLVER_H
#define CGAL_L0_RESAMPLING_INTERNAL_ANY_SOLVER_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>

#include <Eigen/Core>

#include <type_traits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Refers to a model of `L0ResamplingSolverTraits` by a type that depends on the number type of the
/// model only, so that the stages are compiled once for all solvers of that number type.
template <typename FT_>
class Any_solver
{
public:
  using FT = FT_;
  using Unknowns = Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>>;

private:
  template <typename SolverTraits, std::size_t bytes = SolverTraits::bytes_per_sample>
  static constexpr std::size_t bytes_per_sample_of(int)
  {
    return bytes;
  }
  template <typename SolverTraits>
  static constexpr std::size_t bytes_per_sample_of(...)
  {
    return 0;
  }

  void* m_solver;
  Solver_report (*m_solve)(void*, const Quadratic_problem<FT>&, Unknowns);

public:
  const bool needs_explicit_rows;
  const std::size_t bytes_per_sample; ///< that a solve books for sure; 0 if unknown

  /// \param solver outlives this object
  template <typename SolverTraits>
  explicit Any_solver(SolverTraits& solver)
    : m_solver(&solver), m_solve([](void* s, const Quadratic_problem<FT>& problem, Unknowns x) {
        return static_cast<SolverTraits*>(s)->solve(problem, x);
      }),
      needs_explicit_rows(SolverTraits::needs_explicit_rows),
      bytes_per_sample(bytes_per_sample_of<SolverTraits>(0))
  {
    static_assert(!SolverTraits::needs_explicit_rows || std::is_same<FT, double>::value,
                  "The rows of Eq. (11) hold positions and not differences, so that a solver that "
                  "needs them has to take double.");
  }

  Solver_report solve(const Quadratic_problem<FT>& problem, Unknowns x)
  {
    return m_solve(m_solver, problem, x);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ANY_SOLVER_H
