// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Models of L0ResamplingSolverTraits that stop by a residual, or factorize, keep the concept, and
// agree with Ceres, which gets Eq. (10) as printed.

#include "energy/solver_checks.h"

#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace test {
namespace {

using CGAL::L0_resampling::Block_conjugate_gradient_solver_traits;
using CGAL::L0_resampling::Eigen_cholesky_solver_traits;
using CGAL::L0_resampling::Eigen_least_squares_solver_traits;

using Block = Block_conjugate_gradient_solver_traits<double>;
using Cholesky = Eigen_cholesky_solver_traits<double>;
using Least_squares = Eigen_least_squares_solver_traits<double>;

} // namespace

template <>
constexpr bool is_direct<Cholesky> = true;

namespace {

/// `loose` and `tight` have tolerances 1e-3 and 1e-9, `impatient` has 1e-9 and at most one
/// iteration.
template <typename Solver>
void test_stopping_rule(Solver loose, Solver tight, Solver impatient, Generator& generator)
{
  using FT = typename Solver::FT;
  Collapsed_problem<FT> collapsed(random_paper_problem(300, 0.15, 1, generator));

  Coordinates<FT> x = random_start(collapsed.view(), generator);
  const Solver_report loose_report = loose.solve(collapsed.view(), x);
  CHECK(loose_report.converged && loose_report.relative_residual <= 1e-3);
  CHECK(std::abs(relative_residual(collapsed.view(), x) - loose_report.relative_residual) < 1e-12);
  CHECK(is_direct<Solver> ? loose_report.iterations == 0 : loose_report.iterations > 0);

  // From where the loose one stopped, it has nothing to do, and the tight one less than from afar.
  Eigen::VectorXd same = x;
  CHECK(loose.solve(collapsed.view(), same).iterations == 0);
  CHECK(is_direct<Solver> || same == x);
  Coordinates<FT> from_afar = random_start(collapsed.view(), generator);
  const std::size_t iterations_from_afar = tight.solve(collapsed.view(), from_afar).iterations;
  const Solver_report tight_report = tight.solve(collapsed.view(), x);
  CHECK(tight_report.converged && relative_residual(collapsed.view(), x) <= 1.001e-9);
  CHECK(
    is_direct<
      Solver> || (tight_report.iterations > 0 && tight_report.iterations < iterations_from_afar));

  if (!is_direct<Solver>)
  {
    x.setZero();
    const Solver_report report = impatient.solve(collapsed.view(), x);
    CHECK(!report.converged && report.iterations == 1);
    CHECK(report.relative_residual > 1e-9 && report.relative_residual < 1);
    CHECK(std::abs(relative_residual(collapsed.view(), x) - report.relative_residual) < 1e-12);
  }
}

/// Where an earlier solve had a right-hand side a thousand times as long, a thousandth of the
/// residual is asked for.
template <typename Solver>
void test_scale_of_earlier_solves(Solver tight, Generator& generator)
{
  using FT = typename Solver::FT;
  Collapsed_problem<FT> collapsed(random_paper_problem(300, 0.15, 1, generator));
  Quadratic_problem<FT> problem = collapsed.view();
  Coordinates<FT> x = Coordinates<FT>::Zero(Eigen::Index(3 * problem.number_of_samples()));
  const std::size_t iterations = tight.solve(problem, x).iterations;

  problem.right_hand_side_scale = 1000 * double(problem.right_hand_side.norm());
  x.setZero();
  const Solver_report report = tight.solve(problem, x);
  CHECK(report.converged && report.relative_residual <= 1e-9);
  CHECK(std::abs(relative_residual(problem, x) - 1000 * report.relative_residual) < 1e-12);
  CHECK(is_direct<Solver> || report.iterations < iterations);

  problem.right_hand_side_scale = 0.001
                                  * double(problem.right_hand_side.norm()); // its own is longer
  x.setZero();
  CHECK(tight.solve(problem, x).iterations == iterations);
}

template <typename Solver>
void test_model(Solver loose, Solver tight, Solver impatient, Solver tightest)
{
  Generator generator(11);
  test_agrees_with_ceres(tightest, generator);
  test_stopping_rule(loose, tight, impatient, generator);
  test_scale_of_earlier_solves(tight, generator);
  test_zeros(loose);
  test_refuses_values_that_are_not_finite(loose);
  test_refuses_tolerances<Solver>();
}

/// A tolerance far below rounding ends in a report, but in no exception.
template <typename FT>
void test_tolerances_below_rounding()
{
  Generator generator(13);
  Collapsed_problem<FT> collapsed(random_paper_problem(100, 0.15, 1, generator));
  for (const double tolerance : {1e-20, 1e-60, 1e-300})
  {
    Coordinates<FT> x = random_start(collapsed.view(), generator);
    Block_conjugate_gradient_solver_traits<FT>(tolerance, 10000).solve(collapsed.view(), x);
    CHECK(relative_residual(collapsed.view(), x) < 10 * double(std::numeric_limits<FT>::epsilon()));
    x = random_start(collapsed.view(), generator);
    Eigen_least_squares_solver_traits<FT>(tolerance, 100).solve(collapsed.view(), x);
    CHECK(relative_residual(collapsed.view(), x)
          < 100 * double(std::numeric_limits<FT>::epsilon()));
    CHECK(!Eigen_cholesky_solver_traits<FT>(tolerance).solve(collapsed.view(), x).converged);

    const Paper_problem exact = exact_paper_problem();
    Collapsed_problem<FT> collapsed_exact(exact);
    x = exact_solution(exact).template cast<FT>();
    CHECK(Block_conjugate_gradient_solver_traits<FT>(tolerance)
            .solve(collapsed_exact.view(), x)
            .converged);
    CHECK(
      Eigen_least_squares_solver_traits<FT>(tolerance).solve(collapsed_exact.view(), x).converged);
    CHECK(x == exact_solution(exact).template cast<FT>());
  }
}

} // namespace
} // namespace test

int main()
{
  using namespace test;
  static_assert(!Block::needs_explicit_rows && !Cholesky::needs_explicit_rows
                  && Least_squares::needs_explicit_rows,
                "only the paper's way needs the rows");
  test_model(Block(1e-3), Block(1e-9), Block(1e-9, 1), Block(1e-13, 1000));
  test_model(Cholesky(1e-3), Cholesky(1e-9), Cholesky(1e-9), Cholesky(1e-13));
  test_model(Least_squares(1e-3), Least_squares(1e-9, 1000), Least_squares(1e-9, 1),
             Least_squares(1e-13, 1000));
  test_float(Block_conjugate_gradient_solver_traits<float>(1e-5));
  test_float(Eigen_cholesky_solver_traits<float>(1e-5));
  test_float(Eigen_least_squares_solver_traits<float>(1e-5));
  test_tolerances_below_rounding<double>();
  test_tolerances_below_rounding<float>();
  for (const double weakness : {1e6, 1e9, 1e12, 1e15, 1e18})
    test_weak_fit<Block>(weakness);
#ifdef CGAL_LINKED_WITH_TBB
  test_threads_change_no_bit<Block_conjugate_gradient_solver_traits>();
#endif
  test_reuse<Block>();
  return test::result();
}
