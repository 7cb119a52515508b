// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_WRITE_CREASES_H
#define L0_RESAMPLE_WRITE_CREASES_H

#include "basis/Point_cloud.h"
#include "files/Output_file.h"

#include <optional>
#include <string>

namespace l0_tool {

enum class Crease_format
{
  OBJ, ///< lines of places, and places for corners
  PLY, ///< vertices and edges
  DXF  ///< three-dimensional polylines and points, in layers
};

/// \returns nothing for an extension that is none of theirs
std::optional<Crease_format> crease_format_of(const std::string& path);

/// Writes the creases and corners of a result, in place of an older file.
/// \throws Failure as `Output_file` does
void write_creases(const std::string& path, Crease_format format, const Resampled_points& result);

} // namespace l0_tool

#endif // L0_RESAMPLE_WRITE_CREASES_H
