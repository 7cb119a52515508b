// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PARSE_NUMBERS_H
#define L0_RESAMPLE_PARSE_NUMBERS_H

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

namespace l0_tool {

/// Whether digits of a number beyond the range of its type say that it is nearly 0.
inline bool is_tiny(std::string_view number)
{
  const std::size_t exponent = number.find_first_of("eE");
  if (exponent != std::string_view::npos)
    return number.substr(exponent + 1, 1) == "-";
  return number.find_first_not_of("-0") == number.find('.');
}

/// What the run-time library of Visual C++ once wrote for NaN: 1.#QNAN, 1.#IND and the like.
inline bool is_old_nan(std::string_view number)
{
  if (number.substr(0, 1) == "-")
    number.remove_prefix(1);
  return number.substr(0, 3) == "1.#" && number.substr(3, 3) != "INF";
}

/// All of `text` as a number, whatever the locale: "0,5" is none, "nan" and "inf" are. One sign,
/// also "+", is allowed. What is nearer to 0 than any number of the type is 0.
template <typename Number>
std::optional<Number> parse_number(std::string_view text)
{
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1);
  Number number;
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, number);
  if (result.ec == std::errc() && result.ptr == end)
    return number;
  if constexpr (std::is_floating_point<Number>::value) {
    if (result.ec == std::errc::result_out_of_range && result.ptr == end && is_tiny(text))
      return Number(0);
    if (is_old_nan(text))
      return std::numeric_limits<Number>::quiet_NaN();
  }
  return std::nullopt;
}

/// What separates words.
constexpr std::string_view blanks = " \t\v\f\r";

/// Without the blanks at both ends.
inline std::string_view trimmed(std::string_view text)
{
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// With the small letters of ASCII in place of the capital ones.
inline std::string lower_case(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return result;
}

/// Cuts the next word off `line`; empty at its end.
inline std::string_view next_word(std::string_view& line)
{
  const std::size_t begin = line.find_first_not_of(blanks);
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  const std::string_view word = line.substr(begin, line.find_first_of(blanks, begin) - begin);
  line.remove_prefix(begin + word.size());
  return word;
}

/// All words of a line, in place of those before.
inline void split_words(std::string_view line, std::vector<std::string_view>& words)
{
  words.clear();
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line))
    words.push_back(word);
}

/// What stands between the commas of a text, one more than these.
inline std::vector<std::string_view> split_at_commas(std::string_view text)
{
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(','); end != std::string_view::npos; end = text.find(',')) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

inline bool is_empty_or_comment(std::string_view line)
{
  const std::string_view word = next_word(line);
  return word.empty() || word[0] == '#';
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

/// What a refusal says of a word in a file of a format that has no decimal commas.
inline std::string no_number(std::string_view word)
{
  const std::size_t comma = word.find(',');
  const bool has_decimal_comma = comma != std::string_view::npos && comma + 1 < word.size();
  return printable(word) + " is not a number"
         + (has_decimal_comma ? "; XYZ and CSV alone have decimal commas, by --decimal-comma" : "");
}

/// The first three words as coordinates; none if they are fewer, or not all finite numbers.
template <typename Word>
std::optional<std::array<double, 3>> first_coordinates(const std::vector<Word>& words)
{
  std::array<double, 3> coordinates;
  if (words.size() < coordinates.size())
    return std::nullopt;
  for (std::size_t axis = 0; axis < coordinates.size(); ++axis) {
    const std::optional<double> number = parse_number<double>(trimmed(words[axis]));
    if (!number || !std::isfinite(*number))
      return std::nullopt;
    coordinates[axis] = *number;
  }
  return coordinates;
}

/// All of a text, with commas in it, as the coordinates of a point or a direction.
/// \param refuse is called with the reason if it is something else than three finite numbers, and
/// does not return
template <typename Refuse>
std::array<double, 3> parse_coordinates(std::string_view text, const Refuse& refuse)
{
  const std::vector<std::string_view> words = split_at_commas(text);
  const std::optional<std::array<double, 3>> coordinates = first_coordinates(words);
  if (!coordinates || words.size() > coordinates->size())
    refuse(printable(text) + " is not three numbers separated by commas");
  return *coordinates;
}

} // namespace l0_tool

#endif // L0_RESAMPLE_PARSE_NUMBERS_H
