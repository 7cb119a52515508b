// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_HOSTILE_POINTS_H
#define CGAL_L0_RESAMPLING_TEST_HOSTILE_POINTS_H

#include "Attack.h"

#include <string>
#include <vector>

namespace attack {

struct Named_points
{
  std::string name;
  std::vector<Vector> points;
};

/// Our inventions, each with its name; at most 300 points in one.
std::vector<Named_points> hostile_point_sets();

/// One of these or a random shape, then a few random misfortunes: other units, other places,
/// duplicates, outliers, NaN ...
std::vector<Vector> random_point_set(Generator& generator);

/// As many normals as points, of any length, some of them of no use.
std::vector<Vector> random_normals(std::size_t n, Generator& generator);

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_HOSTILE_POINTS_H
