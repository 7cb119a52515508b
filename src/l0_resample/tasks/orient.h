// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_ORIENT_H
#define L0_RESAMPLE_ORIENT_H

#include "basis/Point_cloud.h"
#include "command_line/options.h"
#include "tasks/resample.h"

#include <CGAL/L0_resampling/Report.h>

#include <functional>

namespace l0_tool {

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

#endif // L0_RESAMPLE_ORIENT_H
