// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_RESAMPLE_H
#define L0_RESAMPLE_RESAMPLE_H

#include "basis/Point_cloud.h"
#include "command_line/options.h"

#include <CGAL/L0_resampling/Report.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// Where the points were seen from, if that is known, beside what the options say.
struct Sides
{
  std::optional<std::array<double, 3>> viewpoint; ///< of all points
  std::vector<Point> viewpoints;                  ///< of each point, or none
};

/// \throws Failure with RUN_TIME_FAILURE if the device cannot be used
void check_device(const Options& options);

/// Within a `catch`: throws what the library has thrown as a Failure, anything else as it is.
/// \param task what was to be done to the points
/// \param name of the input
[[noreturn]] void rethrow_as_failure(const std::string& task, const std::string& name,
                                     std::size_t number_of_points, const Options& options);

/// How many points the options ask for, given so many.
/// \throws Failure with INPUT_REFUSED if these are more than the function can give
std::size_t number_of_output_points(const Options& options, std::size_t number_of_input_points);

/// What a call of `resample()` finds out before it works: radii, and with the default method
/// spacing and noise.
/// \throws Failure as `resample()`
CGAL::L0_resampling::Report estimate_scales(const Point_cloud& cloud, const Options& options);

/// Of each point of the result: 1 if it is on a crease, 2 for a corner, else 0.
std::vector<float> marks_of_creases(const Resampled_points& result);

/*!
Calls `CGAL::l0_resample_point_set()` as the options ask. Points of the result get the properties of
those near them in the cloud, as those of a `CGAL::Point_set_3` do.

\param callback as the named parameter `callback`
\param report filled as far as the call came, also if it throws

\throws Failure with INPUT_REFUSED if the points cannot be resampled, with RUN_TIME_FAILURE if
memory, a solver or a
        device failed
*/
Resampled_points resample(const Point_cloud& cloud, const Sides& sides, const Options& options,
                          const std::function<bool(double)>& callback,
                          CGAL::L0_resampling::Report& report);

} // namespace l0_tool

#endif // L0_RESAMPLE_RESAMPLE_H
