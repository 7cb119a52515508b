// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far a result moves when nothing changes but roundings: the coordinates are scaled by numbers
// that differ from 1 by about 1e-9, or the CUDA device computes it. Prints a JSON list, an object
// for each comparison; lengths are in radii.

#include "../methods/method_program.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/l0_resample_point_set.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <map>

namespace {

using namespace L0_benchmark;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;
using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;

const std::map<std::string, Method> methods = {
  {"default", Method::DEFAULT}, {"lor", Method::LOR}, {"alor", Method::ALOR}};

/// What is added to 1 for x, y and z, in 1e-9: unequal, so that distances do not all grow alike.
const std::vector<std::array<double, 3>> scalings = {
  {1, 0.7, -0.4}, {-1, -0.7, 0.4}, {-0.3, 1.1, 0.6}, {0.5, -0.8, 1.3}};

/// Bound of the Hausdorff distance between the results of CPU and device.
constexpr double far = 0.05;

template <typename ConcurrencyTag>
std::vector<Point> resample(const std::vector<Point>& points, std::size_t number_of_output_points,
                            Method method, Report& report)
{
  Oriented_points result;
  CGAL::l0_resample_point_set<ConcurrencyTag>(
    points, std::back_inserter(result),
    CGAL::parameters::number_of_output_points(number_of_output_points)
      | CGAL::parameters::resampling_method(method) | CGAL::parameters::resampling_report(&report));
  std::vector<Point> positions;
  for (const Oriented_point& point : result)
    positions.push_back(point.first);
  return positions;
}

/// Of each point of `from` to the nearest of `to`, in radii.
std::vector<double> nearest_distances(const std::vector<Point>& from, const std::vector<Point>& to,
                                      double radius)
{
  const Search::Tree tree(to.begin(), to.end());
  std::vector<double> distances;
  for (const Point& p : from)
    distances.push_back(std::sqrt(Search(tree, p, 1).begin()->second) / radius);
  return distances;
}

Json compare(const std::vector<Point>& result, const std::vector<Point>& other, double radius)
{
  std::vector<double> distances = nearest_distances(result, other, radius);
  const std::vector<double> back = nearest_distances(other, result, radius);
  std::sort(distances.begin(), distances.end());
  const std::size_t n = distances.size();
  return {{"median", distances[n / 2]},
          {"largest_but_a_thousandth", distances[n - 1 - n / 1000]},
          {"hausdorff", (std::max)(distances.back(), *std::max_element(back.begin(), back.end()))},
          {"number_far",
           std::count_if(distances.begin(), distances.end(), [](double d) { return d > far; })}};
}

} // namespace

int main(int argc, char** argv)
{
  std::string input, method = "default";
  std::size_t number_of_output_points = 0;
  bool on_device = false;
  CLI::App& app = command_line("How far a result moves when nothing changes but roundings");
  app.add_option("input", input, "PLY file; only the positions are used")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("--points", number_of_output_points, "number of output points")
    ->required()
    ->check(CLI::PositiveNumber);
  app.add_option("--method", method)->check(CLI::IsMember(methods))->capture_default_str();
#ifdef CGAL_L0_LINKED_WITH_CUDA
  app.add_flag("--device", on_device,
               "compare with the result of the CUDA device, not with those of scaled coordinates");
#endif

  return run_program(app, argc, argv, [&] {
    const std::vector<Point> points = read_positions(input);
    Report report, other_report;
    const auto resample_with = [&](auto tag, const std::vector<Point>& from, Report& its_report) {
      return resample<decltype(tag)>(from, number_of_output_points, methods.at(method), its_report);
    };
    const CGAL::Parallel_if_available_tag on_cpu;
    const std::vector<Point> result = resample_with(on_cpu, points, report);
    Json comparisons = Json::array();
    const auto compare_with = [&](const std::vector<Point>& other) {
      comparisons.push_back(compare(result, other, report.neighbor_radius));
    };
#ifdef CGAL_L0_LINKED_WITH_CUDA
    if (on_device)
      compare_with(resample_with(CGAL::CUDA_tag(), points, other_report));
#endif
    if (!on_device)
      for (const std::array<double, 3>& scaling : scalings) {
        std::vector<Point> scaled;
        for (const Point& p : points)
          scaled.emplace_back(p.x() * (1 + 1e-9 * scaling[0]), p.y() * (1 + 1e-9 * scaling[1]),
                              p.z() * (1 + 1e-9 * scaling[2]));
        compare_with(resample_with(on_cpu, scaled, other_report));
      }
    std::cout << comparisons.dump() << std::endl;
  });
}
