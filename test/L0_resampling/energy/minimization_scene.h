// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_MINIMIZATION_SCENE_H
#define CGAL_L0_RESAMPLING_TEST_MINIMIZATION_SCENE_H

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/energy/Fit_rows.h>
#include <CGAL/L0_resampling/internal/energy/Minimization_step.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace test {

using CGAL::L0_resampling::Iteration_report;

/// A noisy cube with samples on it, before Algorithm 1.
struct Scene
{
  static constexpr double radius = 0.8;
  Minimization_parameters parameters{std::pow(radius, 2),
                                     std::pow(0.4 * radius, 2),
                                     0.25 * radius,
                                     std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity(),
                                     0,
                                     0,
                                     0.9,
                                     0.15,
                                     0.1,
                                     2,
                                     1.5,
                                     false};
  Samples<double> samples{Counting_allocator<Vector>()};
  Neighborhoods neighbors;
  Fit_rows rows;

  Scene(Generator& generator, bool interleave)
  {
    parameters.interleave_regularization = interleave;
    Oriented_points cube = cube_points(1500, 3, generator);
    add_gaussian_noise(cube.points, 0.1, generator);
    const Gridded_points input(cube.points, radius / 2);
    const Gridded_points start(std::vector<Vector>(cube.points.begin(), cube.points.begin() + 400),
                               radius / 2);
    Unwatched unwatched;
    const Buffer<double> density_weights(1500, 1.5);
    samples.positions = start.points;
    samples.normals = to_buffer(permuted(start.order, cube.normals));
    samples.fit_weights.resize(400, 0.);
    samples.fit_centroids.resize(400);
    rows = gather_fit_rows<CGAL::Sequential_tag>(start.grid, start.points, input.grid, input.points,
                                                 density_weights, radius, 0, unwatched.progress);
    neighbors = find_self_neighbors<CGAL::Sequential_tag>(start.grid, start.points, radius / 2,
                                                          unwatched.progress);
    for (std::size_t i = 0; i < 400; ++i)
    {
      Vector sum = Vector::Zero();
      for (std::size_t r = rows.offsets[i]; r < rows.offsets[i + 1]; ++r)
      {
        samples.fit_weights[i] += rows.weights[r];
        sum += rows.weights[r] * rows.positions[r];
      }
      samples.fit_centroids[i] = sum / samples.fit_weights[i];
    }
  }
};

/// Algorithm 1 with the neighbors of the start.
template <typename ConcurrencyTag, typename Solver>
std::vector<Iteration_report> minimize(const Neighborhoods& neighbors, const Fit_rows& rows,
                                       const Minimization_parameters& parameters, Solver& solver,
                                       Samples<double>& samples)
{
  Unwatched unwatched;
  Minimization_step<ConcurrencyTag, Solver> step(parameters, solver, unwatched.progress,
                                                 samples.positions.get_allocator());
  Buffer<Upper_triangle<double>> normal_spreads;
  sum_normal_spreads<ConcurrencyTag>(samples.normals, neighbors, normal_spreads);
  std::vector<Iteration_report> reports;
  for (const Turn& turn : parameters.turns())
    reports.push_back(step(turn, neighbors, normal_spreads, rows, samples));
  return reports;
}

/// What the solver of Algorithm 1 sees in one iteration.
struct Step
{
  std::vector<Vector> before, after;
  std::vector<double> offsets, pair_weights;
  double penalty;
};

/// The terms of Eq. (7), with lambda as in Eq. (8), read in the scene's unit of length.
struct Energy
{
  double fit = 0, regularization = 0, normal = 0, sparsity = 0;
};

/// Eq. (7) as it stands. The weights of Eq. (4) and (5) are those of the positions before the step.
inline Energy energy(const Scene& scene, const Step& step, bool regularized,
                     const std::vector<Vector>& p, const std::vector<double>& offsets)
{
  const Minimization_parameters& parameters = scene.parameters;
  Energy energy;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t r = scene.rows.offsets[i]; r < scene.rows.offsets[i + 1]; ++r)
      energy.fit += scene.rows.weights[r] * (p[i] - scene.rows.positions[r]).squaredNorm();

  const auto for_each_pair = [&](const auto& f) {
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t e = scene.neighbors.offsets[i]; e < scene.neighbors.offsets[i + 1]; ++e)
        f(e, i, scene.neighbors.indices[e]);
  };
  std::vector<double> w(p.size(), 1);
  const double mean_number_of_neighbors = double(scene.neighbors.indices.size()) / double(p.size());
  const auto squared_distance = [&](std::size_t i, std::size_t k) {
    return (step.before[i] - step.before[k]).squaredNorm();
  };
  for_each_pair([&](std::size_t, std::size_t i, std::size_t k) {
    w[i] += std::exp(-squared_distance(i, k) / parameters.squared_bandwidth)
            / mean_number_of_neighbors;
  });
  for_each_pair([&](std::size_t e, std::size_t i, std::size_t k) {
    const double stretch = std::exp(
      (std::min)(squared_distance(i, k) / parameters.squared_radius, 1.));
    if (regularized)
      energy.regularization += parameters.regularization_weight * stretch / w[i]
                               * (p[i] - p[k]).squaredNorm();
    energy.normal += step.penalty
                     * std::pow(scene.samples.normals[i].dot(p[i] - p[k]) - offsets[e], 2);
    energy.sparsity += parameters.normal_weight * std::pow(parameters.sparsity_unit, 2)
                       * (offsets[e] != 0);
  });
  return energy;
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_MINIMIZATION_SCENE_H
