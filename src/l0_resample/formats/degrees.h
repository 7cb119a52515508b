// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_DEGREES_H
#define L0_RESAMPLE_DEGREES_H

#include "basis/Las_origin.h"

#include <CGAL/Bbox_3.h>

#include <string>

namespace l0_tool {

/// What a file says about x and y.
struct Horizontal_system
{
  bool is_told = false;
  bool is_geographic = false; ///< longitude and latitude
  std::string told_by;        ///< as "its GeoTIFF keys say"
};

/// By the GeoTIFF keys or the WKT among the records, of which the one counts that the file says.
Horizontal_system horizontal_system_of(const Las_origin& origin);

/// Whether coordinates can hardly be anything but degrees and heights in metres: they are on the
/// globe, farther from the origin than they are wide, and 100 times as high as wide.
bool look_like_degrees(const CGAL::Bbox_3& box);

/// The same of LAS, where it is enough that z has 100 times the scale of x and y, and where these
/// have a scale that can tell points apart in degrees.
bool look_like_degrees(const CGAL::Bbox_3& box, const Las_origin& origin);

} // namespace l0_tool

#endif // L0_RESAMPLE_DEGREES_H
