// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/near_pairs.h>

#include <algorithm>
#include <set>
#include <utility>

using namespace test;

using Pair = std::pair<Index, Index>;

/// The pairs that a stage finds, each with the smaller index first.
std::vector<Pair> pairs_by_grid(const Gridded_points& points, double radius)
{
  const int reach = cells_in_reach(radius, points.grid.cell_size());
  std::vector<Pair> pairs;
  Unwatched unwatched;
  const auto make_visitor = [&]() {
    return [&](Search_grid_3::Range queries, Local_points<double>& candidates, const Vector&) {
      for (std::size_t i = 0; i < queries.second - queries.first; ++i)
      {
        CHECK(candidates.indices[i] == queries.first + i);
        const Vector center = candidates.take(i);
        for (std::size_t k = 0; k < candidates.indices.size(); ++k)
          if ((Vector(candidates.x[k], candidates.y[k], candidates.z[k]) - center).squaredNorm()
              < radius * radius)
            pairs.push_back(std::minmax(Index(queries.first + i), candidates.indices[k]));
      }
    };
  };
  for_each_cell_and_those_ahead<double, CGAL::Sequential_tag>(points.grid, points.points,
                                                              Tiles_of_rows(points.grid, reach),
                                                              reach, unwatched.progress,
                                                              make_visitor);
  return pairs;
}

/// Each pair that is close enough comes once, and no other.
void check_pairs(const std::vector<Vector>& points, double cell_size, double radius)
{
  const Gridded_points sorted(points, cell_size);
  std::vector<Pair> expected;
  const auto balls = brute_force_neighbors(sorted.vector, sorted.vector, radius);
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t k : balls[i])
      if (i < k)
        expected.emplace_back(Index(i), Index(k));
  std::vector<Pair> pairs = pairs_by_grid(sorted, radius);
  std::sort(pairs.begin(), pairs.end());
  CHECK(!expected.empty());
  CHECK(pairs == expected);
}

/// Tiles of one color, and what lies ahead of them, have no point in common; all rows are in one
/// tile each.
void check_colors(const std::vector<Vector>& points, double cell_size, int reach)
{
  const Gridded_points sorted(points, cell_size);
  const Tiles_of_rows tiles(sorted.grid, reach);
  std::vector<int> number_of_visits(sorted.grid.number_of_rows(), 0);
  std::size_t number_of_tiles = 0;
  bool are_apart = true;
  for (std::size_t color = 0; color < Tiles_of_rows::number_of_colors; ++color)
  {
    std::set<Index> taken;
    tiles.for_each_tile<CGAL::Sequential_tag>(color, [&](const Index* begin, const Index* end) {
      ++number_of_tiles;
      std::set<Index> touched;
      Search_grid_3::Block_cursor cursor(sorted.grid, reach, Search_grid_3::Block::AHEAD);
      std::vector<Search_grid_3::Range> ranges;
      for (const Index* row = begin; row != end; ++row)
      {
        ++number_of_visits[*row];
        for_each_cell_of_row(sorted.grid, *row, cursor, ranges,
                             [&](Index, const auto& around, std::size_t) {
                               for (const Search_grid_3::Range& range : around)
                                 for (Index k = range.first; k < range.second; ++k)
                                   touched.insert(k);
                             });
      }
      for (Index k : touched)
        are_apart = taken.insert(k).second && are_apart;
    });
  }
  CHECK(are_apart);
  CHECK(number_of_tiles > 4);
  CHECK(
    std::all_of(number_of_visits.begin(), number_of_visits.end(), [](int n) { return n == 1; }));
}

int main()
{
  Generator generator(3);
  std::vector<Vector> points = cube_points(600, 3, generator).points;
  add_gaussian_noise(points, 0.1, generator);
  for (const auto& [cell_size, radius] :
       {std::pair(0.5, 0.5), std::pair(0.5, 0.2), std::pair(0.3, 0.5), std::pair(0.2, 0.59)})
    check_pairs(points, cell_size, radius);
  check_pairs(std::vector<Vector>(40, Vector(1, 2, 3)), 0.5, 0.5); // all in one place
  for (int reach : {1, 2, 3})
    check_colors(points, 0.2, reach);
  return result();
}
