// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "point_spacing.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace l0_tool {
namespace {

std::vector<Point> every_nth(const std::vector<Point>& points, std::size_t step)
{
  std::vector<Point> chosen;
  chosen.reserve(points.size() / step + 1);
  for (std::size_t i = 0; i < points.size(); i += step)
    chosen.push_back(points[i]);
  return chosen;
}

} // namespace

double point_spacing(const std::vector<Point>& points)
{
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;
  constexpr std::size_t searched = 100000, queries = 2000;
  constexpr unsigned neighbors = 6;
  if (points.size() < 2)
    return 0;

  const std::size_t step = (points.size() + searched - 1) / searched;
  const std::vector<Point> sample = every_nth(points, step);
  Search::Tree tree(sample.begin(), sample.end());
  std::vector<double> distances;
  for (const Point& query : every_nth(sample, (sample.size() + queries - 1) / queries)) {
    Search search(tree, query, neighbors + 1); // the query itself is found first
    double sum = 0;
    for (const auto& [point, squared_distance] : search)
      sum += std::sqrt(squared_distance);
    distances.push_back(sum / double((std::min)(std::size_t(neighbors), sample.size() - 1)));
  }
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  return distances[distances.size() / 2] / std::sqrt(double(step));
}

} // namespace l0_tool
