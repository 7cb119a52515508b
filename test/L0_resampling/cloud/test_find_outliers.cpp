// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/find_outliers.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>

#include <cmath>

using namespace test;

/// Whether each point is an outlier, in the order of the points.
std::vector<bool> outliers_of(const std::vector<Vector>& points, double radius,
                              double sensitivity = 1)
{
  Unwatched unwatched;
  const Outlier_thresholds thresholds(sensitivity);
  const double extent = robust_diagonal<CGAL::Sequential_tag>(to_buffer(points));
  std::optional<double> median, same_median;
  const auto parallel = find_outliers<float, CGAL::Parallel_if_available_tag>(
    to_buffer(points), radius, extent, thresholds, Scales_view(), median, unwatched.progress);
  CHECK((parallel
         == find_outliers<float, CGAL::Sequential_tag>(to_buffer(points), radius, extent,
                                                       thresholds, Scales_view(), same_median,
                                                       unwatched.progress)));
  CHECK(*median == *same_median);
  return std::vector<bool>(parallel.begin(), parallel.end());
}

std::size_t number_of(const std::vector<bool>& outliers)
{
  return std::size_t(std::count(outliers.begin(), outliers.end(), true));
}

/// Points of a surface stay: at borders and corners, through noise, and where it is ten times
/// sparser than elsewhere.
void check_surfaces(Generator& generator)
{
  CHECK(number_of(outliers_of(sphere_points(5000, 1, generator).points, 0.2)) == 0);
  CHECK(number_of(outliers_of(cube_points(5000, 2, generator).points, 0.3)) == 0);
  std::vector<Vector> noisy = cube_points(5000, 2, generator).points;
  add_gaussian_noise(noisy, 0.05, generator);
  CHECK(number_of(outliers_of(noisy, 0.3)) <= 5);

  std::vector<Vector> plane = plane_points(8000, 2, generator).points, graded;
  CHECK(number_of(outliers_of(plane, 0.12)) <= 8); // the four corners
  for (const Vector& p : plane)
    if (random_number(0, 1, generator) < std::pow(10, -(p[0] + 1) / 2))
      graded.push_back(p);
  CHECK(number_of(outliers_of(graded, 0.2)) <= graded.size() / 500);
}

/// A sparse surface beside a dense one of 36 times as many points stays, on a sphere and in a
/// plane, and single points off both are found as before.
void check_sparse_beside_dense(Generator& generator)
{
  const double radius = 0.06; // by the dense part
  std::vector<Vector> sphere, plane;
  for (const Vector& p : sphere_points(60000, 1, generator).points)
    if (p[2] > 0.3 || random_number(0, 1, generator) < 1. / 36)
      sphere.push_back(p);
  CHECK(number_of(outliers_of(sphere, radius)) <= sphere.size() / 10000);
  for (const Vector& p : plane_points(60000, 2, generator).points)
    if ((std::max)(std::abs(p[0]), std::abs(p[1])) < 0.3
        || random_number(0, 1, generator) < 1. / 36)
      plane.push_back(p);
  CHECK(number_of(outliers_of(plane, 0.035)) <= plane.size() / 500); // at the border

  const std::size_t size = sphere.size();
  for (int n = 0; n < 60; ++n)
    sphere.push_back(random_number(0.2, 0.5, generator) * random_unit_vector(generator));
  const std::vector<bool> outliers = outliers_of(sphere, radius);
  const auto number_lost = std::count(outliers.begin(), outliers.begin() + std::ptrdiff_t(size),
                                      true);
  CHECK(number_lost <= 10);
  CHECK(number_of(outliers) - std::size_t(number_lost) >= 55);
}

/// Single points and clusters in the space around a surface are found, but for those that lie close
/// to it.
void check_outliers(Generator& generator)
{
  const double radius = 0.2;
  std::vector<Vector> points = sphere_points(8000, 1, generator).points;
  const std::size_t size = points.size();
  for (int n = 0; n < 800; ++n)
    points.push_back(random_vector(1.5, generator));
  const std::size_t size_with_singles = points.size();
  for (const Vector& center : {Vector(0, 0, 0), Vector(1.6, 1.6, 0), Vector(-2, 0, 0)})
    for (int n = 0; n < 20; ++n)
      points.push_back(center + 0.02 * random_unit_vector(generator));

  const std::vector<bool> outliers = outliers_of(points, radius);
  std::size_t number_lost = 0, number_far = 0, number_found = 0;
  for (std::size_t i = 0; i < size; ++i)
    number_lost += outliers[i];
  for (std::size_t i = size; i < size_with_singles; ++i)
    if (std::abs(points[i].norm() - 1) > radius)
    {
      ++number_far;
      number_found += outliers[i];
    }
  CHECK(number_lost == 0);
  CHECK(double(number_found) > 0.93 * double(number_far));
  for (std::size_t i = size_with_singles; i < points.size(); ++i)
    CHECK(outliers[i]);

  // neither the order nor the unit matters
  std::vector<Vector> reversed(points.rbegin(), points.rend());
  for (Vector& p : reversed)
    p *= 4;
  std::vector<bool> outliers_of_reversed = outliers_of(reversed, 4 * radius);
  std::reverse(outliers_of_reversed.begin(), outliers_of_reversed.end());
  CHECK(outliers_of_reversed == outliers);
}

/// A crowd of outliers that fills space is found even if each has enough others around that no
/// comparison with its surroundings tells it; a sheet as sparse as the crowd stays.
void check_crowd(Generator& generator)
{
  const double radius = 0.45;
  std::vector<Vector> points = sphere_points(9000, 1, generator).points;
  add_gaussian_noise(points, 0.08, generator);
  for (const Vector& p : plane_points(1500, 4, generator).points)
    points.push_back(p + Vector(6, 0, 0));
  const std::size_t size = points.size();
  for (int n = 0; n < 6000; ++n)
    points.push_back(random_vector(2, generator));

  const std::vector<bool> outliers = outliers_of(points, radius);
  std::size_t number_far = 0, number_found = 0;
  for (std::size_t i = size; i < points.size(); ++i)
    if (points[i].norm() > 1 + 2 * radius)
    {
      ++number_far;
      number_found += outliers[i];
    }
  CHECK(number_far > 1000);
  CHECK(double(number_found) > 0.99 * double(number_far));
  const auto number_lost = std::count(outliers.begin(), outliers.begin() + std::ptrdiff_t(size),
                                      true);
  CHECK(number_lost <= 75); // at the border of the sparse sheet
}

/// Most of the points in one place, or almost, are no measure for the others: these stay, outliers
/// among them are found as before, and points of the crowd share one lot. The surface is noisy, as
/// sparse points of a sheet would stay whatever the measure.
void check_crowd_in_one_place(Generator& generator)
{
  const double radius = 0.3;
  std::vector<Vector> points = sphere_points(8000, 1, generator).points;
  add_gaussian_noise(points, 0.05, generator);
  const std::size_t size = points.size();
  const Vector place = points[0];
  for (int n = 0; n < 16000; ++n)
    points.push_back(place + 1e-9 * random_unit_vector(generator));
  CHECK(number_of(outliers_of(points, radius)) == 0);

  for (int n = 0; n < 20; ++n)
    points.push_back(3 * random_unit_vector(generator));
  for (int n = 0; n < 1000; ++n)
    points.emplace_back(0, 0, 0);
  const std::vector<bool> outliers = outliers_of(points, radius);
  CHECK(number_of(outliers) == 1020);
  CHECK(std::none_of(outliers.begin(), outliers.begin() + std::ptrdiff_t(size + 16000),
                     [](bool is_outlier) { return is_outlier; }));
}

/// Whoever is an outlier is one at every larger sensitivity: single points, clusters, borders, and
/// a crowd beside the sparse end of a noisy sheet. There are few at a small one.
void check_sensitivity(Generator& generator)
{
  const double radius = 0.45;
  std::vector<Vector> points;
  for (const Vector& p : sphere_points(12000, 1, generator).points)
    if (random_number(0, 1, generator) < std::pow(20, -(p[0] + 1) / 2))
      points.push_back(p);
  add_gaussian_noise(points, 0.08, generator);
  for (int n = 0; n < 1500; ++n)
    points.push_back(random_vector(2, generator));
  for (int n = 0; n < 25; ++n)
    points.push_back(Vector(3, 0, 0) + 0.05 * random_unit_vector(generator));

  std::vector<std::size_t> numbers;
  std::vector<bool> before(points.size(), false);
  for (const double sensitivity : {0.01, 0.3, 0.7, 1., 1.3, 1.7, 2.2, maximum_outlier_sensitivity})
  {
    const std::vector<bool> outliers = outliers_of(points, radius, sensitivity);
    for (std::size_t i = 0; i < points.size(); ++i)
      CHECK(outliers[i] || !before[i]);
    numbers.push_back(number_of(outliers));
    before = outliers;
  }
  CHECK(numbers.front() < points.size() / 100);
  CHECK(2 * numbers[1] < numbers[3] && numbers[5] > numbers[3] + points.size() / 100);
  CHECK(numbers.back() < points.size());
}

/// Where nobody has neighbors, or all are one, nobody is apart from the others. A few parts of
/// equal size are no outliers to each other.
void check_no_cloud(Generator& generator)
{
  CHECK(number_of(outliers_of({Vector(1, 2, 3)}, 1)) == 0);
  CHECK(number_of(outliers_of(lattice_points(4, 10), 1)) == 0);
  CHECK(number_of(outliers_of(std::vector<Vector>(100, Vector(1, 2, 3)), 1)) == 0);
  std::vector<Vector> parts;
  for (const Vector& p : sphere_points(300, 0.5, generator).points)
    for (int part = 0; part < 3; ++part)
      parts.push_back(p + Vector(10 * part, 0, 0));
  CHECK(number_of(outliers_of(parts, 0.3)) == 0);
  parts.emplace_back(1e9, 0, 0); // beyond what a grid numbers
  CHECK(number_of(outliers_of(parts, 0.3)) == 1);
}

int main()
{
  Generator generator(17);
  check_surfaces(generator);
  check_sparse_beside_dense(generator);
  check_outliers(generator);
  check_crowd(generator);
  check_crowd_in_one_place(generator);
  check_sensitivity(generator);
  check_no_cloud(generator);
  return result();
}
