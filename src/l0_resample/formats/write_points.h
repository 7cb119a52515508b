// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_WRITE_POINTS_H
#define L0_RESAMPLE_WRITE_POINTS_H

#include "basis/Point_cloud.h"
#include "files/Output_file.h"
#include "files/file_formats.h"
#include "formats/Point_rows.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// Writes points and normals so that reading them gives the same doubles again: PLY in
/// little-endian binary, NOFF, XYZ with six columns, or NPY of shape (n, 6). Binary PCD holds
/// single precision, as the point types of PCL do, unless that would move a coordinate by more than
/// a millionth of the diagonal of all points; its VIEWPOINT is the origin, as where nobody knows
/// one. LAS rounds coordinates by no more than a thousandth of the spacing of the points, and holds
/// normals in single precision. The file is there as a whole or not at all, see `Output_file`.
void write_points(const std::string& path, File_format format,
                  const std::vector<Oriented_point>& points,
                  Existing_file existing = Existing_file::REPLACE);

/// As above, with the properties that the format can hold, see `choose_columns()`, and in PCD with
/// the viewpoint, if there is one.
/// \returns the names of those that it cannot hold
std::vector<std::string> write_points(const std::string& path, File_format format,
                                      const Resampled_points& result,
                                      Existing_file existing = Existing_file::REPLACE);

/// The same, of points that may be anywhere.
/// \param viewpoint of all points
std::vector<std::string> write_point_rows(const std::string& path, File_format format,
                                          const Point_rows& rows,
                                          const std::optional<Las_origin>& las,
                                          const std::optional<std::array<double, 3>>& viewpoint,
                                          Existing_file existing = Existing_file::REPLACE);

/// Writes what a file held: normals only if there are some, coordinates in the precision of that
/// file, but for binary PCD as above, the properties that the format can hold, see
/// `choose_columns()`, and in PCD the viewpoint, without a rotation.
/// \returns the names of those that it cannot hold
std::vector<std::string> write_point_cloud(const std::string& path, File_format format,
                                           const Point_cloud& cloud,
                                           Existing_file existing = Existing_file::REPLACE);

/// The names of properties that the format has no place for, whatever their values.
std::vector<std::string> properties_left_out(File_format format, const Property_table& properties,
                                             const std::optional<Las_origin>& las);

/// At least the number of bytes that the functions above will write.
std::uint64_t maximum_file_size(File_format format, std::uint64_t number_of_points,
                                const Property_table& properties = {},
                                const std::optional<Las_origin>& las = {});

} // namespace l0_tool

#endif // L0_RESAMPLE_WRITE_POINTS_H
