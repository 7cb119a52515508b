// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Orients the same estimated normals, with signs by chance, by mst_orient_normals() and by
// l0_orient_normals(), and counts those that are on the wrong side of the nearest face.

#include "../methods/baseline_steps.h"
#include "Ground_truth.h"

#include <CGAL/Real_timer.h>
#include <CGAL/l0_orient_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <numeric>
#include <random>
#include <vector>

namespace {

using namespace L0_benchmark;

/// Maps of the indices of points.
auto maps(const std::vector<Point>& points, std::vector<Vector>& normals)
{
  return CGAL::parameters::point_map(CGAL::make_property_map(points))
    .normal_map(CGAL::make_property_map(normals));
}

/// Orients the normals, and measures how well and how fast.
/// \param orient takes the indices of the points, which it may reorder, and the maps
/// \param right for each point, the normals of the nearest faces
template <typename F>
Json measure(const F& orient, const std::vector<Point>& points, std::vector<Vector> normals,
             const std::vector<std::vector<Vector>>& right)
{
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  CGAL::Real_timer timer;
  timer.start();
  const std::clock_t begin = std::clock();
  orient(indices, maps(points, normals));
  const double of_processors = double(std::clock() - begin) / CLOCKS_PER_SEC; // of all threads
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    wrong += std::all_of(right[i].begin(), right[i].end(),
                         [&](const Vector& n) { return normals[i] * n < 0; });
  return {{"wrong_share", double(wrong) / double(points.size())},
          {"seconds", timer.time()},
          {"processor_seconds", of_processors}};
}

} // namespace

int main(int argc, char** argv)
{
  std::string input, truth_path;
  CLI::App& app = command_line("The sides of normals that two functions find");
  app.add_option("input", input, "PLY file; only the positions are used")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("truth", truth_path, "Triangle mesh, OFF")->required()->check(CLI::ExistingFile);
  return run_program(app, argc, argv, [&] {
    const Ground_truth truth(read_triangle_mesh(truth_path));
    const std::vector<Point> points = read_positions(input);
    Oriented_points estimated;
    std::vector<Vector> normals;
    std::vector<std::vector<Vector>> right;
    for (const Point& p : points) {
      estimated.emplace_back(p, CGAL::NULL_VECTOR);
      right.push_back(truth.nearest_normals(p));
    }
    CGAL::pca_estimate_normals<CGAL::Parallel_if_available_tag>(
      estimated, number_of_normal_neighbors, point_and_normal_maps());
    std::mt19937 generator(1);
    for (const Oriented_point& pair : estimated)
      normals.push_back(generator() % 2 == 0 ? pair.second : -pair.second);

    const auto by_tree = [](auto& indices, const auto& np) {
      CGAL::mst_orient_normals(indices, number_of_normal_neighbors, np);
    };
    const auto ours = [](auto& indices, const auto& np) {
      CGAL::l0_orient_normals<CGAL::Parallel_if_available_tag>(indices, np);
    };
    const Json result = {{"points", points.size()},
                         {"mst_orient_normals", measure(by_tree, points, normals, right)},
                         {"l0_orient_normals", measure(ours, points, normals, right)}};
    std::cout << result.dump() << std::endl;
  });
}
