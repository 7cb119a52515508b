// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/option_values.h"

#include "basis/parse_numbers.h"
#include "command_line/command_line.h"
#include "files/Command_output.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace l0_tool {

CLI::Validator number_within(double low, bool low_allowed, double high,
                             const std::string& description)
{
  return CLI::Validator(
    [=](std::string& text) {
      const std::optional<double> number = parse_number<double>(text);
      const bool is_good = number && std::isfinite(*number)
                           && (low_allowed ? *number >= low : *number > low) && *number <= high;
      return is_good ? std::string() : printable(text) + " is not " + description;
    },
    "");
}

CLI::Validator count_within(std::uint64_t low, std::uint64_t high)
{
  return CLI::Validator(
    [=](std::string& text) {
      const std::optional<std::uint64_t> number = parse_number<std::uint64_t>(text);
      const bool is_good = number && *number >= low && *number <= high;
      if (is_good)
        return std::string();
      return printable(text) + " is not a whole number from " + std::to_string(low) + " to "
             + std::to_string(high);
    },
    "");
}

std::array<double, 3> parse_place(const std::string& option, const std::string& text)
{
  return parse_coordinates(text, [&](const std::string& reason) {
    refuse_usage(option + ": " + reason);
  });
}

std::array<double, 3> parse_direction(const std::string& option, const std::string& text)
{
  const std::array<double, 3> direction = parse_place(option, text);
  if (std::all_of(direction.begin(), direction.end(), [](double number) { return number == 0; }))
    refuse_usage(option + ": " + printable(text) + " is not a direction");
  return direction;
}

std::vector<unsigned> parse_classes(const std::string& option, const std::string& text)
{
  constexpr unsigned most = 255;
  std::vector<unsigned> classes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = (std::min)(text.find(',', begin), text.size());
    const std::optional<unsigned> number = parse_number<unsigned>(
      std::string_view(text).substr(begin, end - begin));
    if (!number || *number > most)
      refuse_usage(option + ": " + text + " is not whole numbers from 0 to " + std::to_string(most)
                   + " separated by commas");
    classes.push_back(*number);
    begin = end + 1;
  }
  return classes;
}

std::string parse_decompression(const std::string& option, const std::string& command)
{
  if (command.find(Command_output::placeholder) == std::string::npos)
    refuse_usage(option + ": " + command + " has no {}, which stands for the file");
  return command;
}

} // namespace l0_tool
