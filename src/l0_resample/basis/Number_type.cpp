// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/Number_type.h"

#include "basis/parse_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace l0_tool {
namespace {

template <typename T>
double to_double(const char* bytes, bool swap)
{
  char copy[sizeof(T)];
  std::memcpy(copy, bytes, sizeof(T));
  if (swap)
    std::reverse(copy, copy + sizeof(T));
  T value;
  std::memcpy(&value, copy, sizeof(T));
  return double(value);
}

/// Of a text such as "7.0" or "7e0".
template <typename T>
std::optional<T> whole_number(std::string_view word)
{
  using Limits = std::numeric_limits<T>;
  const std::optional<double> number = parse_number<double>(word);
  if (!number || std::floor(*number) != *number || *number < double((Limits::min)())
      || *number > double((Limits::max)()))
    return std::nullopt;
  return T(*number);
}

template <typename T>
bool parse(std::string_view word, char* target)
{
  std::optional<T> number = parse_number<T>(word);
  if constexpr (std::is_integral<T>::value)
    if (!number)
      number = whole_number<T>(word);
  if (number)
    std::memcpy(target, &*number, sizeof(T));
  return number.has_value();
}

template <typename T>
void write_as(double number, char* bytes)
{
  T value;
  if constexpr (std::is_floating_point<T>::value)
    value = T(number);
  else {
    using Limits = std::numeric_limits<T>;
    const double rounded = std::isfinite(number) ? std::floor(number + 0.5) : 0;
    value = T((std::min)((std::max)(rounded, double((Limits::min)())), double((Limits::max)())));
  }
  std::memcpy(bytes, &value, sizeof(T));
}

} // namespace

std::size_t size_of(Number_type type)
{
  switch (type) {
  case Number_type::INT8:
  case Number_type::UINT8: return 1;
  case Number_type::INT16:
  case Number_type::UINT16: return 2;
  case Number_type::INT32:
  case Number_type::UINT32:
  case Number_type::FLOAT32: return 4;
  case Number_type::FLOAT64: break;
  }
  return 8;
}

double decode(const char* bytes, Number_type type, bool swap)
{
  switch (type) {
  case Number_type::INT8: return to_double<std::int8_t>(bytes, swap);
  case Number_type::UINT8: return to_double<std::uint8_t>(bytes, swap);
  case Number_type::INT16: return to_double<std::int16_t>(bytes, swap);
  case Number_type::UINT16: return to_double<std::uint16_t>(bytes, swap);
  case Number_type::INT32: return to_double<std::int32_t>(bytes, swap);
  case Number_type::UINT32: return to_double<std::uint32_t>(bytes, swap);
  case Number_type::FLOAT32: return to_double<float>(bytes, swap);
  case Number_type::FLOAT64: break;
  }
  return to_double<double>(bytes, swap);
}

void copy_number(const char* bytes, Number_type type, bool swap, char* target)
{
  std::copy_n(bytes, size_of(type), target);
  if (swap)
    std::reverse(target, target + size_of(type));
}

bool parse_number_of(Number_type type, std::string_view word, char* target)
{
  switch (type) {
  case Number_type::INT8: return parse<std::int8_t>(word, target);
  case Number_type::UINT8: return parse<std::uint8_t>(word, target);
  case Number_type::INT16: return parse<std::int16_t>(word, target);
  case Number_type::UINT16: return parse<std::uint16_t>(word, target);
  case Number_type::INT32: return parse<std::int32_t>(word, target);
  case Number_type::UINT32: return parse<std::uint32_t>(word, target);
  case Number_type::FLOAT32: return parse<float>(word, target);
  case Number_type::FLOAT64: break;
  }
  return parse<double>(word, target);
}

double Wide_integer::decode(const char* bytes, bool swap) const
{
  return is_signed ? to_double<std::int64_t>(bytes, swap) : to_double<std::uint64_t>(bytes, swap);
}

std::optional<double> Wide_integer::parse(std::string_view word) const
{
  const double high = std::ldexp(1., is_signed ? 63 : 64), low = is_signed ? -high : 0;
  const std::optional<double> number = parse_number<double>(word);
  const bool is_integer = number && std::floor(*number) == *number && *number >= low
                          && *number <= high;
  return is_integer ? number : std::nullopt;
}

bool is_floating(Number_type type)
{
  return type == Number_type::FLOAT32 || type == Number_type::FLOAT64;
}

bool fits_single_precision(Number_type type)
{
  return type == Number_type::FLOAT32 || size_of(type) <= 2;
}

void encode(double number, Number_type type, char* bytes)
{
  switch (type) {
  case Number_type::INT8: return write_as<std::int8_t>(number, bytes);
  case Number_type::UINT8: return write_as<std::uint8_t>(number, bytes);
  case Number_type::INT16: return write_as<std::int16_t>(number, bytes);
  case Number_type::UINT16: return write_as<std::uint16_t>(number, bytes);
  case Number_type::INT32: return write_as<std::int32_t>(number, bytes);
  case Number_type::UINT32: return write_as<std::uint32_t>(number, bytes);
  case Number_type::FLOAT32: return write_as<float>(number, bytes);
  case Number_type::FLOAT64: break;
  }
  write_as<double>(number, bytes);
}

bool is_little_endian_machine()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace l0_tool
