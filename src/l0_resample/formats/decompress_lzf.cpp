// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/decompress_lzf.h"

#include <cstddef>
#include <string>
#include <utility>

namespace l0_tool {
namespace {

// A reference takes three bytes and stands for up to 264.
constexpr std::uint64_t maximum_ratio_of_lzf = 88;

/// The compressed bytes and what they stand for.
class Lzf_decoder
{
  Input_file& m_file;
  std::uint64_t m_compressed_bytes_left;
  std::uint64_t m_size;
  std::vector<char> m_bytes;

  const char* take(std::size_t n)
  {
    if (n > m_compressed_bytes_left)
      m_file.refuse("the compressed data end within a block");
    m_compressed_bytes_left -= n;
    return m_file.read_bytes(n);
  }

  std::size_t take_byte() { return static_cast<unsigned char>(*take(1)); }

  void check_room(std::size_t length) const
  {
    if (length > m_size - m_bytes.size())
      m_file.refuse("the compressed data hold more than the announced " + std::to_string(m_size)
                    + " bytes");
  }

  void append_literals(std::size_t length)
  {
    check_room(length);
    const char* bytes = take(length);
    m_bytes.insert(m_bytes.end(), bytes, bytes + length);
  }

  /// Repeats bytes that may reach into those that are appended.
  void append_reference(std::size_t distance, std::size_t length)
  {
    if (distance > m_bytes.size())
      m_file.refuse("a reference of the compressed data leads to before their begin");
    check_room(length);
    for (std::size_t i = 0; i < length; ++i)
      m_bytes.push_back(m_bytes[m_bytes.size() - distance]);
  }

public:
  Lzf_decoder(Input_file& file, std::uint64_t compressed_size, std::uint64_t size)
    : m_file(file), m_compressed_bytes_left(compressed_size), m_size(size)
  {
    file.check_count(compressed_size, 1, "compressed bytes");
    if (size > 0 && (size - 1) / maximum_ratio_of_lzf >= compressed_size)
      file.refuse(std::to_string(compressed_size) + " compressed bytes cannot hold the announced "
                  + std::to_string(size));
    if (file.bytes_left()) // of a pipe nothing backs the size
      m_bytes.reserve(std::size_t(size));
  }

  std::vector<char> decode()
  {
    while (m_compressed_bytes_left > 0) {
      const std::size_t control = take_byte();
      if (control < 32) {
        append_literals(control + 1);
        continue;
      }
      std::size_t length = (control >> 5) + 2;
      if (length == 9)
        length += take_byte();
      append_reference(((control & 31) << 8) + take_byte() + 1, length);
    }
    if (m_bytes.size() != m_size)
      m_file.refuse("the compressed data hold " + std::to_string(m_bytes.size())
                    + " bytes, announced are " + std::to_string(m_size));
    return std::move(m_bytes);
  }
};

} // namespace

std::vector<char> decompress_lzf(Input_file& file, std::uint64_t compressed_size,
                                 std::uint64_t size)
{
  return Lzf_decoder(file, compressed_size, size).decode();
}

} // namespace l0_tool
