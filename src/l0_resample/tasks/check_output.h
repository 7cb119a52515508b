// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_CHECK_OUTPUT_H
#define L0_RESAMPLE_CHECK_OUTPUT_H

#include "command_line/options.h"

#include <cstdint>
#include <string>

namespace l0_tool {

/// Whether a dry run finds that the folder of a file is missing, which a batch would have made.
bool is_folder_missing(const Options& options, const std::string& path);

/// As `check_writable()`, of the output.
void check_output(const Options& options, std::uint64_t size);

/// Makes a folder of a batch; in a dry run, finds out whether it can be made.
/// \throws Failure with OUTPUT_NOT_WRITTEN
void make_folder(const Task_options& options, const std::string& folder);

} // namespace l0_tool

#endif // L0_RESAMPLE_CHECK_OUTPUT_H
