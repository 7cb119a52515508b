// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Imitates a scan: samples a triangle mesh with noise, outliers and uneven density.

#include "command_line.h"
#include "sample_mesh.h"

#include <exception>
#include <iostream>
#include <optional>
#include <string>

int main(int argc, char* argv[])
{
  CLI::App& app = L0_benchmark::command_line(
    "Samples a triangle mesh uniformly by area, as a scanner with known errors would.");
  std::string mesh_path, points_path;
  L0_benchmark::Sampling sampling;
  app.add_option("mesh", mesh_path, "Triangle mesh, OFF")->required()->check(CLI::ExistingFile);
  app.add_option("output", points_path, "Point set to write, binary PLY")->required();
  app.add_option("--points", sampling.number_of_points, "Number of points, outliers included")
    ->capture_default_str();
  app
    .add_option("--noise", sampling.noise,
                "Standard deviation of each coordinate, % of the bounding box's diagonal")
    ->capture_default_str();
  app.add_option("--outliers", sampling.outliers, "Share of outliers, %, in the box grown by 10 %")
    ->capture_default_str();
  app
    .add_option("--density-gradient", sampling.density_gradient,
                "Ratio of densities at the ends of the longest axis")
    ->capture_default_str();
  app.add_option("--seed", sampling.seed, "Same seed, same points")->capture_default_str();
  if (const std::optional<int> status = L0_benchmark::read_command_line(app, argc, argv))
    return *status;

  try {
    const L0_benchmark::Triangle_mesh mesh = L0_benchmark::read_triangle_mesh(mesh_path);
    L0_benchmark::write_points(points_path, L0_benchmark::sample_mesh(mesh, sampling));
  } catch (const std::exception& error) {
    std::cerr << "sample_mesh: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
