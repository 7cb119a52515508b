// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Las_layout.h"

#include "formats/Las_extra_bytes.h"

#include <algorithm>
#include <array>
#include <set>

namespace l0_tool {
namespace {

constexpr std::array<const char*, 3> color_channels = {"red", "green", "blue"};

const Property* find_property(const Property_table& table, const std::string& name)
{
  for (const Property& property : table.properties())
    if (property.name == name)
      return &property;
  return nullptr;
}

bool is_channel(const std::string& name)
{
  return std::find(color_channels.begin(), color_channels.end(), name) != color_channels.end();
}

/// Whether there is a color in integers that all have the whole range of their type.
bool has_color(const Property_table& table)
{
  return std::all_of(color_channels.begin(), color_channels.end(), [&](const char* name) {
    const Property* const channel = find_property(table, name);
    return channel && (channel->type == Number_type::UINT8 || channel->type == Number_type::UINT16);
  });
}

unsigned choose_point_format(const Property_table& table, bool is_old)
{
  const bool is_colored = has_color(table);
  if (is_old)
    return (find_property(table, "gps_time") ? 1u : 0u) + (is_colored ? 2u : 0u);
  if (!is_colored)
    return 6;
  return find_property(table, "nir") ? 8 : 7;
}

bool holds_all(const Las_column& column, const Point_rows& rows)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!column.field.holds(rows.value(i, column.property) * column.factor))
      return false;
  return true;
}

} // namespace

std::size_t Las_layout::point_size() const
{
  std::size_t size = las_point_size(point_format) + (has_normals ? 3 * sizeof(float) : 0);
  for (const Output_column& column : extra)
    size += size_of(column.type);
  return size;
}

const Las_column* Las_layout::find_column(const std::string& name) const
{
  for (const Las_column& column : columns)
    if (column.field.name == name)
      return &column;
  return nullptr;
}

Las_layout choose_las_layout(const Point_rows& rows, bool has_normals,
                             const std::optional<Las_origin>& origin)
{
  const Property_table& table = rows.properties();
  const bool is_old = origin && origin->has_old_points();
  const bool has_wkt = origin && origin->minor_version >= 4
                       && (origin->global_encoding & Las_origin::wkt) != 0;
  Las_layout layout;
  layout.minor_version = is_old && !has_wkt ? 2 : 4;
  layout.point_format = choose_point_format(table, is_old);
  layout.fields = las_fields(layout.point_format);
  layout.has_normals = has_normals;

  std::set<std::string> names; // of extra bytes, and of fields with a value
  if (has_normals)
    names.insert(las_normal_names.begin(), las_normal_names.end());
  const std::size_t most = max_las_extra_bytes - names.size();
  for (const Property& property : table.properties()) {
    const bool is_byte_color = is_channel(property.name) && property.type == Number_type::UINT8;
    constexpr double colors_per_byte_color = 257; // 65535 / 255
    const Las_field* const field = find_las_field(layout.fields, property.name);
    const bool is_new = names.count(property.name) == 0;
    if (is_new && field) {
      const Las_column column = {*field, property, is_byte_color ? colors_per_byte_color : 1};
      if (holds_all(column, rows)) {
        layout.columns.push_back(column);
        names.insert(property.name);
        continue;
      }
    }
    if (is_new && property.name.size() <= max_las_name_length && layout.extra.size() < most) {
      layout.extra.push_back(plain_column(property));
      names.insert(property.name);
    } else
      layout.left_out.push_back(property.name);
  }
  return layout;
}

} // namespace l0_tool
