// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_LAS_HEADER_H
#define L0_RESAMPLE_LAS_HEADER_H

#include "basis/Las_origin.h"
#include "files/Input_file.h"
#include "formats/Las_extra_bytes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace l0_tool {

/// The sizes of the block that a file begins with, by minor version, and of the heads of its
/// records, in bytes.
constexpr std::array<std::size_t, 5> las_header_sizes = {227, 227, 227, 235, 375};
constexpr std::size_t las_record_head_size = 54, las_extended_record_head_size = 60;

/// The user of records that tell the coordinate system.
constexpr std::string_view las_projection = "LASF_Projection";

/// What a LAS file says before its points, and, in records of their own, behind them.
struct Las_header
{
  Las_origin origin;
  std::size_t size = 0; ///< in bytes
  std::uint64_t offset_to_points = 0;
  std::uint32_t number_of_records = 0;
  std::size_t point_size = 0; ///< that of the format, or more
  std::uint64_t number_of_points = 0;
  std::uint64_t first_extended_record = 0; ///< where it begins
  std::uint32_t number_of_extended_records = 0;
  Las_extra_bytes extra;
  std::size_t size_of_coordinate_system = 0; ///< of the records of `origin`, in bytes
  std::uint64_t number_of_long_records = 0;  ///< of the coordinate system too, but not kept

  /// Where the points end.
  std::uint64_t end_of_points() const { return offset_to_points + number_of_points * point_size; }
};

/// Whether what comes next in a file is LAZ.
bool is_compressed_las(Input_file& file);

/// Reads to the end of the records before the points.
/// \throws Failure if it is no header of LAS 1.0 to 1.4, or of compressed points (LAZ)
Las_header read_las_header(Input_file& file);

/// Reads the extended records, the first of which comes next.
void read_las_extended_records(Input_file& file, Las_header& header);

} // namespace l0_tool

#endif // L0_RESAMPLE_LAS_HEADER_H
