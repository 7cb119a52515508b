// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Text_columns.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"

#include <CGAL/L0_resampling/internal/core/attribute_kinds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace l0_tool {
namespace {

constexpr std::array<std::string_view, 6> coordinates = {"x", "y", "z", "nx", "ny", "nz"};
constexpr std::size_t left_out = coordinates.size(), first_property_target = left_out + 1;

bool is_left_out(const std::string& name) { return name == "-" || name == "_"; }

bool is_name(const std::string& name)
{
  const auto is_visible = [](char c) { return c > ' ' && c <= '~'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), is_visible);
}

[[noreturn]] void refuse(const std::string& list, const std::string& what)
{
  throw Failure(WRONG_USAGE, "--columns " + list + ": " + what);
}

} // namespace

Column_names parse_column_names(const std::string& list)
{
  const std::vector<std::string_view> parts = split_at_commas(list);
  const Column_names names(parts.begin(), parts.end());
  if (names.size() > max_number_of_columns)
    throw Failure(WRONG_USAGE, "--columns: more names than a file can have properties");
  const auto begin = names.begin(), end = names.end();
  const auto count = [&](std::string_view name) { return std::count(begin, end, name); };
  for (const std::string& name : names) {
    if (!is_name(name))
      refuse(list, printable(name) + " is not a name");
    if (!is_left_out(name) && count(name) > 1)
      refuse(list, printable(name) + " is there twice");
  }
  if (count("x") + count("y") + count("z") != 3)
    refuse(list, "x, y and z have to be among the names");
  const auto normal_coordinates = count("nx") + count("ny") + count("nz");
  if (normal_coordinates != 0 && normal_coordinates != 3)
    refuse(list, "a normal needs nx, ny and nz");
  return names;
}

void Text_columns::Numbers::add(double number)
{
  are_whole = are_whole && std::floor(number) == number && std::isfinite(number);
  lowest = (std::min)(lowest, number);
  highest = (std::max)(highest, number);
}

bool Text_columns::Numbers::lie_within(double low, double high) const
{
  return are_whole && lowest >= low && highest <= high;
}

Text_columns::Text_columns(const Column_names& names, Point_collector& collector)
  : m_collector(collector)
{
  for (const std::string& name : names) {
    const auto found = std::find(coordinates.begin(), coordinates.end(), name);
    std::size_t target = std::size_t(found - coordinates.begin());
    if (target == left_out && !is_left_out(name) && collector.wants_properties()) {
      target = first_property_target + collector.add_property(name, Number_type::FLOAT64);
      m_numbers.push_back({CGAL::L0_resampling::internal::is_color_channel(name)});
    }
    m_targets.push_back(target);
  }
  if (std::find(names.begin(), names.end(), "nx") != names.end())
    collector.set_has_normals();
}

void Text_columns::read(const Input_file& file, const std::vector<std::string_view>& words)
{
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  Point_row row = {};
  for (std::size_t k = 0; k < m_targets.size(); ++k) {
    if (m_targets[k] == left_out)
      continue;
    const std::optional<double> number = words[k].empty() ? missing
                                                          : parse_number<double>(words[k]);
    if (!number)
      file.refuse(printable(words[k]) + " is not a number");
    if (m_targets[k] < left_out) {
      row[m_targets[k]] = *number;
      continue;
    }
    const std::size_t property = m_targets[k] - first_property_target;
    m_numbers[property].add(*number);
    encode(*number, Number_type::FLOAT64, m_collector.property(property));
  }
  m_collector.add(row);
}

void Text_columns::choose_types()
{
  using Int = std::numeric_limits<std::int32_t>;
  using Unsigned_int = std::numeric_limits<std::uint32_t>;
  const auto is_no_byte = [](const Numbers& n) { return n.is_channel && !n.lie_within(0, 255); };
  const bool are_bytes = std::none_of(m_numbers.begin(), m_numbers.end(), is_no_byte);
  std::vector<Number_type> types;
  for (const Numbers& numbers : m_numbers)
    if (numbers.is_channel)
      types.push_back(are_bytes ? Number_type::UINT8 : Number_type::FLOAT64);
    else if (numbers.lie_within(Int::lowest(), (Int::max)()))
      types.push_back(Number_type::INT32);
    else if (numbers.lie_within(0, (Unsigned_int::max)()))
      types.push_back(Number_type::UINT32);
    else
      types.push_back(Number_type::FLOAT64);
  m_collector.set_types(types);
}

} // namespace l0_tool
