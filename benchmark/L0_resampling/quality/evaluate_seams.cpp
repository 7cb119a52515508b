// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the points of a result by tiles near the seams with the others, and prints one JSON
// object. Lengths are in spacings of the samples.

#include "../common/command_line.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Traits = CGAL::Search_traits_adapter<Point_set::Index, Point_set::Point_map,
                                           CGAL::Search_traits_3<Kernel>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

constexpr unsigned number_of_neighbors = 6;
constexpr double doubled = 0.3, gap = 1.6; // in spacings

/// What the samples of a region have around them.
struct Region
{
  std::vector<double> nearest, around; // distances: to the nearest sample, and the mean of six
  std::size_t number_of_opposed = 0;   // to the nearest sample
  double sum_of_angles = 0;            // to the normal of the nearest sample, without signs

  Json to_json() const
  {
    const double n = double(nearest.size());
    double sum = 0, sum_of_squares = 0;
    for (const double distance : around) {
      sum += distance;
      sum_of_squares += distance * distance;
    }
    const auto share = [&](const std::vector<double>& values, const auto& is_one) {
      return 100 * double(std::count_if(values.begin(), values.end(), is_one)) / n;
    };
    return {{"samples", nearest.size()},
            {"mean_distance", sum / n},
            {"variation", std::sqrt(sum_of_squares / n - sum * sum / n / n) / (sum / n)},
            {"doubled_percent", share(nearest, [](double d) { return d < doubled; })},
            {"gap_percent", share(around, [](double d) { return d > gap; })},
            {"angle", sum_of_angles / n},
            {"opposed_percent", 100 * double(number_of_opposed) / n}};
  }
};

/// How many tiles, grown by `width`, a point lies in.
std::size_t number_of_tiles_at(const Kernel::Point_3& p, const Json& tiles, double width)
{
  return std::size_t(std::count_if(tiles.begin(), tiles.end(), [&](const Json& tile) {
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] < tile["low"][std::size_t(axis)].get<double>() - width
          || p[axis] > tile["high"][std::size_t(axis)].get<double>() + width)
        return false;
    return true;
  }));
}

Json compare(const Point_set& samples, const Json& index)
{
  const double spacing = index["sample_spacing"], width = index["neighbor_radius"];
  Search::Tree tree(samples.begin(), samples.end(), Search::Tree::Splitter(),
                    Traits(samples.point_map()));
  Region seams, others;
  for (const Point_set::Index& i : samples) {
    const bool is_at_seam = number_of_tiles_at(samples.point(i), index["tiles"], width) > 1;
    Region& region = is_at_seam ? seams : others;
    Search search(tree, samples.point(i), number_of_neighbors + 1, 0, true,
                  CGAL::Distance_adapter<Point_set::Index, Point_set::Point_map,
                                         CGAL::Euclidean_distance<CGAL::Search_traits_3<Kernel>>>(
                    samples.point_map()));
    double sum = 0;
    bool is_first = true;
    for (const auto& [k, squared_distance] : search) {
      if (k == i)
        continue;
      const double distance = std::sqrt(squared_distance) / spacing;
      sum += distance;
      if (!is_first)
        continue;
      is_first = false;
      region.nearest.push_back(distance);
      const double cosine = samples.normal(i) * samples.normal(k);
      region.number_of_opposed += cosine < 0;
      region.sum_of_angles += std::acos((std::min)(1., std::abs(cosine))) * 180 / CGAL_PI;
    }
    region.around.push_back(sum / number_of_neighbors);
  }
  Json json = {{"elsewhere", others.to_json()}};
  if (!seams.nearest.empty())
    json["seams"] = seams.to_json();
  return json;
}

} // namespace

int main(int argc, char* argv[])
{
  CLI::App& app = L0_benchmark::command_line(
    "Compares samples within a radius of a seam of tiles with the others.");
  std::string result_path, index_path;
  app.add_option("result", result_path, "all points, with normals: PLY")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("index", index_path, "index.json of the run")
    ->required()
    ->check(CLI::ExistingFile);
  if (const std::optional<int> status = L0_benchmark::read_command_line(app, argc, argv))
    return *status;

  try {
    Point_set samples;
    if (!CGAL::IO::read_point_set(result_path, samples) || !samples.has_normal_map())
      throw std::runtime_error(result_path + ": cannot be read as points with normals");
    std::cout << compare(samples, Json::parse(std::ifstream(index_path))).dump(1) << "\n";
  } catch (const std::exception& error) {
    std::cerr << "evaluate_seams: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
