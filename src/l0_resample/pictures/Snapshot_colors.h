// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_SNAPSHOT_COLORS_H
#define L0_RESAMPLE_SNAPSHOT_COLORS_H

namespace l0_tool {

enum class Snapshot_colors
{
  SHADED, ///< gray, blue where the normal is turned away from the eye
  NORMALS ///< by the direction of the normal, as in the figures of the paper
};

} // namespace l0_tool

#endif // L0_RESAMPLE_SNAPSHOT_COLORS_H
