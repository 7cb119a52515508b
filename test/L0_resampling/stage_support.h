// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_STAGE_SUPPORT_H
#define CGAL_L0_RESAMPLING_TEST_STAGE_SUPPORT_H

#include "test_support.h"

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <CGAL/tags.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace test {

using namespace CGAL::L0_resampling::internal;
using CGAL::L0_resampling::Index;

template <typename T>
Buffer<T> to_buffer(const std::vector<T>& values)
{
  return Buffer<T>(values.begin(), values.end());
}

/// Unit vectors in the scalar type of a stage.
template <typename T>
Buffer<Eigen::Matrix<T, 3, 1>> to_local_vectors(const std::vector<Vector>& vectors)
{
  Buffer<Eigen::Matrix<T, 3, 1>> result;
  for (const Vector& v : vectors)
    result.push_back(v.cast<T>());
  return result;
}

/// A `Progress` that nobody watches.
class Unwatched
{
  CGAL::L0_resampling::Report m_report;
  Memory_counter m_memory;

public:
  Progress progress{nullptr, m_report, m_memory};
};

inline std::vector<Vector> permuted(const Buffer<Index>& order, const std::vector<Vector>& values)
{
  std::vector<Vector> result;
  for (Index i : order)
    result.push_back(values[i]);
  return result;
}

/// Points in the order that a grid wants, and the grid.
struct Gridded_points
{
  Buffer<Index> order;        ///< where each point was
  std::vector<Vector> vector; ///< the points, for naive implementations
  Buffer<Vector> points;      ///< the same, for stages
  Search_grid_3 grid;

  Gridded_points(const std::vector<Vector>& unsorted, double cell_size)
    : order(Search_grid_3::sorted_order<CGAL::Sequential_tag>(to_buffer(unsorted), cell_size)),
      vector(permuted(order, unsorted)), points(to_buffer(vector)), grid(points, cell_size)
  {}
};

/// The angle between two lines in degrees, in [0, 90].
inline double angle_of_lines(const Vector& a, const Vector& b)
{
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180 / EIGEN_PI;
}

/// Points on the borders of the cells of a grid, and one rounding step to each side.
inline std::vector<Vector> border_points(double cell_size, Generator& generator)
{
  std::uniform_int_distribution<int> cell(-2, 2), side(-1, 1);
  std::vector<Vector> points;
  for (int n = 0; n < 300; ++n)
  {
    Vector p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = std::nextafter(cell(generator) * cell_size, side(generator) * 10.);
    points.push_back(p);
  }
  return points;
}

/// Clusters with neighbors inside, at the ends of what 2^19 cells number and far beyond.
inline std::vector<Vector> far_points(Generator& generator)
{
  const double end = 1 << 19;
  std::vector<Vector> points;
  for (const Vector& center :
       {Vector(0, 0, 0), Vector(end, 0, 0), Vector(end + 40, -end, 3), Vector(-end - 40, 0, 5),
        Vector(1e9, 0, 0), Vector(1e9, 1e9, -1e9), Vector(-1e9, 0, 2e9), Vector(3e13, 7, 5e12)})
    for (int n = 0; n < 40; ++n)
      points.push_back(center + 2 * random_unit_vector(generator));
  return points;
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_STAGE_SUPPORT_H
