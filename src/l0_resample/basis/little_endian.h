// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_LITTLE_ENDIAN_H
#define L0_RESAMPLE_LITTLE_ENDIAN_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace l0_tool {

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

#endif // L0_RESAMPLE_LITTLE_ENDIAN_H
