// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_RUN_AS_ONE_H
#define L0_RESAMPLE_RUN_AS_ONE_H

#include "basis/Failure.h"
#include "command_line/options.h"

namespace l0_tool {

/// Resamples all files as parts of one cloud; or does a single task of that.
Exit_status run_as_one(const Command& command);

} // namespace l0_tool

#endif // L0_RESAMPLE_RUN_AS_ONE_H
