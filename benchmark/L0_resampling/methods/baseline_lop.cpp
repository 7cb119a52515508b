// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// LOP, then PCA normals oriented over a spanning tree. With --kernel-density-share, LOP on fewer
// points, as in KLOP.

#include "baseline_steps.h"
#include "locally_optimal_projection.h"
#include "subsampling.h"

#include <CGAL/compute_average_spacing.h>

int main(int argc, char** argv)
{
  using namespace L0_benchmark;

  Arguments arguments;
  double radius_in_spacings = 8;
  double kernel_density_share = 100;
  constexpr double bandwidth_in_spacings =
    0.5; // of the kernel density estimate: half a spacing fills the gaps
  constexpr std::uint64_t seed = 1;
  CLI::App& app = command_line("Locally optimal projection");
  arguments.add_to(app);
  app.add_option("--radius-in-spacings", radius_in_spacings, "h, the radius of the kernel")
    ->check(CLI::PositiveNumber);
  app
    .add_option("--kernel-density-share", kernel_density_share,
                "% of the points, drawn from their kernel density estimate, that take part")
    ->check(CLI::Range(1., 100.));

  return run_program(app, argc, argv, [&] {
    std::vector<Point> points = read_positions(arguments.input);
    const std::size_t number_of_input_points = points.size();

    Oriented_points result;
    Measurement measurement;
    const double spacing =
      CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, number_of_spacing_neighbors);
    std::vector<Point> samples = points;
    keep_random_subset(samples, arguments.number_of_output_points, seed);
    if (kernel_density_share < 100)
      measurement.phase("draw from the density", [&] {
        const auto count = std::size_t(double(points.size()) * kernel_density_share / 100);
        points = draw_from_kernel_density(points, count, bandwidth_in_spacings * spacing, seed);
      });
    measurement.phase("project", [&] {
      Projection_parameters parameters;
      parameters.radius = radius_in_spacings * spacing;
      locally_optimal_projection(points, parameters, samples);
    });
    add_normals(samples, measurement, result);
    const Json measured = measurement.result();

    write_oriented_points(arguments.output, result);
    print_result("baseline_lop", arguments, number_of_input_points, result.size(),
                 {{"radius_in_spacings", radius_in_spacings},
                  {"kernel_density_share", kernel_density_share}},
                 measured);
  });
}
