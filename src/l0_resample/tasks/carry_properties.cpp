// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/carry_properties.h"

#include "formats/usual_names.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

namespace l0_tool {
namespace {

using CGAL::L0_resampling::Near_points;

/// What tells of one pulse, under the names that LAS and others have for it, or has several values
/// in the bits of one number: a mean of two passes of the scanner would belong to none, and that of
/// bits means nothing.
bool is_indivisible(const std::string& name)
{
  static constexpr std::array<std::string_view, 8> names = {
    "gpstime", "time", "timestamp", "scanangle", "scananglerank", "rgb", "rgba", "argb"};
  constexpr std::string_view of_cloud_compare = "scalar";
  const std::string text = folded(name);
  std::string_view rest = text;
  if (rest.substr(0, of_cloud_compare.size()) == of_cloud_compare)
    rest.remove_prefix(of_cloud_compare.size());
  return std::find(names.begin(), names.end(), rest) != names.end();
}

bool is_averaged(const Property& property)
{
  if (is_indivisible(property.name))
    return false;
  return property.is_measured || CGAL::L0_resampling::is_color_channel(property.name);
}

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// The value, or NaN if it stands for none.
double datum(double value, const Property& property)
{
  const std::vector<double>& no_data = property.no_data;
  return std::find(no_data.begin(), no_data.end(), value) == no_data.end() ? value : no_value;
}

} // namespace

Property_table carried_properties(const Property_table& properties, const Near_points& near_points,
                                  const std::vector<std::uint32_t>& source_indices,
                                  const std::vector<Result_column>& columns, std::size_t size)
{
  const std::string source_name = "source_index";
  std::vector<const Result_column*> written;
  for (const Result_column& column : columns)
    if (column.is_written)
      written.push_back(&column);
  const auto is_replaced = [&](const std::string& name) {
    return (name == source_name && !source_indices.empty())
           || std::any_of(written.begin(), written.end(),
                          [&](const Result_column* column) { return column->name == name; });
  };
  Property_table result;
  struct Origin
  {
    Property property;
    bool is_averaged;
  };
  std::vector<Origin> origins; // of the first columns of the result
  for (const Property& property : properties.properties())
    if (!is_replaced(property.name)) {
      result.add_property(property.name, property.type);
      origins.push_back({property, is_averaged(property)});
    }
  if (!source_indices.empty())
    result.add_property(source_name, Number_type::UINT32);
  for (const Result_column* column : written)
    result.add_property(column->name, column->type);

  result.resize(size);
  const auto write_row = [&](std::size_t i) {
    char* const row = result.row(i);
    auto column = result.properties().begin();
    for (const Origin& origin : origins) {
      const Property& from = origin.property;
      char* const bytes = row + column++->offset;
      const auto value_of = [&](std::size_t j) { return datum(properties.value(j, from), from); };
      const double mean = origin.is_averaged ? near_points.mean(i, value_of) : no_value;
      if (std::isfinite(mean))
        encode(mean, from.type, bytes);
      else
        std::memcpy(bytes, properties.row(near_points.nearest(i)) + from.offset,
                    size_of(from.type));
    }
    if (!source_indices.empty())
      encode(double(source_indices[i]), Number_type::UINT32, row + column++->offset);
    for (const Result_column* of_result : written)
      encode(double(of_result->values[i]), of_result->type, row + column++->offset);
  };
  const std::size_t rows_per_block = 4096;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size, rows_per_block),
                    [&](const tbb::blocked_range<std::size_t>& block) {
                      for (std::size_t i = block.begin(); i < block.end(); ++i)
                        write_row(i);
                    });
  return result;
}

} // namespace l0_tool
