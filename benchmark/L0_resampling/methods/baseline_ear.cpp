// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The EAR pipeline of CGAL's manual: WLOP down to two thirds of the output, PCA normals oriented
// over a spanning tree, bilateral smoothing, edge-aware upsampling to the output. Every parameter
// that CGAL gives a default keeps it; bilateral smoothing has none for its neighbors and
// repetitions, so they are those of its example.

#include "baseline_steps.h"

#include <CGAL/bilateral_smooth_point_set.h>

namespace {

using namespace L0_benchmark;

constexpr unsigned number_of_smoothing_neighbors = 120;
constexpr unsigned number_of_smoothing_iterations = 3;

struct Parameters
{
  double radius_in_spacings = default_radius; // of WLOP
  double sharpness_angle = 30;                // degrees
  double edge_sensitivity = 1;                // in [0, 1]
};

template <typename ConcurrencyTag>
void run_pipeline(std::vector<Point>& points, std::size_t number_of_output_points,
                  const Parameters& parameters, Measurement& measurement, Oriented_points& result)
{
  measurement.phase("wlop", [&] {
    wlop<ConcurrencyTag>(points, 2 * number_of_output_points / 3, parameters.radius_in_spacings,
                         false, result);
  });
  measurement.phase("estimate normals", [&] { estimate_normals<ConcurrencyTag>(result); });
  measurement.phase("orient normals", [&] { orient_normals(result); });
  measurement.phase("smooth", [&] {
    for (unsigned i = 0; i < number_of_smoothing_iterations; ++i)
      CGAL::bilateral_smooth_point_set<ConcurrencyTag>(result, number_of_smoothing_neighbors,
                                                       point_and_normal_maps().sharpness_angle(
                                                         parameters.sharpness_angle));
  });
  measurement.phase("upsample", [&] {
    upsample<ConcurrencyTag>(number_of_output_points, parameters.sharpness_angle,
                             parameters.edge_sensitivity, result);
  });
}

} // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  Parameters parameters;
  CLI::App& app = command_line("CGAL's functions joined to edge-aware resampling");
  arguments.add_to(app);
  app
    .add_option("--radius-in-spacings", parameters.radius_in_spacings,
                "neighbor_radius of WLOP; without it CGAL's default, 8")
    ->check(CLI::PositiveNumber);
  app.add_option("--sharpness-angle", parameters.sharpness_angle, "degrees")
    ->check(CLI::Range(0., 90.));
  app.add_option("--edge-sensitivity", parameters.edge_sensitivity)->check(CLI::Range(0., 1.));

  return run_program(app, argc, argv, [&] {
    std::vector<Point> points = read_positions(arguments.input);
    const std::size_t number_of_input_points = points.size();

    Oriented_points result(arguments.number_of_output_points);
    Measurement measurement;
    with_concurrency_tag(arguments.number_of_threads, [&](auto tag) {
      run_pipeline<decltype(tag)>(points, arguments.number_of_output_points, parameters,
                                  measurement, result);
    });
    const Json measured = measurement.result();

    write_oriented_points(arguments.output, result);
    print_result("baseline_ear", arguments, number_of_input_points, result.size(),
                 {{"radius_in_spacings", radius_to_json(parameters.radius_in_spacings)},
                  {"sharpness_angle", parameters.sharpness_angle},
                  {"edge_sensitivity", parameters.edge_sensitivity},
                  {"smoothing_neighbors", number_of_smoothing_neighbors},
                  {"smoothing_iterations", number_of_smoothing_iterations}},
                 measured);
  });
}
