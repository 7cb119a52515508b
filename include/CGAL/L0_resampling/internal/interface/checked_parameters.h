// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CHECKED_PARAMETERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_CHECKED_PARAMETERS_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/plan/Method_rules.h>
#include <CGAL/L0_resampling/named_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What messages say of whom the parameters are.
constexpr const char* resampling_function = "l0_resample_point_set";
constexpr const char* orienting_function = "l0_orient_normals";

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

template <typename T>
struct Is_optional : std::false_type
{};
template <typename T>
struct Is_optional<std::optional<T>> : std::true_type
{};

/// Calls `use` with a copy of the named parameter if the caller gave it: as a value, or as a
/// `std::optional` that has one. The latter is for programs that learn at run time what is given,
/// where the names of a chain are known to the compiler. Never binds a reference: that would
/// outlive its value.
template <typename NamedParameters, typename Tag, typename F>
void if_given(const NamedParameters& np, Tag tag, const F& use)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, Tag>::value)
  {
    const auto value = parameters::get_parameter(np, tag);
    if constexpr (!Is_optional<std::decay_t<decltype(value)>>::value)
      use(value);
    else if (value)
      use(*value);
  }
  else
  {
    static_cast<void>(np);
    static_cast<void>(use);
  }
}

template <typename NamedParameters, typename Tag>
bool is_given(const NamedParameters& np, Tag tag)
{
  bool is = false;
  if_given(np, tag, [&](const auto&) { is = true; });
  return is;
}

/// Copies the named parameter to `target` if the caller gave it.
template <typename NamedParameters, typename Tag, typename T>
void read_parameter(const NamedParameters& np, Tag tag, T& target)
{
  if_given(np, tag, [&](const auto& value) { target = static_cast<T>(value); });
}

/// The report that the caller wants to be filled, reset; else `unwanted`.
template <typename NamedParameters>
Report& report_of_call(const NamedParameters& np, Report& unwanted)
{
  Report* report = &unwanted;
  read_parameter(np, internal_np::resampling_report, report);
  *report = Report();
  return *report;
}

/// A count, which callers may pass as any number type; `target` stays as it is if they do not.
template <typename NamedParameters, typename Tag>
void read_count(const NamedParameters& np, Tag tag, const char* name, std::size_t& target,
                const char* function = resampling_function)
{
  if_given(np, tag, [&](const auto& value) {
    check_parameter(!(value < 0)
                      && double(value) <= double((std::numeric_limits<std::size_t>::max)() / 2),
                    name, value, "a count that is not negative", function);
    target = std::size_t(value);
  });
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

template <typename NamedParameters>
Given_sides given_sides(const NamedParameters& np)
{
  return {is_given(np, internal_np::viewpoint), is_given(np, internal_np::up_direction),
          is_given(np, internal_np::viewpoint_map),
          is_given(np, internal_np::orientation_hint_map)};
}

/// Reads what all points were seen from.
template <typename NamedParameters>
void read_viewpoint(const NamedParameters& np, const char* function, Parameters& p)
{
  const Given_sides sides = given_sides(np);
  sides.check_at_most_one(function);
  p.hints_are_viewpoints = sides.viewpoint_map;
  const auto read = [&](const char* name, const auto& coordinates) {
    p.has_viewpoint = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      p.viewpoint.coordinates[axis] = double(coordinates[axis]);
      check_parameter(std::isfinite(p.viewpoint.coordinates[axis]), name,
                      p.viewpoint.coordinates[axis], "three finite coordinates", function);
    }
  };
  if_given(np, internal_np::viewpoint, [&](const auto& place) { read("viewpoint", place); });
  if_given(np, internal_np::up_direction, [&](const auto& direction) {
    read("up_direction", direction);
    p.viewpoint.weight = 0;
    double(&up)[3] = p.viewpoint.coordinates;
    const double largest = (std::max)({std::abs(up[0]), std::abs(up[1]), std::abs(up[2])});
    check_parameter(largest > 0, "up_direction", "0, 0, 0", "a direction", function);
    const double length = std::hypot(up[0] / largest, up[1] / largest, up[2] / largest);
    for (double& coordinate : up)
      coordinate = coordinate / largest / length;
  });
}

/// Reads the radius of a neighborhood.
template <typename NamedParameters>
void read_neighbor_radius(const NamedParameters& np, const char* function, Parameters& p)
{
  const bool is_there = is_given(np, internal_np::neighbor_radius);
  read_parameter(np, internal_np::neighbor_radius, p.neighbor_radius);
  check_parameter(!is_there || (std::isfinite(p.neighbor_radius) && p.neighbor_radius > 0),
                  "neighbor_radius", p.neighbor_radius, "a finite length above 0", function);
}

/// Reads what says how normals get their side.
template <typename NamedParameters>
void read_orientation(const NamedParameters& np, const char* function, Parameters& p)
{
  read_viewpoint(np, function, p);
  read_count(np, internal_np::number_of_orientation_neighbors, "number_of_orientation_neighbors",
             p.number_of_orientation_neighbors, function);
  check_parameter(
    p.number_of_orientation_neighbors >= 3 && p.number_of_orientation_neighbors <= 1000,
    "number_of_orientation_neighbors", p.number_of_orientation_neighbors, "3 to 1000", function);
}

/// Reads and checks everything that does not depend on the types of the points.
/// \param n number of points that are used
/// \throws std::invalid_argument
template <typename NamedParameters>
Parameters checked_parameters(const NamedParameters& np, std::size_t n)
{
  Parameters p;
  const auto is_positive = [](double x) { return std::isfinite(x) && x > 0; };
  const auto is_not_negative = [](double x) { return std::isfinite(x) && x >= 0; };

  read_parameter(np, internal_np::resampling_method, p.method);
  check_parameter(is_method(p.method), "resampling_method", int(p.method), "a Method");

  read_neighbor_radius(np, resampling_function, p);
  const bool has_filter_radius = is_given(np, internal_np::normal_filter_radius);
  read_parameter(np, internal_np::normal_filter_radius, p.normal_filter_radius);
  check_parameter(!has_filter_radius || is_positive(p.normal_filter_radius), "normal_filter_radius",
                  p.normal_filter_radius, "a finite length above 0");

  read_parameter(np, internal_np::sharpness_angle, p.sharpness_angle);
  check_parameter(is_positive(p.sharpness_angle) && p.sharpness_angle <= 90, "sharpness_angle",
                  p.sharpness_angle, "an angle in (0, 90] degrees");
  read_count(np, internal_np::number_of_normal_filter_iterations,
             "number_of_normal_filter_iterations", p.number_of_normal_filter_iterations);
  check_parameter(p.number_of_normal_filter_iterations <= 10000,
                  "number_of_normal_filter_iterations", p.number_of_normal_filter_iterations,
                  "at most 10000");

  read_parameter(np, internal_np::normal_weight, p.normal_weight);
  check_parameter(is_not_negative(p.normal_weight), "normal_weight", p.normal_weight,
                  "a finite number, 0 or above");
  read_parameter(np, internal_np::regularization_weight, p.regularization_weight);
  check_parameter(is_not_negative(p.regularization_weight), "regularization_weight",
                  p.regularization_weight, "a finite number, 0 or above");

  read_parameter(np, internal_np::initial_penalty, p.initial_penalty);
  check_parameter(is_positive(p.initial_penalty), "initial_penalty", p.initial_penalty,
                  "a finite number above 0");
  read_parameter(np, internal_np::maximum_penalty, p.maximum_penalty);
  check_parameter(is_positive(p.maximum_penalty), "maximum_penalty", p.maximum_penalty,
                  "a finite number above 0");
  const Method_rules rules = rules_of(p.method);
  p.penalty_growth = rules.penalty_growth;
  read_parameter(np, internal_np::penalty_growth, p.penalty_growth);
  check_parameter(std::isfinite(p.penalty_growth) && p.penalty_growth > 1, "penalty_growth",
                  p.penalty_growth, "a finite number above 1");
  const double number_of_steps = (std::log(p.maximum_penalty) - std::log(p.initial_penalty))
                                 / std::log(p.penalty_growth);
  check_parameter(number_of_steps <= 1e4, "penalty_growth", p.penalty_growth,
                  "a growth that reaches maximum_penalty in 10000 steps");

  bool drops_outliers = rules.drops_outliers || is_given(np, internal_np::outlier_sensitivity);
  read_parameter(np, internal_np::drop_outliers, drops_outliers);
  double sensitivity = 1;
  read_parameter(np, internal_np::outlier_sensitivity, sensitivity);
  check_parameter(sensitivity >= 0 && sensitivity <= largest_outlier_sensitivity,
                  "outlier_sensitivity", sensitivity, "a number in [0, 3]");
  p.outlier_sensitivity = drops_outliers ? sensitivity : 0;

  read_parameter(np, internal_np::keep_density, p.keep_density);
  read_orientation(np, resampling_function, p);
  p.with_feature_confidences = is_given(np, internal_np::feature_confidence_map);
  p.with_side_confidences = is_given(np, internal_np::side_confidence_map);
  p.with_neighbor_radii = is_given(np, internal_np::neighbor_radius_map);
  p.with_noises = is_given(np, internal_np::noise_map);
  check_parameter(!p.with_noises || rules.refines, "noise_map", "given",
                  "the default method beside it");

  read_parameter(np, internal_np::random_seed, p.random_seed);
  read_parameter(np, internal_np::maximum_memory, p.maximum_memory);

  double percentage = 50;
  read_parameter(np, internal_np::select_percentage, percentage);
  check_parameter(percentage > 0 && percentage <= 100, "select_percentage", percentage,
                  "a number in (0, 100]");
  p.number_of_output_points =
    n == 0 ? 0 : (std::max)(std::size_t(1), std::size_t(std::floor(double(n) * percentage / 100)));
  read_count(np, internal_np::number_of_output_points, "number_of_output_points",
             p.number_of_output_points);
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
template <typename NamedParameters>
Parameters checked_orientation_parameters(const NamedParameters& np, std::size_t n)
{
  Parameters p;
  read_neighbor_radius(np, orienting_function, p);
  read_orientation(np, orienting_function, p);
  read_parameter(np, internal_np::maximum_memory, p.maximum_memory);
  check_parameter(n < (std::numeric_limits<Index>::max)(), "the number of points", n,
                  "fewer than 2^32 - 1", orienting_function);
  p.number_of_output_points = n;
  return p;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CHECKED_PARAMETERS_H
