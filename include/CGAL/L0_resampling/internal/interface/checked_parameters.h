// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CHECKED_PARAMETERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_CHECKED_PARAMETERS_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/plan/Method_rules.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// \throws std::invalid_argument that names the function, the parameter and its value, unless
/// `is_good`
template <typename T>
void check_parameter(bool is_good, const char* name, const T& value, const char* expected,
                     const char* function = resampling_function)
{
  if (is_good)
    return;
  std::ostringstream message;
  message.precision(17);
  message << function << ": " << name << " is " << value << ", expected " << expected;
  throw std::invalid_argument(message.str());
}

/// Sets `target` to what is given, if it is.
template <typename T>
void take(const std::optional<T>& given, T& target)
{
  if (given)
    target = *given;
}

/// Sets `target` to the count that is given, if it is.
/// \throws std::invalid_argument for a number that is no count
inline void take_count(const Given_count& given, const char* name, std::size_t& target,
                       const char* function = resampling_function)
{
  if (!given.is_given)
    return;
  check_parameter(given.refused.empty(), name, given.refused, "a count that is not negative",
                  function);
  target = given.value;
}

/// Which of the parameters are given that say on which side the normals are.
struct Given_sides
{
  bool viewpoint, up_direction, viewpoint_map, orientation_hint_map;

  /// \throws std::invalid_argument for two of them
  void check_at_most_one(const char* function = resampling_function) const
  {
    const std::pair<const char*, bool> sides[] = {{"viewpoint", viewpoint},
                                                  {"up_direction", up_direction},
                                                  {"viewpoint_map", viewpoint_map},
                                                  {"orientation_hint_map", orientation_hint_map}};
    const char* first = nullptr;
    for (const auto& [name, is_given] : sides)
    {
      if (!is_given)
        continue;
      if (first)
        check_parameter(false, first, "given", ("no " + std::string(name) + " beside it").c_str(),
                        function);
      first = name;
    }
  }
};

inline Given_sides given_sides(const Given_parameters& given)
{
  return {given.viewpoint.has_value(), given.up_direction.has_value(), given.viewpoint_map.value,
          given.orientation_hint_map.value};
}

/// Takes what all points were seen from.
inline void take_viewpoint(const Given_parameters& given, const char* function, Parameters& p)
{
  const Given_sides sides = given_sides(given);
  sides.check_at_most_one(function);
  p.hints_are_viewpoints = sides.viewpoint_map;
  p.has_viewpoint = sides.viewpoint || sides.up_direction;
  double(&coordinates)[3] = p.viewpoint.coordinates;
  const auto take_coordinates = [&](const char* name, const std::array<double, 3>& from) {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      coordinates[axis] = from[axis];
      check_parameter(std::isfinite(coordinates[axis]), name, coordinates[axis],
                      "three finite coordinates", function);
    }
  };
  if (given.viewpoint)
    take_coordinates("viewpoint", *given.viewpoint);
  if (given.up_direction)
  {
    take_coordinates("up_direction", *given.up_direction);
    p.viewpoint.weight = 0;
    const double largest = (std::max)(
      {std::abs(coordinates[0]), std::abs(coordinates[1]), std::abs(coordinates[2])});
    check_parameter(largest > 0, "up_direction", "0, 0, 0", "a direction", function);
    const double length = std::hypot(coordinates[0] / largest, coordinates[1] / largest,
                                     coordinates[2] / largest);
    for (double& coordinate : coordinates)
      coordinate = coordinate / largest / length;
  }
}

/// Takes the radius of a neighborhood.
inline void take_neighbor_radius(const Given_parameters& given, const char* function, Parameters& p)
{
  take(given.neighbor_radius, p.neighbor_radius);
  check_parameter(!given.neighbor_radius
                    || (std::isfinite(p.neighbor_radius) && p.neighbor_radius > 0),
                  "neighbor_radius", p.neighbor_radius, "a finite length above 0", function);
}

/// Takes what says how normals get their side.
inline void take_orientation(const Given_parameters& given, const char* function, Parameters& p)
{
  take_viewpoint(given, function, p);
  take_count(given.number_of_orientation_neighbors, "number_of_orientation_neighbors",
             p.number_of_orientation_neighbors, function);
  check_parameter(
    p.number_of_orientation_neighbors >= 3 && p.number_of_orientation_neighbors <= 1000,
    "number_of_orientation_neighbors", p.number_of_orientation_neighbors, "3 to 1000", function);
}

/// Checks everything that does not depend on the types of the points.
/// \param n number of points that are used
/// \throws std::invalid_argument
inline Parameters checked_parameters(const Given_parameters& given, std::size_t n)
{
  Parameters p;
  const auto is_positive = [](double x) { return std::isfinite(x) && x > 0; };
  const auto is_not_negative = [](double x) { return std::isfinite(x) && x >= 0; };

  take(given.method, p.method);
  check_parameter(is_method(p.method), "resampling_method", int(p.method), "a Method");

  take_neighbor_radius(given, resampling_function, p);
  take(given.normal_filter_radius, p.normal_filter_radius);
  check_parameter(!given.normal_filter_radius || is_positive(p.normal_filter_radius),
                  "normal_filter_radius", p.normal_filter_radius, "a finite length above 0");

  take(given.sharpness_angle, p.sharpness_angle);
  check_parameter(is_positive(p.sharpness_angle) && p.sharpness_angle <= 90, "sharpness_angle",
                  p.sharpness_angle, "an angle in (0, 90] degrees");
  take_count(given.number_of_normal_filter_iterations, "number_of_normal_filter_iterations",
             p.number_of_normal_filter_iterations);
  check_parameter(p.number_of_normal_filter_iterations <= 10000,
                  "number_of_normal_filter_iterations", p.number_of_normal_filter_iterations,
                  "at most 10000");

  take(given.normal_weight, p.normal_weight);
  check_parameter(is_not_negative(p.normal_weight), "normal_weight", p.normal_weight,
                  "a finite number, 0 or above");
  take(given.regularization_weight, p.regularization_weight);
  check_parameter(is_not_negative(p.regularization_weight), "regularization_weight",
                  p.regularization_weight, "a finite number, 0 or above");

  take(given.initial_penalty, p.initial_penalty);
  check_parameter(is_positive(p.initial_penalty), "initial_penalty", p.initial_penalty,
                  "a finite number above 0");
  take(given.maximum_penalty, p.maximum_penalty);
  check_parameter(is_positive(p.maximum_penalty), "maximum_penalty", p.maximum_penalty,
                  "a finite number above 0");
  const Method_rules rules = rules_of(p.method);
  take(given.noise, p.noise);
  check_parameter(!given.noise || is_positive(p.noise), "noise", p.noise,
                  "a finite length above 0");
  check_parameter(!given.noise || rules.estimates_scales, "noise", p.noise,
                  "none but with the default method");
  p.is_noise_given_by_point = given.point_noise_map.value;
  check_parameter(!p.is_noise_given_by_point || rules.estimates_scales, "point_noise_map", "given",
                  "the default method beside it");
  check_parameter(!p.is_noise_given_by_point || !given.noise, "point_noise_map", "given",
                  "no noise beside it");
  p.penalty_growth = rules.penalty_growth;
  take(given.penalty_growth, p.penalty_growth);
  check_parameter(std::isfinite(p.penalty_growth) && p.penalty_growth > 1, "penalty_growth",
                  p.penalty_growth, "a finite number above 1");
  const double number_of_steps = (std::log(p.maximum_penalty) - std::log(p.initial_penalty))
                                 / std::log(p.penalty_growth);
  check_parameter(number_of_steps <= 1e4, "penalty_growth", p.penalty_growth,
                  "a growth that reaches maximum_penalty in 10000 steps");

  bool drops_outliers = rules.drops_outliers || given.outlier_sensitivity;
  take(given.drop_outliers, drops_outliers);
  double sensitivity = 1;
  take(given.outlier_sensitivity, sensitivity);
  check_parameter(sensitivity >= 0 && sensitivity <= largest_outlier_sensitivity,
                  "outlier_sensitivity", sensitivity, "a number in [0, 3]");
  p.outlier_sensitivity = drops_outliers ? sensitivity : 0;

  take(given.keep_density, p.keep_density);
  take_orientation(given, resampling_function, p);
  p.with_feature_confidences = given.feature_confidence_map.value;
  p.with_side_confidences = given.side_confidence_map.value;
  p.with_neighbor_radii = given.neighbor_radius_map.value;
  p.with_noises = given.noise_map.value;
  check_parameter(!p.with_noises || rules.refines, "noise_map", "given",
                  "the default method beside it");
  p.with_deviations = given.position_deviation_map.value || given.normal_deviation_map.value;
  check_parameter(!p.with_deviations || rules.refines,
                  given.position_deviation_map.value ? "position_deviation_map"
                                                     : "normal_deviation_map",
                  "given", "the default method beside it");
  p.with_creases = given.crease_output_iterator.value || given.corner_output_iterator.value;
  const char* const creases = given.crease_output_iterator.value ? "crease_output_iterator"
                                                                 : "corner_output_iterator";
  check_parameter(!p.with_creases || rules.refines, creases, "given",
                  "the default method beside it");
  check_parameter(!p.with_creases || !p.keep_density, creases, "given",
                  "no keep_density beside it, as creases are found by one spacing");
  p.with_outliers = given.outlier_output_iterator.value;

  take(given.random_seed, p.random_seed);
  take(given.maximum_memory, p.maximum_memory);

  double percentage = 50;
  take(given.select_percentage, percentage);
  check_parameter(percentage > 0 && percentage <= 100, "select_percentage", percentage,
                  "a number in (0, 100]");
  p.number_of_output_points =
    n == 0 ? 0 : (std::max)(std::size_t(1), std::size_t(std::floor(double(n) * percentage / 100)));
  take_count(given.number_of_output_points, "number_of_output_points", p.number_of_output_points);
  check_parameter(n < (std::numeric_limits<Index>::max)(), "the number of points", n,
                  "fewer than 2^32 - 1");
  check_parameter(p.number_of_output_points < (std::numeric_limits<Index>::max)(),
                  "number_of_output_points", p.number_of_output_points, "fewer than 2^32 - 1");
  if (n == 0)
    p.number_of_output_points = 0;
  return p;
}

/// The same for `l0_orient_normals()`, which has as many points out as in.
/// \param n number of points that are used
/// \throws std::invalid_argument
inline Parameters checked_orientation_parameters(const Given_parameters& given, std::size_t n)
{
  Parameters p;
  take_neighbor_radius(given, orienting_function, p);
  take_orientation(given, orienting_function, p);
  take(given.maximum_memory, p.maximum_memory);
  check_parameter(n < (std::numeric_limits<Index>::max)(), "the number of points", n,
                  "fewer than 2^32 - 1", orienting_function);
  p.number_of_output_points = n;
  return p;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CHECKED_PARAMETERS_H
