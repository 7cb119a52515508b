// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how well lines follow the sharp edges of a mesh, and prints one JSON object. Lengths are
// in spacings of the points.

#include "../common/Aabb_trees.h"
#include "../common/command_line.h"
#include "../common/sample_mesh.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace L0_benchmark;
using Json = nlohmann::ordered_json;

constexpr double degree = CGAL_PI / 180;

struct Lines
{
  std::vector<Segment_3> segments;
  std::vector<Point_3> corners;
};

/// \throws std::runtime_error for a file that is none of those that `l0_resample --creases` writes
Lines read_lines(const std::string& path)
{
  std::ifstream file(path);
  std::vector<Point_3> vertices;
  Lines lines;
  const auto vertex = [&](std::size_t number) -> const Point_3& {
    if (number < 1 || number > vertices.size())
      throw std::runtime_error(path + ": there is no vertex " + std::to_string(number));
    return vertices[number - 1];
  };
  for (std::string text; std::getline(file, text);) {
    std::istringstream words(text);
    std::string kind;
    words >> kind;
    double x, y, z;
    std::size_t number, last = 0;
    if (kind == "v" && words >> x >> y >> z)
      vertices.emplace_back(x, y, z);
    for (bool is_first = true; kind == "l" && words >> number; is_first = false, last = number)
      if (!is_first)
        lines.segments.emplace_back(vertex(last), vertex(number));
    if (kind == "p" && words >> number)
      lines.corners.push_back(vertex(number));
  }
  if (!file.eof())
    throw std::runtime_error(path + ": cannot be read");
  return lines;
}

Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// The edges of at least this angle, and where three of them meet or two turn by 40 degrees.
Lines sharp_edges(const Triangle_mesh& mesh, double minimum_angle)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> triangles_of;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      triangles_of[std::minmax(a, b)].push_back(t);
    }
  const auto normal = [&](std::size_t t) {
    const Triangle_3 triangle = mesh.triangle(t);
    return unit(CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  };
  Lines edges;
  std::map<std::size_t, std::vector<Vector_3>> directions;
  for (const auto& [ends, triangles] : triangles_of)
    if (triangles.size() == 2
        && normal(triangles[0]) * normal(triangles[1]) < std::cos(minimum_angle * degree)) {
      const Point_3 &a = mesh.vertices[ends.first], &b = mesh.vertices[ends.second];
      edges.segments.emplace_back(a, b);
      directions[ends.first].push_back(unit(b - a));
      directions[ends.second].push_back(unit(a - b));
    }
  for (const auto& [vertex, ways] : directions)
    if (ways.size() > 2 || (ways.size() == 2 && ways[0] * ways[1] > -std::cos(40 * degree)))
      edges.corners.push_back(mesh.vertices[vertex]);
  return edges;
}

/// Places a twentieth of a spacing apart.
std::vector<Point_3> places_along(const std::vector<Segment_3>& segments, double spacing)
{
  std::vector<Point_3> places;
  for (const Segment_3& segment : segments) {
    const double length = std::sqrt(segment.squared_length());
    const std::size_t count = std::size_t(std::ceil(20 * length / spacing));
    for (std::size_t k = 0; k < count; ++k)
      places.push_back(segment.source() + (double(k) + 0.5) / double(count) * segment.to_vector());
  }
  return places;
}

/// To each place, the distance in spacings.
std::vector<double> distances(const std::vector<Point_3>& places,
                              const std::vector<Segment_3>& segments, double spacing)
{
  std::vector<double> result;
  if (segments.empty())
    return std::vector<double>(places.size(), 1e9);
  const Segment_tree tree(segments.begin(), segments.end());
  for (const Point_3& place : places)
    result.push_back(std::sqrt(tree.squared_distance(place)) / spacing);
  return result;
}

double share_above(const std::vector<double>& values, double limit)
{
  return values.empty() ? 0
                        : double(std::count_if(values.begin(), values.end(),
                                               [&](double value) { return value > limit; }))
                            / double(values.size());
}

std::size_t number_near(const std::vector<Point_3>& points, const std::vector<Point_3>& others,
                        double radius)
{
  return std::size_t(std::count_if(points.begin(), points.end(), [&](const Point_3& p) {
    return std::any_of(others.begin(), others.end(), [&](const Point_3& q) {
      return CGAL::squared_distance(p, q) < radius * radius;
    });
  }));
}

Json evaluate(const Lines& found, const Triangle_mesh& mesh, std::size_t number_of_points)
{
  const double spacing = std::sqrt(Area_sampler(mesh).area() / double(number_of_points));
  const double minimum_angle = 30, far = 3; // spacings
  const Lines edges = sharp_edges(mesh, minimum_angle);
  const std::vector<Point_3> along_lines = places_along(found.segments, spacing),
                             along_edges = places_along(edges.segments, spacing);
  std::vector<double> to_edges = distances(along_lines, edges.segments, spacing);
  const std::vector<double> to_lines = distances(along_edges, found.segments, spacing);
  const double astray = share_above(to_edges, far);
  to_edges.erase(std::remove_if(to_edges.begin(), to_edges.end(),
                                [&](double distance) { return distance > far; }),
                 to_edges.end());
  double sum = 0;
  for (const double distance : to_edges)
    sum += distance;
  return {{"length", double(along_lines.size()) / 20},
          {"length_of_edges", double(along_edges.size()) / 20},
          {"distance", to_edges.empty() ? 0 : sum / double(to_edges.size())},
          {"covered", 1 - share_above(to_lines, 1)},
          {"astray", astray},
          {"corners", edges.corners.size()},
          {"corners_found", number_near(edges.corners, found.corners, spacing)},
          {"false_corners",
           found.corners.size() - number_near(found.corners, edges.corners, far * spacing)}};
}

} // namespace

int main(int argc, char* argv[])
{
  CLI::App& app = command_line("Measures how well lines follow the sharp edges of a mesh.");
  std::string lines_path, truth_path;
  std::size_t number_of_points = 0;
  app.add_option("lines", lines_path, "creases, OBJ")->required()->check(CLI::ExistingFile);
  app.add_option("truth", truth_path, "mesh, OFF")->required()->check(CLI::ExistingFile);
  app.add_option("--points", number_of_points, "of the result, which tell its spacing")
    ->required()
    ->check(CLI::PositiveNumber);
  if (const std::optional<int> status = read_command_line(app, argc, argv))
    return *status;

  try {
    const Json json = evaluate(read_lines(lines_path), read_triangle_mesh(truth_path),
                               number_of_points);
    std::cout << json.dump(1) << "\n";
  } catch (const std::exception& error) {
    std::cerr << "evaluate_creases: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
