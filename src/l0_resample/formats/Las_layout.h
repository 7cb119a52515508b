// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_LAS_LAYOUT_H
#define L0_RESAMPLE_LAS_LAYOUT_H

#include "basis/Las_origin.h"
#include "formats/Las_fields.h"
#include "formats/Output_columns.h"
#include "formats/Point_rows.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// A property that has a field in the format of the points.
struct Las_column
{
  Las_field field;
  Property property;
  double factor; ///< of its values
};

/// How the points of a LAS file are stored.
struct Las_layout
{
  unsigned minor_version = 4;
  unsigned point_format = 6;
  std::vector<Las_field> fields;     ///< all that the format has
  std::vector<Las_column> columns;   ///< properties with a field of their own
  bool has_normals = false;          ///< the first extra bytes: three floats
  std::vector<Output_column> extra;  ///< the other extra bytes
  std::vector<std::string> left_out; ///< names of properties

  /// Of a point, in bytes.
  std::size_t point_size() const;

  const Las_column* find_column(const std::string& name) const;
};

/*!
Chooses version and format: LAS 1.4 with points of format 6, 7 for colors, or 8 for colors and
infrared; LAS 1.2 with points of formats 0 to 3 if those of the input are of formats 0 to 5, as its
coordinate system may be told in a way that later formats do not have, or 1.4 with these formats if
WKT tells it.

A property goes into the field of that name if this holds all its values, and else into extra bytes
of its own type, if its name has no more than 32 bytes and is that of no other.
*/
Las_layout choose_las_layout(const Point_rows& rows, bool has_normals,
                             const std::optional<Las_origin>& origin);

} // namespace l0_tool

#endif // L0_RESAMPLE_LAS_LAYOUT_H
