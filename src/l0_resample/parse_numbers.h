// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PARSE_NUMBERS_H
#define L0_RESAMPLE_PARSE_NUMBERS_H

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace l0_tool {

/// All of `text` as a number, whatever the locale: "0,5" is none, "nan" and "inf" are. One sign,
/// also "+", is allowed.
template <typename Number>
std::optional<Number> parse_number(std::string_view text)
{
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1);
  Number number;
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(),
                                                        number);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return number;
}

/// Cuts the next word off `line`; empty at its end.
inline std::string_view next_word(std::string_view& line)
{
  constexpr std::string_view blanks = " \t\v\f\r";
  const std::size_t begin = line.find_first_not_of(blanks);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  const std::string_view word = line.substr(begin, line.find_first_of(blanks, begin) - begin);
  line.remove_prefix(begin + word.size());
  return word;
}

/// For a message: short, and without what would disturb a terminal.
inline std::string printable(std::string_view word)
{
  constexpr std::size_t longest = 32;
  std::string text = "'";
  for (const char c : word.substr(0, longest))
    text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > longest ? "...'" : "'");
}

} // namespace l0_tool

#endif // L0_RESAMPLE_PARSE_NUMBERS_H
