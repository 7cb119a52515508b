// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_CONVERT_H
#define L0_RESAMPLE_CONVERT_H

#include "command_line/options.h"
#include "files/Input_file.h"
#include "tasks/report_json.h"

namespace l0_tool {

/// Writes the points of the input as they are, with all their properties that the format of the
/// output can hold; the record warns of others.
/// \throws Failure, as `read_points()` and `write_points()`
void convert_file(const Options& options, Input_file::On_progress on_progress, Run_record& record);

} // namespace l0_tool

#endif // L0_RESAMPLE_CONVERT_H
