// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SOLIDS_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SOLIDS_H

#include "Rotation.h"

#include <cstddef>
#include <vector>

namespace L0_benchmark {

/// \name What scenes are put together from
/// Each function adds one part to a mesh: closed solids with outward normals, and open ground with
/// normals upwards. Lengths are meters, z points upwards. Solids stand a little in the ground,
/// where no ray reaches them.
/// @{

/// A convex solid between two convex polygons with equal numbers of corners, both counterclockwise
/// seen from the side of `end`.
inline void add_frustum(Triangle_mesh& mesh, const std::vector<Point_3>& start,
                        const std::vector<Point_3>& end)
{
  const std::size_t n = start.size(), first = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), start.begin(), start.end());
  mesh.vertices.insert(mesh.vertices.end(), end.begin(), end.end());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = first + i, b = first + (i + 1) % n;
    mesh.triangles.push_back({a, b, b + n});
    mesh.triangles.push_back({a, b + n, a + n});
  }
  for (std::size_t i = 2; i < n; ++i) {
    mesh.triangles.push_back({first, first + i, first + i - 1});
    mesh.triangles.push_back({first + n, first + n + i - 1, first + n + i});
  }
}

/// A box with four upright edges, turned about its axis.
/// \param center of its bottom
inline void add_box(Triangle_mesh& mesh, const Point_3& center, const Vector_3& size,
                    double degrees = 0)
{
  const Rotation turn = Rotation::of_degrees(degrees);
  const Vector_3 up(0, 0, 1);
  std::vector<Point_3> bottom, top;
  for (int i = 0; i < 4; ++i) {
    const Vector_3 corner((i == 1 || i == 2 ? 0.5 : -0.5) * size.x(),
                          (i >= 2 ? 0.5 : -0.5) * size.y(), 0);
    bottom.push_back(center + turn(corner, up));
    top.push_back(bottom.back() + size.z() * up);
  }
  add_frustum(mesh, bottom, top);
}

/// A trunk or pole: 64 sides, 5.6 degrees from one to the next.
inline void add_trunk(Triangle_mesh& mesh, const Point_3& foot, const Point_3& tip, double diameter,
                      double diameter_of_tip)
{
  constexpr int number_of_sides = 64;
  std::vector<Point_3> bottom, top;
  for (int i = 0; i < number_of_sides; ++i) {
    const Rotation angle = Rotation::of_turns(double(i) / number_of_sides);
    const Vector_3 outwards(angle.cosine, angle.sine, 0);
    bottom.push_back(foot + diameter / 2 * outwards);
    top.push_back(tip + diameter_of_tip / 2 * outwards);
  }
  add_frustum(mesh, bottom, top);
}

/// A house whose ridge runs along y in its own frame.
/// \param center of its bottom
/// \param size up to the eaves
/// \param ridge height of the ridge above the eaves
inline void add_gabled_house(Triangle_mesh& mesh, const Point_3& center, const Vector_3& size,
                             double ridge, double degrees)
{
  const Rotation turn = Rotation::of_degrees(degrees);
  const double x = size.x() / 2, z = size.z();
  std::vector<Point_3> back, front; // seen from the front, x to the right
  for (const Vector_3& corner : {Vector_3(-x, 0, 0), Vector_3(x, 0, 0), Vector_3(x, 0, z),
                                 Vector_3(0, 0, z + ridge), Vector_3(-x, 0, z)}) {
    const Vector_3 depth(0, size.y() / 2, 0), up(0, 0, 1);
    back.push_back(center + turn(corner + depth, up));
    front.push_back(center + turn(corner - depth, up));
  }
  add_frustum(mesh, back, front);
}

/// Ground over a rectangle around the origin, as squares of two triangles.
/// \param height a function of x and y
template <class Height>
void add_ground(Triangle_mesh& mesh, double half_width, double half_depth, double step,
                const Height& height)
{
  const std::size_t first = mesh.vertices.size();
  const std::size_t columns = std::size_t(2 * half_width / step + 0.5) + 1;
  const std::size_t rows = std::size_t(2 * half_depth / step + 0.5) + 1;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const double x = double(i) * step - half_width, y = double(j) * step - half_depth;
      mesh.vertices.emplace_back(x, y, height(x, y));
      if (i > 0 && j > 0) {
        const std::size_t a = first + (j - 1) * columns + i - 1, b = a + 1, c = a + columns,
                          d = c + 1;
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      }
    }
}

/// @}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SOLIDS_H
