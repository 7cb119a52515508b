// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's WLOP, then PCA normals oriented over a spanning tree, so that its result can be compared
// with oriented points. Comparisons of speed take the phase "wlop" alone.

#include "baseline_steps.h"

int main(int argc, char** argv)
{
  using namespace L0_benchmark;

  Arguments arguments;
  double radius_in_spacings = default_radius;
  bool require_uniform_sampling = false;
  CLI::App& app = command_line("CGAL::wlop_simplify_and_regularize_point_set()");
  arguments.add_to(app);
  app
    .add_option("--radius-in-spacings", radius_in_spacings,
                "neighbor_radius; without it CGAL's default, 8")
    ->check(CLI::PositiveNumber);
  app.add_flag("--require-uniform-sampling", require_uniform_sampling);

  return run_program(app, argc, argv, [&] {
    std::vector<Point> points = read_positions(arguments.input);
    const std::size_t number_of_input_points = points.size();

    Oriented_points result(arguments.number_of_output_points);
    Measurement measurement;
    with_concurrency_tag(arguments.number_of_threads, [&](auto tag) {
      using Tag = decltype(tag);
      measurement.phase("wlop", [&] {
        wlop<Tag>(points, arguments.number_of_output_points, radius_in_spacings,
                  require_uniform_sampling, result);
      });
      measurement.phase("estimate normals", [&] { estimate_normals<Tag>(result); });
      measurement.phase("orient normals", [&] { orient_normals(result); });
    });
    const Json measured = measurement.result();

    write_oriented_points(arguments.output, result);
    print_result("baseline_wlop", arguments, number_of_input_points, result.size(),
                 {{"radius_in_spacings", radius_to_json(radius_in_spacings)},
                  {"require_uniform_sampling", require_uniform_sampling}},
                 measured);
  });
}
