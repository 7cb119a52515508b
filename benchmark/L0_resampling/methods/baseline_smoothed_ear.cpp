// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What EAR of CGAL can do at its best on noisy points: unlike in baseline_ear, the whole input gets
// normals and is smoothed, before WLOP with uniform sampling makes it two thirds of the output.
// Then normals again and upsampling.

#include "baseline_steps.h"

#include <CGAL/bilateral_smooth_point_set.h>

namespace {

using namespace L0_benchmark;

struct Parameters
{
  double radius_in_spacings = default_radius; // of WLOP; spacings of the smoothed input
  double sharpness_angle = 30;                // degrees
  double edge_sensitivity = 1;                // in [0, 1]
  bool smooth_again = false;                  // also what WLOP returns
};

template <typename ConcurrencyTag>
void smooth_with_normals(Oriented_points& points, const Parameters& parameters, bool smooth)
{
  constexpr unsigned number_of_neighbors = 120; // this and the repetitions as in CGAL's example
  constexpr unsigned number_of_iterations = 3;
  estimate_normals<ConcurrencyTag>(points);
  orient_normals(points);
  for (unsigned i = 0; smooth && i < number_of_iterations; ++i)
    CGAL::bilateral_smooth_point_set<ConcurrencyTag>(points, number_of_neighbors,
                                                     point_and_normal_maps().sharpness_angle(
                                                       parameters.sharpness_angle));
}

template <typename ConcurrencyTag>
void run_pipeline(std::vector<Point>& points, std::size_t number_of_output_points,
                  const Parameters& parameters, Measurement& measurement, Oriented_points& result)
{
  measurement.phase("smooth input", [&] {
    Oriented_points smoothed;
    for (const Point& point : points)
      smoothed.emplace_back(point, CGAL::NULL_VECTOR);
    smooth_with_normals<ConcurrencyTag>(smoothed, parameters, true);
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = smoothed[i].first;
  });
  measurement.phase("wlop", [&] {
    wlop<ConcurrencyTag>(points, 2 * number_of_output_points / 3, parameters.radius_in_spacings,
                         true, result);
  });
  measurement.phase("normals", [&] {
    smooth_with_normals<ConcurrencyTag>(result, parameters, parameters.smooth_again);
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
  CLI::App& app = command_line("CGAL's functions joined to edge-aware resampling, smoothing first");
  arguments.add_to(app);
  app
    .add_option("--radius-in-spacings", parameters.radius_in_spacings,
                "neighbor_radius of WLOP; without it CGAL's default, 8")
    ->check(CLI::PositiveNumber);
  app.add_option("--sharpness-angle", parameters.sharpness_angle, "degrees")
    ->check(CLI::Range(0., 90.));
  app.add_option("--edge-sensitivity", parameters.edge_sensitivity)->check(CLI::Range(0., 1.));
  app.add_flag("--smooth-again", parameters.smooth_again, "also after WLOP");

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
    print_result("baseline_smoothed_ear", arguments, number_of_input_points, result.size(),
                 {{"radius_in_spacings", radius_to_json(parameters.radius_in_spacings)},
                  {"sharpness_angle", parameters.sharpness_angle},
                  {"edge_sensitivity", parameters.edge_sensitivity},
                  {"smooth_again", parameters.smooth_again}},
                 measured);
  });
}
