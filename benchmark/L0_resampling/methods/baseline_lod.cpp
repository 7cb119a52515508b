// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// LOD without its upsampling. It denoises all points; a random subset of them is the result.

#include "baseline_steps.h"
#include "l0_denoising.h"
#include "subsampling.h"

#include <CGAL/compute_average_spacing.h>

int main(int argc, char** argv)
{
  using namespace L0_benchmark;

  Arguments arguments;
  L0_denoising_parameters parameters;
  constexpr std::uint64_t seed = 1;
  CLI::App& app = command_line("L0 denoising");
  arguments.add_to(app);
  app.add_option("--normal-weight", parameters.normal_weight)->check(CLI::PositiveNumber);
  app.add_option("--position-weight", parameters.position_weight, "in squared spacings")
    ->check(CLI::PositiveNumber);

  return run_program(app, argc, argv, [&] {
    const std::vector<Point> points = read_positions(arguments.input);

    Oriented_points result;
    Measurement measurement;
    const double spacing =
      CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, number_of_spacing_neighbors);
    add_normals(points, measurement, result);
    const auto n = Eigen::Index(result.size());
    Rows positions(n, 3), normals(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto& [point, normal] = result[std::size_t(i)];
      positions.row(i) = to_eigen(point).transpose() / spacing;
      normals.row(i) << normal.x(), normal.y(), normal.z();
    }
    Pairs pairs;
    measurement.phase("neighbors",
                      [&] { pairs = neighbor_pairs(points, parameters.number_of_neighbors); });
    measurement.phase("normals", [&] { normals = denoised_normals(normals, pairs, parameters); });
    measurement.phase("positions", [&] {
      positions = denoised_positions(positions, normals, pairs, parameters);
    });
    measurement.phase("edges",
                      [&] { positions = points_on_edges(positions, normals, pairs, parameters); });
    for (Eigen::Index i = 0; i < n; ++i)
      result[std::size_t(i)] = {to_cgal(spacing * positions.row(i).transpose()),
                                Vector(normals(i, 0), normals(i, 1), normals(i, 2))};
    keep_random_subset(result, arguments.number_of_output_points, seed);
    const Json measured = measurement.result();

    write_oriented_points(arguments.output, result);
    print_result("baseline_lod", arguments, points.size(), result.size(),
                 {{"normal_weight", parameters.normal_weight},
                  {"position_weight", parameters.position_weight}},
                 measured);
  });
}
