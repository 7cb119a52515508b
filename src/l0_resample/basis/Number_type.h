// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_NUMBER_TYPE_H
#define L0_RESAMPLE_NUMBER_TYPE_H

#include <cstddef>
#include <string_view>

namespace l0_tool {

/// The types of numbers in binary files.
enum class Number_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  FLOAT32,
  FLOAT64
};
constexpr int number_of_types = 8;

/// In bytes.
std::size_t size_of(Number_type type);

/// The number whose `size_of(type)` bytes begin at `bytes`, wherever that is.
/// \param swap whether the bytes are in the other order than this machine's
double decode(const char* bytes, Number_type type, bool swap);

/// Writes a number in the byte order of this machine: to the nearest one that the type has. One
/// that is not finite becomes 0 in an integer.
void encode(double number, Number_type type, char* bytes);

/// Copies a number of `type`.
/// \param swap whether to reverse its bytes
void copy_number(const char* bytes, Number_type type, bool swap, char* target);

/// Writes the number that `word` is to `target`, as one of `type`.
/// \returns whether it is one of that type
bool parse_number_of(Number_type type, std::string_view word, char* target);

bool is_floating(Number_type type);

/// Whether `float` holds all numbers of `type`.
bool fits_single_precision(Number_type type);

bool is_little_endian_machine();

} // namespace l0_tool

#endif // L0_RESAMPLE_NUMBER_TYPE_H
