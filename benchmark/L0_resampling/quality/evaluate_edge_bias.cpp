// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures on which side of a closed mesh points lie, by their distance from its sharp edges, and
// prints one JSON object. Lengths are % of the diagonal of the mesh's bounding box;
// outside is positive.

#include "../common/command_line.h"
#include "edge_bias.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>

#include <nlohmann/json.hpp>

#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace L0_benchmark;
using Json = nlohmann::ordered_json;

std::vector<Point_3> read_positions(const std::string& path)
{
  CGAL::Point_set_3<Point_3> point_set;
  if (!CGAL::IO::read_point_set(path, point_set))
    throw std::runtime_error(path + ": cannot be read as a point set");
  return {point_set.points().begin(), point_set.points().end()};
}

Json to_json(const std::vector<Edge_bias>& bands)
{
  Json json = Json::array();
  for (const Edge_bias& band : bands)
    json.push_back({{"from_edge", band.lower},
                    {"number_of_points", band.number_of_points},
                    {"signed_error", band.mean_signed_error()},
                    {"absolute_error", band.mean_absolute_error()}});
  return json;
}

} // namespace

int main(int argc, char* argv[])
{
  CLI::App& app = command_line(
    "Measures on which side of a mesh points lie, by distance from its edges.");
  std::string result_path, truth_path;
  app.add_option("result", result_path, "points: PLY, OFF, XYZ")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("truth", truth_path, "closed mesh, OFF")->required()->check(CLI::ExistingFile);
  if (const std::optional<int> status = read_command_line(app, argc, argv))
    return *status;

  try {
    const Triangle_mesh mesh = read_triangle_mesh(truth_path);
    const Edge_biases biases = measure_edge_bias(read_positions(result_path), mesh);
    const Json json = {{"convex", to_json(biases.convex)}, {"concave", to_json(biases.concave)}};
    std::cout << json.dump(1) << "\n";
  } catch (const std::exception& error) {
    std::cerr << "evaluate_edge_bias: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
