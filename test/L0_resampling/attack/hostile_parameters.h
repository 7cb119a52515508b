// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_HOSTILE_PARAMETERS_H
#define CGAL_L0_RESAMPLING_TEST_HOSTILE_PARAMETERS_H

#include "Attack.h"

#include <string>
#include <vector>

namespace attack {

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

#endif // CGAL_L0_RESAMPLING_TEST_HOSTILE_PARAMETERS_H
