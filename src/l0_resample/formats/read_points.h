// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_READ_POINTS_H
#define L0_RESAMPLE_READ_POINTS_H

#include "basis/Point_cloud.h"
#include "files/Input_file.h"
#include "files/file_formats.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace l0_tool {

/// From left to right.
using Column_names = std::vector<std::string>;

struct Read_options
{
  std::uint64_t max_points = (std::numeric_limits<std::uint64_t>::max)();
  std::uint64_t max_memory =
    (std::numeric_limits<std::uint64_t>::max)(); ///< in bytes, for all that is kept of points
  bool drop_non_finite =
    false; ///< drop and count points with a non-finite coordinate instead of refusing the file
  bool with_normals = false; ///< keep the normals, if the file has any
  bool with_properties =
    false; ///< keep all that the file tells of each point, and warn of what cannot be kept
  bool with_wide_colors = false; ///< keep the 16 bits that a channel of a color has in LAS
  std::vector<unsigned>
    classes; ///< keep the points whose property `classification` is one of these; empty for all
  bool only_first_returns = false; ///< keep the points whose property `return_number` is at most 1
  std::string decompression; ///< command whose output is read in place of a file of LAZ, as of
                             ///< `Command_output`; empty if there is none
  Column_names columns;      ///< of XYZ and CSV, as from `parse_column_names()`; empty if unnamed
  /// Gets each point as it is read, with its properties in the types that `Point_cloud::narrowed`
  /// has in the end; then the cloud stays empty, and `max_memory` is for what a reader holds of a
  /// file
  std::function<void(const Point&, const Property_table&, const char* row)> on_point;
};

/*!
Reads the points of a file that nobody vouches for: no header and no content makes it crash, hang or
take more memory than the file's size justifies.

What gzip has compressed, of any of these formats, is read as what it stands for.

- PLY, ASCII or binary of either byte order: one element `vertex` with the scalar properties x, y, z
  and maybe nx, ny, nz, of any type. Its other scalar properties can be kept. Elements before it are
  skipped, those after it are not looked at.
- OFF with its optional prefixes ST, C, N: the vertices. Only N says that there are normals, and
  only C that there are colors, which become the properties red, green, blue and maybe alpha.
- XYZ: one point a line, the same number of columns in all of them. The first line may hold the
  number of points, and without it there has to be a point; empty lines and those that begin with #
  are skipped. The first three columns are coordinates, and if there are exactly six, the others are
  normals, unless more than 5 % of them have another length than 1: then a warning says so. Columns
  with names are read as `Text_columns` does.
- PCD, ASCII, binary or compressed, of version 0.5 to 0.7: the fields x, y, z and maybe normal_x,
  normal_y, normal_z, of any type but integers of 64 bits, and the place of the viewpoint. Of the
  other fields that can be kept, one of several values becomes as many properties, and the packed
  colors rgb and rgba become the properties red, green, blue and alpha.
- NPY: an array of float32, float64 or integers, of shape (n, 3), or (n, 6) for points with
  normals, in the order of C or Fortran. Integers of 64 bits are rounded to double precision.
- CSV: a table with a header line, whose columns are separated by commas, semicolons, tabs or
  blanks. The line names them, maybe in quotes or behind # or //: x, y, z and maybe nx, ny, nz or
  normal_x, normal_y, normal_z, in upper or lower case, and r, g, b for a color. Other columns of
  numbers are properties, as `Text_columns` has them. Names of `columns` go before those of the
  file, which then needs none. An empty value is NaN.
- OBJ: the vertices (v) and, if there are as many of them, the vertex normals (vn), of which the
  i-th is taken for that of the i-th vertex. Three numbers behind x, y, z (and maybe w) are a
  color. What else the file has is skipped.

- LAS 1.0 to 1.4, point data record formats 0 to 10: the coordinates in double precision, and as
  properties the fields of `las_fields()` and the extra bytes that the file describes, but for
  integers of 64 bits. Extra bytes nx, ny, nz or NormalX, NormalY, NormalZ in floating-point numbers
  are normals. Colors get 8 bits a channel, unless `with_wide_colors`; a file whose channels are all
  below 256 has them already. Points that are flagged as withheld are left out. LAZ is refused
  without a command that decompresses it.

The filters `classes` and `only_first_returns` need `with_properties`, and act in all formats.

\throws Failure with INPUT_REFUSED and the line or byte where the file is not what it should be, has
not the property that a filter looks at, or holds more than
        `max_points`; with RUN_TIME_FAILURE where the points need more than `max_memory`; with the
        status of an interrupt
*/
Point_cloud read_points(const std::string& path, File_format format, const Read_options& options,
                        Input_file::On_progress on_progress = {});

} // namespace l0_tool

#endif // L0_RESAMPLE_READ_POINTS_H
