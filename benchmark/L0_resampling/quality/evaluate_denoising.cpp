// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures a point set as the field that learns to denoise does: the Chamfer distance to a clean
// point set and the distance to the mesh, both squared and in both directions, in the unit of a
// sphere around the clean points, or around the mesh. Prints one JSON object.

#include "../common/Aabb_trees.h"
#include "../methods/method_program.h"

#include <CGAL/Orthogonal_incremental_neighbor_search.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace L0_benchmark;
using Traits = CGAL::Search_traits_3<Kernel>;
using Nearest = CGAL::Orthogonal_k_neighbor_search<Traits>;
using Incremental = CGAL::Orthogonal_incremental_neighbor_search<Traits>;

/// Squared, of the sphere around the middle of the box of the points.
double squared_radius_of_sphere(const std::vector<Point>& points)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const Point middle((box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2,
                     (box.zmin() + box.zmax()) / 2);
  double largest = 0;
  for (const Point& p : points)
    largest = (std::max)(largest, CGAL::squared_distance(p, middle));
  return largest;
}

double mean_squared_distance(const std::vector<Point>& from, const std::vector<Point>& to)
{
  const Nearest::Tree tree(to.begin(), to.end());
  double sum = 0;
  for (const Point& p : from)
    sum += Nearest(tree, p, 1).begin()->second;
  return sum / double(from.size());
}

double mean_squared_distance(const std::vector<Point>& points,
                             const std::vector<Triangle_3>& triangles)
{
  const Triangle_tree tree(triangles.begin(), triangles.end());
  double sum = 0;
  for (const Point& p : points)
    sum += tree.squared_distance(p);
  return sum / double(points.size());
}

/// Of each triangle to the nearest of the points. No point farther from the centroid than the
/// nearest one so far and the farthest corner together can be nearer.
double mean_squared_distance(const std::vector<Triangle_3>& triangles,
                             const std::vector<Point>& points)
{
  const Incremental::Tree tree(points.begin(), points.end());
  double sum = 0;
  for (const Triangle_3& triangle : triangles) {
    const Point centroid = CGAL::centroid(triangle);
    double reach = 0;
    for (int corner = 0; corner < 3; ++corner)
      reach = (std::max)(reach, CGAL::squared_distance(centroid, triangle[corner]));
    reach = std::sqrt(reach);
    double nearest = CGAL::squared_distance(points.front(), triangle);
    const Incremental search(tree, centroid);
    for (const auto& [point, squared_distance] : search) {
      if (std::sqrt(squared_distance) > std::sqrt(nearest) + reach)
        break;
      nearest = (std::min)(nearest, CGAL::squared_distance(point, triangle));
    }
    sum += nearest;
  }
  return sum / double(triangles.size());
}

} // namespace

int main(int argc, char** argv)
{
  std::string result_file, clean_file, mesh_file;
  CLI::App& app = command_line("The distances that learned methods of denoising are compared by");
  app.add_option("result", result_file, "PLY file")->required()->check(CLI::ExistingFile);
  app.add_option("clean", clean_file, "PLY file of the points before the noise")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("mesh", mesh_file, "OFF file that they lie on")
    ->required()
    ->check(CLI::ExistingFile);

  return run_program(app, argc, argv, [&] {
    const std::vector<Point> result = read_positions(result_file),
                             clean = read_positions(clean_file);
    const Triangle_mesh mesh = read_triangle_mesh(mesh_file);
    const std::vector<Triangle_3> triangles = proper_triangles(mesh);
    const double unit_of_clean = squared_radius_of_sphere(clean),
                 unit_of_mesh = squared_radius_of_sphere(mesh.vertices);
    const nlohmann::ordered_json json = {
      {"number_of_points", result.size()},
      {"chamfer", (mean_squared_distance(result, clean) + mean_squared_distance(clean, result))
                    / unit_of_clean},
      {"points_to_mesh", mean_squared_distance(result, triangles) / unit_of_mesh},
      {"mesh_to_points", mean_squared_distance(triangles, result) / unit_of_mesh}};
    std::cout << json.dump() << std::endl;
  });
}
