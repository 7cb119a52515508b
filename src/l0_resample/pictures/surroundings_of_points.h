// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_SURROUNDINGS_OF_POINTS_H
#define L0_RESAMPLE_SURROUNDINGS_OF_POINTS_H

#include "basis/Point_cloud.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace l0_tool {

/// What the surface is like around a point.
struct Surroundings
{
  double spacing = 0; ///< of the points nearby, half to twice that of most points
  Vector normal =
    CGAL::NULL_VECTOR; ///< as given, or of a plane that fits and any sign; unit or zero

  /// Points nearby that lie across sharp convex edges, as far as normals are given.
  std::array<std::optional<std::size_t>, 2> across_edges;
};

/// Of each point. In a large cloud, most points take those of the nearest one of a sample.
/// \param normals one for each point, of any length, or none at all
std::vector<Surroundings> surroundings_of_points(const std::vector<Point>& points,
                                                 const std::vector<Vector>& normals);

} // namespace l0_tool

#endif // L0_RESAMPLE_SURROUNDINGS_OF_POINTS_H
