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

inline void take(const Given_count& given, std::size_t& target)
{
  if (given.is_given)
    target = given.value;
}

/// \throws std::invalid_argument for a value that is given and not good
template <typename T, typename IsGood>
void check_value(const std::optional<T>& given, const char* name, const IsGood& is_good,
                 const char* expected, const char* function)
{
  if (given)
    check_parameter(is_good(*given), name, *given, expected, function);
}

template <typename IsGood>
void check_value(const Given_count& given, const char* name, const IsGood& is_good,
                 const char* expected, const char* function)
{
  if (!given.is_given)
    return;
  check_parameter(given.refused.empty(), name, given.refused, "a count that is not negative",
                  function);
  check_parameter(is_good(given.value), name, given.value, expected, function);
}

template <typename IsGood>
void check_value(const Given_parameters::Place& given, const char* name, const IsGood& is_good,
                 const char* expected, const char* function)
{
  if (given)
    for (const double coordinate : *given)
      check_parameter(is_good(coordinate), name, coordinate, expected, function);
}

/// \throws std::invalid_argument for a value that no call takes, whatever else is given
inline void check_values(const Given_parameters& given, const char* function)
{
  const auto is_finite = [](double x) { return std::isfinite(x); };
  const auto is_positive = [](double x) { return std::isfinite(x) && x > 0; };
  const auto is_not_negative = [](double x) { return std::isfinite(x) && x >= 0; };

#define CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED)                                          \
  check_value(                                                                                     \
    given.X, #X, [&]([[maybe_unused]] const auto& x) { return IS_GOOD; }, EXPECTED, function);
#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED)                               \
  CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED)
#include <CGAL/L0_resampling/value_parameters.h>
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
  const Given_parameters::Place& place = given.viewpoint ? given.viewpoint : given.up_direction;
  if (place)
    std::copy(place->begin(), place->end(), coordinates);
  if (given.up_direction)
  {
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

/// Checks everything that does not depend on the types of the points.
/// \param n number of points that are used
/// \throws std::invalid_argument
inline Parameters checked_parameters(const Given_parameters& given, std::size_t n)
{
  check_values(given, resampling_function);
  Parameters p;
  take(given.resampling_method, p.method);
  check_parameter(is_method(p.method), "resampling_method", int(p.method), "a Method");
  const Method_rules rules = rules_of(p.method);
  p.penalty_growth = rules.penalty_growth;

#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED) take(given.X, p.X);
#include <CGAL/L0_resampling/value_parameters.h>

  check_parameter(!given.noise || rules.estimates_scales, "noise", p.noise,
                  "none but with the default method");
  p.is_noise_given_by_point = given.point_noise_map.value;
  check_parameter(!p.is_noise_given_by_point || rules.estimates_scales, "point_noise_map", "given",
                  "the default method beside it");
  check_parameter(!p.is_noise_given_by_point || !given.noise, "point_noise_map", "given",
                  "no noise beside it");
  const double number_of_steps = (std::log(p.maximum_penalty) - std::log(p.initial_penalty))
                                 / std::log(p.penalty_growth);
  check_parameter(number_of_steps <= 1e4, "penalty_growth", p.penalty_growth,
                  "a growth that reaches maximum_penalty in 10000 steps");

  bool drops_outliers = rules.drops_outliers || given.outlier_sensitivity;
  take(given.drop_outliers, drops_outliers);
  double sensitivity = 1;
  take(given.outlier_sensitivity, sensitivity);
  p.outlier_sensitivity = drops_outliers ? sensitivity : 0;

  take_viewpoint(given, resampling_function, p);
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

  double percentage = 50;
  take(given.select_percentage, percentage);
  p.number_of_output_points =
    n == 0 ? 0 : (std::max)(std::size_t(1), std::size_t(std::floor(double(n) * percentage / 100)));
  take(given.number_of_output_points, p.number_of_output_points);
  check_parameter(n < (std::numeric_limits<Index>::max)(), "the number of points", n,
                  "fewer than 2^32 - 1");
  if (n == 0)
    p.number_of_output_points = 0;
  return p;
}

/// The same for `l0_orient_normals()`, which has as many points out as in.
/// \param n number of points that are used
/// \throws std::invalid_argument
inline Parameters checked_orientation_parameters(const Given_parameters& given, std::size_t n)
{
  check_values(given, orienting_function);
  Parameters p;
  take(given.neighbor_radius, p.neighbor_radius);
  take(given.number_of_orientation_neighbors, p.number_of_orientation_neighbors);
  take_viewpoint(given, orienting_function, p);
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
