// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_VIEW_H
#define L0_RESAMPLE_VIEW_H

#include "basis/Point_cloud.h"

#include <array>
#include <optional>
#include <vector>

namespace l0_tool {

/// From where points are drawn.
struct View
{
  Vector towards_eye = Vector(0.6, 0.55, 1); ///< not zero; by default from the front right above
  Vector up = Vector(0, 1, 0);               ///< not zero
  /// Whether what is turned away from the eye is left out, as of a room that is looked into
  bool is_cut_open = false;
};

/// What is known of a cloud that is to be drawn.
struct Known_sides
{
  std::optional<std::array<double, 3>> towards_eye; ///< as somebody wants it
  std::optional<std::array<double, 3>> up;
  std::vector<Point> viewpoints; ///< of all points, of each, or none
};

/*!
Chooses a view that shows what the points are. Where a few planes hold most of them, as in scans of
rooms and facades and in drawings of machines, z points up, unless these planes stand on y (see
`is_y_vertical()`), else y, as in most models of figures.
The eye is on the side that was seen, or the broad one, where the ground is, a little above; a scene
that surrounds its viewpoints is cut open. Where the eye looks along z, y points up, or down where
it is that of a camera that looks along its z.

\param result of which the normals tell the planes
*/
View choose_view(const std::vector<Oriented_point>& result, const Known_sides& known);

} // namespace l0_tool

#endif // L0_RESAMPLE_VIEW_H
