// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_POINT_CLOUD_H
#define L0_RESAMPLE_POINT_CLOUD_H

#include "basis/Las_origin.h"
#include "basis/Number_type.h"
#include "basis/Property_table.h"

#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace l0_tool {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented_point = std::pair<Point, Vector>;
using Crease = CGAL::L0_resampling::Crease<Kernel>;
using Crease_corner = CGAL::L0_resampling::Crease_corner<Kernel>;

/// What the 16 bits that a channel of a color has in LAS hold, by the values of all points.
enum class Las_colors
{
  NONE,         ///< or all are black
  BYTES,        ///< as they are
  SCALED_BYTES, ///< times 256 or 257
  FINE
};

/// How a property was read, if its values became others once all were there.
struct Narrowed_property
{
  Number_type type; ///< before
  unsigned shift;   ///< the bits that values have lost at their lower end
};

/// What a file held.
struct Point_cloud
{
  std::vector<Point> points;               ///< all finite
  std::vector<Vector> normals;             ///< of length 1, 0 or NaN: one for each point, or none
  bool file_has_normals = false;           ///< also if they are not kept
  Property_table properties;               ///< all others, if asked for
  std::vector<Narrowed_property> narrowed; ///< of all properties, or none if they are as read
  Number_type coordinate_type =
    Number_type::FLOAT64; ///< FLOAT32 if that held all coordinates and normals
  std::optional<std::array<double, 3>>
    viewpoint; ///< of PCD or of the camera in PLY, if it is not the origin
  std::size_t number_of_dropped_points = 0; ///< those with a coordinate that is not finite
  std::optional<Las_origin> las;            ///< of LAS
  Las_colors las_colors = Las_colors::NONE; ///< likewise, if properties were asked for
  std::string degrees; ///< what says that x and y are longitude and latitude; empty if nothing does
  std::vector<std::string> warnings; ///< one line each, with the name of the file
  std::vector<std::string> notes;    ///< as `warnings`, of what is as it should be
};

/// The property that says which points of a result are on creases.
constexpr const char* name_of_crease_marks = "crease";

/// What is found of each point of a result.
struct Result_column
{
  std::string name;
  std::vector<float> values;
  Number_type type = Number_type::FLOAT32;
  bool is_written = true; ///< or found for the page alone
};

/// What is written.
struct Resampled_points
{
  std::vector<Oriented_point> points;
  Property_table properties;     ///< one row for each point
  std::optional<Las_origin> las; ///< of an input in LAS
  std::vector<float>
    feature_confidences; ///< for the snapshot, if asked for; they are among the properties too
  std::vector<Result_column>
    columns; ///< for the page, whether they are among the properties or not
  std::optional<std::array<double, 3>> viewpoint; ///< that the call had, if all points had one
  std::vector<Crease> creases;                    ///< if asked for
  std::vector<Crease_corner> corners;             ///< likewise
  std::vector<std::size_t> outliers;              ///< likewise: points of the input, ascending
};

} // namespace l0_tool

#endif // L0_RESAMPLE_POINT_CLOUD_H
