// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_DESCRIBE_H
#define L0_RESAMPLE_DESCRIBE_H

#include "basis/Point_cloud.h"
#include "command_line/options.h"

#include <string>

namespace l0_tool {

/// What `--info` prints, a line for each fact: what the file holds, spacing and noise of its
/// points, and what a run with these options would choose.
/// \throws Failure if the points cannot be resampled
std::string describe(const Point_cloud& cloud, const Options& options);

} // namespace l0_tool

#endif // L0_RESAMPLE_DESCRIBE_H
