// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_RUN_H
#define L0_RESAMPLE_RUN_H

#include "basis/Failure.h"
#include "command_line/options.h"
#include "tasks/report_json.h"

#include <functional>
#include <string>

namespace l0_tool {

/// Runs the function and keeps in the record how it ended.
void guarded(Run_record& record, const std::function<void()>& function);

/// Reads, resamples or converts, and writes, and throws nothing: how it ended is in the record.
Run_record run(const Options& options);

/// The summary of a run that went well, and warnings.
void print_outcome(const Options& options, Run_record& record);

void write_text(const std::string& path, const std::string& text);

/// Runs one input after the other, whatever becomes of one, until an interrupt; lists the failures
/// at the end.
/// \returns the status of the program, as `--help` tells it
Exit_status run_batch(const Command& command);

} // namespace l0_tool

#endif // L0_RESAMPLE_RUN_H
