// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_MANUAL_H
#define L0_RESAMPLE_MANUAL_H

#include <string>
#include <utility>
#include <vector>

namespace CLI {

class App;

} // namespace CLI

namespace l0_tool {

// Made of the table of options that `add_options()` fills.

/// One page of at most 100 columns: the options in their groups, and examples.
std::string help_text(const CLI::App& app);

/// In the language of man(7).
std::string man_page(const CLI::App& app);

/// A table in HTML of each group of options, for the manual, behind the name of the group in small
/// letters with underscores for blanks.
std::vector<std::pair<std::string, std::string>> option_tables(const CLI::App& app);

/// A script for bash: names of options, choices, files and folders.
std::string bash_completion(const CLI::App& app);

} // namespace l0_tool

#endif // L0_RESAMPLE_MANUAL_H
