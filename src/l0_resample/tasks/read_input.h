// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_READ_INPUT_H
#define L0_RESAMPLE_READ_INPUT_H

#include "basis/Point_cloud.h"
#include "command_line/options.h"
#include "files/Input_file.h"
#include "tasks/report_json.h"

namespace l0_tool {

/// Reads the input with all properties, as the options ask, and puts down what there is to say.
/// \throws Failure as `read_points()`
Point_cloud read_input(const Options& options, bool with_normals,
                       Input_file::On_progress on_progress, Run_record& record);

} // namespace l0_tool

#endif // L0_RESAMPLE_READ_INPUT_H
