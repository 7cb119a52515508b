// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PCD_HEADER_H
#define L0_RESAMPLE_PCD_HEADER_H

#include "basis/Number_type.h"
#include "files/Input_file.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// Of values of one type; a bool of PCL is not read.
struct Pcd_field : Type_in_file
{
  std::string name;
  std::uint64_t size;                 ///< of each value, in bytes
  std::string type_name;              ///< for messages
  std::uint64_t count = 1;            ///< of values in a row; 0 for padding that is none
  std::size_t number_of_channels = 0; ///< of a color that PCL packs into the bytes of one number
  std::uint64_t values_in_column = 1; ///< of a point, where columns come one after the other
  std::uint64_t first_in_column = 0;  ///< of these
};

struct Pcd_header
{
  enum class Encoding
  {
    ASCII,
    BINARY,
    COMPRESSED_BINARY
  };

  std::vector<Pcd_field> fields;
  std::uint64_t number_of_points = 0;
  bool is_organized = false; ///< an image, which has points without a measurement too
  Encoding encoding = Encoding::ASCII;
  bool has_viewpoint = false;
  std::optional<std::array<double, 3>> viewpoint; ///< unless it is no place

  /// Of values in a row.
  std::uint64_t number_of_values() const;

  /// In a binary file, in bytes.
  std::uint64_t row_size() const;
};

/// Reads to the end of the line DATA: at most 1 MiB, 1000 fields.
/// \throws Failure with the line that is at fault
Pcd_header read_pcd_header(Input_file& file);

} // namespace l0_tool

#endif // L0_RESAMPLE_PCD_HEADER_H
