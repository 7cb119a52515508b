// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Eq. (10) in its three forms: the paper's terms, the rows of Eq. (11), and the collapsed form with
// its normal matrix.

#include "energy/random_problem.h"
#include "test_support.h"

#include <CGAL/L0_resampling/internal/core/checked_count.h>
#include <CGAL/L0_resampling/internal/energy/half_sampling.h>
#include <CGAL/L0_resampling/internal/energy/least_squares_rows.h>
#include <CGAL/L0_resampling/internal/energy/normal_matrix.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

using CGAL::L0_resampling::Index;
using CGAL::L0_resampling::Quadratic_problem;
using test::Collapsed_problem;
using test::Generator;
using test::Paper_problem;
using test::Vector;
namespace internal = CGAL::L0_resampling::internal;

std::vector<Vector> random_displacements(const Paper_problem& paper, Generator& generator)
{
  std::vector<Vector> x;
  for (std::size_t i = 0; i < paper.samples.size(); ++i)
    x.push_back(test::random_number(0, 2, generator) * test::random_unit_vector(generator));
  return x;
}

/// Eq. (10), in which the samples are where the displacements `x` take them.
double paper_energy(const Paper_problem& paper, const std::vector<Vector>& x)
{
  std::vector<Vector> p = paper.samples;
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] += x[i];
  return paper.energy(p);
}

/// The fit term in the documentation of `Quadratic_problem`, without its constant, and in place of
/// Eq. (10)'s.
double collapsed_energy(const Paper_problem& paper, const Quadratic_problem<double>& problem,
                        const std::vector<Vector>& centroids, const std::vector<Vector>& x)
{
  Paper_problem others = paper;
  others.fit.clear();
  double sum = paper_energy(others, x);
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += problem.fit_weights[Eigen::Index(i)]
           * (paper.samples[i] + x[i] - centroids[i]).squaredNorm();
  return sum;
}

void test_rows_have_the_energy_of_eq_10(const Paper_problem& paper,
                                        const Quadratic_problem<double>& problem,
                                        Generator& generator)
{
  const auto system = internal::least_squares_system(problem);
  CHECK(system.number_of_rows == system.matrix.rows());
  CHECK(std::size_t(system.matrix.cols()) == 3 * paper.samples.size());

  const std::size_t pairs = paper.pairs.size(), active_pairs = paper.alpha > 0 ? pairs / 2 : 0;
  CHECK(std::size_t(system.matrix.rows()) == 3 * paper.fit.size() + 3 * active_pairs + pairs);
  CHECK(std::size_t(system.matrix.nonZeros())
        == 3 * paper.fit.size() + 6 * active_pairs + 6 * pairs);

  for (int trial = 0; trial < 5; ++trial)
  {
    const std::vector<Vector> x = random_displacements(paper, generator);
    const double squared_residual =
      (system.matrix * test::coordinates(x) - system.rhs).squaredNorm();
    CHECK(test::is_close(squared_residual, paper_energy(paper, x), 1e-12));
  }
}

void test_collapsed_fit_term_differs_by_a_constant(const Paper_problem& paper,
                                                   const Quadratic_problem<double>& problem,
                                                   Generator& generator)
{
  std::vector<Vector> centroids(paper.samples.size(), Vector::Zero());
  for (const auto& t : paper.fit)
    centroids[t.i] += t.q / t.v / problem.fit_weights[Eigen::Index(t.i)];
  double constant = 0; // the spread of each neighborhood around its centroid
  for (const auto& t : paper.fit)
    constant += (t.q - centroids[t.i]).squaredNorm() / t.v;
  for (int trial = 0; trial < 5; ++trial)
  {
    const std::vector<Vector> x = random_displacements(paper, generator);
    CHECK(test::is_close(paper_energy(paper, x),
                         collapsed_energy(paper, problem, centroids, x) + constant, 1e-12));
  }
}

void test_normal_equations_are_those_of_the_rows(const Quadratic_problem<double>& problem)
{
  const auto system = internal::least_squares_system(problem);
  const internal::Normal_matrix<double> expected = system.matrix.transpose() * system.matrix;
  const internal::Normal_matrix<double> matrix = internal::assemble_normal_matrix(problem);
  CHECK(internal::Normal_matrix<double>(matrix - expected).norm() < 1e-14 * expected.norm());
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) // as Eigen demands it
    for (auto e = matrix.outerIndexPtr()[column] + 1; e < matrix.outerIndexPtr()[column + 1]; ++e)
      CHECK(matrix.innerIndexPtr()[e - 1] < matrix.innerIndexPtr()[e]);

  const Eigen::Map<const Eigen::VectorXd> rhs(problem.right_hand_side.data(),
                                              problem.right_hand_side.size());
  CHECK((rhs - system.matrix.transpose() * system.rhs).norm() < 1e-13 * rhs.norm());
}

/// E(x) of Eq. (10) is x^T H x - 2 g^T x plus E(0): what a solver gets is all of Eq. (10).
void test_quadratic_form(const Paper_problem& paper, const Quadratic_problem<double>& problem,
                         Generator& generator)
{
  const internal::Normal_matrix<double> matrix = internal::assemble_normal_matrix(problem);
  const Eigen::Map<const Eigen::VectorXd> rhs(problem.right_hand_side.data(),
                                              problem.right_hand_side.size());
  const double energy_at_zero = paper.energy(paper.samples);
  for (int trial = 0; trial < 5; ++trial)
  {
    const std::vector<Vector> displacements = random_displacements(paper, generator);
    const Eigen::VectorXd x = test::coordinates(displacements);
    const double energy = x.dot(matrix * x) - 2 * rhs.dot(x) + energy_at_zero;
    CHECK(test::is_close(paper_energy(paper, displacements), energy, 1e-12));
  }
}

/// Section 4.1 replaces the original neighbors by merged ones. With weights that add up at the
/// weighted mean, Eq. (11) has fewer rows and the same normal equations.
void test_merged_rows_have_the_same_normal_equations(Collapsed_problem<double>& collapsed)
{
  const auto full = internal::least_squares_system(collapsed.view());

  internal::Pair_partitioner<double> partitioner;
  std::vector<double> positions, weights;
  std::vector<std::size_t> offsets{0};
  for (std::size_t i = 0; i + 1 < collapsed.fit_offsets.size(); ++i)
  {
    const std::size_t first = collapsed.fit_offsets[i], last = collapsed.fit_offsets[i + 1];
    std::vector<double> q(collapsed.fit_positions.begin() + std::ptrdiff_t(3 * first),
                          collapsed.fit_positions.begin() + std::ptrdiff_t(3 * last));
    std::vector<double> w(collapsed.row_weights.begin() + std::ptrdiff_t(first),
                          collapsed.row_weights.begin() + std::ptrdiff_t(last));
    for (int pass = 0; pass < 2; ++pass)
    {
      const std::size_t size = internal::merge_pairs(partitioner(q.data(), w.size()), q.data(),
                                                     w.data());
      q.resize(3 * size);
      w.resize(size);
    }
    positions.insert(positions.end(), q.begin(), q.end());
    weights.insert(weights.end(), w.begin(), w.end());
    offsets.push_back(weights.size());
  }
  CHECK(weights.size() < collapsed.row_weights.size() / 2);
  collapsed.fit_positions = positions;
  collapsed.row_weights = weights;
  collapsed.fit_offsets = offsets;

  const auto merged = internal::least_squares_system(collapsed.view());
  CHECK(merged.matrix.rows() < full.matrix.rows());
  const internal::Normal_matrix<double> full_matrix = full.matrix.transpose() * full.matrix;
  const internal::Normal_matrix<double> merged_matrix = merged.matrix.transpose() * merged.matrix;
  CHECK(internal::Normal_matrix<double>(full_matrix - merged_matrix).norm()
        < 1e-14 * full_matrix.norm());
  const Eigen::VectorXd full_rhs = full.matrix.transpose() * full.rhs;
  CHECK((full_rhs - merged.matrix.transpose() * merged.rhs).norm() < 1e-13 * full_rhs.norm());
}

void test_sizes_are_checked()
{
  using internal::Checked_count;
  const std::size_t largest = std::size_t((std::numeric_limits<Eigen::Index>::max)());
  CHECK(Checked_count().add(largest, 1).index() == (std::numeric_limits<Eigen::Index>::max)());
  CHECK(Checked_count().add(100, 3).add(7, 6).index() == 342);
  CHECK_THROWS(Checked_count().add(largest + 1, 1), std::length_error);
  CHECK_THROWS(Checked_count().add(largest, 1).add(1, 1), std::length_error);
  CHECK_THROWS(Checked_count().add(largest / 3 + 1, 3), std::length_error);
  CHECK_THROWS(Checked_count().add((std::numeric_limits<std::size_t>::max)(), 2),
               std::length_error);
}

} // namespace

int main()
{
  Generator generator(10);
  for (const double alpha : {0.15, 0.})
    for (const double beta : {0.1, 1.7})
    {
      const Paper_problem paper = test::random_paper_problem(200, alpha, beta, generator);
      Collapsed_problem<double> collapsed(paper);
      CHECK(paper.pairs.size() > 1000);
      test_rows_have_the_energy_of_eq_10(paper, collapsed.view(), generator);
      test_collapsed_fit_term_differs_by_a_constant(paper, collapsed.view(), generator);
      test_normal_equations_are_those_of_the_rows(collapsed.view());
      test_quadratic_form(paper, collapsed.view(), generator);
      test_merged_rows_have_the_same_normal_equations(collapsed);
    }
  test_sizes_are_checked();
  return test::result();
}
