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
  Column_names columns; ///< of XYZ, CSV and NPY, as from `parse_column_names()`; empty if unnamed
  /// What becomes of a file whose x and y are degrees, so that they are no lengths as heights are.
  enum class Degrees
  {
    REFUSE,
    WARN,
    ACCEPT
  };
  Degrees degrees = Degrees::ACCEPT;
  bool needs_names_of_rest =
    false; ///< refuse more columns than x, y and z, or these and a normal, where none has a name
  std::string how_to_name_columns = "--columns can name them"; ///< for messages
  bool has_decimal_commas = false; ///< texts have them in place of points
  /// Gets each point as it is read, with its properties in the types that `Point_cloud::narrowed`
  /// has in the end; then the cloud stays empty, and `max_memory` is for what a reader holds of a
  /// file
  std::function<void(const Point&, const Property_table&, const char* row)> on_point;
};

/*!
Reads the points of a file that nobody vouches for: no header and no content makes it crash, hang or
take more memory than the file's size justifies.

What gzip has compressed, of any of these formats, is read as what it stands for.

The columns of tables of all formats have the names of `usual_names()`. Normals are unit vectors: if
more than 5 % of those that are neither 0 nor NaN have another length than 1, they are none, and a
warning says so, unless the names are of `columns`. Else those of another length get length 1, and a
warning says how many. A point whose normal is 0 or NaN has none.

Integers of 64 bits become doubles, in all formats that have them and for coordinates too. If some
are beyond 2^53, and so may be rounded, a warning says of which column.

- PLY, ASCII or binary of either byte order: one element `vertex`, or else one of a name such as
  `Points`, with the scalar properties x, y, z and maybe nx, ny, nz, of any type of PLY or integers
  of 64 bits. Its other scalar properties of these types can be kept. Those of bool and half are
  left out, and in ASCII those of any other type. One element `camera` with view_px, view_py,
  view_pz is the viewpoint. Other elements are skipped, as far as one of these comes behind them.
- OFF with its optional prefixes ST, C, N, or ST, N, C, in capital letters or small ones: the
  vertices. Only N says that there are normals, and only C that there are colors, which become the
  properties red, green, blue and maybe alpha. Of other numbers behind those a warning tells.
- XYZ: one point a line, the same number of columns in all of them, separated by blanks and tabs, or
  by commas or semicolons. Before the points may be a line that names the columns, maybe behind #,
  //, %, ! or ;, and one that holds their number, maybe behind a name and a colon; without it there
  has to be a point. If there were as many, another number may follow, with the points of another
  block, and a block may be empty. Empty lines and others that begin with #, //, %, ! or a single ;
  are skipped. Of columns without names the first three are coordinates, and if there are exactly
  six, the others are normals; before them may be one of texts.
- CSV: the same, where a line or `columns` has to name the columns. Names may stand in quotes. Other
  columns of numbers are properties, as `Named_columns` has them. Names of `columns` go before those
  of the file, which then needs none. An empty value is NaN, as NA is.
- PCD, ASCII, binary or compressed, of version 0.5 to 0.7: the fields x, y, z and maybe normal_x,
  normal_y, normal_z, of any type but bool, and the viewpoint. One field may hold all coordinates,
  as xyz, or all of a normal or a color. Of the other fields that can be kept, one of several values
  becomes as many properties, and the packed colors rgb and rgba become the properties red, green,
  blue and alpha.
- NPY: an array of floating-point numbers or integers, of shape (n, 3), or (n, 6) for points with
  normals, in the order of C or Fortran, or of more columns, which `columns` names; in the order of
  C the points may be those of an image, (h, w, 3). Or an array of records, of any shape, whose
  fields are numbers, several of them or other records; `columns` names all their numbers.
- OBJ: the vertices (v) and the vertex normals (vn) that the faces (f) give them. A vertex with
  several gets their mean, with length 1. Where faces give none, the i-th normal is that of the i-th
  vertex, if there are as many. Three numbers behind x, y, z (and maybe w) are a color. What else
  the file has is skipped.
- LAS 1.0 to 1.4, point data record formats 0 to 10: the coordinates in double precision, and as
  properties the fields of `las_fields()` and the extra bytes that the file describes. Extra bytes
  in floating-point numbers may be normals. Colors get 8 bits a channel, unless `with_wide_colors`;
  a file whose channels are all below 256 has them already. That x and y are degrees is told by its
  records, or else by coordinates that can be nothing else. Points that are flagged as withheld are
  left out. LAZ is refused without a command that decompresses it, which starts where the name or,
  of a file that is no pipe, the content is that of LAZ.

The filters `classes` and `only_first_returns` need `with_properties`, and act in all formats.

\throws Failure with INPUT_REFUSED and the line or byte where the file is not what it should be, has
not the property that a filter looks at, or holds more than
        `max_points`; with RUN_TIME_FAILURE where the points need more than `max_memory`; with the
        status of an interrupt
*/
Point_cloud read_points(const std::string& path, File_format format, const Read_options& options,
                        const Input_file::On_progress& on_progress = {});

} // namespace l0_tool

#endif // L0_RESAMPLE_READ_POINTS_H
