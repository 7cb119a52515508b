// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_RUN_BATCH_H
#define L0_RESAMPLE_RUN_BATCH_H

#include "basis/Failure.h"
#include "command_line/options.h"

namespace l0_tool {

/// Runs one input after the other, whatever becomes of one, until an interrupt; lists the failures
/// at the end.
/// \returns the status of the program, as `--help` tells it
Exit_status run_batch(const Command& command);

} // namespace l0_tool

#endif // L0_RESAMPLE_RUN_BATCH_H
