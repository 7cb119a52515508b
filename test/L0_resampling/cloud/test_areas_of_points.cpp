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
  std::optional<std::uint64_t> units_of_balls;
  return areas_of_points<CGAL::Parallel_if_available_tag, float>(
    input.grid, input.points, radius, number_of_samples,
    units_per_length_for(input.grid.cell_size(), radius, !input.grid.has_one_scale()),
    units_of_balls, unwatched.progress);
}

/// The units of all points, from balls counted one by one.
std::vector<std::uint64_t> naive_units(const Gridded_points& input, double radius)
{
  std::vector<std::uint64_t> units(input.vector.size());
  for (std::size_t cell = 0; cell < input.grid.number_of_cells(); ++cell)
  {
    const auto range = input.grid.points_of_cell(cell);
    std::uint64_t sum = 0;
    for (Index i = range.first; i < range.second; ++i)
    {
      std::uint64_t count = 0;
      for (const Vector& p : input.vector)
        count += (p - input.vector[i]).squaredNorm() < radius * radius;
      sum += area_units_of_ball / count;
    }
    for (Index i = range.first; i < range.second; ++i)
      units[i] = sum / (range.second - range.first);
  }
  return units;
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
    const Areas areas = areas_of(input, radius);
    CHECK(std::vector<std::uint64_t>(areas.units.begin(), areas.units.end())
          == naive_units(input, radius));
  }
  CHECK(areas_of(Gridded_points(lattice, 0.15), 3 * spacing).units
        != areas_of(Gridded_points(lattice, 0.15), 3 * spacing * (1 + 1e-8)).units);
}

/// On points at random, and where cells are much larger or smaller than the ball.
void check_counts(const std::vector<Vector>& points)
{
  for (const double cell_size : {0.07, 0.2, 3.})
    for (const double radius : {0.01, 0.2})
    {
      const Gridded_points input(points, cell_size);
      const Areas areas = areas_of(input, radius);
      CHECK(std::vector<std::uint64_t>(areas.units.begin(), areas.units.end())
            == naive_units(input, radius));
    }
}

/// The areas of the points of a surface add up to its own, in dense and sparse parts alike.
void check_areas(Generator& generator)
{
  std::vector<Vector> points = plane_points(6000, 2, generator).points;
  for (const Vector& p : plane_points(600, 2, generator).points)
    points.push_back(p + Vector(5, 0, 0));
  const Gridded_points sorted(points, 0.2);
  const Areas areas = areas_of(sorted, 0.21);
  double inside[2] = {0, 0}, true_area[2] = {0, 0}, total = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const bool is_sparse = sorted.vector[i][0] > 2.5;
    const double x = sorted.vector[i][0] - (is_sparse ? 5 : 0), y = sorted.vector[i][1];
    total += areas.of_point(i);
    if (std::abs(x) < 0.6 && std::abs(y) < 0.6) // away from the border
    {
      inside[is_sparse] += areas.of_point(i);
      true_area[is_sparse] += 4 / (is_sparse ? 600. : 6000.);
    }
  }
  CHECK(is_close(inside[0], true_area[0], 0.05));
  CHECK(is_close(inside[1], true_area[1], 0.15));
  CHECK(is_close(areas.total(), total, 1e-9));
}

/// Everybody stands for something, however many share a place; where not all candidates are looked
/// at, those that are count for the others.
void check_crowds()
{
  std::vector<Vector> points(20000, Vector(1, 2, 3));
  points.emplace_back(50, 0, 0);
  const Gridded_points input(points, 1);
  const Areas areas = areas_of(input, 0.7);
  bool are_shared = true;
  for (std::size_t i = 0; i < points.size(); ++i)
    are_shared = are_shared
                 && is_close(double(areas.units[i]) / double(area_units_of_ball),
                             input.vector[i][0] > 10 ? 1 : 1. / 20000, 0.01);
  CHECK(are_shared);
}

/// Where radii differ, points on a line that has nothing beside it stand for a strip as wide as the
/// samples are apart, so that as many start there as find room; and a point alone for an eighth of
/// its disk.
void check_lines()
{
  const double radius = 0.2;
  std::vector<Vector> points;
  for (int k = 0; k < 3000; ++k)
    points.push_back(Vector(0.01 * k + 0.0003 * (k % 7), 0, 0));
  points.push_back(Vector(0, 100, 0));
  const Buffer<float> scales(points.size(), 1.f);
  const Sorted_queries input(CGAL::Sequential_tag(), to_buffer(points), Cell_sizes(radius, scales));
  const double of_loner = 3.1416 * radius * radius / double(fewest_points_of_disk);
  for (const std::size_t number_of_samples : {300u, 3000u})
  {
    const Areas areas = areas_of(input, radius, number_of_samples);
    const double all_as_surface = 30 * radius * 3.1416 / 2,
                 spacing = std::sqrt(all_as_surface / double(number_of_samples));
    CHECK(is_close(areas.total(), 30 * (std::min)(spacing, 0.1 * 3.1416), 0.05));
    for (std::size_t i = 0; i < points.size(); ++i)
      CHECK(input.points[i][1] < 50 || is_close(areas.of_point(i), of_loner, 0.01));
  }
}

int main()
{
  Generator generator(7);
  check_lines();
  check_exactness();
  check_counts(cube_points(1500, 1, generator).points);
  check_areas(generator);
  check_crowds();
  return result();
}
