// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/text_cells.h"

#include "basis/parse_numbers.h"
#include "formats/Named_columns.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace l0_tool {
namespace {

/// Cuts a cell in quotes off `line`; nothing if it does not end.
std::optional<std::string_view> take_quoted_cell(std::string_view& line)
{
  std::size_t end = line.find('"', 1);
  while (end != std::string_view::npos && line.substr(end + 1, 1) == "\"")
    end = line.find('"', end + 2); // two of them stand for one
  if (end == std::string_view::npos)
    return std::nullopt;
  const std::string_view cell = line.substr(1, end - 1);
  line.remove_prefix(end + 1);
  return cell;
}

} // namespace

char find_separator(std::string_view line, bool has_decimal_commas)
{
  const bool has_quotes = line.find('"') != std::string_view::npos;
  std::string candidates = ";\t";
  if (!has_decimal_commas || has_quotes)
    candidates += ',';
  std::array<std::size_t, 3> counts = {};
  bool is_quoted = false;
  for (const char c : line) {
    is_quoted = is_quoted != (c == '"');
    const std::size_t k = candidates.find(c);
    if (!is_quoted && k != std::string::npos)
      ++counts[k];
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return *most == 0 ? ' ' : candidates[std::size_t(most - counts.begin())];
}

std::string split_cells(std::string_view line, char separator, Cells& cells)
{
  if (separator == ' ' && line.find('"') == std::string_view::npos) {
    split_words(line, cells);
    return cells.size() > max_number_of_columns
             ? "more than " + std::to_string(max_number_of_columns) + " columns"
             : "";
  }
  cells.clear();
  line = separator == '\t' ? line : trimmed(line);
  for (;;) {
    line.remove_prefix((std::min)(line.find_first_not_of(' '), line.size()));
    std::optional<std::string_view> quoted;
    if (line.substr(0, 1) == "\"") {
      quoted = take_quoted_cell(line);
      if (!quoted)
        return "a cell in quotes does not end in its line";
    }
    const std::size_t end = line.find(separator);
    const std::string_view plain = trimmed(line.substr(0, end));
    if (quoted && !plain.empty())
      return printable(plain) + " stands behind a cell in quotes";
    if (cells.size() == max_number_of_columns)
      return "more than " + std::to_string(max_number_of_columns) + " columns";
    cells.push_back(quoted.value_or(plain));
    if (end == std::string_view::npos)
      return "";
    line.remove_prefix(end + 1);
  }
}

} // namespace l0_tool
