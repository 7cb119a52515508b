// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TILE_DESCRIPTION_H
#define L0_RESAMPLE_TILE_DESCRIPTION_H

#include "command_line/options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace l0_tool {

/// Whether samples get the properties of the points: if a format that is written has places for
/// some.
bool carries_properties(const Command& command);

/// All that the result of a run of `--as-one` depends on, one line for each thing: the program, its
/// sources and compiler, the instructions it uses, options, and the files with formats,
/// sizes and times.
/// \throws Failure with INPUT_REFUSED if a file is not there
std::string describe_run(const Command& command);

/// A number that differs for runs that differ, but for accidents.
std::uint64_t key_of_run(const std::string& description);

/// Of the run that is noted in a file; empty if there is none.
std::string read_description(const std::string& path);

/// Of the run that has written this index at its end; empty if there is none.
std::string read_finished(const std::string& index);

/// \throws Failure that says what differs: with INPUT_REFUSED for an input, with WRONG_USAGE for
/// anything else
void check_same_run(const std::string& old, const std::string& now);

/// The files of the tiles that a run has written to this folder, as its index says.
std::vector<std::string> tiles_of_finished(const std::string& folder);

/// Removes what a run has left in a folder, and nothing else.
void remove_run(const std::string& folder);

} // namespace l0_tool

#endif // L0_RESAMPLE_TILE_DESCRIPTION_H
