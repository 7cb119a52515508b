// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_ATTACK_H
#define CGAL_L0_RESAMPLING_TEST_ATTACK_H

#include "../test_support.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace attack {

using test::Generator;
using test::Vector;

enum class Solver
{
  BLOCK_CHEBYSHEV,
  CHOLESKY,
  LEAST_SQUARES
};

/// All that one call is asked for. Counts are numbers of any kind, as a caller's arithmetic may
/// have made them; what has no value is not passed at all.
struct Parameters
{
  int method = 0;
  Solver solver = Solver::BLOCK_CHEBYSHEV;
  bool in_single_precision = false; // the kernel of the caller
  bool with_normals = false;
  bool with_hints = false;      // of the side of the normals; the same vectors
  bool with_point_data = false; // indices of the nearest points, and confidences

  std::optional<double> number_of_output_points, neighbor_radius, normal_filter_radius, noise;
  std::optional<double> regularization_weight, penalty_growth; // the default depends on the method
  std::optional<bool> drop_outliers;                           // likewise
  std::optional<double> outlier_sensitivity;
  std::optional<double> viewpoint, up_direction; // x of a point and of a vector off all axes
  bool viewpoint_by_map = false;                 // whether the viewpoint is given for each point
  double select_percentage = 50;
  double sharpness_angle = 15;
  double number_of_normal_filter_iterations = 3;
  double normal_weight = 0.9;
  double initial_penalty = 0.1;
  double maximum_penalty = 2;
  double number_of_orientation_neighbors = 12;
  std::size_t random_seed = 0;
  bool drop_non_finite = false;
  bool keep_density = false;
  std::size_t maximum_memory = (std::numeric_limits<std::size_t>::max)();

  // The first access to the point map, and the first point written, that throws. None if it is
  // never reached.
  std::size_t throwing_access = (std::numeric_limits<std::size_t>::max)();
  std::size_t throwing_write = (std::numeric_limits<std::size_t>::max)();
};

/// Calls `f(name, member)` for each parameter.
template <typename F>
void for_each_parameter(const F& f)
{
  f("method", &Parameters::method);
  f("solver", &Parameters::solver);
  f("in_single_precision", &Parameters::in_single_precision);
  f("with_normals", &Parameters::with_normals);
  f("with_hints", &Parameters::with_hints);
  f("with_point_data", &Parameters::with_point_data);
  f("number_of_output_points", &Parameters::number_of_output_points);
  f("neighbor_radius", &Parameters::neighbor_radius);
  f("noise", &Parameters::noise);
  f("normal_filter_radius", &Parameters::normal_filter_radius);
  f("regularization_weight", &Parameters::regularization_weight);
  f("penalty_growth", &Parameters::penalty_growth);
  f("drop_outliers", &Parameters::drop_outliers);
  f("outlier_sensitivity", &Parameters::outlier_sensitivity);
  f("viewpoint", &Parameters::viewpoint);
  f("viewpoint_by_map", &Parameters::viewpoint_by_map);
  f("up_direction", &Parameters::up_direction);
  f("keep_density", &Parameters::keep_density);
  f("select_percentage", &Parameters::select_percentage);
  f("sharpness_angle", &Parameters::sharpness_angle);
  f("number_of_normal_filter_iterations", &Parameters::number_of_normal_filter_iterations);
  f("normal_weight", &Parameters::normal_weight);
  f("initial_penalty", &Parameters::initial_penalty);
  f("maximum_penalty", &Parameters::maximum_penalty);
  f("number_of_orientation_neighbors", &Parameters::number_of_orientation_neighbors);
  f("random_seed", &Parameters::random_seed);
  f("drop_non_finite", &Parameters::drop_non_finite);
  f("maximum_memory", &Parameters::maximum_memory);
  f("throwing_access", &Parameters::throwing_access);
  f("throwing_write", &Parameters::throwing_write);
}

struct Attack
{
  std::string name;
  std::vector<Vector> points;
  std::vector<Vector> normals; // one a point
  Parameters parameters;
};

/// As text: the parameters that are not at their defaults, then a line for each point and its
/// normal, in hexadecimal digits.
void write_attack(const std::string& path, const Attack& attack);

/// \throws std::runtime_error if the file is not of that form
Attack read_attack(const std::string& path);

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_ATTACK_H
