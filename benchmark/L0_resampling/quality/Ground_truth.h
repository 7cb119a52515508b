// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_GROUND_TRUTH_H
#define CGAL_L0_RESAMPLING_BENCHMARK_GROUND_TRUTH_H

#include "../common/Aabb_trees.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace L0_benchmark {

constexpr double degrees_per_radian = 57.29577951308232;

/// Angle in degrees between two vectors, by atan2: an acos would lose all digits of small angles.
inline double angle_in_degrees(const Vector_3& u, const Vector_3& v)
{
  return degrees_per_radian
         * std::atan2(std::sqrt(CGAL::cross_product(u, v).squared_length()), u * v);
}

inline Vector_3 area_normal(const Triangle_3& triangle)
{
  return CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

/// Edges between two triangles whose normals differ by `angle` degrees or more. Borders are no
/// features: nothing is known about the surface beyond them. Triangles without area have no normal,
/// so their edges are left out.
inline std::vector<Segment_3> feature_edges(const Triangle_mesh& mesh, double angle)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Vector_3>> normals_of_edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector_3 normal = area_normal(mesh.triangle(t));
    if (normal == CGAL::NULL_VECTOR)
      continue;
    for (int i = 0; i < 3; ++i)
      normals_of_edges[std::minmax({mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]})]
        .push_back(normal);
  }
  std::vector<Segment_3> features;
  for (const auto& [edge, normals] : normals_of_edges)
    for (std::size_t i = 1; i < normals.size(); ++i)
      if (angle_in_degrees(normals[0], normals[i]) >= angle) {
        features.emplace_back(mesh.vertices[edge.first], mesh.vertices[edge.second]);
        break;
      }
  return features;
}

/// A mesh with what it takes to measure points against it.
class Ground_truth
{
public:
  /// \param feature_angle the least angle between the normals at a feature edge, in degrees
  /// \throws std::invalid_argument if no triangle has an area
  explicit Ground_truth(Triangle_mesh mesh, double feature_angle = 30)
    : m_mesh(std::move(mesh)), m_diagonal(L0_benchmark::diagonal(bounding_box(m_mesh))),
      m_triangles(proper_triangles(m_mesh)),
      m_features(L0_benchmark::feature_edges(m_mesh, feature_angle))
  {
    if (m_triangles.empty())
      throw std::invalid_argument("a mesh without area is no ground truth");
    m_triangle_tree.insert(m_triangles.cbegin(), m_triangles.cend());
    m_feature_tree.insert(m_features.cbegin(), m_features.cend());
  }

  // The trees hold iterators into the vectors.
  Ground_truth(const Ground_truth&) = delete;
  Ground_truth& operator=(const Ground_truth&) = delete;

  const Triangle_mesh& mesh() const { return m_mesh; }
  double diagonal() const { return m_diagonal; }
  const std::vector<Segment_3>& feature_edges() const { return m_features; }

  Point_3 nearest_point(const Point_3& p) const { return m_triangle_tree.closest_point(p); }

  double distance(const Point_3& p) const { return std::sqrt(m_triangle_tree.squared_distance(p)); }

  /// \pre there is a feature edge
  double distance_to_features(const Point_3& p) const
  {
    return std::sqrt(m_feature_tree.squared_distance(p));
  }

  /// The normals that are right at `p`: of the nearest triangle or, where the foot point lies on an
  /// edge or a vertex, of all triangles there. Not of unit length.
  std::vector<Vector_3> nearest_normals(const Point_3& p) const
  {
    const Point_3 foot = m_triangle_tree.closest_point(p);
    // Wider than the rounding of coordinates stored as `float`, far below the size of any detail.
    const double tolerance = 1e-6 * m_diagonal;
    const Vector_3 reach(tolerance, tolerance, tolerance);
    std::vector<Triangle_iterator> found;
    m_triangle_tree.all_intersected_primitives(Kernel::Iso_cuboid_3(foot - reach, foot + reach),
                                               std::back_inserter(found));
    std::vector<Vector_3> normals;
    normals.reserve(found.size());
    for (const Triangle_iterator triangle : found)
      normals.push_back(area_normal(*triangle));
    return normals;
  }

  /// How far the line through the nearest point of the mesh, along a normal that is right there,
  /// runs to either side until it meets the mesh again; infinite if it never does.
  double distance_to_next_sheet(const Point_3& p) const
  {
    const Point_3 foot = m_triangle_tree.closest_point(p);
    const Vector_3 normal = nearest_normals(p).front(),
                   step = 1e-6 * m_diagonal / std::sqrt(normal.squared_length()) * normal;
    double number_of_steps = std::numeric_limits<double>::infinity();
    for (const Vector_3& direction : {step, -step})
      if (const auto triangle = m_triangle_tree.first_intersected_primitive(
            Kernel::Ray_3(foot + direction, direction))) {
        const Vector_3 other_normal = area_normal(**triangle);
        const double height_of_step = other_normal * direction,
                     height = other_normal * ((**triangle)[0] - foot);
        number_of_steps = (std::min)(number_of_steps,
                                     height_of_step != 0 ? height / height_of_step : 0);
      }
    return number_of_steps * std::sqrt(step.squared_length());
  }

private:
  Triangle_mesh m_mesh;
  double m_diagonal;
  std::vector<Triangle_3> m_triangles;
  std::vector<Segment_3> m_features;
  Triangle_tree m_triangle_tree;
  Segment_tree m_feature_tree;
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_GROUND_TRUTH_H
