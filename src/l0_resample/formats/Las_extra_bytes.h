// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_LAS_EXTRA_BYTES_H
#define L0_RESAMPLE_LAS_EXTRA_BYTES_H

#include "files/Input_file.h"
#include "formats/Las_fields.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {

/// The user and the number of the variable length record that describes extra bytes.
constexpr std::string_view las_specification = "LASF_Spec";
constexpr unsigned las_extra_bytes_id = 4;

/// The bytes of a field in that record, and the most of them that one record holds.
constexpr std::size_t las_extra_bytes_size = 192, max_las_extra_bytes = 341;

constexpr std::size_t max_las_name_length = 32;

/// Of the coordinates of a normal, as it is written.
constexpr std::array<std::string_view, 3> las_normal_names = {"NormalX", "NormalY", "NormalZ"};

/// What a point has behind the bytes of its format.
struct Las_extra_bytes
{
  std::vector<Las_field> fields;
  std::size_t size = 0; ///< of all, in bytes
};

/// Adds what the data of a record describes, which begins at `extra.size` behind the bytes of a
/// point of that size. Of several numbers, as older files have them, each is a field of its own.
/// \throws Failure if it is not such data
void add_las_extra_bytes(const Input_file& file, std::string_view data, std::size_t point_size,
                         Las_extra_bytes& extra);

/// The part of such a record that describes numbers of that type.
/// \param name of at most `max_las_name_length` bytes
std::string las_extra_bytes_record(std::string_view name, Number_type type);

} // namespace l0_tool

#endif // L0_RESAMPLE_LAS_EXTRA_BYTES_H
