// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CLOP, then PCA normals oriented over a spanning tree.

#include "baseline_steps.h"
#include "continuous_projection.h"
#include "subsampling.h"

#include <CGAL/compute_average_spacing.h>

int main(int argc, char** argv)
{
  using namespace L0_benchmark;

  Arguments arguments;
  double radius_in_spacings = 8;
  double reach = 2.3;
  unsigned number_of_levels = 3;
  constexpr double floor_in_spacings = 0.05; // flat enough for any surface
  constexpr std::uint64_t seed = 1;
  CLI::App& app = command_line("Continuous locally optimal projection");
  arguments.add_to(app);
  app.add_option("--radius-in-spacings", radius_in_spacings, "h, the radius of the kernel")
    ->check(CLI::PositiveNumber);
  app.add_option("--reach", reach, "alpha of the hierarchical expectation maximization")
    ->check(CLI::PositiveNumber);
  app.add_option("--levels", number_of_levels, "each leaves about a third of the components");

  return run_program(app, argc, argv, [&] {
    const std::vector<Point> points = read_positions(arguments.input);

    Oriented_points result;
    Measurement measurement;
    const double spacing =
      CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, number_of_spacing_neighbors);
    std::vector<Point> samples = points;
    keep_random_subset(samples, arguments.number_of_output_points, seed);
    Gaussian_mixture mixture;
    measurement.phase("fit the mixture", [&] {
      Portable_random random(seed);
      mixture = gaussians_of_points(points, floor_in_spacings * spacing);
      for (unsigned level = 0; level < number_of_levels; ++level)
        mixture = reduced_mixture(mixture, reach, random);
    });
    measurement.phase("project", [&] {
      Projection_parameters parameters;
      parameters.radius = radius_in_spacings * spacing;
      parameters.repulsion_power = 0;
      continuous_projection(mixture, parameters, samples);
    });
    add_normals(samples, measurement, result);
    const Json measured = measurement.result();

    write_oriented_points(arguments.output, result);
    print_result("baseline_clop", arguments, points.size(), result.size(),
                 {{"radius_in_spacings", radius_in_spacings},
                  {"reach", reach},
                  {"levels", number_of_levels},
                  {"components", mixture.size()}},
                 measured);
  });
}
