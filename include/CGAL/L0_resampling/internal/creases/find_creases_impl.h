// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_IMPL_H

#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/core/precedes.h>
#include <CGAL/L0_resampling/internal/creases/Curves_at_corner.h>
#include <CGAL/L0_resampling/internal/creases/find_creases.h>
#include <CGAL/L0_resampling/internal/creases/place_on_creases.h>
#include <CGAL/L0_resampling/internal/creases/see_creases.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Creases and corners as all samples see them, in one frame.
struct Points_on_creases
{
  std::vector<Crease_point> points;
  std::vector<Corner_point> corners;
};

/// \param frame out; like the order, it depends on the places of the samples only
inline Points_on_creases points_in_one_frame(Seen_creases seen, Crease_frame& frame)
{
  Points_on_creases all;
  if (seen.points.empty())
    return all;
  frame.origin = seen.points.front().sample;
  for (const auto& point : seen.points)
    frame.origin = frame.origin.cwiseMin(point.sample);
  const auto take = [&](auto& of_samples, auto& points) {
    std::stable_sort(of_samples.begin(), of_samples.end(),
                     [](const auto& a, const auto& b) { return precedes(a.sample, b.sample); });
    for (auto& seen_there : of_samples)
    {
      seen_there.point.position += frame.enter(seen_there.sample);
      points.push_back(seen_there.point);
    }
  };
  take(seen.points, all.points);
  take(seen.corners, all.corners);
  return all;
}

/// Joins crease points to lines, and finds the corners that they meet at.
template <typename ConcurrencyTag>
Crease_lines join_crease_points(const Points_on_creases& found)
{
  const Crease_thinning thinning(ConcurrencyTag(), found.points);
  const auto graph_with = [&](const std::vector<Corner_of_creases>& corners) {
    Crease_graph graph(thinning.nodes(corners), corners);
    graph.link(2.2, 0.8);
    return graph;
  };
  std::vector<Corner_point> corner_points = found.corners;
  for (const Corner_point& corner : graph_with({}).corners_of_ends())
    corner_points.push_back(corner);
  const auto closed_graph_with = [&](const std::vector<Corner_of_creases>& corners) {
    Crease_graph graph = graph_with(corners);
    graph.link(4.5, 0.9); // gaps, the longer the straighter
    graph.link(8, 0.965);
    return graph;
  };
  const Crease_graph graph_of_all = closed_graph_with(find_corners(corner_points));
  const Crease_graph graph = closed_graph_with(corners_of(graph_of_all, creases_of(graph_of_all)));
  return make_crease_lines(graph, creases_of(graph));
}

template <typename ConcurrencyTag, typename FT>
Placed_creases find_creases(double spacing, Progress& progress, Buffer<Vector>& positions,
                            Buffer<Eigen::Matrix<FT, 3, 1>>& normals)
{
  if (positions.empty() || !(spacing > 0))
    return {};
  Seen_creases seen;
  see_creases<ConcurrencyTag>(positions, normals, positions.size(), spacing, progress, seen);
  Crease_frame frame{Vector::Zero(), spacing};
  const Crease_lines lines = join_crease_points<ConcurrencyTag>(
    points_in_one_frame(std::move(seen), frame));
  Samples_beside_creases beside(lines, frame);
  for_each_in_order(positions.size(), [&](std::size_t i) {
    beside.add(i, positions[i], normals[i].template cast<double>());
  });
  Placed_creases placed = std::move(beside).place();
  for (const Sample_beside_crease& sample : placed.moved)
  {
    positions[sample.number] = sample.position;
    normals[sample.number] = sample.normal.template cast<FT>();
  }
  return placed;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_IMPL_H
