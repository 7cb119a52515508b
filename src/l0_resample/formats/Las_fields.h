// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_LAS_FIELDS_H
#define L0_RESAMPLE_LAS_FIELDS_H

#include "basis/Number_type.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {

/// A number of a point of a LAS file.
struct Las_field
{
  enum class Kind
  {
    UNSIGNED,
    SIGNED,
    FLOATING
  };

  std::string name;   ///< of the property that it is
  Number_type type;   ///< of that
  std::size_t offset; ///< of its bytes in the point
  Kind kind;
  std::size_t size;            ///< in bytes
  unsigned first_bit = 0;      ///< of these bytes, if it has not all their bits
  unsigned number_of_bits = 0; ///< 0 for all
  double scale = 1;            ///< of an integer: the value of 1
  double shift = 0;            ///< the value of 0

  double value(const char* point) const;

  /// Whether it is an integer of 64 bits without a scale, which becomes a double.
  bool is_wide_integer() const
  {
    return kind != Kind::FLOATING && size == 8 && scale == 1 && shift == 0;
  }

  /// Whether `set_value()` would keep the value: rounded, where an integer has another value than
  /// itself.
  bool holds(double value) const;

  /// Only for a value that it holds, and where its bits are 0.
  void set_value(double value, char* point) const;
};

constexpr unsigned max_las_point_format = 10;

/// \returns the least number of bytes of a point
std::size_t las_point_size(unsigned point_format);

bool has_las_waveforms(unsigned point_format);

/// The fields of a point behind x, y, z, which are its first twelve bytes, but for waveforms:
/// intensity, return_number, number_of_returns, scan_direction_flag, edge_of_flight_line,
/// classification, classification_flags (a bit each for synthetic, key-point, withheld and
/// overlap), scanner_channel, user_data, scan_angle in degrees, point_source_id, gps_time, red,
/// green, blue, nir.
std::vector<Las_field> las_fields(unsigned point_format);

/// \returns nullptr if none has that name
const Las_field* find_las_field(const std::vector<Las_field>& fields, std::string_view name);

/// The bit of `classification_flags` that says that a point is to be taken for deleted.
constexpr unsigned las_withheld = 4;

} // namespace l0_tool

#endif // L0_RESAMPLE_LAS_FIELDS_H
