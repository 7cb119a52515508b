// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_ORIENTATION_SUPPORT_H
#define CGAL_L0_RESAMPLING_TEST_ORIENTATION_SUPPORT_H

#include "stage_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

namespace test {

/// Samples without the clusters and holes of chance, as resampling leaves them: of twelve
/// candidates the one furthest from the rest.
inline Oriented_points evenly(std::size_t n,
                              const std::function<Oriented_points(std::size_t)>& candidates)
{
  Oriented_points result;
  while (result.points.size() < n)
  {
    const Oriented_points some = candidates(12);
    std::size_t best = 0;
    double largest = -1;
    for (std::size_t c = 0; c < some.points.size(); ++c)
    {
      double nearest = 1e9;
      for (const Vector& p : result.points)
        nearest = (std::min)(nearest, (p - some.points[c]).squaredNorm());
      if (nearest > largest)
      {
        largest = nearest;
        best = c;
      }
    }
    result.points.push_back(some.points[best]);
    result.normals.push_back(some.normals[best]);
  }
  return result;
}

/// Radii 1 and 0.4, around the z axis; not quite uniform by area.
inline Oriented_points torus_points(std::size_t n, Generator& generator)
{
  Oriented_points result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double u = random_number(0, 2 * EIGEN_PI, generator),
                 v = random_number(0, 2 * EIGEN_PI, generator);
    const Vector out(std::cos(u), std::sin(u), 0);
    result.normals.push_back(std::cos(v) * out + std::sin(v) * Vector::UnitZ());
    result.points.push_back(out + 0.4 * result.normals.back());
  }
  return result;
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_ORIENTATION_SUPPORT_H
