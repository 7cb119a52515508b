// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_H

#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/creases/place_on_creases.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <mutex>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Creases and corners as all samples see them, in the order of the samples.
struct Points_on_creases
{
  std::vector<Crease_point> points;
  std::vector<Corner_point> corners;
};

/// Calls `f(k)` for each candidate nearer than `radius`.
template <typename F>
void for_each_in_ball(Local_points<Local>& candidates, const Local_vector& center, double radius,
                      const F& f)
{
  const Local squared_radius = Local(radius * radius);
  candidates.for_each_run_in_ball(
    center, squared_radius, [&](std::size_t first, const Lanes<Local>& distances) {
      Local squared_distances[Lanes<Local>::size];
      distances.store(squared_distances);
      for (std::size_t lane = 0; lane < std::size_t(Lanes<Local>::size); ++lane)
        if (squared_distances[lane] < squared_radius)
          f(candidates.indices[first + lane]);
    });
}

/// \param frame_origin, spacing the frame and the unit of what is found
template <typename ConcurrencyTag, typename FT>
Points_on_creases find_crease_points(const Buffer<Vector>& positions,
                                     const Buffer<Eigen::Matrix<FT, 3, 1>>& normals,
                                     const Vector& frame_origin, double spacing, Progress& progress)
{
  const double reach = reach_of_crease_point * spacing;
  const Sorted_queries sorted(ConcurrencyTag(), positions, Cell_sizes(reach));
  const Buffer<Eigen::Matrix<FT, 3, 1>> sorted_normals =
    values_in_order<ConcurrencyTag>(sorted.order, normals);
  const double cosine_of_other = std::cos(least_crease_angle);

  std::mutex mutex;
  std::vector<std::pair<Index, Crease_point>> points;
  std::vector<std::pair<Index, Corner_point>> corners;
  const auto make_visitor = [&]() {
    return
      [&, around = std::vector<Oriented_sample>(),
       creases = Creases_of_sample()](Search_grid_3::Range queries, Local_points<Local>& candidates,
                                      const Vector& origin) mutable {
        const auto sample_at = [&](Index k) {
          return Oriented_sample{(sorted.points[k] - origin) / spacing,
                                 sorted_normals[k].template cast<double>()};
        };
        for (Index q = queries.first; q < queries.second; ++q)
        {
          const Local_vector center = (sorted.points[q] - origin).template cast<Local>();
          bool is_beside_other = false;
          for_each_in_ball(candidates, center, reach_of_crease * spacing, [&](Index k) {
            is_beside_other |= double(sorted_normals[k].dot(sorted_normals[q])) < cosine_of_other;
          });
          if (!is_beside_other)
            continue;
          around.clear();
          for_each_in_ball(candidates, center, reach,
                           [&](Index k) { around.push_back(sample_at(k)); });
          creases.find(sample_at(q), around);

          const std::lock_guard<std::mutex> lock(mutex);
          const auto add = [&](const auto& found, auto& all) {
            for (auto point : found)
            {
              point.position += (origin - frame_origin) / spacing;
              all.push_back({sorted.order[q], point});
            }
          };
          add(creases.points(), points);
          add(creases.corners(), corners);
        }
      };
  };
  for_each_cell<Local, ConcurrencyTag>(sorted.grid, sorted.points, sorted.grid, sorted.points, 1,
                                       progress, make_visitor);

  const auto in_order = [](auto& found, auto& values) {
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& value : found)
      values.push_back(value.second);
  };
  Points_on_creases all;
  in_order(points, all.points);
  in_order(corners, all.corners);
  return all;
}

/// Joins crease points to lines, and finds the corners that they meet at.
inline Crease_lines join_crease_points(const Points_on_creases& found)
{
  const Crease_thinning thinning(found.points);
  const auto graph_with = [&](const std::vector<Vector>& corners) {
    Crease_graph graph(thinning.nodes(corners), corners);
    graph.link(2.2, 0.8);
    return graph;
  };
  std::vector<Corner_point> corner_points = found.corners;
  for (const Corner_point& corner : graph_with({}).corners_of_ends())
    corner_points.push_back(corner);
  const auto closed_graph_with = [&](const std::vector<Vector>& corners) {
    Crease_graph graph = graph_with(corners);
    graph.link(4.5, 0.9); // gaps, the longer the straighter
    graph.link(8, 0.965);
    return graph;
  };
  const Crease_graph graph_of_all = closed_graph_with(find_corners(corner_points));
  const Crease_graph graph = closed_graph_with(corners_of(graph_of_all, creases_of(graph_of_all)));
  return make_crease_lines(graph, creases_of(graph));
}

/*!
Finds the creases and corners of samples, and puts some of the samples on them.

\param spacing of the samples, which is the same everywhere
\param normals unit vectors, all outwards
*/
template <typename ConcurrencyTag, typename FT>
Placed_creases find_creases(double spacing, Progress& progress, Buffer<Vector>& positions,
                            Buffer<Eigen::Matrix<FT, 3, 1>>& normals)
{
  if (positions.empty() || !(spacing > 0))
    return {};
  const Vector origin = positions.front();
  return place_on_creases(join_crease_points(find_crease_points<ConcurrencyTag>(
                            positions, normals, origin, spacing, progress)),
                          origin, spacing, positions, normals);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_H
