// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Las_extra_bytes.h"

#include "basis/Number_type.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace l0_tool {
namespace {

using Kind = Las_field::Kind;

constexpr std::size_t max_number_of_extra_fields = 1000;

// Where the parts of a description begin.
constexpr std::size_t type_at = 2, options_at = 3, name_at = 4, scale_at = 112, shift_at = 136;

constexpr unsigned has_scale = 8, has_shift = 16; // bits of the options

/// By the number of the type, from 1 on. Types 11 to 20 are two of these, and 21 to 30 three.
struct Las_number
{
  Kind kind;
  std::size_t size;
};
constexpr std::array<Las_number, 10> numbers = {{{Kind::UNSIGNED, 1},
                                                 {Kind::SIGNED, 1},
                                                 {Kind::UNSIGNED, 2},
                                                 {Kind::SIGNED, 2},
                                                 {Kind::UNSIGNED, 4},
                                                 {Kind::SIGNED, 4},
                                                 {Kind::UNSIGNED, 8},
                                                 {Kind::SIGNED, 8},
                                                 {Kind::FLOATING, 4},
                                                 {Kind::FLOATING, 8}}};

/// By the same number.
constexpr std::array<Number_type, 10> types = {Number_type::UINT8,   Number_type::INT8,
                                               Number_type::UINT16,  Number_type::INT16,
                                               Number_type::UINT32,  Number_type::INT32,
                                               Number_type::FLOAT64, Number_type::FLOAT64,
                                               Number_type::FLOAT32, Number_type::FLOAT64};

/// As one word, as other formats need it.
std::string name_of(std::string_view description, std::size_t index)
{
  std::string name(description.substr(name_at, max_las_name_length));
  name.resize((std::min)(name.find('\0'), name.size()));
  while (!name.empty() && name.back() == ' ')
    name.pop_back();
  const auto ends_word = [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; };
  std::replace_if(name.begin(), name.end(), ends_word, '_');
  return name.empty() ? "extra_bytes_" + std::to_string(index) : name;
}

double number_at(std::string_view description, std::size_t position)
{
  return decode(description.data() + position, Number_type::FLOAT64, !is_little_endian_machine());
}

void add_field(const Input_file& file, std::string_view description, std::size_t point_size,
               std::size_t index, Las_extra_bytes& extra)
{
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(description[k]); };
  const unsigned type = byte(type_at), options = byte(options_at);
  if (type == 0) { // of no known meaning; the options are their number
    extra.size += options;
    return;
  }
  if (type > 3 * numbers.size())
    file.refuse("the extra bytes have a field of type " + std::to_string(type)
                + ", which is not one of LAS");
  const Las_number number = numbers[(type - 1) % numbers.size()];
  const std::size_t count = (type - 1) / numbers.size() + 1;
  const std::string name = name_of(description, index);
  Las_field field = {name, types[(type - 1) % numbers.size()], 0, number.kind, number.size};
  const bool is_scaled = (options & (has_scale | has_shift)) != 0;
  for (std::size_t k = 0; k < count; ++k) {
    field.name = count == 1 ? name : name + "_" + std::to_string(k);
    field.offset = point_size + extra.size;
    extra.size += number.size;
    if (is_scaled) {
      field.type = Number_type::FLOAT64;
      field.scale = options & has_scale ? number_at(description, scale_at + 8 * k) : 1;
      field.shift = options & has_shift ? number_at(description, shift_at + 8 * k) : 0;
      if (!std::isfinite(field.scale) || !std::isfinite(field.shift) || field.scale == 0)
        file.refuse("the extra bytes have a scale that is 0 or not finite");
    }
    extra.fields.push_back(field);
  }
  if (extra.fields.size() > max_number_of_extra_fields)
    file.refuse("the extra bytes have more than " + std::to_string(max_number_of_extra_fields)
                + " fields");
}

} // namespace

void add_las_extra_bytes(const Input_file& file, std::string_view data, std::size_t point_size,
                         Las_extra_bytes& extra)
{
  if (data.size() % las_extra_bytes_size != 0)
    file.refuse("the record of extra bytes has " + std::to_string(data.size())
                + " bytes, which is no multiple of " + std::to_string(las_extra_bytes_size));
  for (std::size_t k = 0; k < data.size() / las_extra_bytes_size; ++k)
    add_field(file, data.substr(k * las_extra_bytes_size, las_extra_bytes_size), point_size, k,
              extra);
}

std::string las_extra_bytes_record(std::string_view name, Number_type type)
{
  std::string description(las_extra_bytes_size, '\0');
  // The last one of the type, as integers of 64 bits come before double precision
  const auto found = std::find(types.rbegin(), types.rend(), type);
  description[type_at] = char(types.rend() - found);
  name.copy(&description[name_at], max_las_name_length);
  return description;
}

} // namespace l0_tool
