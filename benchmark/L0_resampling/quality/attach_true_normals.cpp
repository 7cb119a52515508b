// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Gives points the normals of the surface that they were sampled from, and on request the places:
// what a method could know that estimates them without any error.

#include "../methods/method_program.h"
#include "Ground_truth.h"

int main(int argc, char** argv)
{
  using namespace L0_benchmark;

  std::string input, truth_path, output;
  bool moves = false;
  CLI::App& app = command_line("The normals of the nearest faces");
  app.add_option("input", input, "PLY file; only the positions are used")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("truth", truth_path, "Triangle mesh, OFF")->required()->check(CLI::ExistingFile);
  app.add_option("output", output, "binary PLY file of points with normals")->required();

  app.add_flag("--move-to-surface", moves, "moves each point to the nearest one of the truth");

  return run_program(app, argc, argv, [&] {
    const Ground_truth truth(read_triangle_mesh(truth_path));
    Oriented_points points;
    for (const Point& p : read_positions(input)) {
      const Vector normal = truth.nearest_normals(p).front();
      points.emplace_back(moves ? truth.nearest_point(p) : p,
                          normal / std::sqrt(normal.squared_length()));
    }
    write_oriented_points(output, points);
  });
}
