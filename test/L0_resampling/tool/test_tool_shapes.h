// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TEST_TOOL_SHAPES_H
#define L0_RESAMPLE_TEST_TOOL_SHAPES_H

#include "basis/Point_cloud.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tool_test {

/// Evenly spread on the unit sphere, from its north to its south pole on the z axis.
inline std::vector<l0_tool::Oriented_point> sphere(std::size_t n)
{
  std::vector<l0_tool::Oriented_point> points;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double z = 1 - (2 * double(i) + 1) / double(n),
                 angle = 2.399963229728653 * double(i); // the golden angle
    const l0_tool::Vector v(std::sqrt(1 - z * z) * std::cos(angle),
                            std::sqrt(1 - z * z) * std::sin(angle), z);
    points.emplace_back(CGAL::ORIGIN + v, v);
  }
  return points;
}

/// Six faces, from -1 to 1, of `n` by `n` points that are no nearer to an edge than to each other.
inline std::vector<l0_tool::Oriented_point> cube(int n)
{
  std::vector<l0_tool::Oriented_point> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1., 1.})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
        {
          std::array<double, 3> p, normal = {0, 0, 0};
          p[std::size_t(axis)] = normal[std::size_t(axis)] = side;
          p[std::size_t((axis + 1) % 3)] = (2. * i + 1) / n - 1;
          p[std::size_t((axis + 2) % 3)] = (2. * j + 1) / n - 1;
          points.emplace_back(l0_tool::Point(p[0], p[1], p[2]),
                              l0_tool::Vector(normal[0], normal[1], normal[2]));
        }
  return points;
}

/// A cube that is longer along y, as a hall is, with normals outwards or inwards.
inline std::vector<l0_tool::Oriented_point> hall(double side)
{
  std::vector<l0_tool::Oriented_point> points;
  for (const l0_tool::Oriented_point& point : cube(30))
    points.emplace_back(l0_tool::Point(point.first.x(), 3 * point.first.y(), point.first.z()),
                        side * point.second);
  return points;
}

} // namespace tool_test

#endif // L0_RESAMPLE_TEST_TOOL_SHAPES_H
