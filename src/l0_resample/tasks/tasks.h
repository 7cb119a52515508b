// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TASKS_H
#define L0_RESAMPLE_TASKS_H

#include "basis/Point_cloud.h"
#include "command_line/options.h"
#include "files/Input_file.h"
#include "formats/read_points.h"
#include "tasks/report_json.h"
#include "tasks/resample.h"

#include <CGAL/L0_resampling/Report.h>

#include <functional>
#include <string>

// What a run does with an input, but for resampling it.

namespace l0_tool {

/// What the options ask of a reader.
Read_options read_options_of(const Options& options);

/// Reads the input with all properties, as the options ask, and puts down what there is to say.
/// \throws Failure as `read_points()`
Point_cloud read_input(const Options& options, bool with_normals,
                       Input_file::On_progress on_progress, Run_record& record);

/// Writes the points of the input as they are, with all their properties that the format of the
/// output can hold; the record warns of others.
/// \throws Failure, as `read_points()` and `write_points()`
void convert_file(const Options& options, Input_file::On_progress on_progress, Run_record& record);

/// What `--info` prints, a line for each fact: what the file holds, spacing and noise of its
/// points, and what a run with these options would choose.
/// \throws Failure if the points cannot be resampled
std::string describe(const Point_cloud& cloud, const Options& options);

/*!
Calls `CGAL::l0_orient_normals()` as the options ask. A cloud without normals gets estimated ones.

\param callback as the named parameter `callback`
\param report filled as far as the call came, also if it throws

\throws Failure with INPUT_REFUSED if the normals cannot be oriented as asked for, with
        RUN_TIME_FAILURE if memory or the device does not suffice
*/
void orient(const Sides& sides, const Options& options, const std::function<bool(double)>& callback,
            Point_cloud& cloud, CGAL::L0_resampling::Report& report);

} // namespace l0_tool

#endif // L0_RESAMPLE_TASKS_H
