// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// LOP, CLOP and the smaller input of KLOP, as the benchmarks have them: what their papers say of
// them.

#include "../../../benchmark/L0_resampling/methods/continuous_projection.h"
#include "../../../benchmark/L0_resampling/methods/locally_optimal_projection.h"
#include "../../../benchmark/L0_resampling/methods/subsampling.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace L0_benchmark;

std::vector<Point_3> to_points(const std::vector<test::Vector>& vectors)
{
  std::vector<Point_3> points;
  for (const test::Vector& v : vectors)
    points.push_back(to_cgal(v));
  return points;
}

constexpr double noise = 0.02, radius = 0.4;

/// The unit square in z = 0 with noise.
std::vector<Point_3> noisy_plane(std::size_t n)
{
  test::Generator generator(3);
  std::vector<test::Vector> vectors = test::plane_points(n, 1, generator).points;
  test::add_gaussian_noise(vectors, noise, generator);
  return to_points(vectors);
}

double mean_height(const std::vector<Point_3>& points)
{
  double sum = 0;
  for (const Point_3& p : points)
    sum += std::abs(p.z());
  return sum / double(points.size());
}

double mean_distance_to_nearest(const std::vector<Point_3>& points)
{
  const Point_tree tree(points);
  double sum = 0;
  for (const Point_3& p : points)
  {
    const std::vector<std::size_t> two = tree.nearest(p, 2);
    sum += std::sqrt((std::max)(CGAL::squared_distance(p, points[two[0]]),
                                CGAL::squared_distance(p, points[two[1]])));
  }
  return sum / double(points.size());
}

Projection_parameters parameters_of(double h)
{
  Projection_parameters parameters;
  parameters.radius = h;
  return parameters;
}

// Where the kernel is flat and nothing repels, LOP finds the L1 median: of a convex quadrilateral,
// where the diagonals cross.
void lop_finds_the_l1_median()
{
  const std::vector<Point_3> corners = {{0, 0, 0}, {4, 0, 0}, {5, 4, 0}, {0, 3, 0}};
  Projection_parameters parameters = parameters_of(1e4);
  parameters.repulsion = 0;
  parameters.number_of_iterations = 200;
  std::vector<Point_3> sample = {{1, 1, 1}};
  locally_optimal_projection(corners, parameters, sample);
  CHECK(std::sqrt(CGAL::squared_distance(sample[0], Point_3(60. / 31, 48. / 31, 0))) < 1e-4);
}

void lop_projects_a_noisy_plane_onto_the_plane()
{
  const std::vector<Point_3> points = noisy_plane(3000);
  std::vector<Point_3> samples(points.begin(), points.begin() + 600);
  locally_optimal_projection(points, parameters_of(radius), samples);
  CHECK(mean_height(samples) < mean_height(points) / 4);
}

void repulsion_spreads_the_samples()
{
  const std::vector<Point_3> points = noisy_plane(3000);
  std::vector<Point_3> repelled(points.begin(), points.begin() + 600), alone = repelled;
  Projection_parameters parameters = parameters_of(radius);
  locally_optimal_projection(points, parameters, repelled);
  parameters.repulsion = 0;
  locally_optimal_projection(points, parameters, alone);
  CHECK(mean_distance_to_nearest(repelled) > 1.5 * mean_distance_to_nearest(alone));
}

void lop_does_not_depend_on_the_order()
{
  std::vector<Point_3> points = noisy_plane(1000);
  std::vector<Point_3> samples(points.begin(), points.begin() + 200),
    reversed(samples.rbegin(), samples.rend());
  Projection_parameters parameters = parameters_of(radius);
  parameters.number_of_iterations = 10;
  locally_optimal_projection(points, parameters, samples);
  std::reverse(points.begin(), points.end());
  locally_optimal_projection(points, parameters, reversed);
  for (std::size_t i = 0; i < samples.size(); ++i)
    CHECK(CGAL::squared_distance(samples[i], reversed[samples.size() - 1 - i]) < 1e-18);
}

// Of all the mixture stands for, its reduction keeps number, mean and covariance.
void reduced_mixtures_keep_their_moments()
{
  const auto moments = [](const Gaussian_mixture& mixture) {
    Merged_gaussian all(Eigen::Vector3d::Zero());
    for (const Gaussian& gaussian : mixture)
      all.add(gaussian, 1);
    return all.result();
  };
  Portable_random random(1);
  const Gaussian_mixture fine = gaussians_of_points(noisy_plane(2000), 1e-3);
  const Gaussian_mixture coarse = reduced_mixture(reduced_mixture(fine, 2.3, random), 2.3, random);
  CHECK(coarse.size() < fine.size() / 3);
  CHECK(test::is_close(moments(coarse).weight, moments(fine).weight, 1e-9));
  CHECK((moments(coarse).mean - moments(fine).mean).norm() < 1e-9);
  CHECK((moments(coarse).covariance - moments(fine).covariance).norm() < 1e-9);
}

// CLOP is LOP where each point is a Gaussian of no width.
void clop_is_lop_for_narrow_gaussians()
{
  const std::vector<Point_3> points = noisy_plane(1000);
  Gaussian_mixture mixture;
  for (const Point_3& point : points)
    mixture.push_back({1, to_eigen(point), 1e-12 * Eigen::Matrix3d::Identity()});
  const Point_tree tree(points);
  const Continuous_attraction attract(mixture, radius);
  for (int i = -4; i <= 4; ++i)
  {
    const Point_3 sample(0.1 * i, -0.05 * i, 0.2 * radius);
    const Point_3 discrete = local_mean(sample, points, tree, radius, 1);
    CHECK(CGAL::squared_distance(attract(sample), discrete)
          < 1e-3 * CGAL::squared_distance(sample, discrete));
  }
}

void clop_projects_a_noisy_plane_onto_the_plane()
{
  const std::vector<Point_3> points = noisy_plane(3000);
  Portable_random random(1);
  const Gaussian_mixture mixture = reduced_mixture(gaussians_of_points(points, 1e-3), 2.3, random);
  std::vector<Point_3> samples(points.begin(), points.begin() + 600);
  Projection_parameters parameters = parameters_of(radius);
  parameters.repulsion_power = 0;
  continuous_projection(mixture, parameters, samples);
  CHECK(mean_height(samples) < mean_height(points) / 4);
}

// The density estimate of a tenth of the points, scaled, is that of all.
void kernel_density_draws_keep_the_density()
{
  std::vector<Point_3> points = noisy_plane(40000);
  for (Point_3& p : points) // denser to the left
    p = Point_3(p.x() < 0 ? 2 * (p.x() + 0.5) * (p.x() + 0.5) - 0.5 : p.x(), p.y(), p.z());
  const std::vector<Point_3> drawn = draw_from_kernel_density(points, 4000, 0.01, 1);
  CHECK(drawn.size() == 4000);
  const auto density = [](const std::vector<Point_3>& of, const Point_3& at) {
    double sum = 0;
    for (const Point_3& p : of)
      sum += projection_kernel(CGAL::squared_distance(p, at), 0.4);
    return sum / double(of.size());
  };
  for (double x : {-0.4, -0.3, -0.1, 0.1, 0.3})
  {
    const Point_3 at(x, 0.1, 0);
    CHECK(test::is_close(density(drawn, at), density(points, at), 0.1));
  }
  const bool is_subset = std::all_of(drawn.begin(), drawn.begin() + 20, [&](const Point_3& p) {
    return std::find(points.begin(), points.end(), p) != points.end();
  });
  CHECK(!is_subset); // it is drawn from the estimate, which is smooth
}

} // namespace

int main()
{
  lop_finds_the_l1_median();
  lop_projects_a_noisy_plane_onto_the_plane();
  repulsion_spreads_the_samples();
  lop_does_not_depend_on_the_order();
  reduced_mixtures_keep_their_moments();
  clop_is_lop_for_narrow_gaussians();
  clop_projects_a_noisy_plane_onto_the_plane();
  kernel_density_draws_keep_the_density();
  return test::result();
}
