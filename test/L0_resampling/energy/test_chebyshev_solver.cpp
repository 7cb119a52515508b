// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Block_chebyshev_solver_traits: its tolerance decides how many steps it takes, its report says
// what residual they leave, and far samples have no influence.

#include "energy/solver_checks.h"

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>

#include <cmath>
#include <cstddef>

namespace test {
namespace {

using CGAL::L0_resampling::Block_chebyshev_solver_traits;

using Chebyshev = Block_chebyshev_solver_traits<double>;

} // namespace

template <>
constexpr bool counts_steps_before<Chebyshev> = true;

namespace {

/// The number of steps and their coefficients depend on the weights and the tolerance only. So
/// problems side by side are solved as each by itself, to the last bit, and so is a problem scaled
/// by a power of two.
void test_knows_no_sums()
{
  Generator generator(17);
  Paper_problem near = random_paper_problem(200, 0.15, 1, generator),
                far = random_paper_problem(300, 0.15, 1, generator);
  for (Paper_problem::Fit_term& t : far.fit) // longer ways, and weaker fits
    t = {t.i, 30 * t.q, 100 * t.v};
  const std::size_t n = near.samples.size();
  Paper_problem both = near;
  both.samples.insert(both.samples.end(), far.samples.begin(), far.samples.end());
  both.normals.insert(both.normals.end(), far.normals.begin(), far.normals.end());
  both.densities.insert(both.densities.end(), far.densities.begin(), far.densities.end());
  for (const Paper_problem::Fit_term& t : far.fit)
    both.fit.push_back({t.i + n, t.q, t.v});
  for (const Paper_problem::Pair_term& t : far.pairs)
    both.pairs.push_back({t.i + n, t.k + n, t.stretch, t.offset});

  Collapsed_problem<double> collapsed(near), collapsed_both(both);
  const Eigen::Index size = Eigen::Index(3 * n);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size),
                  y = Eigen::VectorXd::Zero(Eigen::Index(3 * both.samples.size()));
  const Solver_report report = Chebyshev().solve(collapsed.view(), x);
  CHECK(Chebyshev().solve(collapsed_both.view(), y).iterations == report.iterations);
  CHECK(x == y.head(size));

  for (double& g : collapsed.right_hand_side)
    g *= 0x1p-40;
  y = Eigen::VectorXd::Zero(size);
  CHECK(Chebyshev().solve(collapsed.view(), y).iterations == report.iterations);
  CHECK(x == 0x1p40 * y);
}

/// A tolerance asks for no more steps than it takes, nor for fewer.
void test_number_of_steps()
{
  const auto steps = [](double alpha, double beta, double coupling, double tolerance,
                        std::size_t most) {
    using namespace CGAL::L0_resampling::internal;
    return number_of_chebyshev_steps(low_end_of_spectrum(alpha, beta, coupling), tolerance, most);
  };
  for (const double beta : {0.1, 0.4, 1.6})
  {
    Generator generator(18);
    Collapsed_problem<double> collapsed(random_paper_problem(300, 0.15, beta, generator));
    for (const double tolerance : {1e-2, 1e-3, 1e-6})
    {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(3 * 300);
      const Solver_report report = Chebyshev(tolerance).solve(collapsed.view(), x);
      CHECK(report.iterations == steps(0.15, beta, 1, tolerance, 100) && report.converged);
      CHECK(std::abs(relative_residual(collapsed.view(), x) - report.relative_residual) < 1e-12);
    }
  }
  CHECK(steps(0.15, 0.1, 1, 1e-3, 100) < steps(0.15, 1.6, 1, 1e-3, 100));
  CHECK(steps(0.15, 1.6, 1, 1e-3, 100) < steps(3, 1.6, 1, 1e-3, 100));
  CHECK(steps(0.15, 1.6, 1, 1e-3, 100) < steps(0.15, 1.6, 8, 1e-3, 100));
  CHECK(steps(0, 1e-15, 1, 1e-3, 100) >= 1);
  CHECK(steps(0.15, 1e30, 1, 1e-3, 100) == 100);
  CHECK(steps(0.15, 1, 1, 1e-9, 1) == 1);
}

/// The report tells what the steps have left, also as a part of an earlier right-hand side.
void test_report()
{
  Generator generator(11);
  Collapsed_problem<double> collapsed(random_paper_problem(300, 0.15, 1, generator));
  Eigen::VectorXd x = random_start(collapsed.view(), generator);
  const Solver_report report = Chebyshev(1e-9, 1).solve(collapsed.view(), x);
  CHECK(!report.converged && report.iterations == 1 && report.relative_residual > 1e-9);
  CHECK(std::abs(relative_residual(collapsed.view(), x) - report.relative_residual) < 1e-12);

  Quadratic_problem<double> problem = collapsed.view();
  problem.right_hand_side_scale = 1000 * problem.right_hand_side.norm();
  const Solver_report scaled = Chebyshev(1e-9).solve(problem, x);
  CHECK(std::abs(relative_residual(problem, x) - 1000 * scaled.relative_residual) < 1e-12);
}

} // namespace
} // namespace test

int main()
{
  using namespace test;
  Generator generator(11);
  test_agrees_with_ceres(Chebyshev(1e-13, 1000), generator);
  test_zeros(Chebyshev(1e-3));
  test_refuses_values_that_are_not_finite(Chebyshev(1e-3));
  test_refuses_tolerances<Chebyshev>();
  test_number_of_steps();
  test_knows_no_sums();
  test_report();
  test_float(Block_chebyshev_solver_traits<float>(1e-5));
  for (const double weakness : {1e6, 1e9, 1e12, 1e15, 1e18})
    test_weak_fit<Chebyshev>(weakness);
#ifdef CGAL_LINKED_WITH_TBB
  test_threads_change_no_bit<Block_chebyshev_solver_traits>();
#endif
  test_reuse<Chebyshev>();
  return test::result();
}
