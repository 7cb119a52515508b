// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_NUMBER_TYPE_H
#define L0_RESAMPLE_NUMBER_TYPE_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
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

/// An integer of 64 bits in a file. It becomes a double, to which one beyond 2^53 is rounded.
struct Wide_integer
{
  bool is_signed;

  /// As the function of that name.
  double decode(const char* bytes, bool swap) const;

  /// Nothing if `word` is no such integer.
  std::optional<double> parse(std::string_view word) const;
};

/// The type of numbers in a file; those of some types are not read.
struct Type_in_file
{
  std::optional<Number_type> number;               ///< not for integers of 64 bits
  std::optional<Wide_integer> wide = std::nullopt; ///< for those

  /// Whether numbers of it are read.
  bool is_number() const { return number || wide; }

  /// Of such a type, as the function `decode()`.
  double number_at(const char* bytes, bool swap) const
  {
    return wide ? wide->decode(bytes, swap) : decode(bytes, *number, swap);
  }
};

bool is_floating(Number_type type);

/// Whether `float` holds all numbers of `type`.
bool fits_single_precision(Number_type type);

bool is_little_endian_machine();

/// The unsigned integer of `size` bytes, at most 8, the lowest of which comes first.
inline std::uint64_t little_endian_at(const char* bytes, std::size_t size)
{
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < size; ++k)
    number |= std::uint64_t(static_cast<unsigned char>(bytes[k])) << (8 * k);
  return number;
}

/// Appends the bits of a number as those of a `Bits`, an unsigned integer of its size.
template <typename Bits, typename Number>
void append_little_endian(Number number, std::string& bytes)
{
  static_assert(sizeof(Bits) == sizeof(Number));
  Bits bits;
  std::memcpy(&bits, &number, sizeof bits);
  for (std::size_t byte = 0; byte < sizeof bits; ++byte)
    bytes += char(static_cast<unsigned char>(bits >> (8 * byte)));
}

} // namespace l0_tool

#endif // L0_RESAMPLE_NUMBER_TYPE_H
