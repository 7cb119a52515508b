// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TEXT_CELLS_H
#define L0_RESAMPLE_TEXT_CELLS_H

#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {

/// Of a line of a text.
using Cells = std::vector<std::string_view>;

/// The one that the line has most of outside quotes, or a blank: then any number of them separates
/// two cells.
char find_separator(std::string_view line, bool has_decimal_commas);

/// Finds the cells of a line, without their quotes and blanks.
/// \returns what is wrong with the line, or nothing
std::string split_cells(std::string_view line, char separator, Cells& cells);

} // namespace l0_tool

#endif // L0_RESAMPLE_TEXT_CELLS_H
