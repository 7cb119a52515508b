// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cases.h"

#include <CGAL/IO/read_ply_points.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace result_hashes {
namespace {

using test::Generator;
using test::Oriented_points;
using test::random_number;
using test::Vector;

/// Without normals: only cases that pass them on need them.
Case unoriented(const std::string& name, const std::vector<Vector>& points)
{
  const std::vector<Vector> normals(points.size(), Vector::UnitZ());
  return {name, points, normals, {}};
}

Case from_file(const std::string& directory, const std::string& name)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  const std::string path = directory + "/" + name + ".ply";
  if (!CGAL::IO::read_PLY(path, std::back_inserter(points)) || points.empty())
    throw std::runtime_error(path + ": cannot be read");
  std::vector<Vector> vectors;
  for (const auto& p : points)
    vectors.emplace_back(p.x(), p.y(), p.z());
  return unoriented(name, vectors);
}

Oriented_points noisy_cube(std::size_t n, double noise)
{
  Generator generator(1);
  Oriented_points cube = test::cube_points(n, 1, generator);
  test::add_gaussian_noise(cube.points, noise, generator);
  return cube;
}

std::vector<Vector> noisy_sphere(std::size_t n, double noise)
{
  Generator generator(2);
  std::vector<Vector> points = test::sphere_points(n, 1, generator).points;
  test::add_gaussian_noise(points, noise, generator);
  return points;
}

/// In a box around the origin, each coordinate up to half of `sides`.
std::vector<Vector> random_points(std::size_t n, const Vector& sides, Generator& generator)
{
  std::vector<Vector> points;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = random_number(-0.5, 0.5, generator), y = random_number(-0.5, 0.5, generator);
    const Vector p(x, y, random_number(-0.5, 0.5, generator));
    points.push_back(p.cwiseProduct(sides));
  }
  return points;
}

/// Two parallel squares with side 1, noisy.
std::vector<Vector> thin_plate(std::size_t n, double thickness)
{
  Generator generator(3);
  std::vector<Vector> points = random_points(n, Vector(1, 1, 0), generator);
  for (std::size_t i = 0; i < n; ++i)
    points[i][2] = (i % 2 == 0 ? 0.5 : -0.5) * thickness;
  test::add_gaussian_noise(points, 0.1 * thickness, generator);
  return points;
}

/// On a sphere that is ten times as dense at one pole as at the other.
std::vector<Vector> density_gradient(std::size_t n)
{
  Generator generator(4);
  std::vector<Vector> points;
  while (points.size() < n)
  {
    const Vector p = test::random_unit_vector(generator);
    if (random_number(0, 1, generator) < std::pow(10, (p[2] - 1) / 2))
      points.push_back(p);
  }
  return points;
}

std::vector<Vector> with_outliers(std::vector<Vector> points)
{
  Generator generator(5);
  const std::vector<Vector> outliers = random_points(points.size() / 20, {2, 2, 2}, generator);
  points.insert(points.end(), outliers.begin(), outliers.end());
  points.emplace_back(1e6, 0, 0);
  return points;
}

/// The first half of the points a second time, the first quarter a third time.
std::vector<Vector> with_duplicates(std::vector<Vector> points)
{
  const std::vector<Vector> once = points;
  for (const std::size_t share : {2, 4})
    points.insert(points.end(), once.begin(), once.begin() + std::ptrdiff_t(once.size() / share));
  return points;
}

/// Half of the points within 1e-9 of one of the others.
std::vector<Vector> with_crowd(std::vector<Vector> points)
{
  Generator generator(6);
  for (std::size_t i = 0; i < points.size(); i += 2)
    points[i] = points[1] + 1e-9 * test::random_unit_vector(generator);
  return points;
}

/// What a scanner with 32 rotating beams sees from the middle of a room: rings on the floor and on
/// the walls, dense along the ring and sparse across.
std::vector<Vector> lidar_rings(std::size_t points_per_ring)
{
  Generator generator(7);
  const Vector room(10, 6, 3);
  std::vector<Vector> points;
  for (int ring = 0; ring < 32; ++ring)
    for (std::size_t i = 0; i < points_per_ring; ++i)
    {
      const double angle = 2 * EIGEN_PI * double(i) / double(points_per_ring);
      const Vector beam(std::cos(angle), std::sin(angle), std::tan((ring - 20) * EIGEN_PI / 120));
      const double distance = (room / 2).cwiseQuotient(beam.cwiseAbs()).minCoeff();
      points.push_back((distance + 0.005 * random_number(-1, 1, generator)) * beam);
    }
  return points;
}

/// On a wavy square, in rows whose points are twenty times as dense as the rows.
std::vector<Vector> rows_of_points(std::size_t number_of_rows)
{
  std::vector<Vector> points;
  const double spacing = 1. / double(number_of_rows);
  for (std::size_t row = 0; row < number_of_rows; ++row)
    for (std::size_t i = 0; i < 20 * number_of_rows; ++i)
    {
      const double shift = 0.3 * double(row % 3);
      const double x = (double(i) + shift) * spacing / 20, y = double(row) * spacing;
      points.emplace_back(x, y, 0.1 * std::sin(6 * x) * std::cos(4 * y));
    }
  return points;
}

std::vector<Vector> collinear(std::size_t n)
{
  Generator generator(8);
  std::vector<Vector> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(random_number(-1, 1, generator) * Vector(1, 2, -0.5));
  return points;
}

std::vector<Vector> moved(std::vector<Vector> points, const Vector& translation)
{
  for (Vector& p : points)
    p += translation;
  return points;
}

std::vector<Vector> scaled(std::vector<Vector> points, double factor)
{
  for (Vector& p : points)
    p *= factor;
  return points;
}

void add_generated(std::vector<Case>& cases)
{
  Generator generator(9);
  const auto add = [&](const std::string& name, const std::vector<Vector>& points) {
    cases.push_back(unoriented(name, points));
  };
  const std::vector<Vector> cube = noisy_cube(5000, 0.005).points;
  add("plane", test::plane_points(4000, 1, generator).points);
  add("sphere", noisy_sphere(5000, 0));
  add("sphere_with_noise", noisy_sphere(5000, 0.02));
  add("cube_with_noise", cube);
  add("plate_with_noise", thin_plate(6000, 0.05));
  add("density_gradient", density_gradient(6000));
  add("outliers", with_outliers(cube));
  add("duplicates", with_duplicates(noisy_cube(3000, 0.005).points));
  add("crowd", with_crowd(noisy_sphere(2000, 0.01)));
  add("all_equal", std::vector<Vector>(300, Vector(1, 2, 3)));
  add("collinear", collinear(1000));
  add("lattice", test::lattice_points(13, 0.125));
  add("volume", random_points(3000, {1, 1, 1}, generator));
  add("one_point", {Vector(1, 2, 3)});
  add("two_points", {Vector(1, 2, 3), Vector(1, 2, 4)});
  add("utm_offset", moved(cube, {456075.1, 5935300.5, 120.25}));
  add("micrometers", scaled(noisy_sphere(4000, 0.01), 1e-6));
  add("lidar_rings", lidar_rings(240));
  add("rows", rows_of_points(20));
}

/// One parameter at a time, on a noisy cube unless said otherwise.
void add_with_parameters(std::vector<Case>& cases)
{
  const Oriented_points cube = noisy_cube(4000, 0.005);
  const auto add = [&](const std::string& name, const Case& input, const auto& change) {
    cases.push_back(input);
    cases.back().name = name;
    change(cases.back().parameters);
  };
  using Parameters = attack::Parameters;
  const Case input{"", cube.points, cube.normals, {}};
  Case some_normals = input, not_finite = input;
  for (std::size_t i = 0; i < input.points.size(); i += 7)
    some_normals.normals[i] = Vector::Zero();
  for (std::size_t i = 0; i < input.points.size(); i += 100)
    not_finite.points[i][1] = std::numeric_limits<double>::infinity();
  Case small = input;
  small.points.resize(1500);
  small.normals.resize(1500);

  add("given_normals", input, [](Parameters& p) { p.with_normals = true; });
  add("some_given_normals", some_normals, [](Parameters& p) { p.with_normals = true; });
  add("hints", some_normals, [](Parameters& p) { p.with_hints = true; });
  const Case plate = unoriented("", thin_plate(5000, 0));
  add("viewpoint", plate, [](Parameters& p) { p.viewpoint = 4; });
  add("viewpoint_map", plate, [](Parameters& p) {
    p.viewpoint = 4;
    p.viewpoint_by_map = true;
  });
  add("up_direction", plate, [](Parameters& p) { p.up_direction = -3; });
  const Case gradient = unoriented("", density_gradient(6000));
  add("keep_density", gradient, [](Parameters& p) { p.keep_density = true; });
  add("confidences", input, [](Parameters& p) { p.with_point_data = true; });
  add("neighbor_radius", input, [](Parameters& p) { p.neighbor_radius = 0.12; });
  add("normal_filter_radius", input, [](Parameters& p) { p.normal_filter_radius = 0.15; });
  add("more_points", input, [](Parameters& p) { p.number_of_output_points = 10000; });
  add("ten_points", input, [](Parameters& p) { p.number_of_output_points = 10; });
  add("all_points", input, [](Parameters& p) { p.select_percentage = 100; });
  add("random_seed", input, [](Parameters& p) { p.random_seed = 12345; });
  add("sharpness_angle", input, [](Parameters& p) { p.sharpness_angle = 40; });
  add("no_filter", input, [](Parameters& p) { p.number_of_normal_filter_iterations = 0; });
  add("weights", input, [](Parameters& p) {
    p.normal_weight = 3;
    p.regularization_weight = 0.5;
  });
  add("penalties", input, [](Parameters& p) {
    p.initial_penalty = 0.05;
    p.maximum_penalty = 5;
    p.penalty_growth = 1.3;
  });
  add("noise", input, [](Parameters& p) { p.noise = 0.02; });
  const Case outliers = unoriented("", with_outliers(cube.points));
  add("outlier_sensitivity", outliers, [](Parameters& p) { p.outlier_sensitivity = 1.5; });
  add("no_outliers_dropped", outliers, [](Parameters& p) { p.drop_outliers = false; });
  add("not_finite", not_finite, [](Parameters& p) { p.drop_non_finite = true; });
  add("single_precision", input, [](Parameters& p) { p.in_single_precision = true; });
  add("cholesky", small, [](Parameters& p) { p.solver = attack::Solver::CHOLESKY; });
  add("least_squares", small, [](Parameters& p) { p.solver = attack::Solver::LEAST_SQUARES; });
}

} // namespace

std::vector<Case> all_cases(const std::string& data_directory)
{
  std::vector<Case> cases;
  for (const char* const shape : {"bracket", "dodecahedron", "staircase", "thin_plate", "torus"})
    for (const char* const kind : {"_clean", "_noisy"})
      cases.push_back(from_file(data_directory, std::string(shape) + kind));
  add_generated(cases);
  add_with_parameters(cases);
  return cases;
}

} // namespace result_hashes
