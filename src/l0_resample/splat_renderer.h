// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_SPLAT_RENDERER_H
#define L0_RESAMPLE_SPLAT_RENDERER_H

#include "Camera.h"
#include "Image.h"

#include <array>
#include <vector>

namespace l0_tool {

/// A disc in space as the camera sees it.
struct Splat
{
  Projected_point center;
  std::array<float, 3>
    normal; ///< in the directions of `Projected_point`, unit length; (0, 0, 1) faces the eye
  Color color;
};

/*!
Draws the discs on white, smooth at their edges. Those that lie behind a surface are left out,
although one could look at them between the discs in front: a first pass lets every disc grow until
the surface closes and keeps its depth.

\param spacing of the points, in pixels
\param has_normals whether the splats' normals mean something; if not, their light comes from the
  depth of what surrounds them
*/
Image render_splats(const std::vector<Splat>& splats, float spacing, bool has_normals, int width,
                    int height);

} // namespace l0_tool

#endif // L0_RESAMPLE_SPLAT_RENDERER_H
