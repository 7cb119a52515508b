// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CREASE_GRAPH_H
#define CGAL_L0_RESAMPLING_INTERNAL_CREASE_GRAPH_H

#include <CGAL/L0_resampling/internal/creases/find_corners.h>
#include <CGAL/L0_resampling/internal/creases/thin_crease_points.h>

#include <cstddef>
#include <optional>
#include <tuple>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// All lengths are in units of `spacing_of_creases()`.

/*!
Joins crease points to curves. A node has two ports, one in the direction of its tangent and one
against it, and one link at each; a corner has any number. So what is connected is a chain or a
loop, and there are no branches to cut off.
*/
class Crease_graph
{
public:
  static constexpr std::size_t none = std::size_t(-1);

private:
  std::vector<Crease_point> m_nodes;
  std::vector<Vector> m_positions;                   // of the nodes, and after them of the corners
  std::vector<std::array<std::size_t, 2>> m_ports;   // of the nodes: what is linked there
  std::vector<std::vector<std::size_t>> m_neighbors; // of the corners

public:
  Crease_graph(std::vector<Crease_point> nodes, const std::vector<Corner_of_creases>& corners)
    : m_nodes(std::move(nodes)), m_ports(m_nodes.size(), {none, none}), m_neighbors(corners.size())
  {
    for (const Crease_point& node : m_nodes)
      m_positions.push_back(node.position);
    for (const Corner_of_creases& corner : corners)
      m_positions.push_back(corner.position);
  }

  const Crease_point& node(std::size_t i) const { return m_nodes[i]; }
  const Vector& position(std::size_t i) const { return m_positions[i]; }
  std::size_t number_of_nodes() const { return m_nodes.size(); }
  std::size_t number_of_corners() const { return m_neighbors.size(); }
  bool is_corner(std::size_t i) const { return i >= m_nodes.size(); }

  /// Links free ports to each other and to corners, the straightest and shortest links first.
  void link(double reach, double minimum_cosine)
  {
    std::vector<std::tuple<double, std::size_t, std::size_t>> links;
    const Nearby_points nearby(m_positions, reach);
    for (std::size_t a = 0; a < m_nodes.size(); ++a)
      nearby.for_each_near(m_positions[a], reach, [&](std::size_t b) {
        if (b <= a || !can_link(a, b))
          return;
        const Vector way = m_positions[b] - m_positions[a];
        const double length = way.norm(), cosine_a = std::abs(way.dot(m_nodes[a].tangent)) / length,
                     cosine_b = is_corner(b) ? 1 : std::abs(way.dot(m_nodes[b].tangent)) / length;
        if ((std::min)(cosine_a, cosine_b) >= minimum_cosine)
          links.push_back({length * (1 + 4 * (1 - cosine_a) + 4 * (1 - cosine_b)), a, b});
      });
    std::sort(links.begin(), links.end());
    for (const auto& [cost, a, b] : links)
      if (can_link(a, b))
      {
        port(a, b) = b;
        if (is_corner(b))
          m_neighbors[b - m_nodes.size()].push_back(a);
        else
          port(b, a) = a;
      }
  }

  /// Places, nodes and corners, in the order along each curve. A loop ends where it begins.
  std::vector<std::vector<std::size_t>> curves() const
  {
    std::vector<char> is_left(m_nodes.size(), 1);
    std::vector<std::vector<std::size_t>> curves;
    for (std::size_t q = 0; q < m_neighbors.size(); ++q)
      for (std::size_t i : m_neighbors[q])
        if (is_left[i])
          curves.push_back(curve_from(m_nodes.size() + q, i, is_left));
    for (std::size_t i = 0; i < m_nodes.size(); ++i)
      if (is_left[i] && (m_ports[i][0] == none || m_ports[i][1] == none))
        curves.push_back(curve_from(none, i, is_left));
    for (std::size_t i = 0; i < m_nodes.size(); ++i)
      if (is_left[i])
        curves.push_back(curve_from(m_ports[i][0], i, is_left));
    return curves;
  }

  /// Where ends of curves would meet each other, or the inside of another curve: as good as what a
  /// few samples say.
  std::vector<Corner_point> corners_of_ends() const
  {
    const double reach = 4.5, reach_back = 1.2, farthest_from_tangent = 0.6,
                 farthest_from_curve = 0.7, maximum_cosine = 0.82, weight_of_ends = 1.5;
    const std::size_t minimum_number_of_nodes = 3;
    std::vector<std::size_t> curve_of(m_nodes.size());
    std::vector<std::pair<std::size_t, Vector>> ends;
    std::vector<std::optional<Vector>> outward_of(m_nodes.size());
    std::size_t number = 0;
    for (const std::vector<std::size_t>& curve : curves())
    {
      for (std::size_t i : curve)
        if (!is_corner(i))
          curve_of[i] = number;
      ++number;
      if (curve.size() < minimum_number_of_nodes || curve.front() == curve.back())
        continue;
      for (std::size_t end : {curve.front(), curve.back()})
        if (!is_corner(end))
        {
          const std::array<std::size_t, 2>& ports = m_ports[end];
          const Vector inward = m_positions[ports[ports[0] == none ? 1 : 0]] - m_positions[end];
          const Vector& tangent = m_nodes[end].tangent;
          outward_of[end] = inward.dot(tangent) > 0 ? Vector(-tangent) : tangent;
          ends.push_back({end, *outward_of[end]});
        }
    }

    std::vector<Corner_point> corners;
    const Nearby_points nearby(m_positions, reach);
    const auto off_tangent = [&](std::size_t i, const Vector& p) {
      const Vector way = p - m_positions[i];
      return (way - way.dot(m_nodes[i].tangent) * m_nodes[i].tangent).norm();
    };
    for (const auto& [end, outward] : ends)
      nearby.for_each_near(
        m_positions[end], 1.6 * reach, [&, a = end, out = outward](std::size_t b) {
          if (is_corner(b) || b == a || (outward_of[b] && b < a)
              || std::abs(m_nodes[a].tangent.dot(m_nodes[b].tangent)) > maximum_cosine)
            return;
          const Vector meeting = nearest_to_tangents(a, b);
          const auto is_ahead = [&](std::size_t i, const Vector& direction) {
            const double ahead = (meeting - m_positions[i]).dot(direction);
            return -reach_back <= ahead && ahead <= reach;
          };
          if (!is_ahead(a, out) || off_tangent(a, meeting) > farthest_from_tangent
              || off_tangent(b, meeting) > farthest_from_tangent)
            return;
          if (outward_of[b])
          {
            if (is_ahead(b, *outward_of[b]))
              corners.push_back({meeting, weight_of_ends, 4});
          }
          else if ((meeting - m_positions[b]).norm() < farthest_from_curve
                   && curve_of[a] != curve_of[b])
            corners.push_back({meeting, 1, 4});
        });
    return corners;
  }

private:
  /// Of a node: what it is linked to in the direction of another place.
  std::size_t& port(std::size_t from, std::size_t to)
  {
    return m_ports[from][port_towards(from, to)];
  }
  std::size_t port_towards(std::size_t from, std::size_t to) const
  {
    return (m_positions[to] - m_positions[from]).dot(m_nodes[from].tangent) > 0 ? 0 : 1;
  }
  bool is_free(std::size_t from, std::size_t to) const
  {
    return m_ports[from][port_towards(from, to)] == none;
  }
  bool can_link(std::size_t a, std::size_t b) const
  {
    return is_free(a, b)
           && (is_corner(b) || (is_free(b, a) && m_nodes[a].is_convex == m_nodes[b].is_convex));
  }

  std::vector<std::size_t> curve_from(std::size_t before, std::size_t i,
                                      std::vector<char>& is_left) const
  {
    std::vector<std::size_t> curve;
    const std::size_t first = i;
    if (before != none && is_corner(before))
      curve.push_back(before);
    while (i != none && !is_corner(i) && is_left[i])
    {
      is_left[i] = 0;
      curve.push_back(i);
      const std::size_t next = m_ports[i][m_ports[i][0] == before ? 1 : 0];
      before = i;
      i = next;
    }
    if (i != none && (is_corner(i) || i == first))
      curve.push_back(i);
    return curve;
  }

  Vector nearest_to_tangents(std::size_t a, std::size_t b) const
  {
    const Vector middle = (m_positions[a] + m_positions[b]) / 2;
    Eigen::Matrix3d matrix = 1e-3 * Eigen::Matrix3d::Identity();
    Vector right = Vector::Zero();
    for (std::size_t i : {a, b})
    {
      const Vector& tangent = m_nodes[i].tangent;
      const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - tangent * tangent.transpose();
      matrix += across;
      right += across * (m_positions[i] - middle);
    }
    return middle + matrix.ldlt().solve(right);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CREASE_GRAPH_H
