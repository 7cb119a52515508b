// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_CHECK_PATHS_H
#define L0_RESAMPLE_CHECK_PATHS_H

#include "command_line/options.h"

#include <string>

namespace l0_tool {

/*!
Refuses, as the parser does, to write two things to one file, or anything over a file that is read;
but INPUT and OUTPUT of one run may be one file.

\param config the file that options come from; empty for none
*/
void check_paths(const Command& command, const std::string& config);

} // namespace l0_tool

#endif // L0_RESAMPLE_CHECK_PATHS_H
