// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/carry_properties.h"

#include <CGAL/L0_resampling/internal/core/attribute_kinds.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace l0_tool {
namespace {

using CGAL::L0_resampling::internal::Near_points;

/// What LAS tells of one pulse; a mean of two passes of the scanner would belong to none.
bool is_of_one_pulse(const std::string& name) { return name == "gps_time" || name == "scan_angle"; }

bool is_averaged(const Property& property)
{
  if (is_of_one_pulse(property.name))
    return false;
  return property.type == Number_type::FLOAT32 || property.type == Number_type::FLOAT64
         || CGAL::L0_resampling::internal::is_color_channel(property.name);
}

} // namespace

Property_table carried_properties(const Property_table& properties, const Near_points& near_points,
                                  const std::vector<std::uint32_t>& source_indices,
                                  const std::vector<Result_column>& columns, std::size_t size)
{
  const std::string source_name = "source_index";
  const auto is_replaced = [&](const std::string& name) {
    return (name == source_name && !source_indices.empty())
           || std::any_of(columns.begin(), columns.end(),
                          [&](const Result_column& column) { return column.name == name; });
  };
  Property_table result;
  std::vector<Property> origins; // of the first columns of the result
  for (const Property& property : properties.properties())
    if (!is_replaced(property.name)) {
      result.add_property(property.name, property.type);
      origins.push_back(property);
    }
  if (!source_indices.empty())
    result.add_property(source_name, Number_type::UINT32);
  for (const Result_column& column : columns)
    result.add_property(column.name, Number_type::FLOAT32);

  result.reserve(size);
  std::vector<char> row(result.row_size());
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < origins.size(); ++k) {
      const Property& from = origins[k];
      char* const bytes = row.data() + result.properties()[k].offset;
      if (is_averaged(from))
        encode(near_points.mean(i, [&](std::size_t j) { return properties.value(j, from); }),
               from.type, bytes);
      else
        std::memcpy(bytes, properties.row(near_points.nearest(i)) + from.offset,
                    size_of(from.type));
    }
    std::size_t next = origins.size();
    if (!source_indices.empty())
      encode(double(source_indices[i]), Number_type::UINT32,
             row.data() + result.properties()[next++].offset);
    for (const Result_column& column : columns)
      encode(double(column.values[i]), Number_type::FLOAT32,
             row.data() + result.properties()[next++].offset);
    result.append(row);
  }
  return result;
}

} // namespace l0_tool
