// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_SPLAT_RENDERER_H
#define L0_RESAMPLE_SPLAT_RENDERER_H

#include "pictures/Camera.h"
#include "pictures/Image.h"

#include <array>
#include <vector>

namespace l0_tool {

/// In the directions of `Projected_point`.
using Direction = std::array<float, 3>;

/// A disc in space as the camera sees it.
struct Splat
{
  /// What lies behind a plane.
  struct Half_space
  {
    Direction normal = {0, 0, 0};
    float offset = 0; ///< of the plane from the center of the disc, in pixels; not negative
  };

  Projected_point center;
  float radius;     ///< in pixels
  Direction normal; ///< of unit length; (0, 0, 1) faces the eye
  Color color;
  float colored_share = 1;         ///< of the radius: the rest of the disc is white
  std::array<Half_space, 2> clips; ///< to draw what lies in all of them
};

/*!
Draws the discs on white, smooth at their edges. Of discs that overlap, each shows what lies nearest
to its center, so that they may be large enough to leave no gap: their rims give way to others as if
they were bent away from the eye.
*/
Image render_splats(const std::vector<Splat>& splats, int width, int height);

} // namespace l0_tool

#endif // L0_RESAMPLE_SPLAT_RENDERER_H
