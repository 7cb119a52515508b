// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PLY_HEADER_H
#define L0_RESAMPLE_PLY_HEADER_H

#include "basis/Number_type.h"
#include "files/Input_file.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {

/// Of a number; a bool is not read.
struct Ply_type : Type_in_file
{
  std::size_t size = 0; ///< in a binary file, in bytes; 0 if unknown
  std::string name;
};

struct Ply_property
{
  std::string name;
  Ply_type type; ///< of the value, or of each entry of a list
  bool is_list = false;
  Ply_type length_type = {}; ///< only of a list; no floating-point type
};

struct Ply_element
{
  std::string name;
  std::uint64_t count;
  std::vector<Ply_property> properties;

  bool has_lists() const;

  /// Number of bytes of a row in a binary file, with empty lists.
  std::uint64_t minimum_binary_size() const;
};

struct Ply_header
{
  enum class Encoding
  {
    ASCII,
    LITTLE_ENDIAN_BINARY,
    BIG_ENDIAN_BINARY
  };

  Encoding encoding;
  std::vector<Ply_element> elements;
};

/// Reads to the end of the header: at most 1 MiB, 1000 properties, 100 elements.
/// \throws Failure with the line that is at fault
Ply_header read_ply_header(Input_file& file);

} // namespace l0_tool

#endif // L0_RESAMPLE_PLY_HEADER_H
