// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The pipeline of CGAL's manual that ends with EAR: WLOP, normals, bilateral smoothing, edge-aware
// upsampling. On noisy points EAR can do better where the whole input gets normals and is smoothed
// first, and WLOP spreads its points evenly.

#include "baseline_steps.h"

#include <CGAL/bilateral_smooth_point_set.h>

#include <string>

namespace {

using namespace L0_benchmark;

constexpr unsigned number_of_smoothing_neighbors = 120; // this and the repetitions as in CGAL's
constexpr unsigned number_of_smoothing_iterations = 3;  // example

struct Parameters
{
  double radius_in_spacings = default_radius; // of WLOP; spacings of what it gets
  double sharpness_angle = 30;                // degrees
  double edge_sensitivity = 1;                // in [0, 1]
  std::string smoothing = "after";            // WLOP: see the option
};

template <typename ConcurrencyTag>
void smooth(Oriented_points& points, double sharpness_angle)
{
  for (unsigned i = 0; i < number_of_smoothing_iterations; ++i)
    CGAL::bilateral_smooth_point_set<ConcurrencyTag>(points, number_of_smoothing_neighbors,
                                                     point_and_normal_maps().sharpness_angle(
                                                       sharpness_angle));
}

template <typename ConcurrencyTag>
void run_pipeline(std::vector<Point>& points, std::size_t number_of_output_points,
                  const Parameters& parameters, Measurement& measurement, Oriented_points& result)
{
  const bool smooths_first = parameters.smoothing != "after";
  if (smooths_first)
    measurement.phase("smooth input", [&] {
      Oriented_points smoothed;
      for (const Point& point : points)
        smoothed.emplace_back(point, CGAL::NULL_VECTOR);
      estimate_normals<ConcurrencyTag>(smoothed);
      orient_normals(smoothed);
      smooth<ConcurrencyTag>(smoothed, parameters.sharpness_angle);
      for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = smoothed[i].first;
    });
  measurement.phase("wlop", [&] {
    wlop<ConcurrencyTag>(points, 2 * number_of_output_points / 3, parameters.radius_in_spacings,
                         smooths_first, result);
  });
  measurement.phase("estimate normals", [&] { estimate_normals<ConcurrencyTag>(result); });
  measurement.phase("orient normals", [&] { orient_normals(result); });
  if (parameters.smoothing != "first")
    measurement.phase("smooth",
                      [&] { smooth<ConcurrencyTag>(result, parameters.sharpness_angle); });
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
  app
    .add_option(
      "--smoothing", parameters.smoothing,
      "after WLOP, as CGAL's example; first, of the input; or both. With the last two WLOP "
      "requires uniform sampling")
    ->check(CLI::IsMember({"after", "first", "both"}));

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
                  {"smoothing", parameters.smoothing},
                  {"smoothing_neighbors", number_of_smoothing_neighbors},
                  {"smoothing_iterations", number_of_smoothing_iterations}},
                 measured);
  });
}
