// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/minimization_scene.h"

#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

using namespace test;
using namespace CGAL::L0_resampling;

/// Solves by Cholesky and takes notes.
struct Watching_solver
{
  using FT = double;
  static constexpr bool needs_explicit_rows = true;
  std::vector<Step> steps;

  Solver_report solve(const Quadratic_problem<double>& problem, Eigen::Ref<Eigen::VectorXd> x)
  {
    const Solver_report report = Eigen_cholesky_solver_traits<double>().solve(problem, x);
    Step step{{}, {}, {}, {}, problem.penalty};
    for (std::size_t i = 0; i < problem.number_of_samples(); ++i)
    {
      step.before.emplace_back(Eigen::Map<const Vector>(problem.rows->origins + 3 * i));
      step.after.push_back(step.before.back() + x.segment<3>(Eigen::Index(3 * i)));
    }
    step.offsets.assign(problem.rows->normal_offsets,
                        problem.rows->normal_offsets + problem.pair_weights.size());
    step.pair_weights.assign(problem.pair_weights.data(),
                             problem.pair_weights.data() + problem.pair_weights.size());
    steps.push_back(std::move(step));
    return report;
  }
};

/// At a fixed penalty neither half of an iteration raises Eq. (7): line 2 finds offsets better than
/// all others tried, line 3 positions.
void check_descent(const Scene& scene, const std::vector<Step>& steps,
                   const std::vector<Iteration_report>& reports, Generator& generator)
{
  std::vector<double> last_offsets(scene.neighbors.indices.size(), 0);
  for (std::size_t t = 0; t < steps.size(); ++t)
  {
    const auto eq_7 = [&](const std::vector<Vector>& p, const std::vector<double>& offsets) {
      const Energy e = energy(scene, steps[t], reports[t].regularized, p, offsets);
      return e.fit + e.regularization + e.normal + e.sparsity;
    };
    const double shrunk = eq_7(steps[t].before, steps[t].offsets),
                 solved = eq_7(steps[t].after, steps[t].offsets);
    CHECK(shrunk <= eq_7(steps[t].before, last_offsets));
    CHECK(solved < shrunk);

    std::vector<double> other_offsets = steps[t].offsets;
    for (double& offset : other_offsets)
      if (std::bernoulli_distribution(0.1)(generator))
        offset = offset == 0 || std::bernoulli_distribution()(generator)
                   ? random_number(-0.4, 0.4, generator)
                   : 0;
    CHECK(eq_7(steps[t].before, other_offsets) > shrunk);
    for (double size : {1e-3, 1e-6})
    {
      std::vector<Vector> other_positions = steps[t].after;
      add_gaussian_noise(other_positions, size, generator);
      CHECK(eq_7(other_positions, steps[t].offsets) > solved);
    }
    last_offsets = steps[t].offsets;
  }
}

/// The report gives the terms of Eq. (7) after line 2, per squared radius, the fit term above its
/// least value.
void check_report(const Scene& scene, const std::vector<Step>& steps,
                  const std::vector<Iteration_report>& reports)
{
  const double unit = scene.parameters.squared_radius;
  const std::vector<Vector> centroids(scene.samples.fit_centroids.begin(),
                                      scene.samples.fit_centroids.end());
  for (std::size_t t = 0; t < steps.size(); ++t)
  {
    const Energy naive = energy(scene, steps[t], reports[t].regularized, steps[t].before,
                                steps[t].offsets);
    const double minimum_fit = energy(scene, steps[t], false, centroids, steps[t].offsets).fit;
    CHECK(std::abs(reports[t].fit_energy * unit - (naive.fit - minimum_fit)) < 1e-13 * naive.fit);
    CHECK(is_close(reports[t].regularization_energy, naive.regularization / unit, 1e-10));
    CHECK(is_close(reports[t].normal_energy, naive.normal / unit, 1e-10));
    CHECK(is_close(reports[t].sparsity_energy, naive.sparsity / unit, 1e-10));
    const auto inactive = double(std::count(steps[t].offsets.begin(), steps[t].offsets.end(), 0.));
    CHECK(is_close(1 - reports[t].active_pair_share, inactive / double(steps[t].offsets.size()),
                   1e-12));
    CHECK(reports[t].solver.converged);
  }
  // small penalties let no jump through, large ones some
  CHECK(reports.front().active_pair_share == 0 && reports.back().active_pair_share > 0.005);
}

/// Algorithm 1: eight penalties, each iteration from where the last one ended; the second half of
/// Section 4 drops the pairs' weights in every second one.
void check_course(const Scene& start, const Scene& end, const std::vector<Step>& steps,
                  const std::vector<Iteration_report>& reports)
{
  CHECK(steps.size() == 8 && reports.size() == 8);
  for (std::size_t t = 0; t < steps.size(); ++t)
  {
    const bool regularized = !start.parameters.interleave_regularization || t % 2 == 0;
    CHECK(is_close(steps[t].penalty, 0.1 * std::pow(1.5, double(t)), 1e-12)
          && reports[t].penalty == steps[t].penalty);
    CHECK(reports[t].regularized == regularized);
    CHECK(std::all_of(steps[t].pair_weights.begin(), steps[t].pair_weights.end(),
                      [&](double a) { return (a > 0) == regularized; }));
    CHECK(to_buffer(steps[t].before)
          == (t == 0 ? start.samples.positions : to_buffer(steps[t - 1].after)));
  }
  CHECK(to_buffer(steps.back().after) == end.samples.positions);
  CHECK(start.samples.normals == end.samples.normals
        && start.neighbors.indices == end.neighbors.indices);
}

/// Of the pairs of the scene those that are no longer than that, but for the pair of these two
/// samples; of a sample with itself, there is none.
Neighborhoods pairs_within(const Scene& scene, double range, std::size_t one, std::size_t other)
{
  const Buffer<Vector>& p = scene.samples.positions;
  Neighborhoods pairs{Buffer<std::size_t>(1, 0, p.get_allocator()),
                      Buffer<Index>(p.get_allocator())};
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    for (std::size_t e = scene.neighbors.offsets[i]; e < scene.neighbors.offsets[i + 1]; ++e)
    {
      const std::size_t k = scene.neighbors.indices[e];
      const bool is_left_out = (i == one && k == other) || (i == other && k == one);
      if ((p[i] - p[k]).norm() <= range && !is_left_out)
        pairs.indices.push_back(Index(k));
    }
    pairs.offsets.push_back(pairs.indices.size());
  }
  return pairs;
}

/// No rounding that decides whether two samples are neighbors moves them.
void check_end_of_range(const Scene& scene)
{
  const double penalty = 1, jump = 0.3;
  const Buffer<Vector>&p = scene.samples.positions, &normals = scene.samples.normals;
  std::size_t number_of_checks = 0;
  for (std::size_t i = 0; i < p.size(); i += 10)
  {
    const std::size_t e = scene.neighbors.offsets[i];
    if (e == scene.neighbors.offsets[i + 1])
      continue;
    const std::size_t k = scene.neighbors.indices[e];
    const Vector d = p[i] - p[k];
    const double height = std::abs(normals[i].dot(d)), range = d.norm() * (1 + 1e-9);
    if (height < 0.05 || height >= jump)
      continue;
    const auto pull_on_sample = [&](const Neighborhoods& pairs) {
      Buffer<Vector> pulls(p.size());
      Buffer<double> pair_weights(pairs.indices.size(), 0.), no_offsets;
      shrink_normal_offsets<CGAL::Sequential_tag>(scene.samples, pairs, pair_weights, penalty,
                                                  Shrunk_jumps<double>(jump, 0), range, pulls,
                                                  no_offsets);
      return pulls[i];
    };
    const Vector with_pair = pull_on_sample(pairs_within(scene, range, i, i)),
                 without_pair = pull_on_sample(pairs_within(scene, range, i, k));
    CHECK((with_pair - without_pair).norm() < 1e-7);
    ++number_of_checks;
  }
  CHECK(number_of_checks > 10);
}

int main()
{
  Generator generator(8);
  for (bool interleave : {false, true})
  {
    const Scene start(generator, interleave);
    Scene end = start;
    Watching_solver solver;
    const std::vector<Iteration_report> reports = minimize<CGAL::Parallel_if_available_tag>(
      end.neighbors, end.rows, end.parameters, solver, end.samples);
    check_course(start, end, solver.steps, reports);
    check_descent(start, solver.steps, reports, generator);
    check_report(start, solver.steps, reports);
    check_end_of_range(start);

    // Solvers of the collapsed form get no rows and see the same problems.
    Scene without_rows = start;
    Eigen_cholesky_solver_traits<double> cholesky;
    minimize<CGAL::Sequential_tag>(end.neighbors, Fit_rows(), end.parameters, cholesky,
                                   without_rows.samples);
    CHECK(without_rows.samples.positions == end.samples.positions);
  }
  return result();
}
