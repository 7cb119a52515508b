// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_WRITE_LAS_H
#define L0_RESAMPLE_WRITE_LAS_H

#include "basis/Las_origin.h"
#include "files/Output_file.h"
#include "formats/Point_rows.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// Writes points as a LAS file, on the lattice of `choose_las_lattice()` and with the layout of
/// `choose_las_layout()`. Normals are extra bytes NormalX, NormalY, NormalZ. The same points give
/// the same bytes: the day in the header is that of the environment variable SOURCE_DATE_EPOCH, or
/// none.
/// \param path for messages
/// \returns the names of the properties that have no place in it
/// \throws Failure with OUTPUT_NOT_WRITTEN, also if a coordinate is not finite
std::vector<std::string> write_las(Output_file& file, const std::string& path,
                                   const Point_rows& rows, bool has_normals,
                                   const std::optional<Las_origin>& origin);

/// At least the number of bytes that `write_las()` will write.
std::uint64_t maximum_las_size(std::uint64_t number_of_points, const Property_table& properties,
                               const std::optional<Las_origin>& origin);

} // namespace l0_tool

#endif // L0_RESAMPLE_WRITE_LAS_H
