// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Every model of L0ResamplingSolverTraits keeps the concept, and agrees with Ceres, which gets Eq.
// (10) as printed.

#include "energy/ceres_referee.h"
#include "energy/random_problem.h"
#include "test_support.h"

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using CGAL::L0_resampling::Block_chebyshev_solver_traits;
using CGAL::L0_resampling::Block_conjugate_gradient_solver_traits;
using CGAL::L0_resampling::Eigen_cholesky_solver_traits;
using CGAL::L0_resampling::Eigen_least_squares_solver_traits;
using CGAL::L0_resampling::Quadratic_problem;
using CGAL::L0_resampling::Solver_error;
using CGAL::L0_resampling::Solver_report;
using test::Collapsed_problem;
using test::Generator;
using test::Paper_problem;
using test::Vector;

template <typename FT>
using Coordinates = Eigen::Matrix<FT, Eigen::Dynamic, 1>;

using Block = Block_conjugate_gradient_solver_traits<double>;
using Chebyshev = Block_chebyshev_solver_traits<double>;
using Cholesky = Eigen_cholesky_solver_traits<double>;
using Least_squares = Eigen_least_squares_solver_traits<double>;

/// Steps that are counted before the solve are as many as an initial guess of zero needs, even
/// where there is nothing left to do.
template <typename Solver>
constexpr bool counts_steps_before = std::is_same<Solver, Chebyshev>::value;

template <typename FT>
Coordinates<FT> random_start(const Quadratic_problem<FT>& problem, Generator& generator)
{
  Coordinates<FT> x(3 * Eigen::Index(problem.number_of_samples()));
  for (FT& c : x)
    c = FT(test::random_number(-1, 1, generator));
  return x;
}

/// \f$ \|g - Hx\| / \|g\| \f$ from the formula in the documentation of `Quadratic_problem`.
template <typename FT>
double relative_residual(const Quadratic_problem<FT>& problem, const Coordinates<FT>& x)
{
  using Vectors = Eigen::Map<const CGAL::L0_resampling::Matrix_3X<FT>>;
  const Vectors displacements(x.data(), 3, x.size() / 3);
  Eigen::Matrix3Xd residual = problem.right_hand_side.template cast<double>();
  for (Eigen::Index i = 0; i < displacements.cols(); ++i)
  {
    const auto vector = [](const Vectors& v, Eigen::Index j) -> Vector {
      return v.col(j).template cast<double>();
    };
    residual.col(i) -= double(problem.fit_weights[i]) * vector(displacements, i);
    for (std::size_t e = problem.self_neighbors.offsets[i];
         e < problem.self_neighbors.offsets[i + 1]; ++e)
    {
      const Eigen::Index k = Eigen::Index(problem.self_neighbors.indices[e]);
      const Vector d = vector(displacements, i) - vector(displacements, k);
      for (const Eigen::Index j : {i, k})
      {
        const Vector n = vector(problem.sample_normals, j);
        residual.col(i) -= double(problem.penalty) * n.dot(d) * n;
      }
      residual.col(i) -= double(problem.pair_weights[Eigen::Index(e)]) * d;
    }
  }
  return residual.norm() / problem.right_hand_side.template cast<double>().norm();
}

template <typename Solver>
void test_agrees_with_ceres(Solver solver, Generator& generator)
{
  for (const double alpha : {0.15, 0.})
    for (const double beta : {0.1, 1.7})
    {
      const Paper_problem paper = test::random_paper_problem(300, alpha, beta, generator);
      Collapsed_problem<double> collapsed(paper);
      const Eigen::VectorXd expected = test::solve_with_ceres(paper);
      for (const bool starts_at_zero : {true, false})
      {
        Eigen::VectorXd x = random_start(collapsed.view(), generator);
        if (starts_at_zero)
          x.setZero();
        const Solver_report report = solver.solve(collapsed.view(), x);
        CHECK(report.converged || (counts_steps_before<Solver> && !starts_at_zero));
        CHECK((x - expected).lpNorm<Eigen::Infinity>() < 1e-8 * expected.lpNorm<Eigen::Infinity>());
      }
    }
}

/// `loose` and `tight` have tolerances 1e-3 and 1e-9, `impatient` has 1e-9 and at most one
/// iteration.
template <typename Solver>
void test_stopping_rule(Solver loose, Solver tight, Solver impatient, Generator& generator)
{
  using FT = typename Solver::FT;
  Collapsed_problem<FT> collapsed(test::random_paper_problem(300, 0.15, 1, generator));
  const bool is_direct = std::is_same<Solver, Cholesky>::value;

  Coordinates<FT> x = random_start(collapsed.view(), generator);
  const Solver_report loose_report = loose.solve(collapsed.view(), x);
  CHECK(loose_report.converged && loose_report.relative_residual <= 1e-3);
  CHECK(std::abs(relative_residual(collapsed.view(), x) - loose_report.relative_residual) < 1e-12);
  CHECK(is_direct ? loose_report.iterations == 0 : loose_report.iterations > 0);

  // From where the loose one stopped, it has nothing to do, and the tight one less than from afar.
  Eigen::VectorXd same = x;
  CHECK(loose.solve(collapsed.view(), same).iterations == 0);
  CHECK(is_direct || same == x);
  Coordinates<FT> from_afar = random_start(collapsed.view(), generator);
  const std::size_t iterations_from_afar = tight.solve(collapsed.view(), from_afar).iterations;
  const Solver_report tight_report = tight.solve(collapsed.view(), x);
  CHECK(tight_report.converged && relative_residual(collapsed.view(), x) <= 1.001e-9);
  CHECK(is_direct
        || (tight_report.iterations > 0 && tight_report.iterations < iterations_from_afar));

  if (!is_direct)
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
  Collapsed_problem<FT> collapsed(test::random_paper_problem(300, 0.15, 1, generator));
  Quadratic_problem<FT> problem = collapsed.view();
  Coordinates<FT> x = Coordinates<FT>::Zero(Eigen::Index(3 * problem.number_of_samples()));
  const std::size_t iterations = tight.solve(problem, x).iterations;

  problem.right_hand_side_scale = 1000 * double(problem.right_hand_side.norm());
  x.setZero();
  const Solver_report report = tight.solve(problem, x);
  CHECK(report.converged && report.relative_residual <= 1e-9);
  CHECK(std::abs(relative_residual(problem, x) - 1000 * report.relative_residual) < 1e-12);
  CHECK((std::is_same<Solver, Cholesky>::value) || report.iterations < iterations);

  problem.right_hand_side_scale = 0.001
                                  * double(problem.right_hand_side.norm()); // its own is longer
  x.setZero();
  CHECK(tight.solve(problem, x).iterations == iterations);
}

/// Isolated samples with one fit row of weight 1 each, displaced by small multiples of 1/4: solved
/// to the last bit.
Paper_problem exact_paper_problem()
{
  Paper_problem paper{{}, {}, {}, {}, {}, 0.15, 1};
  for (std::size_t i = 0; i < 50; ++i)
  {
    paper.samples.push_back(Vector::Zero());
    paper.normals.push_back(Vector::UnitX());
    paper.densities.push_back(1);
    paper.fit.push_back({i, Vector(0.25, -0.5, double(i)), 1});
  }
  return paper;
}

Eigen::VectorXd exact_solution(const Paper_problem& paper)
{
  std::vector<Vector> x;
  for (const auto& t : paper.fit)
    x.push_back(t.q);
  return test::coordinates(x);
}

/// No quotient of zeros: g = 0, a start that is the solution to the last bit, and no samples at
/// all.
template <typename Solver>
void test_zeros(Solver solver)
{
  Generator generator(7);
  {
    Collapsed_problem<double> collapsed(test::random_paper_problem(50, 0.15, 1, generator));
    std::fill(collapsed.right_hand_side.begin(), collapsed.right_hand_side.end(), 0.);
    // rows that say so too: nothing pulls anywhere
    std::fill(collapsed.normal_offsets.begin(), collapsed.normal_offsets.end(), 0.);
    std::fill(collapsed.origins.begin(), collapsed.origins.end(), 0.);
    std::fill(collapsed.fit_positions.begin(), collapsed.fit_positions.end(), 0.);
    for (const bool starts_at_zero : {true, false})
    {
      Eigen::VectorXd x = random_start(collapsed.view(), generator);
      if (starts_at_zero)
        x.setZero();
      const Solver_report report = solver.solve(collapsed.view(), x);
      CHECK(x == Eigen::VectorXd::Zero(x.size()));
      CHECK(report.converged && report.iterations == 0 && report.relative_residual == 0);
    }
  }
  {
    const Paper_problem paper = exact_paper_problem();
    Collapsed_problem<double> collapsed(paper);
    Eigen::VectorXd x = exact_solution(paper);
    Solver_report report = solver.solve(collapsed.view(), x);
    CHECK(x == exact_solution(paper));
    CHECK(report.converged && report.relative_residual == 0);
    CHECK(counts_steps_before<Solver> || report.iterations == 0);

    // and from elsewhere the preconditioner is the inverse
    x.setZero();
    report = solver.solve(collapsed.view(), x);
    CHECK(report.converged);
    if (!counts_steps_before<Solver>)
    {
      CHECK((x - exact_solution(paper)).norm() < 1e-12);
      CHECK(report.iterations == std::size_t(!std::is_same<Solver, Cholesky>::value));
    }
  }
  {
    Collapsed_problem<double> collapsed(Paper_problem{{}, {}, {}, {}, {}, 0.15, 1});
    Eigen::VectorXd x;
    const Solver_report report = solver.solve(collapsed.view(), x);
    CHECK(report.converged && report.iterations == 0 && report.relative_residual == 0);
  }
}

/// The number of steps and their coefficients depend on the weights and the tolerance only. So
/// problems side by side are solved as each by itself, to the last bit, and so is a problem scaled
/// by a power of two.
void test_chebyshev_knows_no_sums()
{
  Generator generator(17);
  Paper_problem near = test::random_paper_problem(200, 0.15, 1, generator),
                far = test::random_paper_problem(300, 0.15, 1, generator);
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
void test_number_of_chebyshev_steps()
{
  const auto steps = [](double alpha, double beta, double coupling, double tolerance,
                        std::size_t most) {
    using namespace CGAL::L0_resampling::internal;
    return number_of_chebyshev_steps(low_end_of_spectrum(alpha, beta, coupling), tolerance, most);
  };
  for (const double beta : {0.1, 0.4, 1.6})
  {
    Generator generator(18);
    Collapsed_problem<double> collapsed(test::random_paper_problem(300, 0.15, beta, generator));
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

template <typename Solver>
void test_refuses_values_that_are_not_finite(Solver solver)
{
  Generator generator(8);
  Collapsed_problem<double> collapsed(test::random_paper_problem(50, 0.15, 1, generator));
  const Eigen::VectorXd start = Eigen::VectorXd::Zero(150);
  Eigen::VectorXd x = start;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    const auto planted = [&](double& in_the_problem, double& in_the_rows) {
      const double good = in_the_problem, good_row = in_the_rows;
      in_the_problem = in_the_rows = bad;
      x = start;
      CHECK_THROWS(solver.solve(collapsed.view(), x), Solver_error);
      in_the_problem = good;
      in_the_rows = good_row;
    };
    planted(collapsed.right_hand_side[20], collapsed.normal_offsets[3]);
    planted(collapsed.pair_weights[5], collapsed.normal_offsets[3]);
    planted(collapsed.fit_weights[4], collapsed.row_weights[4]);
    if (!std::is_same<Solver, Cholesky>::value) // which does not read the initial guess
    {
      x = start;
      x[11] = bad;
      CHECK_THROWS(solver.solve(collapsed.view(), x), Solver_error);
    }
  }
  {
    // finite, but not its norm, so that nothing can be said of convergence
    Collapsed_problem<double> huge(test::random_paper_problem(50, 0.15, 1, generator));
    huge.right_hand_side[20] = huge.normal_offsets[3] = 1e200;
    x = start;
    CHECK_THROWS(solver.solve(huge.view(), x), Solver_error);
  }
  x = start;
  CHECK(
    solver.solve(collapsed.view(), x).converged); // and an object that has thrown goes on to work
}

template <typename Solver>
void test_refuses_tolerances()
{
  for (const double tolerance : {0., 1., -1e-6, 2., std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()})
    CHECK_THROWS(Solver(tolerance), std::invalid_argument);
  CHECK(!test::throws<std::exception>([]() { Solver(1e-12); }));
  std::string message;
  try
  {
    Solver(1.5);
  }
  catch (const std::invalid_argument& e)
  {
    message = e.what();
  }
  CHECK(message.find("tolerance") != std::string::npos && message.find("1.5") != std::string::npos);
}

/// Its tolerance decides how many steps it takes, and its report tells what they left.
void test_chebyshev()
{
  Generator generator(11);
  test_agrees_with_ceres(Chebyshev(1e-13, 1000), generator);
  test_zeros(Chebyshev(1e-3));
  test_refuses_values_that_are_not_finite(Chebyshev(1e-3));
  test_refuses_tolerances<Chebyshev>();
  test_number_of_chebyshev_steps();
  test_chebyshev_knows_no_sums();

  Collapsed_problem<double> collapsed(test::random_paper_problem(300, 0.15, 1, generator));
  Eigen::VectorXd x = random_start(collapsed.view(), generator);
  const Solver_report report = Chebyshev(1e-9, 1).solve(collapsed.view(), x);
  CHECK(!report.converged && report.iterations == 1 && report.relative_residual > 1e-9);
  CHECK(std::abs(relative_residual(collapsed.view(), x) - report.relative_residual) < 1e-12);

  Quadratic_problem<double> problem = collapsed.view();
  problem.right_hand_side_scale = 1000 * problem.right_hand_side.norm();
  const Solver_report scaled = Chebyshev(1e-9).solve(problem, x);
  CHECK(std::abs(relative_residual(problem, x) - 1000 * scaled.relative_residual) < 1e-12);
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

/// In `float` each model meets a tolerance that `float` can hold.
template <typename Solver>
void test_float(Solver solver)
{
  Generator generator(12);
  const Paper_problem paper = test::random_paper_problem(300, 0.15, 1, generator);
  Collapsed_problem<float> collapsed(paper);
  Coordinates<float> x = random_start(collapsed.view(), generator);
  CHECK(solver.solve(collapsed.view(), x).converged);
  CHECK(relative_residual(collapsed.view(), x) < 2e-5);
}

/// A tolerance far below rounding ends in a report, but in no exception.
template <typename FT>
void test_tolerances_below_rounding()
{
  Generator generator(13);
  Collapsed_problem<FT> collapsed(test::random_paper_problem(100, 0.15, 1, generator));
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

/// Blocks and a matrix that rounding may make indefinite: fit weights far below beta, normals
/// alike. No matter whether that can be solved, no step may raise E or go far.
template <typename Solver>
void test_weak_fit(double weakness)
{
  Generator generator(14);
  Paper_problem paper = test::random_paper_problem(60, 0, 1e3, generator);
  const Vector normal = test::random_unit_vector(generator);
  paper.normals.assign(paper.normals.size(), normal);
  for (auto& t : paper.fit)
    t.v *= weakness;
  Collapsed_problem<double> collapsed(paper);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(180);
  const Solver_report report = Solver(1e-6, 1000).solve(collapsed.view(), x);
  CHECK(std::isfinite(report.relative_residual));
  CHECK(x.norm() < 60);
  std::vector<Vector> moved = paper.samples;
  for (std::size_t i = 0; i < moved.size(); ++i)
    moved[i] += x.segment<3>(3 * Eigen::Index(i));
  CHECK(paper.energy(moved) <= paper.energy(paper.samples));
}

#ifdef CGAL_LINKED_WITH_TBB
/// Bitwise equal results for `Sequential_tag` and `Parallel_tag`, for every number of threads and
/// from run to run.
template <template <typename, typename> class Solver>
void test_threads_change_no_bit()
{
  Generator generator(15);
  Collapsed_problem<double> collapsed(test::random_paper_problem(5000, 0.15, 1, generator));
  const Eigen::VectorXd start = random_start(collapsed.view(), generator);
  Eigen::VectorXd expected = start;
  const Solver_report expected_report =
    Solver<double, CGAL::Sequential_tag>(1e-10).solve(collapsed.view(), expected);
  for (const std::size_t threads : {1, 2, 3, 8})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    for (int run = 0; run < 5; ++run)
    {
      Eigen::VectorXd x = start;
      const Solver_report report = Solver<double, CGAL::Parallel_tag>(1e-10).solve(collapsed.view(),
                                                                                   x);
      CHECK(x == expected);
      CHECK(report.iterations == expected_report.iterations);
      CHECK(report.relative_residual == expected_report.relative_residual);
    }
  }
}
#endif

/// What one solve may leave behind does not change what the next one finds.
template <typename Solver>
void test_reuse()
{
  Generator generator(16);
  Collapsed_problem<double> large(test::random_paper_problem(400, 0.15, 1, generator));
  Collapsed_problem<double> small(test::random_paper_problem(30, 0.15, 0.5, generator));
  Solver reused;
  for (Collapsed_problem<double>* problem : {&large, &small, &large})
  {
    Eigen::VectorXd x = random_start(problem->view(), generator), y = x;
    reused.solve(problem->view(), x);
    Solver().solve(problem->view(), y);
    CHECK(x == y);
  }
}

} // namespace

int main()
{
  static_assert(!Block::needs_explicit_rows && !Cholesky::needs_explicit_rows
                  && Least_squares::needs_explicit_rows,
                "only the paper's way needs the rows");
  test_model(Block(1e-3), Block(1e-9), Block(1e-9, 1), Block(1e-13, 1000));
  test_model(Cholesky(1e-3), Cholesky(1e-9), Cholesky(1e-9), Cholesky(1e-13));
  test_model(Least_squares(1e-3), Least_squares(1e-9, 1000), Least_squares(1e-9, 1),
             Least_squares(1e-13, 1000));
  test_chebyshev();
  test_float(Block_chebyshev_solver_traits<float>(1e-5));
  test_float(Block_conjugate_gradient_solver_traits<float>(1e-5));
  test_float(Eigen_cholesky_solver_traits<float>(1e-5));
  test_float(Eigen_least_squares_solver_traits<float>(1e-5));
  test_tolerances_below_rounding<double>();
  test_tolerances_below_rounding<float>();
  for (const double weakness : {1e6, 1e9, 1e12, 1e15, 1e18})
  {
    test_weak_fit<Block>(weakness);
    test_weak_fit<Chebyshev>(weakness);
  }
#ifdef CGAL_LINKED_WITH_TBB
  test_threads_change_no_bit<Block_conjugate_gradient_solver_traits>();
  test_threads_change_no_bit<Block_chebyshev_solver_traits>();
#endif
  test_reuse<Block>();
  test_reuse<Chebyshev>();
  return test::result();
}
