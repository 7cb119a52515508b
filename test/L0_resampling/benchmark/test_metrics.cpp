// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The measures of the benchmarks where their values are known

#include "mesh_support.h"

#include "../../../benchmark/L0_resampling/quality/metrics.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace L0_benchmark;
using namespace L0_benchmark_test;

namespace {

// Two unit squares with a common edge, the second turned down by an angle.
Triangle_mesh fold(double degrees)
{
  const double c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
  return {{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0),
           Point_3(1 + c, 0, -s), Point_3(1 + c, 1, -s)},
          {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}};
}

// n x n points with distance 1 / n, the outermost half of that from the border of the unit square.
std::vector<Point_3> grid(int n, double z)
{
  std::vector<Point_3> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      points.emplace_back((i + 0.5) / n, (j + 0.5) / n, z);
  return points;
}

std::vector<Point_3> ring(int n, double radius, double z)
{
  std::vector<Point_3> points;
  for (int i = 0; i < n; ++i)
    points.emplace_back(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), z);
  return points;
}

// Above the rectangle another one, of half its width, with its outside up.
Triangle_mesh two_sheets(double height)
{
  return {{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0),
           Point_3(0, 0, height), Point_3(0.5, 0, height), Point_3(0.5, 1, height),
           Point_3(0, 1, height)},
          {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
}

void test_statistics()
{
  std::vector<double> values;
  for (int i = 100; i > 0; --i)
    values.push_back(i);
  check_close(mean(values), 50.5, 1e-12);
  check_close(quantile(values, 0.5), 50, 0);
  check_close(quantile(values, 0.95), 95, 0);
  check_close(quantile({3, 1, 2}, 0.5), 2, 0);
  check_close(quantile({7}, 0.01), 7, 0);
  check_close(coefficient_of_variation({1, 3}), 0.5, 1e-15);
  check_close(coefficient_of_variation({4, 4, 4}), 0, 0);
  const Distance_statistics statistics = summarize(values, 2);
  check_close(statistics.p95, 47.5, 0);
  check_close(statistics.p99, 49.5, 0);
  check_close(statistics.max, 50, 0);
}

void test_distance_to_mesh()
{
  const Ground_truth truth(rectangle(1, 1));
  const double height = 0.01;
  const double percent = std::sqrt(2.) / 100;

  const Evaluation on_mesh = evaluate(grid(40, 0), {}, truth);
  check_close(on_mesh.distance.max, 0, 0);
  check(!on_mesh.normals && !on_mesh.features, "there are neither normals nor edges to measure");

  const Evaluation above = evaluate(grid(40, height), {}, truth);
  check_close(above.distance.mean, height / percent, 1e-12);
  check_close(above.distance.p95, height / percent, 1e-12);
  check_close(above.distance.max, height / percent, 1e-12);

  // Beside the mesh the border is nearest, not the plane.
  check_close(truth.distance(Point_3(2, 0.5, 0)), 1, 1e-15);
}

void test_coverage()
{
  const Ground_truth truth(rectangle(1, 1));
  const double percent = std::sqrt(2.) / 100;

  // The mean distance from a corner of the unit square is (sqrt(2) + log(1 + sqrt(2))) / 3.
  const Evaluation corner = evaluate({Point_3(0, 0, 0)}, {}, truth);
  check_close(corner.coverage.mean * percent, (std::sqrt(2.) + std::log(1 + std::sqrt(2.))) / 3,
              0.003);
  check(corner.coverage.max > 99 && corner.coverage.max <= 100,
        "the opposite corner is a diagonal away");
  check_close(corner.chamfer, corner.coverage.mean, 0);
  check_close(corner.hausdorff, corner.coverage.max, 0);

  // Cells of a grid are 1 / 40 wide: no sample is farther than half a cell's diagonal. The mean in
  // a square of half that width, from its corner, is again the formula above.
  const Evaluation covered = evaluate(grid(40, 0), {}, truth);
  check_close(covered.coverage.mean * percent,
              (std::sqrt(2.) + std::log(1 + std::sqrt(2.))) / 3 / 80, 5e-5);
  check(covered.coverage.max * percent <= std::sqrt(0.5) / 40, "a sample lies beyond its cell");
  check(covered.coverage.p99 <= covered.coverage.max, "quantiles rise");

  // A point far from the mesh does not matter to coverage, but to the other direction.
  std::vector<Point_3> points = grid(40, 0);
  points.emplace_back(0.5, 0.5, 3);
  const Evaluation with_outlier = evaluate(points, {}, truth);
  check_close(with_outlier.coverage.mean, covered.coverage.mean, 0);
  check_close(with_outlier.hausdorff * percent, 3, 1e-12);
  check_close(with_outlier.chamfer - with_outlier.coverage.mean, 3 / percent / 1601, 1e-9);
}

void test_normals()
{
  const Ground_truth truth(rectangle(1, 1));
  const std::vector<Point_3> points = grid(20, 0.01);
  const auto measured = [&](double degrees, double sign) {
    const double length = 3; // must not matter
    const Vector_3 normal =
      sign * length * Vector_3(std::sin(degrees * pi / 180), 0, std::cos(degrees * pi / 180));
    return summarize(
      normal_deviations(points, std::vector<Vector_3>(points.size(), normal), truth));
  };
  for (double sign : {1., -1.})
    for (double degrees : {0., 1e-6, 14.9, 15.1, 59.9, 60.1, 80.})
    {
      const Normal_statistics statistics = measured(degrees, sign);
      check_close(statistics.mean_error, degrees, 1e-9);
      check_close(statistics.share_above_15_degrees, degrees > 15, 0);
      check_close(statistics.share_inwards, sign < 0, 0);
      check_close(statistics.share_turned, sign < 0 && degrees < 60, 0);
    }

  std::vector<Vector_3> mixed(points.size(), Vector_3(0, 0, 1));
  for (std::size_t i = 0; i < 100; ++i)
    mixed[i] = Vector_3(0, 0, -1);
  check_close(summarize(normal_deviations(points, mixed, truth)).share_inwards, 0.25, 0);

  const double nan = std::numeric_limits<double>::quiet_NaN();
  check_close(normal_deviation(points[0], Vector_3(0, 0, 0), truth).angle, 90, 0);
  check_close(normal_deviation(points[0], Vector_3(nan, 0, 1), truth).angle, 90, 0);
}

// Where the foot point is on an edge or a vertex, each of the faces there is right.
void test_normals_at_edges()
{
  const Ground_truth truth(cube());
  const Point_3 edge(0.5, 1.01, 1.01), vertex(1.01, 1.01, 1.01), face(0.5, 0.9, 1.01);
  const Vector_3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  check_close(normal_deviation(edge, y, truth).angle, 0, 1e-12);
  check_close(normal_deviation(edge, z, truth).angle, 0, 1e-12);
  check_close(normal_deviation(edge, x, truth).angle, 90, 1e-12);
  check_close(normal_deviation(edge, y + z, truth).angle, 45, 1e-12);
  check(normal_deviation(edge, -y, truth).inwards, "the opposite of a normal points inwards");
  for (const Vector_3& normal : {x, y, z})
    check_close(normal_deviation(vertex, normal, truth).angle, 0, 1e-12);
  check_close(normal_deviation(vertex, x + y + z, truth).angle,
              std::acos(1 / std::sqrt(3.)) * 180 / pi, 1e-12);
  check_close(normal_deviation(face, y, truth).angle, 90, 1e-12);
  // Stored as float, a point on an edge is next to it.
  check_close(normal_deviation(Point_3(0.5, 1 - 1e-7, 1), y, truth).angle, 0, 1e-12);
}

void test_uniformity()
{
  // All points of a ring are alike.
  std::vector<Point_3> points = ring(100, 1, 0);
  const Search_tree one_ring(points.begin(), points.end());
  const Uniformity even = measure_uniformity(points, one_ring, 1);
  check_close(even.median_spacing, 2 * std::sin(pi / 100), 1e-12);
  check_close(even.spacing_variation, 0, 1e-12);
  check_close(even.density_variation, 0, 1e-12);

  // Values m and 2 m, equally often: mean 1.5 m, standard deviation 0.5 m.
  const std::vector<Point_3> wide = ring(100, 2, 50);
  points.insert(points.end(), wide.begin(), wide.end());
  const Search_tree two_rings(points.begin(), points.end());
  check_close(measure_uniformity(points, two_rings, 1).spacing_variation, 1. / 3, 1e-12);
  check(measure_uniformity(points, two_rings, 1).density_variation > 0.01,
        "the rings differ in density");

  // In a square lattice the 6 nearest are 4 at 1 and 2 at sqrt(2) spacings; at the border there are
  // fewer.
  const std::vector<Point_3> lattice = grid(20, 0);
  const Search_tree lattice_tree(lattice.begin(), lattice.end());
  const std::vector<double> means = mean_neighbor_distances(lattice, lattice_tree, 6);
  for (int i = 1; i < 19; ++i)
    for (int j = 1; j < 19; ++j)
      check_close(means[20 * i + j], (4 + 2 * std::sqrt(2.)) / 6 / 20, 1e-12);
  check(means[0] > means[21], "a corner's neighbors are farther");

  const std::vector<Point_3> alone = {Point_3(0, 0, 0)};
  const Search_tree alone_tree(alone.begin(), alone.end());
  check_close(mean_neighbor_distances(alone, alone_tree, 6)[0], 0, 0);
  check_close(local_densities(alone, alone_tree, 1)[0], 1, 0);
}

// Eq. (5) by hand: neighbor counts 1, 2 and 1 have the mean 4 / 3; the fourth point is out of reach
// of all.
void test_local_density()
{
  const std::vector<Point_3> points = {Point_3(0, 0, 0), Point_3(0.6, 0, 0), Point_3(1.2, 0, 0),
                                       Point_3(9, 0, 0)};
  const Search_tree tree(points.begin(), points.end());
  const std::vector<double> densities = local_densities(points, tree, 1);
  const double theta = std::exp(-4 * 0.36);
  check_close(densities[0], 1 + theta, 1e-12);
  check_close(densities[1], 1 + 2 * theta, 1e-12);
  check_close(densities[2], 1 + theta, 1e-12);
  check_close(densities[3], 1, 1e-12);
}

void test_features()
{
  check(feature_edges(cube(), 30).size() == 12,
        "a cube has 12 edges; the diagonals of its faces are none");
  check(feature_edges(fold(29.9), 30).empty(), "a fold of 29.9 degrees is no feature");
  check(feature_edges(fold(30.1), 30).size() == 1,
        "a fold of 30.1 degrees is one, borders are none");

  // Points along one of the 12 edges, 0.001 apart: it is met, and the 4 edges at its ends up to 2
  // spacings.
  const Ground_truth truth(cube());
  std::vector<Point_3> points;
  for (int i = 0; i <= 1000; ++i)
    points.emplace_back(i / 1000., 0, 0);
  const Feature_statistics met = *evaluate(points, {}, truth).features;
  check_close(met.edge_recall, (1 + 4 * 0.002) / 12, 1e-4);
  check(met.number_of_points == 1001, "all points are near an edge");
  check(!met.mean_normal_error, "there are no normals");

  // 1.5 % of the diagonal are 0.02598. Only points nearer than that to an edge count.
  points = {Point_3(0.5, 0.025, -0.001), Point_3(0.5, 0.027, 0), Point_3(0.5, 0.5, 1.2)};
  const std::vector<Vector_3> normals = {Vector_3(0, 1, -1), Vector_3(1, 0, 0), Vector_3(1, 0, 0)};
  const Feature_statistics near = *evaluate(points, normals, truth).features;
  check(near.number_of_points == 1, "one point is near an edge");
  check_close(near.mean_distance, 0.1 / std::sqrt(3.), 1e-9);
  check_close(near.mean_normal_error.value_or(-1), 45, 1e-9);
  check_close(evaluate({Point_3(0.5, 0.5, 0)}, {}, truth).features->mean_distance, 0, 0);
}

void test_refusals()
{
  const Ground_truth truth(rectangle(1, 1));
  const double infinity = std::numeric_limits<double>::infinity();
  check_throws([&] { evaluate({}, {}, truth); });
  check_throws([&] { evaluate({Point_3(0, 0, 0), Point_3(0, infinity, 0)}, {}, truth); });
  check_throws([&] { evaluate(grid(2, 0), {Vector_3(0, 0, 1)}, truth); });

  const auto refused = [](double noise, double outliers, double density_gradient) {
    check_throws([&] { sample_mesh(rectangle(1, 1), {10, noise, outliers, density_gradient, 1}); });
  };
  refused(-1, 0, 1);
  refused(infinity, 0, 1);
  refused(0, 101, 1);
  refused(0, -1, 1);
  refused(0, 0, 0.5);
  refused(0, 0, std::nan(""));
  check_throws([] { sample_mesh(rectangle(1, 0), {}); });
  check_throws([] { const Ground_truth flat(rectangle(1, 0)); });
}

void test_mesh_files()
{
  const std::string path =
    (std::filesystem::temp_directory_path() / "test_metrics_cube.off").string();
  {
    // Every triangle with vertices of its own, as some exporters write them.
    const Triangle_mesh mesh = cube();
    std::ofstream file(path);
    file << "OFF\n36 12 0\n";
    for (std::size_t t = 0; t < 12; ++t)
      for (int i = 0; i < 3; ++i)
        file << mesh.triangle(t)[i] << "\n";
    for (int t = 0; t < 12; ++t)
      file << "3 " << 3 * t << " " << 3 * t + 1 << " " << 3 * t + 2 << "\n";
  }
  const Triangle_mesh mesh = read_triangle_mesh(path);
  check(mesh.vertices.size() == 8 && mesh.triangles.size() == 12, "equal vertices become one");
  check(feature_edges(mesh, 30).size() == 12, "edges are found in a soup");

  std::ofstream(path) << "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
  check_throws<std::runtime_error>([&] { read_triangle_mesh(path); });
  std::ofstream(path) << "OFF\n1 0 0\n0 0 0\n";
  check_throws<std::runtime_error>([&] { read_triangle_mesh(path); });
  std::filesystem::remove(path);
  check_throws<std::runtime_error>([&] { read_triangle_mesh(path); });
}

void test_sides_where_sheets_are_apart()
{
  const Ground_truth truth(two_sheets(0.1));
  const Point_3 below(0.2, 0.3, 0.001), above(0.3, 0.4, 0.101), alone(0.8, 0.3, -0.001);
  check_close(truth.distance_to_next_sheet(below), 0.1, 1e-9);
  check_close(truth.distance_to_next_sheet(above), 0.1, 1e-9);
  check(std::isinf(truth.distance_to_next_sheet(alone)), "there is no sheet above or below");

  const Vector_3 up(0, 0, 1);
  const std::vector<Point_3> points = {below, above, alone, Point_3(0.9, 0.9, 0)};
  const std::vector<Vector_3> normals = {-up, up, -up, up};
  check_close(share_inwards_where_apart(points, normals, truth, 0.05).value(), 0.5, 0);
  check_close(share_inwards_where_apart(points, {-up, -up, up, up}, truth, 0.15).value(), 0, 0);
  check(!share_inwards_where_apart({below}, {up}, truth, 0.15), "no point is apart");
}

} // namespace

int main()
{
  test_statistics();
  test_distance_to_mesh();
  test_coverage();
  test_normals();
  test_normals_at_edges();
  test_uniformity();
  test_local_density();
  test_features();
  test_refusals();
  test_mesh_files();
  test_sides_where_sheets_are_apart();
  return number_of_failures == 0 ? 0 : 1;
}
