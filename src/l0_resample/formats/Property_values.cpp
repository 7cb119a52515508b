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

namespace l0_tool {

void Property_values::Values::add(double value)
{
  if (!std::isfinite(value)) {
    are_finite = false;
    return;
  }
  are_whole = are_whole && std::floor(value) == value;
  lowest = (std::min)(lowest, value);
  highest = (std::max)(highest, value);
}

bool Property_values::Values::are_whole_within(double low, double high) const
{
  return are_whole && are_finite && lowest >= low && highest <= high;
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
    if (values.are_whole) // else all is known
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
  constexpr double largest_exact = 9007199254740992.; // 2^53
  std::vector<std::string> names;
  for (const Values& values : m_values)
    if (values.is_type_open && values.are_whole
        && (values.lowest < -largest_exact || values.highest > largest_exact))
      names.push_back(table.properties()[values.property].name);
  return names;
}

void Property_values::mark_whole(Property_table& table) const
{
  for (const Values& values : m_values)
    if (values.are_whole)
      table.set_whole(values.property);
}

} // namespace l0_tool
