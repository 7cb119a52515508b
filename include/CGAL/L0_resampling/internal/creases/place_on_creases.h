// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PLACE_ON_CREASES_H
#define CGAL_L0_RESAMPLING_INTERNAL_PLACE_ON_CREASES_H

#include <CGAL/L0_resampling/internal/core/precedes.h>
#include <CGAL/L0_resampling/internal/creases/Crease_lines.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The frame and the unit of lines.
struct Crease_frame
{
  Vector origin;
  double spacing; ///< of the samples

  Vector enter(const Vector& p) const { return (p - origin) / spacing; }
  Vector leave(const Vector& p) const { return origin + spacing * p; }
};

/// The samples near creases, each of which can be put on one vertex.
class Samples_beside_creases
{
  static constexpr double reach = 2.5;
  static constexpr std::size_t none = std::size_t(-1);

  const Crease_lines& m_lines; // the caller keeps them
  const Crease_frame m_frame;
  const std::vector<Vector> m_vertices;
  const Nearby_points m_nearby_vertices;
  std::vector<Sample_beside_crease> m_samples;

  // Once all are there, of each
  std::vector<Vector> m_places; // in the frame
  std::vector<char> m_are_free, m_have_moved;

public:
  Samples_beside_creases(const Crease_lines& lines, const Crease_frame& frame)
    : m_lines(lines), m_frame(frame), m_vertices(vertices_of(lines)),
      m_nearby_vertices(m_vertices, reach)
  {}

  /// Takes a sample, if it is near to a crease.
  void add(std::size_t number, const Vector& position, const Vector& normal)
  {
    if (m_nearby_vertices.has_near(m_frame.enter(position), reach))
      m_samples.push_back({number, position, normal});
  }

  /// Moves a sample, the nearest one, on each corner and on each vertex of a line, with the mean of
  /// the normals of the faces there. The number of samples stays what it is. In which order they
  /// were added does not matter.
  Placed_creases place() &&
  {
    std::sort(m_samples.begin(), m_samples.end(),
              [](const Sample_beside_crease& a, const Sample_beside_crease& b) {
                return precedes(a.position, b.position);
              });
    for (const Sample_beside_crease& sample : m_samples)
      m_places.push_back(m_frame.enter(sample.position));
    m_are_free.assign(m_samples.size(), 1);
    m_have_moved.assign(m_samples.size(), 0);
    const Nearby_points nearby(m_places, reach);

    Placed_creases placed;
    std::vector<std::size_t> samples_of_corners;
    for (const Meeting_creases& corner : m_lines.corners)
    {
      Vector sum = Vector::Zero();
      for (const Vector& normal : corner.normals)
        sum += normal;
      samples_of_corners.push_back(put_nearest_on(corner.position, sum, nearby));
      if (samples_of_corners.back() != none)
        placed.corners.push_back({samples_of_corners.back(), corner.normals});
    }
    for (const Crease_line& line : m_lines.lines)
    {
      Placed_crease crease{{}, {}, line.is_closed, line.is_convex, line.confidence};
      const auto add = [&](std::size_t sample, const Crease_vertex& vertex) {
        if (sample == none)
          return;
        crease.samples.push_back(sample);
        crease.vertices.push_back(vertex);
      };
      const auto add_corner = [&](std::size_t corner, const Crease_vertex& nearest) {
        if (corner != Crease_graph::none)
          add(samples_of_corners[corner], nearest);
      };
      add_corner(line.first_corner, line.vertices.front());
      for (const Crease_vertex& vertex : line.vertices)
        add(put_nearest_on(vertex.position, vertex.normals[0] + vertex.normals[1], nearby), vertex);
      add_corner(line.last_corner, line.vertices.back());
      if (crease.samples.size() > 1)
        placed.creases.push_back(std::move(crease));
    }
    keep_clear(nearby);
    for (std::size_t k = 0; k < m_samples.size(); ++k)
      if (m_have_moved[k])
        placed.moved.push_back(m_samples[k]);
    std::sort(placed.moved.begin(), placed.moved.end(),
              [](const Sample_beside_crease& a, const Sample_beside_crease& b) {
                return a.number < b.number;
              });
    return placed;
  }

private:
  static std::vector<Vector> vertices_of(const Crease_lines& lines)
  {
    std::vector<Vector> vertices;
    for (const Meeting_creases& corner : lines.corners)
      vertices.push_back(corner.position);
    for (const Crease_line& line : lines.lines)
      for (const Crease_vertex& vertex : line.vertices)
        vertices.push_back(vertex.position);
    return vertices;
  }

  void move(std::size_t k, const Vector& place)
  {
    m_samples[k].position = m_frame.leave(place);
    m_have_moved[k] = 1;
  }

  /// Takes the nearest sample that was not taken before.
  /// \returns its number, or none
  std::size_t put_nearest_on(const Vector& place, const Vector& sum_of_normals,
                             const Nearby_points& nearby)
  {
    std::size_t nearest = m_samples.size();
    double least = reach * reach;
    nearby.for_each_near(place, reach, [&](std::size_t k) {
      const double squared_distance = (m_places[k] - place).squaredNorm();
      if (m_are_free[k] && squared_distance < least)
      {
        least = squared_distance;
        nearest = k;
      }
    });
    if (nearest == m_samples.size())
      return none;
    m_are_free[nearest] = 0;
    move(nearest, place);
    if (sum_of_normals.squaredNorm() > 0)
      m_samples[nearest].normal = sum_of_normals.normalized();
    return m_samples[nearest].number;
  }

  /// Moves those that were not taken, on their faces, away from the lines: so that nothing is
  /// nearer to a line than its own points are to each other, nor beyond it.
  void keep_clear(const Nearby_points& nearby)
  {
    const double clearance = 0.8, reach_across = 1.2, reach_along = 0.55,
                 minimum_cosine = 0.8; // of normals of a face
    std::vector<Vector> places = m_places;
    for (const Crease_line& line : m_lines.lines)
      for (const Crease_vertex& vertex : line.vertices)
        nearby.for_each_near(vertex.position, reach_across, [&](std::size_t k) {
          const Vector way = places[k] - vertex.position;
          if (!m_are_free[k] || std::abs(way.dot(vertex.tangent)) > reach_along)
            return;
          const Vector& normal = m_samples[k].normal;
          const bool is_left = normal.dot(vertex.normals[0]) > normal.dot(vertex.normals[1]);
          const Vector& normal_of_face = vertex.normals[is_left ? 0 : 1];
          const Vector to_left = normal.cross(vertex.tangent).normalized(),
                       inwards = is_left ? to_left : Vector(-to_left);
          if (normal.dot(normal_of_face) > minimum_cosine)
            places[k] += (std::max)(clearance - way.dot(inwards), 0.) * inwards;
        });
    for (std::size_t k = 0; k < places.size(); ++k)
      if (places[k] != m_places[k])
        move(k, places[k]);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PLACE_ON_CREASES_H
