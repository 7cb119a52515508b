// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_OUTPUT_COLUMNS_H
#define L0_RESAMPLE_OUTPUT_COLUMNS_H

#include "basis/Property_table.h"
#include "files/file_formats.h"

#include <cstddef>
#include <string>
#include <vector>

namespace l0_tool {

/// A column of a file, behind coordinates and normals.
struct Output_column
{
  static constexpr std::size_t zero = std::size_t(-1);

  std::string name;
  Number_type type;
  std::vector<std::size_t>
    bytes; ///< of a number, the lowest first: where each lies in a row of properties, or `zero`
};

/// What of the properties a format can hold.
struct Output_columns
{
  std::vector<Output_column> columns;
  std::vector<std::string> left_out; ///< names of properties
};

/// Whether the format has places for some properties at all.
bool holds_properties(File_format format);

/// The property as it is.
Output_column plain_column(const Property& property);

/*!
Chooses the columns of a file, but for LAS, which has a layout of its own:
- PLY holds all properties;
- PCD too, and the channels of a color in bytes are packed as PCL does it: into a field rgb, or rgba
if there is alpha;
- OFF holds red, green, blue and maybe alpha in bytes, in that order;
- XYZ and NPY hold coordinates and normals.

No column has the name of another one, or of a coordinate.
*/
Output_columns choose_columns(const Property_table& table, File_format format, bool has_normals);

} // namespace l0_tool

#endif // L0_RESAMPLE_OUTPUT_COLUMNS_H
