// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures a point set against the mesh that it should be a sampling of, and prints one JSON
// object.

#include "../common/command_line.h"
#include "metrics.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>

#include <nlohmann/json.hpp>

#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using L0_benchmark::Evaluation;
using L0_benchmark::Point_3;
using L0_benchmark::Vector_3;
using Json = nlohmann::ordered_json;

struct Result
{
  std::vector<Point_3> points;
  std::vector<Vector_3> normals;
};

Result read_result(const std::string& path)
{
  CGAL::Point_set_3<Point_3> point_set;
  if (!CGAL::IO::read_point_set(path, point_set))
    throw std::runtime_error(path + ": cannot be read as a point set");
  Result result;
  for (const auto& i : point_set) {
    result.points.push_back(point_set.point(i));
    if (point_set.has_normal_map())
      result.normals.push_back(point_set.normal(i));
  }
  return result;
}

// Names carry the unit where it is not % of the diagonal or a plain number.
Json to_json(const Evaluation& e, const L0_benchmark::Ground_truth& truth)
{
  Json json;
  json["diagonal_length"] = truth.diagonal();
  json["distance"] = {{"mean", e.distance.mean}, {"p95", e.distance.p95}, {"max", e.distance.max}};
  json["coverage"] = {{"mean", e.coverage.mean}, {"p99", e.coverage.p99}, {"max", e.coverage.max}};
  json["chamfer"] = e.chamfer;
  json["hausdorff"] = e.hausdorff;
  json["normals"] = nullptr;
  if (e.normals)
    json["normals"] = {{"mean_error_degrees", e.normals->mean_error},
                       {"share_above_15_degrees", e.normals->share_above_15_degrees},
                       {"share_inwards", e.normals->share_inwards},
                       {"share_turned", e.normals->share_turned}};
  json["uniformity"] = {{"median_spacing", e.uniformity.median_spacing / truth.diagonal() * 100},
                        {"spacing_variation", e.uniformity.spacing_variation},
                        {"density_variation", e.uniformity.density_variation}};
  json["features"] = nullptr;
  if (e.features) {
    json["features"] = {{"edge_recall", e.features->edge_recall},
                        {"number_of_points", e.features->number_of_points},
                        {"mean_distance", e.features->mean_distance},
                        {"mean_normal_error_degrees", nullptr}};
    if (e.features->mean_normal_error)
      json["features"]["mean_normal_error_degrees"] = *e.features->mean_normal_error;
  }
  return json;
}

/// For each point, as two `float`: distance to the mesh, % of the diagonal, and density of Eq. (5),
/// with the radius of `measure_uniformity()`.
void write_values_of_points(const std::string& path, const std::vector<Point_3>& points,
                            const L0_benchmark::Ground_truth& truth)
{
  const double area = L0_benchmark::Area_sampler(truth.mesh()).area();
  const L0_benchmark::Search_tree tree(points.begin(), points.end());
  const std::vector<double> distances = distances_to_mesh(points, truth);
  const std::vector<double> densities =
    L0_benchmark::local_densities(points, tree, L0_benchmark::density_radius(area, points.size()));
  std::vector<float> values;
  for (std::size_t i = 0; i < points.size(); ++i) {
    values.push_back(float(distances[i] / truth.diagonal() * 100));
    values.push_back(float(densities[i]));
  }
  std::ofstream out(path, std::ios::binary);
  if (!out.write(reinterpret_cast<const char*>(values.data()),
                 std::streamsize(sizeof(float) * values.size())))
    throw std::runtime_error(path + ": cannot be written");
}

} // namespace

int main(int argc, char* argv[])
{
  CLI::App& app = L0_benchmark::command_line(
    "Measures a point set against a triangle mesh. Lengths are % of the bounding box's diagonal.");
  std::string result_path, truth_path, values_path;
  app.add_option("result", result_path, "Point set: PLY, OFF or XYZ")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("truth", truth_path, "Triangle mesh, OFF")->required()->check(CLI::ExistingFile);
  app.add_option("--values", values_path,
                 "File for distance and density of each point, two float32 a point");
  double apart = -1;
  app
    .add_option("--apart", apart,
                "Also the normals inwards where no other sheet is as near, % of the diagonal")
    ->check(CLI::NonNegativeNumber);
  if (const std::optional<int> status = L0_benchmark::read_command_line(app, argc, argv))
    return *status;

  try {
    const Result result = read_result(result_path);
    const L0_benchmark::Ground_truth truth(L0_benchmark::read_triangle_mesh(truth_path));
    Json json = {{"number_of_points", result.points.size()}};
    json.update(to_json(L0_benchmark::evaluate(result.points, result.normals, truth), truth));
    if (apart >= 0 && !result.normals.empty()) {
      const std::optional<double> share = L0_benchmark::share_inwards_where_apart(
        result.points, result.normals, truth, apart / 100 * truth.diagonal());
      json["normals"]["share_inwards_where_apart"] = share ? Json(*share) : Json(nullptr);
    }
    if (!values_path.empty())
      write_values_of_points(values_path, result.points, truth);
    std::cout << json.dump(2) << "\n";
  } catch (const std::exception& error) {
    std::cerr << "evaluate_point_set: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
