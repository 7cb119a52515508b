// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_MESH_SUPPORT_H
#define CGAL_L0_RESAMPLING_TEST_MESH_SUPPORT_H

#include "failure_count.h"

#include "../../../benchmark/L0_resampling/common/Triangle_mesh.h"

#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

// What tests of the benchmarks check, and small meshes
namespace L0_benchmark_test {

using namespace L0_benchmark;

constexpr double pi = 3.14159265358979323846;
inline void check_close(double value, double expected, double tolerance,
                        int line = __builtin_LINE())
{
  std::ostringstream what;
  what << std::setprecision(17) << value << " is not " << expected << " within " << tolerance;
  check(std::abs(value - expected) <= tolerance, what.str(), line);
}

template <class Exception = std::invalid_argument, class Function>
void check_throws(Function function, int line = __builtin_LINE())
{
  try
  {
    function();
  }
  catch (const Exception&)
  {
    return;
  }
  check(false, "nothing was thrown", line);
}

// In the plane z = 0, seen from above.
inline Triangle_mesh rectangle(double width, double depth)
{
  return {{Point_3(0, 0, 0), Point_3(width, 0, 0), Point_3(width, depth, 0), Point_3(0, depth, 0)},
          {{0, 1, 2}, {0, 2, 3}}};
}

// [0, 1]^3; bit i of a vertex's index is its i-th coordinate.
inline Triangle_mesh cube()
{
  Triangle_mesh mesh;
  for (int v = 0; v < 8; ++v)
    mesh.vertices.emplace_back(v & 1, v >> 1 & 1, v >> 2);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

} // namespace L0_benchmark_test

#endif // CGAL_L0_RESAMPLING_TEST_MESH_SUPPORT_H
