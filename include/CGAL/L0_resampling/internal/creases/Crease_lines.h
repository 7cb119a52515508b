// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CREASE_LINES_H
#define CGAL_L0_RESAMPLING_INTERNAL_CREASE_LINES_H

#include <CGAL/L0_resampling/internal/creases/Crease_graph.h>
#include <CGAL/L0_resampling/internal/creases/Placed_creases.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// All lengths are in units of `spacing_of_creases()`, all angles in radians.

struct Crease_line
{
  std::vector<Crease_vertex> vertices;   ///< a spacing apart; without the corners at its ends
  std::size_t first_corner, last_corner; ///< or `Crease_graph::none`
  bool is_closed;                        ///< the first vertex follows the last one
  bool is_convex;
  double confidence; ///< in [0, 1]
};

/// A corner.
struct Meeting_creases
{
  Vector position;
  std::vector<Vector> normals; ///< of the faces that meet there
};

struct Crease_lines
{
  std::vector<Crease_line> lines;
  std::vector<Meeting_creases> corners;
};

/// The curves of a graph that are long and sharp enough.
inline std::vector<std::vector<std::size_t>> creases_of(const Crease_graph& graph)
{
  const double minimum_mean_angle = 27 * double(EIGEN_PI) / 180, minimum_length = 6,
               minimum_length_between_corners = 0.5; // as short ones that end anywhere are spurs
  std::vector<std::vector<std::size_t>> curves = graph.curves();
  const auto is_none = [&](const std::vector<std::size_t>& curve) {
    double length = 0, sum_of_angles = 0;
    std::size_t number_of_nodes = 0;
    for (std::size_t k = 0; k < curve.size(); ++k)
    {
      if (k > 0)
        length += (graph.position(curve[k]) - graph.position(curve[k - 1])).norm();
      if (!graph.is_corner(curve[k]))
      {
        sum_of_angles += graph.node(curve[k]).angle;
        ++number_of_nodes;
      }
    }
    const bool is_between_corners = graph.is_corner(curve.front()) && graph.is_corner(curve.back());
    return length <= (is_between_corners ? minimum_length_between_corners : minimum_length)
           || sum_of_angles < minimum_mean_angle * double(number_of_nodes);
  };
  curves.erase(std::remove_if(curves.begin(), curves.end(), is_none), curves.end());
  return curves;
}

/// A curve of a graph as a line whose vertices are as far apart as samples are.
class Crease_line_of_curve
{
  struct Place
  {
    Vector position, tangent;
    const Crease_point* node; // the nearest one
  };

  std::vector<Place> m_places;
  std::vector<double> m_lengths; // up to each place
  bool m_is_closed;
  bool m_starts_at_corner, m_ends_at_corner;

public:
  Crease_line_of_curve(const Crease_graph& graph, const std::vector<std::size_t>& curve)
    : m_is_closed(curve.front() == curve.back() && !graph.is_corner(curve.front())),
      m_starts_at_corner(graph.is_corner(curve.front())),
      m_ends_at_corner(graph.is_corner(curve.back()))
  {
    const std::size_t last = curve.size() - 1;
    for (std::size_t k = 0; k <= last; ++k)
    {
      const bool is_corner = graph.is_corner(curve[k]);
      const Vector before = graph.position(curve[k > 0         ? k - 1
                                                 : m_is_closed ? last - 1
                                                               : 0]),
                   after = graph.position(curve[k < last      ? k + 1
                                                : m_is_closed ? 1
                                                              : last]);
      Vector tangent = (after - before).normalized();
      if (!is_corner)
      {
        const Vector& of_node = graph.node(curve[k]).tangent;
        tangent = of_node.dot(tangent) < 0 ? Vector(-of_node) : of_node;
      }
      m_places.push_back({graph.position(curve[k]), tangent,
                          &graph.node(!is_corner ? curve[k]
                                      : k == 0   ? curve[1]
                                                 : curve[k - 1])});
      m_lengths.push_back(
        k == 0 ? 0 : m_lengths.back() + (m_places[k].position - m_places[k - 1].position).norm());
    }
  }

  Crease_line operator()(std::size_t first_corner, std::size_t last_corner) const
  {
    Crease_line line{
      {}, first_corner, last_corner, m_is_closed, m_places[0].node->is_convex, confidence()};
    const std::size_t minimum_number_of_steps = m_is_closed ? 3
                                                            : 2, // with a vertex between corners
      number_of_steps = (std::max)(std::size_t(m_lengths.back() + 0.5), minimum_number_of_steps);
    const std::size_t begin = m_starts_at_corner ? 1 : 0,
                      end = number_of_steps + (m_is_closed || m_ends_at_corner ? 0 : 1);
    for (std::size_t step = begin; step < end; ++step)
      line.vertices.push_back(vertex_at(m_lengths.back() * double(step) / double(number_of_steps)));
    return line;
  }

private:
  Crease_vertex vertex_at(double length) const
  {
    const std::size_t k =
      (std::min)(std::size_t((std::max)(std::upper_bound(m_lengths.begin(), m_lengths.end(), length)
                                          - m_lengths.begin() - 1,
                                        std::ptrdiff_t(0))),
                 m_places.size() - 2);
    const Place &a = m_places[k], &b = m_places[k + 1];
    const double step = m_lengths[k + 1] - m_lengths[k], t = (length - m_lengths[k]) / step,
                 u = 1 - t;
    // Hermite's cubic
    const Vector position = u * u * (1 + 2 * t) * a.position + t * t * (1 + 2 * u) * b.position
                            + step * t * u * (u * a.tangent - t * b.tangent),
                 tangent = (u * a.tangent + t * b.tangent).normalized();
    const Crease_point& node = t < 0.5 ? *a.node : *b.node;
    Crease_vertex vertex{position, tangent, node.normals, node.angle};
    if (!is_left(node, 0, tangent))
      std::swap(vertex.normals[0], vertex.normals[1]);
    return vertex;
  }

  /// Whether a face is to the left of the crease, seen from outside.
  static bool is_left(const Crease_point& node, std::size_t face, const Vector& tangent)
  {
    const Vector outwards = node.normals[0] + node.normals[1], left = outwards.cross(tangent);
    return (node.normals[1 - face].dot(left) < 0) == node.is_convex;
  }

  /// The mean of the nodes, where they are no farther apart than neighbors are.
  double confidence() const
  {
    const double longest_step = 2.2;
    double sum = 0;
    for (std::size_t k = 1; k < m_places.size(); ++k)
    {
      const double step = m_lengths[k] - m_lengths[k - 1];
      if (step <= longest_step)
        sum += step * (m_places[k - 1].node->confidence + m_places[k].node->confidence) / 2;
    }
    return sum / m_lengths.back();
  }
};

/// The creases and corners of a graph of crease points.
inline Crease_lines make_crease_lines(const Crease_graph& graph,
                                      const std::vector<std::vector<std::size_t>>& curves)
{
  const double cosine_of_one_face = 0.9;
  Crease_lines made;
  std::vector<std::size_t> number_of_lines(graph.number_of_corners(), 0),
    number_of(graph.number_of_corners(), Crease_graph::none);
  for (const std::vector<std::size_t>& curve : curves)
    for (std::size_t end : {curve.front(), curve.back()})
      if (graph.is_corner(end))
        ++number_of_lines[end - graph.number_of_nodes()];
  for (std::size_t q = 0; q < number_of.size(); ++q)
    if (number_of_lines[q] > 1)
    {
      number_of[q] = made.corners.size();
      made.corners.push_back({graph.position(graph.number_of_nodes() + q), {}});
    }
  const auto corner_at = [&](std::size_t place) {
    return graph.is_corner(place) ? number_of[place - graph.number_of_nodes()] : Crease_graph::none;
  };
  const auto add_normals = [&](std::size_t corner, std::size_t node) {
    if (corner == Crease_graph::none || graph.is_corner(node))
      return;
    std::vector<Vector>& normals = made.corners[corner].normals;
    for (const Vector& normal : graph.node(node).normals)
      if (std::none_of(normals.begin(), normals.end(),
                       [&](const Vector& other) { return other.dot(normal) > cosine_of_one_face; }))
        normals.push_back(normal);
  };
  for (const std::vector<std::size_t>& curve : curves)
  {
    const std::size_t first = corner_at(curve.front()), last = corner_at(curve.back());
    made.lines.push_back(Crease_line_of_curve(graph, curve)(first, last));
    // the second place of a curve, as the faces at the first are those of a round corner
    const std::size_t step = curve.size() > 3 ? 2 : 1;
    add_normals(first, curve[step]);
    add_normals(last, curve[curve.size() - 1 - step]);
  }
  return made;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CREASE_LINES_H
