// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's simpler ways to fewer or cleaner points. Filters that keep the number of points get a
// random subset of their result. Normals are PCA normals oriented over a spanning tree, but for
// bilateral smoothing, which has its own.

#include "baseline_steps.h"
#include "subsampling.h"

#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/grid_simplify_point_set.h>
#include <CGAL/jet_smooth_point_set.h>

#include <map>

namespace {

using namespace L0_benchmark;

constexpr std::uint64_t seed = 1;

// As in CGAL's examples, but for the number of neighbors, which is an option
constexpr unsigned number_of_bilateral_iterations = 3;
constexpr double sharpness_angle = 25;

std::vector<Point> one_a_cell(std::vector<Point> points, double cell_size)
{
  points.erase(CGAL::grid_simplify_point_set(points, cell_size), points.end());
  return points;
}

/// The largest cells that leave enough points, of which a random few are then too many.
std::vector<Point> simplified_by_grid(const std::vector<Point>& points, std::size_t count,
                                      double spacing)
{
  double enough = 1e-3 * spacing, too_few = 100 * spacing;
  for (int i = 0; i < 30; ++i) {
    const double middle = std::sqrt(enough * too_few);
    (one_a_cell(points, middle).size() >= count ? enough : too_few) = middle;
  }
  std::vector<Point> result = one_a_cell(points, enough);
  keep_random_subset(result, count, seed);
  return result;
}

template <typename ConcurrencyTag>
void run_filter(const std::string& filter, unsigned number_of_neighbors, std::vector<Point>& points,
                std::size_t count, Measurement& measurement, Oriented_points& result)
{
  if (filter == "random")
    measurement.phase(filter, [&] { keep_random_subset(points, count, seed); });
  else if (filter == "grid")
    measurement.phase(filter, [&] {
      points = simplified_by_grid(
        points, count,
        CGAL::compute_average_spacing<ConcurrencyTag>(points, number_of_spacing_neighbors));
    });
  else if (filter == "jet")
    measurement.phase(filter, [&] {
      CGAL::jet_smooth_point_set<ConcurrencyTag>(points, number_of_neighbors);
    });

  add_normals(points, measurement, result);
  if (filter == "bilateral")
    measurement.phase(filter, [&] {
      for (unsigned i = 0; i < number_of_bilateral_iterations; ++i)
        CGAL::bilateral_smooth_point_set<ConcurrencyTag>(
          result, number_of_neighbors, point_and_normal_maps().sharpness_angle(sharpness_angle));
    });
  keep_random_subset(result, count, seed);
}

} // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  std::string filter;
  unsigned number_of_neighbors = 24;
  CLI::App& app = command_line(
    "CGAL's random and grid simplification, jet and bilateral smoothing");
  arguments.add_to(app);
  app.add_option("--filter", filter)
    ->required()
    ->check(CLI::IsMember({"random", "grid", "jet", "bilateral"}));
  app.add_option("--neighbors", number_of_neighbors, "of each point, for jet and bilateral")
    ->check(CLI::PositiveNumber);

  return run_program(app, argc, argv, [&] {
    std::vector<Point> points = read_positions(arguments.input);
    const std::size_t number_of_input_points = points.size();

    Oriented_points result;
    Measurement measurement;
    with_concurrency_tag(arguments.number_of_threads, [&](auto tag) {
      run_filter<decltype(tag)>(filter, number_of_neighbors, points,
                                arguments.number_of_output_points, measurement, result);
    });
    const Json measured = measurement.result();

    write_oriented_points(arguments.output, result);
    print_result("baseline_filter", arguments, number_of_input_points, result.size(),
                 {{"filter", filter}, {"neighbors", number_of_neighbors}}, measured);
  });
}
