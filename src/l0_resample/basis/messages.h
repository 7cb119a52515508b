// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_MESSAGES_H
#define L0_RESAMPLE_MESSAGES_H

#include <string>
#include <vector>

namespace l0_tool {

/// The text with '?' for each control character, as names of files may have them: a line stays one
/// line, and says nothing to a terminal.
std::string on_one_line(std::string text);

/// A line on standard error; nothing if there is no error.
void print_error(const std::string& error);

void print_notes(const std::vector<std::string>& notes);
void print_warnings(const std::vector<std::string>& warnings);

} // namespace l0_tool

#endif // L0_RESAMPLE_MESSAGES_H
