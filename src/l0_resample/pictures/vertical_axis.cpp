// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/vertical_axis.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>

namespace l0_tool {
namespace {

/// Where a direction, of either sign, lies on a cube of three faces with square cells, of which one
/// has an axis in its middle.
constexpr std::size_t cells_of_edge = 9, number_of_cells = 3 * cells_of_edge * cells_of_edge;

std::size_t cell_of(const Vector& n)
{
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(n[k]) > std::abs(n[axis]))
      axis = k;
  const auto part = [&](int k) {
    const double place = (n[(axis + k) % 3] / n[axis] + 1) / 2 * cells_of_edge;
    return (std::min)(std::size_t((std::max)(place, 0.)), cells_of_edge - 1);
  };
  return (std::size_t(axis) * cells_of_edge + part(1)) * cells_of_edge + part(2);
}

constexpr double cosine_along = 0.985, cosine_across = 0.17; // 10 degrees

/// Of points in floors across the axis, or in walls along it that meet at right angles: as the sum
/// of the fourth powers of the directions of their normals. So the slopes of a roof with a ridge
/// along the axis are no walls.
double share_of_floors_and_walls(const std::vector<Oriented_point>& points, int axis)
{
  std::size_t number_of_floors = 0;
  std::complex<double> walls = 0;
  for (const auto& [point, normal] : points) {
    const double cosine = std::abs(normal[axis]);
    const std::complex<double> across(normal[(axis + 1) % 3], normal[(axis + 2) % 3]);
    if (cosine > cosine_along)
      ++number_of_floors;
    else if (cosine < cosine_across && normal != CGAL::NULL_VECTOR)
      walls += std::pow(across / std::abs(across), 4);
  }
  return (double(number_of_floors) + std::abs(walls)) / double(points.size());
}

/// The faces of the bounding box that hold points.
class Faces
{
  static constexpr std::size_t edge = 8;

  using Cells = std::array<bool, edge * edge>; // of a face

  CGAL::Bbox_3 m_box;
  std::array<std::array<Cells, 2>, 3> m_are_held = {}; // of each axis the low one and the high one

  double part(const Point& p, int axis) const
  {
    const double length = extent(axis);
    return length > 0 ? (p[axis] - m_box.min(axis)) / length : 0.;
  }

  std::size_t place(const Point& p, int axis) const
  {
    return (std::min)(std::size_t(part(p, axis) * edge), edge - 1);
  }

public:
  explicit Faces(const std::vector<Oriented_point>& points)
  {
    constexpr double depth = 0.15; // of a face, by the extent along its normal
    for (const Oriented_point& point : points)
      m_box += point.first.bbox();
    for (const auto& [point, normal] : points)
      for (int axis = 0; axis < 3; ++axis) {
        const double along = part(point, axis);
        if (std::abs(normal[axis]) > cosine_along && (along < depth || along > 1 - depth))
          m_are_held[std::size_t(axis)][along > 1 - depth]
                    [place(point, (axis + 1) % 3) * edge + place(point, (axis + 2) % 3)] = true;
      }
  }

  double extent(int axis) const { return m_box.max(axis) - m_box.min(axis); }

  bool is_held(int axis, bool is_high) const
  {
    constexpr double minimum_share = 0.6; // windows, and what stands before a wall
    const Cells& cells = m_are_held[std::size_t(axis)][is_high];
    return double(std::count(cells.begin(), cells.end(), true))
           > minimum_share * double(cells.size());
  }

  int number_held() const
  {
    int number = 0;
    for (int axis = 0; axis < 3; ++axis)
      number += int(is_held(axis, false)) + int(is_held(axis, true));
    return number;
  }
};

/// Whether there are walls on the ground, and not a facade alone, whose ground would be a wall.
bool has_walls(const std::vector<Oriented_point>& points)
{
  constexpr double minimum_share = 0.25;
  const auto number = std::count_if(points.begin(), points.end(), [](const Oriented_point& p) {
    return p.second != CGAL::NULL_VECTOR && std::abs(p.second.y()) < cosine_across;
  });
  return double(number) > minimum_share * double(points.size());
}

} // namespace

// The share of six of 243 cells is 0.7 and more of buildings, rooms and machined parts, and 0.25 at
// most of figures.
bool are_planes(const std::vector<Oriented_point>& points)
{
  constexpr double minimum_share = 0.5;
  constexpr std::size_t number_of_planes = 6;
  std::array<std::size_t, number_of_cells> counts = {};
  std::size_t n = 0;
  for (const Oriented_point& point : points)
    if (point.second != CGAL::NULL_VECTOR) {
      ++counts[cell_of(point.second)];
      ++n;
    }
  std::partial_sort(counts.begin(), counts.begin() + number_of_planes, counts.end(),
                    std::greater<>());
  std::size_t sum = 0;
  for (std::size_t k = 0; k < number_of_planes; ++k)
    sum += counts[k];
  return double(sum) > minimum_share * double(n);
}

bool is_y_vertical(const std::vector<Oriented_point>& points)
{
  constexpr double minimum_difference = 0.1;
  const double difference = share_of_floors_and_walls(points, 1)
                            - share_of_floors_and_walls(points, 2);
  if (std::abs(difference) > minimum_difference)
    return difference > 0;
  const Faces faces(points);
  if (!faces.is_held(1, false))
    return false;
  if (faces.number_held() == 1)
    return has_walls(points);
  constexpr double minimum_ratio = 1.2;
  return faces.is_held(2, false) && faces.number_held() >= 4
         && faces.extent(2) > minimum_ratio * faces.extent(1);
}

} // namespace l0_tool
