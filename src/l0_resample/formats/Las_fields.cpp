// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Las_fields.h"

#include "basis/Number_type.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace l0_tool {
namespace {

using Kind = Las_field::Kind;

std::uint64_t mask_of(unsigned number_of_bits)
{
  return number_of_bits == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << number_of_bits) - 1;
}

Las_field unsigned_field(const char* name, Number_type type, std::size_t offset)
{
  return {name, type, offset, Kind::UNSIGNED, size_of(type)};
}

/// Of one byte.
Las_field bit_field(const char* name, std::size_t offset, unsigned first_bit,
                    unsigned number_of_bits)
{
  Las_field field = unsigned_field(name, Number_type::UINT8, offset);
  field.first_bit = first_bit;
  field.number_of_bits = number_of_bits;
  return field;
}

Las_field angle_field(std::size_t offset, std::size_t size, double scale)
{
  Las_field field = {"scan_angle", Number_type::FLOAT32, offset, Kind::SIGNED, size};
  field.scale = scale;
  return field;
}

/// Of formats 0 to 5.
void add_old_fields(std::vector<Las_field>& fields)
{
  fields.insert(fields.end(),
                {bit_field("return_number", 14, 0, 3), bit_field("number_of_returns", 14, 3, 3),
                 bit_field("scan_direction_flag", 14, 6, 1),
                 bit_field("edge_of_flight_line", 14, 7, 1), bit_field("classification", 15, 0, 5),
                 bit_field("classification_flags", 15, 5, 3), angle_field(16, 1, 1),
                 unsigned_field("user_data", Number_type::UINT8, 17),
                 unsigned_field("point_source_id", Number_type::UINT16, 18)});
}

/// Of formats 6 to 10.
void add_new_fields(std::vector<Las_field>& fields)
{
  fields.insert(
    fields.end(),
    {bit_field("return_number", 14, 0, 4), bit_field("number_of_returns", 14, 4, 4),
     bit_field("scan_direction_flag", 15, 6, 1), bit_field("edge_of_flight_line", 15, 7, 1),
     unsigned_field("classification", Number_type::UINT8, 16),
     bit_field("classification_flags", 15, 0, 4), bit_field("scanner_channel", 15, 4, 2),
     unsigned_field("user_data", Number_type::UINT8, 17), angle_field(18, 2, 0.006),
     unsigned_field("point_source_id", Number_type::UINT16, 20)});
}

/// What only some formats have: where it begins, 0 for what is not there.
struct Layout_of_fields
{
  std::size_t size, time, color, infrared;
  bool has_waveforms;
};

const Layout_of_fields& layout_of(unsigned point_format)
{
  static constexpr std::array<Layout_of_fields, max_las_point_format + 1> layouts = {
    {{20, 0, 0, 0, false},
     {28, 20, 0, 0, false},
     {26, 0, 20, 0, false},
     {34, 20, 28, 0, false},
     {57, 20, 0, 0, true},
     {63, 20, 28, 0, true},
     {30, 22, 0, 0, false},
     {36, 22, 30, 0, false},
     {38, 22, 30, 36, false},
     {59, 22, 0, 0, true},
     {67, 22, 30, 36, true}}};
  return layouts[point_format];
}

} // namespace

double Las_field::value(const char* point) const
{
  const char* const bytes = point + offset;
  if (kind == Kind::FLOATING)
    return decode(bytes, size == 4 ? Number_type::FLOAT32 : Number_type::FLOAT64,
                  !is_little_endian_machine())
             * scale
           + shift;
  std::uint64_t bits = little_endian_at(bytes, size);
  if (kind == Kind::SIGNED) {
    const std::uint64_t sign = std::uint64_t(1) << (8 * size - 1);
    return double(std::int64_t((bits ^ sign) - sign)) * scale + shift;
  }
  if (number_of_bits > 0)
    bits = bits >> first_bit & mask_of(number_of_bits);
  return double(bits) * scale + shift;
}

bool Las_field::holds(double value) const
{
  if (kind == Kind::FLOATING)
    return true;
  const double integer = (value - shift) / scale;
  const unsigned bits = number_of_bits > 0 ? number_of_bits : unsigned(8 * size);
  const double low = kind == Kind::SIGNED ? -std::ldexp(1., int(bits) - 1) : 0;
  const double high = low + std::ldexp(1., int(bits)) - 1;
  const bool is_itself = scale == 1 && shift == 0 && type != Number_type::FLOAT32;
  return integer >= low && integer <= high && (!is_itself || std::floor(integer) == integer);
}

void Las_field::set_value(double value, char* point) const
{
  char* const bytes = point + offset;
  if (kind == Kind::FLOATING) {
    encode(value, size == 4 ? Number_type::FLOAT32 : Number_type::FLOAT64, bytes);
    if (!is_little_endian_machine())
      std::reverse(bytes, bytes + size);
    return;
  }
  const auto integer = std::uint64_t(std::llround((value - shift) / scale));
  const std::uint64_t mask = mask_of(number_of_bits > 0 ? number_of_bits : unsigned(8 * size));
  const std::uint64_t bits = little_endian_at(bytes, size) | (integer & mask) << first_bit;
  for (std::size_t k = 0; k < size; ++k)
    bytes[k] = char(static_cast<unsigned char>(bits >> (8 * k)));
}

std::size_t las_point_size(unsigned point_format) { return layout_of(point_format).size; }

bool has_las_waveforms(unsigned point_format) { return layout_of(point_format).has_waveforms; }

std::vector<Las_field> las_fields(unsigned point_format)
{
  const Layout_of_fields& layout = layout_of(point_format);
  std::vector<Las_field> fields = {unsigned_field("intensity", Number_type::UINT16, 12)};
  if (point_format < 6)
    add_old_fields(fields);
  else
    add_new_fields(fields);
  if (layout.time > 0)
    fields.push_back({"gps_time", Number_type::FLOAT64, layout.time, Kind::FLOATING, 8});
  if (layout.color > 0)
    for (std::size_t k = 0; k < 3; ++k) {
      static constexpr std::array<const char*, 3> channels = {"red", "green", "blue"};
      fields.push_back(unsigned_field(channels[k], Number_type::UINT16, layout.color + 2 * k));
    }
  if (layout.infrared > 0)
    fields.push_back(unsigned_field("nir", Number_type::UINT16, layout.infrared));
  return fields;
}

const Las_field* find_las_field(const std::vector<Las_field>& fields, std::string_view name)
{
  for (const Las_field& field : fields)
    if (field.name == name)
      return &field;
  return nullptr;
}

} // namespace l0_tool
