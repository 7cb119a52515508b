// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_TRIANGLE_MESH_H
#define CGAL_L0_RESAMPLING_BENCHMARK_TRIANGLE_MESH_H

#include <CGAL/Bbox_3.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/bounding_box.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace L0_benchmark {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Triangle_3 = Kernel::Triangle_3;

/// The ground truth of a benchmark: triangles, counterclockwise seen from outside. It may have
/// borders.
struct Triangle_mesh
{
  using Triangle = std::array<std::size_t, 3>;

  std::vector<Point_3> vertices;
  std::vector<Triangle> triangles;

  Triangle_3 triangle(std::size_t t) const
  {
    return {vertices[triangles[t][0]], vertices[triangles[t][1]], vertices[triangles[t][2]]};
  }
};

inline CGAL::Bbox_3 bounding_box(const Triangle_mesh& mesh)
{
  return CGAL::bbox_3(mesh.vertices.begin(), mesh.vertices.end());
}

/// The length that all errors and all noise are percentages of.
inline double diagonal(const CGAL::Bbox_3& box)
{
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

/// Vertices at the same position become one, since edges are recognised by their vertices.
/// \throws std::runtime_error if the file cannot be read, is empty or has a face that is not a
/// triangle
inline Triangle_mesh read_triangle_mesh(const std::string& path)
{
  Triangle_mesh mesh;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_OFF(path, mesh.vertices, polygons))
    throw std::runtime_error(path + ": cannot be read as an OFF file");
  if (polygons.empty())
    throw std::runtime_error(path + ": has no faces");
  CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(mesh.vertices, polygons);
  mesh.triangles.reserve(polygons.size());
  for (const std::vector<std::size_t>& polygon : polygons) {
    if (polygon.size() != 3)
      throw std::runtime_error(path + ": has a face with " + std::to_string(polygon.size())
                               + " vertices, not 3");
    mesh.triangles.push_back({polygon[0], polygon[1], polygon[2]});
  }
  return mesh;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_TRIANGLE_MESH_H
