// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Property_values.h"

#include <CGAL/L0_resampling/Near_points.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace l0_tool {
namespace {

constexpr std::size_t most_labels = 256, least_points_of_label = 10;

} // namespace

bool may_be_rounded(double lowest, double highest)
{
  constexpr double largest_exact = 9007199254740992.; // 2^53
  return lowest < -largest_exact || highest > largest_exact;
}

void Property_values::Extreme::add(double other)
{
  if (side * other > side * value) {
    next_value = value;
    value = other;
    number = 0;
  }
  if (other == value)
    ++number;
  else if (side * other > side * next_value)
    next_value = other;
}

void Property_values::Values::add(double value)
{
  if (!std::isfinite(value)) {
    are_finite = false;
    return;
  }
  ++number;
  are_whole = are_whole && std::floor(value) == value;
  lowest.add(value);
  highest.add(value);
  if (different.size() > most_labels)
    return;
  const auto place = std::lower_bound(different.begin(), different.end(), value);
  if (place == different.end() || *place != value)
    different.insert(place, value);
}

bool Property_values::Values::are_whole_within(double low, double high) const
{
  return are_whole && are_finite && lowest.value >= low && highest.value <= high;
}

bool Property_values::Values::are_few() const
{
  return different.size() <= most_labels && number >= least_points_of_label * different.size();
}

std::vector<double> Property_values::Values::no_data() const
{
  for (const auto& [extreme, other] : {std::pair(lowest, highest), std::pair(highest, lowest)})
    if (extreme.number > 1
        && std::abs(extreme.value - extreme.next_value)
             > std::abs(other.value - extreme.next_value))
      return {extreme.value};
  return {};
}

void Property_values::add_property(const Property_table& table, bool is_type_open)
{
  const Property& property = table.properties().back();
  if (is_floating(property.type))
    m_values.push_back({table.properties().size() - 1, is_type_open,
                        CGAL::L0_resampling::is_color_channel(property.name)});
}

void Property_values::look(const Property_table& table, const char* row)
{
  for (Values& values : m_values) {
    const Property& property = table.properties()[values.property];
    values.add(decode(row + property.offset, property.type, false));
  }
}

std::vector<Number_type> Property_values::types(const Property_table& table) const
{
  using Int = std::numeric_limits<std::int32_t>;
  using Unsigned_int = std::numeric_limits<std::uint32_t>;
  constexpr double highest_byte = 255;
  const bool are_bytes = std::none_of(m_values.begin(), m_values.end(), [&](const Values& values) {
    return values.is_type_open && values.is_channel && !values.are_whole_within(0, highest_byte);
  });
  std::vector<Number_type> types;
  for (const Property& property : table.properties())
    types.push_back(property.type);
  for (const Values& values : m_values) {
    if (!values.is_type_open)
      continue;
    Number_type& type = types[values.property];
    if (values.is_channel)
      type = are_bytes ? Number_type::UINT8 : Number_type::FLOAT64;
    else if (values.are_whole_within(Int::lowest(), (Int::max)()))
      type = Number_type::INT32;
    else if (values.are_whole_within(0, (Unsigned_int::max)()))
      type = Number_type::UINT32;
  }
  return types;
}

std::vector<std::string> Property_values::names_of_rounded(const Property_table& table) const
{
  std::vector<std::string> names;
  for (const Values& values : m_values)
    if (values.is_type_open && values.are_whole
        && may_be_rounded(values.lowest.value, values.highest.value))
      names.push_back(table.properties()[values.property].name);
  return names;
}

void Property_values::set_meanings(Property_table& table) const
{
  for (const Values& values : m_values)
    if (is_floating(table.properties()[values.property].type)) {
      const bool are_labels = values.are_whole || values.are_few();
      table.set_meaning(values.property, !are_labels,
                        are_labels || values.is_channel ? std::vector<double>() : values.no_data());
    }
}

} // namespace l0_tool
