// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Output_columns.h"

#include <algorithm>
#include <array>
#include <set>

namespace l0_tool {
namespace {

constexpr std::array<const char*, 4> channels_with_alpha = {"red", "green", "blue", "alpha"};

const Property* find_channel(const Property_table& table, const std::string& name)
{
  for (const Property& property : table.properties())
    if (property.name == name && property.type == Number_type::UINT8)
      return &property;
  return nullptr;
}

/// Red, green, blue and maybe alpha; empty if there is no color in bytes.
std::vector<const Property*> find_color(const Property_table& table)
{
  std::vector<const Property*> color;
  for (const char* name : channels_with_alpha)
    if (const Property* channel = find_channel(table, name))
      color.push_back(channel);
    else if (std::string(name) != "alpha")
      return {};
  return color;
}

bool contains(const std::vector<const Property*>& properties, const Property& property)
{
  return std::find(properties.begin(), properties.end(), &property) != properties.end();
}

Output_column packed_color(const std::vector<const Property*>& color)
{
  const bool has_alpha = color.size() == 4;
  return {has_alpha ? "rgba" : "rgb",
          has_alpha ? Number_type::UINT32 : Number_type::FLOAT32,
          {color[2]->offset, color[1]->offset, color[0]->offset,
           has_alpha ? color[3]->offset : Output_column::zero}};
}

std::set<std::string> names_of_coordinates(File_format format, bool has_normals)
{
  std::set<std::string> names = {"x", "y", "z"};
  if (has_normals && format == File_format::PLY)
    names.insert({"nx", "ny", "nz"});
  if (has_normals && format == File_format::PCD)
    names.insert({"normal_x", "normal_y", "normal_z"});
  return names;
}

} // namespace

bool holds_properties(File_format format)
{
  return format != File_format::XYZ && format != File_format::NPY;
}

Output_column plain_column(const Property& property)
{
  Output_column column = {property.name, property.type, {}};
  for (std::size_t k = 0; k < size_of(property.type); ++k)
    column.bytes.push_back(property.offset + k);
  if (!is_little_endian_machine())
    std::reverse(column.bytes.begin(), column.bytes.end());
  return column;
}

Output_columns choose_columns(const Property_table& table, File_format format, bool has_normals)
{
  Output_columns chosen;
  const std::vector<const Property*> color = find_color(table);
  std::set<std::string> names = names_of_coordinates(format, has_normals);
  const auto add = [&](const Property& property, const Output_column& column) {
    if (names.insert(column.name).second)
      chosen.columns.push_back(column);
    else
      chosen.left_out.push_back(property.name);
  };

  if (format == File_format::OFF)
    for (const Property* channel : color)
      add(*channel, plain_column(*channel));
  for (const Property& property : table.properties()) {
    const bool is_color = contains(color, property);
    if (format == File_format::PLY || (format == File_format::PCD && !is_color))
      add(property, plain_column(property));
    else if (format == File_format::PCD && &property == color.front())
      add(property, packed_color(color));
    else if (!holds_properties(format) || !is_color)
      chosen.left_out.push_back(property.name);
  }
  return chosen;
}

} // namespace l0_tool
