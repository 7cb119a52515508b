// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_VERTICAL_AXIS_H
#define L0_RESAMPLE_VERTICAL_AXIS_H

#include "basis/Point_cloud.h"

#include <vector>

namespace l0_tool {

/// Whether few planes hold most points, as of buildings, rooms and machined parts.
bool are_planes(const std::vector<Oriented_point>& points);

/*!
Whether y is the vertical of such points; else it is z, as in most scans. The criteria are

- the share of points in floors across the axis or in walls along it that meet at right angles,
  whatever their direction is, if it differs between y and z;
- else, as where walls go along x and z, the faces of the bounding box that hold points. y is the
  vertical if its lower face is the only one, as of ground with walls on it; or if the lower faces
  of y and z and at least two more hold points, as of a room, and that of y is the larger one. Of a
  building without ground nothing holds the lower face.
*/
bool is_y_vertical(const std::vector<Oriented_point>& points);

} // namespace l0_tool

#endif // L0_RESAMPLE_VERTICAL_AXIS_H
