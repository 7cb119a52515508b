// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_RENDER_SNAPSHOT_H
#define L0_RESAMPLE_RENDER_SNAPSHOT_H

#include "basis/Point_cloud.h"
#include "pictures/Image.h"
#include "pictures/View.h"

#include <array>
#include <optional>
#include <vector>

namespace l0_tool {

/// Draws the input on the left and the result on the right, seen by the same camera in the same
/// light, a row for each view: as surfaces of discs that are large enough to leave no gap. An input
/// without normals is gray, and lit as planes through its points would be.
/// \param feature_confidences of the result, in [0, 1], or none; with some, the shaded result is
/// the redder the higher they are
/// \param as_dots whether a white surface has a dot for each point, which shows how they lie
/// \param viewpoints of the points of the input, one for all or one for each: of a view that is cut
/// open they tell what of the input is turned away from the eye
Image render_snapshot(const Point_cloud& input, const std::vector<Oriented_point>& result,
                      const std::vector<View>& views, const std::vector<Point>& viewpoints,
                      const std::vector<float>& feature_confidences,
                      const std::vector<std::vector<Point>>& lines, Snapshot_colors colors);

/// The same, not cut open, and with y pointing up.
/// \param towards_eye not zero; by default from the front right, a little above
Image render_snapshot(const Point_cloud& input, const std::vector<Oriented_point>& result,
                      const std::optional<std::array<double, 3>>& towards_eye,
                      const std::vector<float>& feature_confidences = {},
                      Snapshot_colors colors = Snapshot_colors::SHADED, bool as_dots = false,
                      const std::vector<std::vector<Point>>& lines = {});

/// Creases of a result, as the lines of a snapshot.
std::vector<std::vector<Point>> lines_of_creases(const std::vector<Crease>& creases,
                                                 const std::vector<Oriented_point>& result);

} // namespace l0_tool

#endif // L0_RESAMPLE_RENDER_SNAPSHOT_H
