// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/areas_of_points.h>

#include <cmath>
#include <map>
#include <optional>

using namespace test;

/// \param input has a grid and its points
template <typename Input>
Areas areas_of(const Input& input, double radius, std::size_t number_of_samples = 1)
{
  Unwatched unwatched;
  std::optional<std::uint64_t> units_of_disks;
  return areas_of_points<CGAL::Parallel_if_available_tag, float>(
    input.grid, input.points, radius, number_of_samples,
    units_per_length_for(input.grid.cell_size(), radius, !input.grid.has_one_scale()),
    units_of_disks, unwatched.progress);
}

/// The areas of all points, from balls looked at one by one.
std::vector<double> naive_areas(const Gridded_points& input, double radius,
                                std::size_t number_of_samples)
{
  const std::size_t n = input.vector.size();
  const double disk = EIGEN_PI * radius * radius;
  std::vector<double> counts(n, 0), areas(n);
  std::vector<Eigen::Matrix3d> covariances(n, Eigen::Matrix3d::Zero());
  double of_disks = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    Vector sum = Vector::Zero();
    for (const Vector& p : input.vector)
    {
      const Vector d = (p - input.vector[i]) / radius;
      if (!((p - input.vector[i]).squaredNorm() < radius * radius))
        continue;
      ++counts[i];
      sum += d;
      covariances[i] += d * d.transpose();
    }
    covariances[i] = (covariances[i] - sum * sum.transpose() / counts[i])
                     / (std::max)(counts[i] - 1, 1.);
    of_disks += disk / counts[i];
  }
  const double strip = of_disks / double(number_of_samples) / (radius * radius) / 20;
  const auto sum_of_minors = [](const Eigen::Matrix3d& c) {
    return (c.trace() * c.trace() - (c * c).trace()) / 2;
  };
  const Eigen::Matrix3d added = strip * Eigen::Matrix3d::Identity(),
                        of_disk = Vector(0.25, 0.25, 0).asDiagonal();
  for (std::size_t cell = 0; cell < input.grid.number_of_cells(); ++cell)
  {
    const auto range = input.grid.points_of_cell(cell);
    double sum = 0;
    for (Index i = range.first; i < range.second; ++i)
      sum += disk / counts[i]
             * std::sqrt(sum_of_minors(covariances[i] + added) / sum_of_minors(of_disk + added));
    for (Index i = range.first; i < range.second; ++i)
      areas[i] = sum / (range.second - range.first);
  }
  return areas;
}

bool are_as_expected(const Areas& areas, const std::vector<double>& expected)
{
  bool are_close = areas.units.size() == expected.size();
  for (std::size_t i = 0; i < expected.size(); ++i)
    are_close = are_close && is_close(areas.of_point(i), expected[i], 1e-6);
  return are_close;
}

/// The counts are exact: a point on the border of a ball is outside, and inside of one that is
/// larger by less than a `float` can tell.
void check_exactness()
{
  const double spacing = 1. / 16;
  std::vector<Vector> lattice;
  for (int x = 0; x < 12; ++x)
    for (int y = 0; y < 12; ++y)
      for (int z = 0; z < 3; ++z)
        lattice.push_back(Vector(x, y, z) * spacing + Vector(40, -3, 7));
  for (const double factor : {1 - 1e-8, 1., 1 + 1e-8})
  {
    const double radius = 3 * spacing * factor;
    const Gridded_points input(lattice, 0.15);
    CHECK(are_as_expected(areas_of(input, radius, 100), naive_areas(input, radius, 100)));
  }
  CHECK(areas_of(Gridded_points(lattice, 0.15), 3 * spacing).units
        != areas_of(Gridded_points(lattice, 0.15), 3 * spacing * (1 + 1e-8)).units);
}

/// On points at random, and where cells are much larger or smaller than the ball.
void check_formulas(const std::vector<Vector>& points)
{
  for (const double cell_size : {0.07, 0.2, 3.})
    for (const double radius : {0.01, 0.2})
    {
      const Gridded_points input(points, cell_size);
      for (const std::size_t number_of_samples : {10u, 3000u})
        CHECK(are_as_expected(areas_of(input, radius, number_of_samples),
                              naive_areas(input, radius, number_of_samples)));
    }
}

/// The areas of the points of a surface add up to its own, in dense and sparse parts alike.
void check_areas(Generator& generator)
{
  std::vector<Vector> points = plane_points(6000, 2, generator).points;
  for (const Vector& p : plane_points(600, 2, generator).points)
    points.push_back(p + Vector(5, 0, 0));
  const Gridded_points sorted(points, 0.2);
  const Areas areas = areas_of(sorted, 0.21, 3000);
  double inside[2] = {0, 0}, true_area[2] = {0, 0}, of_all[2] = {0, 0};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const bool is_sparse = sorted.vector[i][0] > 2.5;
    const double x = sorted.vector[i][0] - (is_sparse ? 5 : 0), y = sorted.vector[i][1];
    of_all[is_sparse] += areas.of_point(i);
    if (std::abs(x) < 0.6 && std::abs(y) < 0.6) // away from the border
    {
      inside[is_sparse] += areas.of_point(i);
      true_area[is_sparse] += 4 / (is_sparse ? 600. : 6000.);
    }
  }
  CHECK(is_close(inside[0], true_area[0], 0.05));
  CHECK(is_close(inside[1], true_area[1], 0.15));
  CHECK(is_close(of_all[0], 4, 0.05)); // what is cut by a border is no whole disk
  CHECK(is_close(areas.total(), of_all[0] + of_all[1], 1e-9));
}

/// All points of a place stand for that of one sample together, however many they are; where not
/// all candidates are looked at, those that are count for the others.
void check_crowds()
{
  std::vector<Vector> points(20000, Vector(1, 2, 3));
  points.emplace_back(50, 0, 0);
  const Gridded_points input(points, 1);
  const double radius = 0.7;
  const std::size_t number_of_samples = 1000;
  const Areas areas = areas_of(input, radius, number_of_samples);
  const double of_place = 2 * EIGEN_PI * radius * radius / double(number_of_samples);
  bool are_shared = true;
  for (std::size_t i = 0; i < points.size(); ++i)
    are_shared = are_shared
                 && is_close(areas.of_point(i),
                             input.vector[i][0] > 10 ? of_place : of_place / 20000, 0.15);
  CHECK(are_shared);
}

/// Points on a line that has nothing beside it stand for a strip as wide as the samples are apart,
/// so that as many start there as find room; and a point alone for the place of one.
void check_lines(bool has_scales)
{
  const double radius = 0.2;
  std::vector<Vector> points;
  for (int k = 0; k < 3000; ++k)
    points.push_back(Vector(0.01 * k + 0.0003 * (k % 7), 0, 0));
  points.push_back(Vector(0, 100, 0));
  Buffer<float> scales;
  if (has_scales)
    scales.assign(points.size(), 1.f);
  const Sorted_queries input(CGAL::Sequential_tag(), to_buffer(points), Cell_sizes(radius, scales));
  for (const std::size_t number_of_samples : {300u, 1000u, 3000u})
  {
    const Areas areas = areas_of(input, radius, number_of_samples);
    const double disks = 30 * radius * EIGEN_PI / 2 + EIGEN_PI * radius * radius,
                 spacing = std::sqrt(disks / double(number_of_samples));
    double of_line = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (input.points[i][1] > 50)
        CHECK(is_close(areas.of_point(i), spacing * spacing, spacing < 0.8 * radius ? 0.15 : 0.2));
      else
        of_line += areas.of_point(i);
    CHECK(is_close(of_line, 30 * spacing, 0.15));
  }
}

int main()
{
  Generator generator(7);
  check_lines(false);
  check_lines(true);
  check_exactness();
  check_formulas(cube_points(1500, 1, generator).points);
  check_areas(generator);
  check_crowds();
  return result();
}
