// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL::remove_outliers() of a known share, so that baselines without a step of their own can be
// compared on points with outliers.

#include "../methods/method_program.h"

#include <CGAL/IO/write_ply_points.h>
#include <CGAL/remove_outliers.h>

#include <stdexcept>

int main(int argc, char** argv)
{
  using namespace L0_benchmark;

  std::string input, output;
  double percent = 0;
  constexpr unsigned number_of_neighbors = 24; // as in CGAL's example
  CLI::App& app = command_line("CGAL::remove_outliers()");
  app.add_option("input", input, "PLY file; only the positions are used")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("output", output, "binary PLY file of points")->required();
  app.add_option("--percent", percent, "share of the points to remove")
    ->required()
    ->check(CLI::Range(0., 100.));

  return run_program(app, argc, argv, [&] {
    std::vector<Point> points = read_positions(input);
    points.erase(CGAL::remove_outliers<CGAL::Sequential_tag>(
                   points, number_of_neighbors,
                   CGAL::parameters::threshold_percent(percent).threshold_distance(0)),
                 points.end());
    if (!CGAL::IO::write_PLY(output, points))
      throw std::runtime_error(output + ": cannot be written");
  });
}
