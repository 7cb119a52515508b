// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_WARNINGS_H
#define CGAL_L0_RESAMPLING_WARNINGS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// Why a result cannot be good, see `warnings()`.
enum class Warning
{
  MANY_OUTLIERS,   ///< more than 1 % of the points were left out as outliers
  SHRUNKEN_EXTENT, ///< `Report::extent_share` is below 95 %
  SMALL_RADIUS,    ///< more than a quarter of the points have a degenerate neighborhood
  /// more than 5 % of the samples have no original neighbor or no compatible one
  UNSUPPORTED_SAMPLES,
  /// around more than 10 % of the samples the points scatter more than those of one surface with
  /// the estimated noise do
  UNEXPLAINED_POINTS,
};

namespace internal {

constexpr double maximum_share_of_outliers = 0.01, minimum_extent_share = 0.95;
constexpr double maximum_share_of_degenerate_neighborhoods = 0.25,
                 maximum_share_of_lonely_samples = 0.05, maximum_share_of_unexplained_samples = 0.1;

inline double share_of(std::size_t part, std::size_t whole)
{
  return double(part) / (std::max)(double(whole), 1.);
}

inline double share_of_degenerate_neighborhoods(const Report& report)
{
  return share_of(report.number_of_degenerate_neighborhoods,
                  report.number_of_input_points - report.number_of_outliers);
}

/// A share as a percentage, rounded down so that no part is called all.
inline std::string as_percentage(double share)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", std::floor(1000 * share) / 10);
  return text;
}

inline std::string in_digits(double number, int digits)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, number);
  return text;
}

inline std::string three_digits(double length) { return in_digits(length, 3); }

/// A ball, its center with as many digits as tell it from one whose center is a tenth of the radius
/// off.
inline std::string as_place(const std::array<double, 3>& center, double radius)
{
  std::string text = "within " + three_digits(radius) + " of (";
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double radii = std::abs(center[axis]) / radius,
                 digits = 2 + std::ceil(std::log10((std::max)(radii, 1.)));
    text += (axis > 0 ? ", " : "") + in_digits(center[axis], int((std::min)(digits, 17.)));
  }
  return text + ")";
}

} // namespace internal

/// \ingroup PkgL0ResamplingRef
/// The largest `normal_weight` that the default method has a use for: a call with a larger one,
/// which gave this report, has the same result. Infinite if there was no iteration.
inline double largest_effective_normal_weight(const Report& report)
{
  if (report.iterations.empty())
    return std::numeric_limits<double>::infinity();
  const double maximum_jump = internal::minimum_height_between_sheets
                              * internal::sheet_height(report.estimated_noise,
                                                       report.neighbor_radius);
  const double jumps = maximum_jump / (internal::sparsity_unit_factor * report.neighbor_radius);
  return report.iterations.back().penalty * jumps * jumps;
}

/*!
\ingroup PkgL0ResamplingRef

What `report` says about a result that cannot be good, in the order of `Warning`; nothing if no
result was written. The tool and the Python package say the same, as they ask this function.
*/
inline std::vector<Warning> warnings(const Report& report)
{
  std::vector<Warning> found;
  const auto add_if = [&](bool holds, Warning warning) {
    if (holds)
      found.push_back(warning);
  };
  if (report.number_of_output_points == 0)
    return found;
  add_if(internal::share_of(report.number_of_outliers, report.number_of_input_points)
           > internal::maximum_share_of_outliers,
         Warning::MANY_OUTLIERS);
  add_if(report.extent_share < internal::minimum_extent_share, Warning::SHRUNKEN_EXTENT);
  add_if(internal::share_of_degenerate_neighborhoods(report)
           > internal::maximum_share_of_degenerate_neighborhoods,
         Warning::SMALL_RADIUS);
  add_if(internal::share_of(report.number_of_lonely_samples, report.number_of_output_points)
           > internal::maximum_share_of_lonely_samples,
         Warning::UNSUPPORTED_SAMPLES);
  add_if(internal::share_of(report.number_of_unexplained_samples, report.number_of_output_points)
           > internal::maximum_share_of_unexplained_samples,
         Warning::UNEXPLAINED_POINTS);
  return found;
}

/// \ingroup PkgL0ResamplingRef
/// The name of a warning for programs, such as `"many_outliers"`.
inline std::string name_of(Warning warning)
{
  switch (warning)
  {
  case Warning::MANY_OUTLIERS: return "many_outliers";
  case Warning::SHRUNKEN_EXTENT: return "shrunken_extent";
  case Warning::SMALL_RADIUS: return "small_radius";
  case Warning::UNSUPPORTED_SAMPLES: return "unsupported_samples";
  case Warning::UNEXPLAINED_POINTS: return "unexplained_points";
  }
  return "";
}

/// \ingroup PkgL0ResamplingRef
/// A warning in one line of English, with the numbers of the report.
inline std::string message_of(Warning warning, const Report& report)
{
  using namespace internal;
  switch (warning)
  {
  case Warning::MANY_OUTLIERS:
    return as_percentage(share_of(report.number_of_outliers, report.number_of_input_points))
           + " of the points were left out as outliers, which outlier_output_iterator tells, and "
             "--outliers of the tool";
  case Warning::SHRUNKEN_EXTENT:
    return "the result has " + as_percentage(report.extent_share) + " of the extent of the input";
  case Warning::SMALL_RADIUS:
    return as_percentage(share_of_degenerate_neighborhoods(report))
           + " of the points have fewer than six points, or points on a line only, within the "
             "radius, which is "
           + three_digits(report.neighbor_radius)
           + "; a larger neighbor_radius, on scan lines one that reaches the next, may be better";
  case Warning::UNSUPPORTED_SAMPLES:
    return as_percentage(share_of(report.number_of_lonely_samples, report.number_of_output_points))
           + " of the result has no compatible input points near it";
  case Warning::UNEXPLAINED_POINTS:
    return "around "
           + as_percentage(
             share_of(report.number_of_unexplained_samples, report.number_of_output_points))
           + " of the result"
           + (report.unexplained_radius > 0
                ? ", as " + as_place(report.unexplained_center, report.unexplained_radius) + ","
                : std::string())
           + " the points scatter more than those of one surface with a noise of "
           + three_digits(report.estimated_noise)
           + " do: sheets may have become one, which a smaller neighbor_radius keeps apart";
  }
  return "";
}

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_WARNINGS_H
