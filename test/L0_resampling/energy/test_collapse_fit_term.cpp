// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/energy/Fit_rows.h>
#include <CGAL/L0_resampling/internal/energy/collapse_fit_term.h>

#include <cmath>
#include <numeric>

using namespace test;

/// Noisy input, its density weights, and samples near it of which the last three are out of its
/// reach.
struct Scene
{
  static constexpr double radius = 0.5;
  Gridded_points input, samples;
  std::vector<double> density_weights;

  explicit Scene(Generator& generator)
    : input(noisy_cube(2500, generator), radius / 2), samples(sample_points(generator), radius / 2)
  {
    for (std::size_t j = 0; j < input.points.size(); ++j)
      density_weights.push_back(random_number(1, 3, generator));
  }

  static std::vector<Vector> noisy_cube(std::size_t n, Generator& generator)
  {
    std::vector<Vector> points = cube_points(n, 2, generator).points;
    add_gaussian_noise(points, 0.05, generator);
    return points;
  }

  static std::vector<Vector> sample_points(Generator& generator)
  {
    std::vector<Vector> points = noisy_cube(150, generator);
    for (double x : {5., 50., 500.})
      points.emplace_back(x, 0, 0);
    return points;
  }
};

/// W_i and c_i, which stand for the fit term of a sample.
struct Collapsed
{
  Buffer<double> weights;
  Buffer<Vector> centroids;
  std::size_t number_of_lonely;
};

template <typename T>
Collapsed collapse(const Scene& scene)
{
  Unwatched unwatched;
  const Buffer<T> density_weights(scene.density_weights.begin(), scene.density_weights.end());
  Collapsed c{Buffer<double>(scene.samples.points.size()),
              Buffer<Vector>(scene.samples.points.size()), 0};
  c.number_of_lonely = collapse_fit_term<CGAL::Parallel_if_available_tag>(
    scene.samples.grid, scene.samples.points, scene.input.grid, scene.input.points, density_weights,
    scene.radius, Buffer<Index>(), unwatched.progress, c.weights, c.centroids);
  return c;
}

/// Wherever a sample moves, its fit term of Eq. (6) changes by what the collapsed term changes.
template <typename T>
void check_identity(const Scene& scene, double tolerance, Generator& generator)
{
  const Collapsed c = collapse<T>(scene);
  const auto neighbors = brute_force_neighbors(scene.samples.vector, scene.input.vector,
                                               scene.radius);
  const auto fit_energy = [&](std::size_t i, const Vector& p) {
    double sum = 0;
    for (std::size_t j : neighbors[i])
      sum += (p - scene.input.vector[j]).squaredNorm() / scene.density_weights[j];
    return sum;
  };
  double worst = 0;
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    for (int n = 0; n < 5 && !neighbors[i].empty(); ++n)
    {
      const Vector start = scene.samples.vector[i],
                   p = start + scene.radius * random_unit_vector(generator);
      const double change = fit_energy(i, p) - fit_energy(i, start);
      const double collapsed_change = c.weights[i]
                                      * ((p - c.centroids[i]).squaredNorm()
                                         - (start - c.centroids[i]).squaredNorm());
      worst = (std::max)(worst, std::abs(collapsed_change - change)
                                  / (c.weights[i] * scene.radius * scene.radius));
    }
  CHECK(worst < tolerance);
}

/// A sample without an original neighbor is tied to where it is, with weight 1, so that Eq. (10)
/// has one minimum.
void check_lonely(const Scene& scene)
{
  const Collapsed c = collapse<float>(scene);
  const auto neighbors = brute_force_neighbors(scene.samples.vector, scene.input.vector,
                                               scene.radius);
  std::size_t number_of_lonely = 0;
  for (std::size_t i = 0; i < neighbors.size(); ++i)
  {
    CHECK(c.weights[i] > 0);
    if (!neighbors[i].empty())
      continue;
    ++number_of_lonely;
    CHECK(c.weights[i] == 1 && c.centroids[i] == scene.samples.vector[i]);
  }
  CHECK(number_of_lonely >= 3 && c.number_of_lonely == number_of_lonely);
}

/// The rows of Eq. (11) are the original neighbors, and Algorithm 2 halves them, rounding up,
/// without changing what they collapse to.
void check_fit_rows(const Scene& scene, std::size_t number_of_passes)
{
  Unwatched unwatched;
  const Buffer<double> density_weights(scene.density_weights.begin(), scene.density_weights.end());
  const Fit_rows rows = gather_fit_rows<CGAL::Parallel_if_available_tag>(
    scene.samples.grid, scene.samples.points, scene.input.grid, scene.input.points, density_weights,
    scene.radius, number_of_passes, unwatched.progress);
  const Collapsed c = collapse<double>(scene);
  const auto neighbors = brute_force_neighbors(scene.samples.vector, scene.input.vector,
                                               scene.radius);
  CHECK(rows.offsets.size() == neighbors.size() + 1 && rows.offsets.front() == 0);
  CHECK(rows.positions.size() == rows.offsets.back() && rows.weights.size() == rows.offsets.back());
  for (std::size_t i = 0; i < neighbors.size(); ++i)
  {
    std::size_t expected_size = neighbors[i].size();
    for (std::size_t pass = 0; pass < number_of_passes; ++pass)
      expected_size = (expected_size + 1) / 2;
    CHECK(rows.offsets[i + 1] - rows.offsets[i] == (std::max)(expected_size, std::size_t(1)));

    double weight = 0;
    Vector centroid = Vector::Zero();
    for (std::size_t r = rows.offsets[i]; r < rows.offsets[i + 1]; ++r)
    {
      weight += rows.weights[r];
      centroid += rows.weights[r] * (rows.positions[r] - scene.samples.vector[i]);
      if (number_of_passes == 0 && !neighbors[i].empty())
      {
        const std::size_t j = neighbors[i][r - rows.offsets[i]];
        CHECK(rows.positions[r] == scene.input.vector[j]
              && rows.weights[r] == 1 / scene.density_weights[j]);
      }
    }
    CHECK(is_close(weight, c.weights[i], 1e-12));
    CHECK((centroid / weight + scene.samples.vector[i] - c.centroids[i]).norm()
          < 1e-12 * scene.radius);
  }
}

int main()
{
  Generator generator(7);
  const Scene scene(generator);
  check_identity<double>(scene, 1e-12, generator);
  check_identity<float>(scene, 1e-5, generator);
  check_lonely(scene);
  for (std::size_t number_of_passes : {0, 1, 2, 3})
    check_fit_rows(scene, number_of_passes);
  return result();
}
