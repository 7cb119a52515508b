// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_EDGE_BIAS_H
#define CGAL_L0_RESAMPLING_BENCHMARK_EDGE_BIAS_H

#include "Ground_truth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace L0_benchmark {

/// Errors of the points whose foot on the mesh is so far from the nearest sharp edge.
struct Edge_bias
{
  double lower; ///< least distance of this band, % of the diagonal, up to that of the next one
  std::size_t number_of_points = 0;
  double sum_of_signed_errors = 0; ///< % of the diagonal, outside is positive
  double sum_of_absolute_errors = 0;

  double mean_signed_error() const
  {
    return number_of_points > 0 ? sum_of_signed_errors / double(number_of_points) : 0;
  }
  double mean_absolute_error() const
  {
    return number_of_points > 0 ? sum_of_absolute_errors / double(number_of_points) : 0;
  }
};

/// By the kind of the nearest edge, since the errors at convex and at concave edges can cancel.
struct Edge_biases
{
  std::vector<Edge_bias> convex;
  std::vector<Edge_bias> concave;
};

struct Sharp_edges
{
  std::vector<Segment_3> convex;
  std::vector<Segment_3> concave;
};

/// \param angle the least angle between the normals of the triangles of a sharp edge, in degrees
inline Sharp_edges classify_edges(const Triangle_mesh& mesh, double angle = 30)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> triangle_of_halfedge;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      triangle_of_halfedge[{mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]}] = t;

  Sharp_edges edges;
  for (const auto& [halfedge, t] : triangle_of_halfedge) {
    const auto [source, target] = halfedge;
    const auto opposite = triangle_of_halfedge.find({target, source});
    if (source > target || opposite == triangle_of_halfedge.end())
      continue;
    const Vector_3 left = area_normal(mesh.triangle(t));
    const Vector_3 right = area_normal(mesh.triangle(opposite->second));
    if (!(angle_in_degrees(left, right) >= angle))
      continue;
    const Vector_3 along = mesh.vertices[target] - mesh.vertices[source];
    const bool is_convex = CGAL::cross_product(right, left) * along < 0;
    std::vector<Segment_3>& same_kind = is_convex ? edges.convex : edges.concave;
    same_kind.emplace_back(mesh.vertices[source], mesh.vertices[target]);
  }
  return edges;
}

/// \param mesh closed
/// \throws std::invalid_argument if the mesh has no sharp edge
inline Edge_biases measure_edge_bias(const std::vector<Point_3>& points, const Triangle_mesh& mesh)
{
  const Sharp_edges edges = classify_edges(mesh);
  if (edges.convex.empty() && edges.concave.empty())
    throw std::invalid_argument("the mesh has no sharp edge");
  const Segment_tree convex(edges.convex.begin(), edges.convex.end());
  const Segment_tree concave(edges.concave.begin(), edges.concave.end());
  const Ground_truth truth(mesh);
  const double percent = truth.diagonal() / 100;
  const auto distance = [percent](const Segment_tree& tree, const Point_3& p) {
    if (tree.empty())
      return std::numeric_limits<double>::infinity();
    return std::sqrt(tree.squared_distance(p)) / percent;
  };

  Edge_biases biases;
  for (double lower : {0., 0.5, 1., 2., 4., 8.}) {
    biases.convex.push_back({lower});
    biases.concave.push_back({lower});
  }
  for (const Point_3& p : points) {
    const Point_3 foot = truth.nearest_point(p);
    // Where the foot lies on an edge, the sum of the normals there tells the side.
    Vector_3 outwards = CGAL::NULL_VECTOR;
    for (const Vector_3& normal : truth.nearest_normals(p))
      outwards += normal / std::sqrt(normal.squared_length());
    const double error = std::sqrt(CGAL::squared_distance(p, foot)) / percent;
    const double to_convex = distance(convex, foot), to_concave = distance(concave, foot);
    std::vector<Edge_bias>& bands = to_convex <= to_concave ? biases.convex : biases.concave;
    std::size_t band = bands.size() - 1;
    while ((std::min)(to_convex, to_concave) < bands[band].lower)
      --band;
    ++bands[band].number_of_points;
    bands[band].sum_of_signed_errors += (p - foot) * outwards < 0 ? -error : error;
    bands[band].sum_of_absolute_errors += error;
  }
  return biases;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_EDGE_BIAS_H
