// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_HOSTILE_H
#define CGAL_L0_RESAMPLING_TEST_HOSTILE_H

#include "Attack.h"

#include <limits>
#include <string>
#include <vector>

namespace attack {

using Numbers = std::numeric_limits<double>;

inline constexpr double nan = Numbers::quiet_NaN();
inline constexpr double infinity = Numbers::infinity();
inline constexpr double largest = 1.7976931348623157e308;

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

struct Named_parameters
{
  std::string name;
  Parameters parameters;
};

/// Our inventions, each with its name, for a cloud of that many points with that diagonal.
std::vector<Named_parameters> hostile_parameter_sets(std::size_t size, double diagonal);

/// Some of the parameters from the same sources as above, the others at their defaults.
Parameters random_parameters(std::size_t n, double diagonal, Generator& generator);

/// How often the penalty grows until it is its maximum, which is how often Algorithm 1 repeats its
/// steps. No finite number for some that are refused.
double number_of_growths(const Parameters& parameters);

/// Of the bounding box of the finite points, and finite itself.
double diagonal_of(const std::vector<Vector>& points);

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_HOSTILE_H
