// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/normals/estimate_pca_normals.h>

#include <Eigen/Eigenvalues>

#include <cmath>

using namespace test;

struct Normals
{
  std::vector<Vector> vectors; ///< in the order of the points asked for
  std::size_t number_of_degenerate;
};

template <typename T>
Normals pca_normals(const std::vector<Vector>& points, double radius,
                    bool looks_beyond_strips = false)
{
  const Gridded_points sorted(
    points, radius / 1.4); // the cells of the package are not those of this radius
  Unwatched unwatched;
  Buffer<Eigen::Matrix<T, 3, 1>> normals(points.size());
  Normals result{std::vector<Vector>(points.size()), 0};
  result.number_of_degenerate = estimate_pca_normals<CGAL::Parallel_if_available_tag>(
    sorted.grid, sorted.points, Buffer<Index>(), radius, looks_beyond_strips, unwatched.progress,
    normals);
  for (std::size_t i = 0; i < points.size(); ++i)
    result.vectors[sorted.order[i]] = normals[i].template cast<double>();
  bool are_unit = true;
  for (const Vector& n : result.vectors)
    are_unit = are_unit && std::abs(n.norm() - 1) < 1e-6;
  CHECK(are_unit);
  return result;
}

/// Variances and their directions in the ball around a point, from the definition in two passes.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> covariance_of_ball(const std::vector<Vector>& points,
                                                                  const Vector& center,
                                                                  double radius)
{
  const auto ball = brute_force_neighbors({center}, points, radius).front();
  Vector mean = Vector::Zero();
  for (std::size_t j : ball)
    mean += points[j] / double(ball.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t j : ball)
    covariance += (points[j] - mean) * (points[j] - mean).transpose() / double(ball.size());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance);
}

template <typename T>
void check_planes(double tolerance, Generator& generator)
{
  for (int n = 0; n < 10; ++n)
  {
    const Eigen::Matrix3d rotation = random_rotation(generator);
    std::vector<Vector> points = plane_points(400, 2, generator).points;
    for (Vector& p : points)
      p = rotation * p + Vector(3, -2, 1);
    const Normals normals = pca_normals<T>(points, 0.5);
    CHECK(normals.number_of_degenerate == 0);
    double largest = 0;
    for (const Vector& normal : normals.vectors)
      largest = (std::max)(largest, angle_of_lines(normal, rotation.col(2)));
    CHECK(largest < tolerance);
  }
}

/// In noise the normal is the direction of least variance in the ball.
template <typename T>
void check_noise(double tolerance, Generator& generator)
{
  std::vector<Vector> points = cube_points(1500, 2, generator).points;
  add_gaussian_noise(points, 0.03, generator);
  const Normals normals = pca_normals<T>(points, 0.4);
  CHECK(normals.number_of_degenerate == 0);
  double worst = 0;
  for (std::size_t i = 0; i < points.size(); i += 7)
  {
    const auto naive = covariance_of_ball(points, points[i], 0.4);
    if (naive.eigenvalues()[1] > 1.5 * naive.eigenvalues()[0]) // else no direction is the least one
      worst = (std::max)(worst, angle_of_lines(normals.vectors[i], naive.eigenvectors().col(0)));
  }
  CHECK(worst < tolerance);
}

/// The normals of a turned cloud are the turned normals.
void check_rotation(Generator& generator)
{
  std::vector<Vector> points = sphere_points(1500, 1, generator).points;
  add_gaussian_noise(points, 0.01, generator);
  const Eigen::Matrix3d rotation = random_rotation(generator);
  std::vector<Vector> turned;
  for (const Vector& p : points)
    turned.push_back(rotation * p);
  const Normals normals = pca_normals<float>(points, 0.3),
                turned_normals = pca_normals<float>(turned, 0.3);
  double worst = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    worst = (std::max)(worst,
                       angle_of_lines(rotation * normals.vectors[i], turned_normals.vectors[i]));
  CHECK(worst < 0.01);
}

/// A line has no plane, but there are directions across it.
void check_lines(Generator& generator)
{
  for (std::size_t size : {2, 3, 30, 1000})
  {
    const Vector direction = random_unit_vector(generator);
    std::vector<Vector> points;
    for (std::size_t n = 0; n < size; ++n)
      points.push_back(Vector(1, 2, 3) + random_number(-0.4, 0.4, generator) * direction);
    const Normals normals = pca_normals<float>(points, 1);
    CHECK(normals.number_of_degenerate == size);
    double worst = 90;
    for (const Vector& n : normals.vectors)
      worst = (std::min)(worst, angle_of_lines(n, direction));
    CHECK(worst > 89.9);
  }
}

/// Points whose ball spans no plane take the normal of the first ball that does, of twice, four
/// times ... the radius.
void check_larger_balls(Generator& generator)
{
  const Eigen::Matrix3d rotation = random_rotation(generator);
  std::vector<Vector> points = plane_points(500, 2, generator).points;
  points.emplace_back(1.2, 0, 0.3);                       // sees the patch in the ball of 2 radii
  points.emplace_back(-5, 1, 0);                          // of 16
  points.insert(points.end(), 50, Vector(0.3, 1.7, 0.6)); // duplicates, of 4
  for (Vector& p : points)
    p = rotation * p;
  const double radius = 0.3;
  const Normals normals = pca_normals<float>(points, radius);
  CHECK(normals.number_of_degenerate == 52);
  for (const auto& [i, factor] :
       {std::pair<std::size_t, int>(500, 2), {501, 16}, {502, 4}, {551, 4}})
  {
    CHECK(covariance_of_ball(points, points[i], factor / 2 * radius).eigenvalues()[1] < 1e-9);
    const auto naive = covariance_of_ball(points, points[i], factor * radius);
    CHECK(naive.eigenvalues()[1] > 1e-3);
    CHECK(angle_of_lines(normals.vectors[i], naive.eigenvectors().col(0)) < 0.1);
  }
}

/// How much a plane counts, by the variances of its points, ascending.
double naive_share(const Eigen::Vector3d& variances)
{
  return (std::min)(1., (variances[1] - variances[0]) / (0.1 * variances[2]));
}

/// Scan lines that are further apart than a ball is wide, with errors along the rays, which are not
/// across the surface. And a pole, around which there is nothing: its points count as degenerate,
/// as those of the lines do whose next one no ball reaches.
void check_strips(Generator& generator)
{
  const double radius = 0.5;
  const Vector ray = Vector(1, 0, -0.4).normalized();
  std::vector<Vector> points;
  for (int line = -4; line <= 4; ++line)
    for (double y = -3; y < 3; y += 0.06)
      points.push_back(Vector(0.7 * line, y, 0) + random_number(-0.06, 0.06, generator) * ray);
  const std::size_t size_of_scan = points.size();
  for (double z = 0; z < 4; z += 0.04)
    points.push_back(Vector(20, 0, z) + random_vector(Vector(0.03, 0.03, 0), generator));
  const Eigen::Matrix3d rotation = random_rotation(generator);
  for (Vector& p : points)
    p = rotation * p;
  const Normals normals = pca_normals<float>(points, radius, true);
  double worst = 0, of_scan = 0, of_scan_without = 0;
  const Normals without = pca_normals<float>(points, radius);
  std::size_t number_of_blends = 0, number_on_lines = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto own = covariance_of_ball(points, points[i], radius),
               wide = covariance_of_ball(points, points[i], 2 * radius);
    const double weight = (1 - naive_share(own.eigenvalues())) * naive_share(wide.eigenvalues());
    const auto is_line = [](const Eigen::Vector3d& variances) {
      return variances[1] < 0.1 * variances[2];
    };
    const bool is_on_line = is_line(own.eigenvalues()) && is_line(wide.eigenvalues());
    number_on_lines += is_on_line;
    CHECK(is_on_line == (i >= size_of_scan));
    const Vector n = own.eigenvectors().col(0), m = wide.eigenvectors().col(0);
    const Vector expected = (1 - weight) * n + (n.dot(m) < 0 ? -weight : weight) * m;
    number_of_blends += weight > 0.1 && weight < 0.9;
    worst = (std::max)(worst, angle_of_lines(normals.vectors[i], expected.normalized()));
    if (i < size_of_scan)
    {
      of_scan += angle_of_lines(normals.vectors[i], rotation.col(2)) / double(size_of_scan);
      of_scan_without += angle_of_lines(without.vectors[i], rotation.col(2)) / double(size_of_scan);
    }
    else
      CHECK(weight < 0.3);
  }
  CHECK(normals.number_of_degenerate == number_on_lines && without.number_of_degenerate == 0);
  CHECK(worst < 0.1 && number_of_blends > 10);
  CHECK(of_scan < 4 && of_scan_without > 15);
}

/// Where no ball spans a plane there is still a unit vector, by agreement (0, 0, 1).
void check_fallback()
{
  for (std::size_t size : {1, 2, 3, 100})
  {
    const Normals normals = pca_normals<float>(std::vector<Vector>(size, Vector(7, -8, 9)), 0.1);
    CHECK(normals.number_of_degenerate == size);
    for (const Vector& n : normals.vectors)
      CHECK(n == Vector(0, 0, 1));
  }
  // further apart than the largest ball reaches
  const Normals apart = pca_normals<float>({Vector(0, 0, 0), Vector(1e6, 0, 0), Vector(0, 1e6, 0)},
                                           1);
  CHECK(apart.number_of_degenerate == 3);
  CHECK(apart.vectors == std::vector<Vector>(3, Vector(0, 0, 1)));
}

int main()
{
  Generator generator(4);
  check_planes<float>(0.01, generator);
  check_planes<double>(1e-5, generator);
  check_noise<float>(0.01, generator);
  check_noise<double>(1e-6, generator);
  check_rotation(generator);
  check_lines(generator);
  check_larger_balls(generator);
  check_strips(generator);
  check_fallback();
  return result();
}
