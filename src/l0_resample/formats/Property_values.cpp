// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Property_values.h"

#include <CGAL/L0_resampling/Near_points.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

namespace l0_tool {

bool may_be_rounded(double lowest, double highest)
{
  constexpr double maximum_exact_integer = 9007199254740992.; // 2^53
  return lowest < -maximum_exact_integer || highest > maximum_exact_integer;
}

bool Property_values::Values::are_whole_within(double low, double high) const
{
  return are_whole() && are_finite() && lowest() >= low && highest() <= high;
}

void Property_values::add_property(const Property_table& table, bool is_type_open)
{
  const Property& property = table.properties().back();
  if (is_floating(property.type))
    m_values.push_back({{},
                        table.properties().size() - 1,
                        is_type_open,
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
  const auto are_channels_within = [&](double highest) {
    return std::none_of(m_values.begin(), m_values.end(), [&](const Values& values) {
      return values.is_type_open && values.is_channel && !values.are_whole_within(0, highest);
    });
  };
  const Number_type type_of_channels = are_channels_within(255)     ? Number_type::UINT8
                                       : are_channels_within(65535) ? Number_type::UINT16
                                                                    : Number_type::FLOAT64;
  std::vector<Number_type> types;
  for (const Property& property : table.properties())
    types.push_back(property.type);
  for (const Values& values : m_values) {
    if (!values.is_type_open)
      continue;
    Number_type& type = types[values.property];
    if (values.is_channel)
      type = type_of_channels;
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
    if (values.is_type_open && values.are_whole()
        && may_be_rounded(values.lowest(), values.highest()))
      names.push_back(table.properties()[values.property].name);
  return names;
}

void Property_values::set_meanings(Property_table& table) const
{
  for (const Values& values : m_values)
    if (is_floating(table.properties()[values.property].type)) {
      const bool are_labels = values.are_labels();
      const std::optional<double> no_data = are_labels || values.is_channel ? std::nullopt
                                                                            : values.no_data();
      table.set_meaning(values.property, !are_labels,
                        no_data ? std::vector<double>{*no_data} : std::vector<double>());
    }
}

} // namespace l0_tool
