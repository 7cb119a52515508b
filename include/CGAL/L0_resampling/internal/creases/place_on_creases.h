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

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/creases/Crease_lines.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A crease of samples.
struct Placed_crease
{
  std::vector<Index> samples;
  std::vector<Crease_vertex> vertices; ///< one a sample, whose positions are not used any more
  bool is_closed, is_convex;
  double confidence;
};

struct Placed_corner
{
  Index sample;
  std::vector<Vector> normals;
};

struct Placed_creases
{
  std::vector<Placed_crease> creases;
  std::vector<Placed_corner> corners;
};

/// The samples near creases, each of which can be put on one vertex.
class Samples_beside_creases
{
  static constexpr double reach = 2.5;

  std::vector<Index> m_samples;
  std::vector<Vector> m_places;
  std::vector<char> m_are_free;
  std::optional<Nearby_points> m_nearby;

public:
  static constexpr Index none = Index(-1);

  /// \param place_of of a sample, in the frame and unit of the lines
  template <typename PlaceOf>
  Samples_beside_creases(const Crease_lines& lines, std::size_t number_of_samples,
                         const PlaceOf& place_of)
  {
    std::vector<Vector> vertices;
    for (const Meeting_creases& corner : lines.corners)
      vertices.push_back(corner.position);
    for (const Crease_line& line : lines.lines)
      for (const Crease_vertex& vertex : line.vertices)
        vertices.push_back(vertex.position);
    const Nearby_points nearby_vertices(vertices, reach);
    for_each_in_order(number_of_samples, [&](std::size_t i) {
      const Vector place = place_of(i);
      if (!nearby_vertices.has_near(place, reach))
        return;
      m_samples.push_back(Index(i));
      m_places.push_back(place);
    });
    m_are_free.assign(m_samples.size(), 1);
    m_nearby.emplace(m_places, reach);
  }

  /// The nearest one that was not taken before, or none.
  Index take_nearest(const Vector& position)
  {
    std::size_t nearest = m_samples.size();
    double least = reach * reach;
    m_nearby->for_each_near(position, reach, [&](std::size_t k) {
      const double squared_distance = (m_places[k] - position).squaredNorm();
      if (m_are_free[k] && squared_distance < least)
      {
        least = squared_distance;
        nearest = k;
      }
    });
    if (nearest == m_samples.size())
      return none;
    m_are_free[nearest] = 0;
    return m_samples[nearest];
  }

  /// Moves those that were not taken, on their faces, away from the lines: so that nothing is
  /// nearer to a line than its own points are to each other, nor beyond it.
  /// \param normal_of, move of a sample: `move()` gets its new place
  template <typename NormalOf, typename Move>
  void keep_clear(const std::vector<Crease_line>& lines, const NormalOf& normal_of,
                  const Move& move)
  {
    const double clearance = 0.8, reach_across = 1.2, reach_along = 0.55,
                 least_cosine = 0.8; // of normals of a face
    std::vector<Vector> places = m_places;
    for (const Crease_line& line : lines)
      for (const Crease_vertex& vertex : line.vertices)
        m_nearby->for_each_near(vertex.position, reach_across, [&](std::size_t k) {
          const Vector way = places[k] - vertex.position;
          if (!m_are_free[k] || std::abs(way.dot(vertex.tangent)) > reach_along)
            return;
          const Vector normal = normal_of(m_samples[k]);
          const bool is_left = normal.dot(vertex.normals[0]) > normal.dot(vertex.normals[1]);
          const Vector& normal_of_face = vertex.normals[is_left ? 0 : 1];
          const Vector to_left = normal.cross(vertex.tangent).normalized(),
                       inwards = is_left ? to_left : Vector(-to_left);
          if (normal.dot(normal_of_face) > least_cosine)
            places[k] += (std::max)(clearance - way.dot(inwards), 0.) * inwards;
        });
    for (std::size_t k = 0; k < places.size(); ++k)
      if (places[k] != m_places[k])
        move(m_samples[k], places[k]);
  }
};

/*!
Moves a sample, the nearest one, on each corner and on each vertex of a line, with the mean of the
normals of the faces there. The number of samples stays what it is.

\param origin, spacing the frame and the unit of the lines
*/
template <typename FT>
Placed_creases place_on_creases(const Crease_lines& lines, const Vector& origin, double spacing,
                                Buffer<Vector>& positions, Buffer<Eigen::Matrix<FT, 3, 1>>& normals)
{
  constexpr Index none = Samples_beside_creases::none;
  Samples_beside_creases beside(lines, positions.size(), [&](std::size_t i) {
    return Vector((positions[i] - origin) / spacing);
  });
  const auto place = [&](const Vector& position, const Vector& sum_of_normals) {
    const Index sample = beside.take_nearest(position);
    if (sample != none)
    {
      positions[sample] = origin + spacing * position;
      if (sum_of_normals.squaredNorm() > 0)
        normals[sample] = sum_of_normals.normalized().template cast<FT>();
    }
    return sample;
  };

  Placed_creases placed;
  std::vector<Index> samples_of_corners;
  for (const Meeting_creases& corner : lines.corners)
  {
    Vector sum = Vector::Zero();
    for (const Vector& normal : corner.normals)
      sum += normal;
    samples_of_corners.push_back(place(corner.position, sum));
    if (samples_of_corners.back() != none)
      placed.corners.push_back({samples_of_corners.back(), corner.normals});
  }
  for (const Crease_line& line : lines.lines)
  {
    Placed_crease crease{{}, {}, line.is_closed, line.is_convex, line.confidence};
    const auto add = [&](Index sample, const Crease_vertex& vertex) {
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
      add(place(vertex.position, vertex.normals[0] + vertex.normals[1]), vertex);
    add_corner(line.last_corner, line.vertices.back());
    if (crease.samples.size() > 1)
      placed.creases.push_back(std::move(crease));
  }
  beside.keep_clear(
    lines.lines, [&](Index i) { return Vector(normals[i].template cast<double>()); },
    [&](Index i, const Vector& p) { positions[i] = origin + spacing * p; });
  return placed;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PLACE_ON_CREASES_H
