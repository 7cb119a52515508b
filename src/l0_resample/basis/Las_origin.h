// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_LAS_ORIGIN_H
#define L0_RESAMPLE_LAS_ORIGIN_H

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace l0_tool {

/// A variable length record of a LAS file, all of which is bytes.
struct Las_record
{
  std::string user_id; ///< 16 bytes, with the zeros behind it
  std::uint16_t id;
  std::string description; ///< 32 bytes
  std::string data;        ///< at most `max_data_size`

  static constexpr std::size_t max_data_size = 65535;
};

/// What of a LAS file goes along to another one, beside its points.
struct Las_origin
{
  unsigned minor_version = 4; ///< of 1.x
  unsigned point_format = 6;
  std::uint16_t global_encoding = 0;
  std::array<double, 3> scale = {}; ///< a coordinate is an integer times this, plus the offset
  std::array<double, 3> offset = {};
  std::vector<Las_record> coordinate_system; ///< those of the user LASF_Projection

  /// Bits of `global_encoding`: what times are, that returns are synthetic, and that the coordinate
  /// system is told by WKT.
  static constexpr std::uint16_t standard_time = 1, synthetic_returns = 8, wkt = 16;

  bool has_old_points() const { return point_format < 6; }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_LAS_ORIGIN_H
