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

using Point_of = std::function<const Point&(std::size_t)>;

std::vector<Point> every_nth(std::size_t size, const Point_of& point, std::size_t step)
{
  std::vector<Point> chosen;
  chosen.reserve(size / step + 1);
  for (std::size_t i = 0; i < size; i += step)
    chosen.push_back(point(i));
  return chosen;
}

Point_of elements_of(const std::vector<Point>& points)
{
  return [&](std::size_t i) -> const Point& { return points[i]; };
}

} // namespace

double point_spacing(const std::vector<Point>& points)
{
  return point_spacing(points.size(), elements_of(points));
}

double point_spacing(std::size_t size, const Point_of& point)
{
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;
  constexpr std::size_t searched = 100000, queries = 2000;
  constexpr unsigned neighbors = 6;
  if (size < 2)
    return 0;

  const std::size_t step = (size + searched - 1) / searched;
  const std::vector<Point> sample = every_nth(size, point, step);
  Search::Tree tree(sample.begin(), sample.end());
  std::vector<double> distances;
  const std::size_t query_step = (sample.size() + queries - 1) / queries;
  for (const Point& query : every_nth(sample.size(), elements_of(sample), query_step)) {
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
