// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_SOLVER_CHECKS_H
#define CGAL_L0_RESAMPLING_TEST_SOLVER_CHECKS_H

// What every model of L0ResamplingSolverTraits has to keep.

#include "energy/ceres_referee.h"
#include "energy/random_problem.h"
#include "test_support.h"

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>

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
#include <vector>

namespace test {

using CGAL::L0_resampling::Quadratic_problem;
using CGAL::L0_resampling::Solver_error;
using CGAL::L0_resampling::Solver_report;

template <typename FT>
using Coordinates = Eigen::Matrix<FT, Eigen::Dynamic, 1>;

/// Whether the solver factorizes the matrix, and reads no initial guess.
template <typename Solver>
constexpr bool is_direct = false;

/// Whether the steps are counted before the solve: as many as an initial guess of zero needs, even
/// where there is nothing left to do.
template <typename Solver>
constexpr bool counts_steps_before = false;

template <typename FT>
Coordinates<FT> random_start(const Quadratic_problem<FT>& problem, Generator& generator)
{
  Coordinates<FT> x(3 * Eigen::Index(problem.number_of_samples()));
  for (FT& c : x)
    c = FT(random_number(-1, 1, generator));
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
      const Paper_problem paper = random_paper_problem(300, alpha, beta, generator);
      Collapsed_problem<double> collapsed(paper);
      const Eigen::VectorXd expected = solve_with_ceres(paper);
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

/// Isolated samples with one fit row of weight 1 each, displaced by small multiples of 1/4: solved
/// to the last bit.
inline Paper_problem exact_paper_problem()
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

inline Eigen::VectorXd exact_solution(const Paper_problem& paper)
{
  std::vector<Vector> x;
  for (const auto& t : paper.fit)
    x.push_back(t.q);
  return coordinates(x);
}

/// No quotient of zeros: g = 0, a start that is the solution to the last bit, and no samples at
/// all.
template <typename Solver>
void test_zeros(Solver solver)
{
  Generator generator(7);
  {
    Collapsed_problem<double> collapsed(random_paper_problem(50, 0.15, 1, generator));
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
      CHECK(report.iterations == std::size_t(!is_direct<Solver>));
    }
  }
  {
    Collapsed_problem<double> collapsed(Paper_problem{{}, {}, {}, {}, {}, 0.15, 1});
    Eigen::VectorXd x;
    const Solver_report report = solver.solve(collapsed.view(), x);
    CHECK(report.converged && report.iterations == 0 && report.relative_residual == 0);
  }
}

template <typename Solver>
void test_refuses_values_that_are_not_finite(Solver solver)
{
  Generator generator(8);
  Collapsed_problem<double> collapsed(random_paper_problem(50, 0.15, 1, generator));
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
    if (!is_direct<Solver>)
    {
      x = start;
      x[11] = bad;
      CHECK_THROWS(solver.solve(collapsed.view(), x), Solver_error);
    }
  }
  {
    // finite, but not its norm, so that nothing can be said of convergence
    Collapsed_problem<double> huge(random_paper_problem(50, 0.15, 1, generator));
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
  CHECK(!throws<std::exception>([]() { Solver(1e-12); }));
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

/// In `float` each model meets a tolerance that `float` can hold.
template <typename Solver>
void test_float(Solver solver)
{
  Generator generator(12);
  const Paper_problem paper = random_paper_problem(300, 0.15, 1, generator);
  Collapsed_problem<float> collapsed(paper);
  Coordinates<float> x = random_start(collapsed.view(), generator);
  CHECK(solver.solve(collapsed.view(), x).converged);
  CHECK(relative_residual(collapsed.view(), x) < 2e-5);
}

/// Blocks and a matrix that rounding may make indefinite: fit weights far below beta, normals
/// alike. No matter whether that can be solved, no step may raise E or go far.
template <typename Solver>
void test_weak_fit(double weakness)
{
  Generator generator(14);
  Paper_problem paper = random_paper_problem(60, 0, 1e3, generator);
  const Vector normal = random_unit_vector(generator);
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
  Collapsed_problem<double> collapsed(random_paper_problem(5000, 0.15, 1, generator));
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
  Collapsed_problem<double> large(random_paper_problem(400, 0.15, 1, generator));
  Collapsed_problem<double> small(random_paper_problem(30, 0.15, 0.5, generator));
  Solver reused;
  for (Collapsed_problem<double>* problem : {&large, &small, &large})
  {
    Eigen::VectorXd x = random_start(problem->view(), generator), y = x;
    reused.solve(problem->view(), x);
    Solver().solve(problem->view(), y);
    CHECK(x == y);
  }
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_SOLVER_CHECKS_H
