// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SIDE_HINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SIDE_HINTS_H

#include <CGAL/L0_resampling/internal/Parameters.h>
#include <CGAL/L0_resampling/internal/Samples.h>
#include <CGAL/L0_resampling/internal/orient_normals.h>
#include <CGAL/L0_resampling/internal/working_frame.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the caller says of the sides of the samples, where they are when it is asked for.
template <typename FT>
Side_hints side_hints(const Parameters& parameters, const Working_frame& frame,
                      const Samples<FT>& samples)
{
  Side_hints hints;
  hints.are_viewpoints = parameters.has_viewpoint || parameters.hints_are_viewpoints;
  if (!samples.hints.empty())
    hints.direction_of = [&](Index i) -> Vector {
      return samples.hints[i].template cast<double>();
    };
  else if (parameters.has_viewpoint)
  {
    Viewpoint viewpoint = parameters.viewpoint;
    Eigen::Map<Vector> place(viewpoint.coordinates);
    if (viewpoint.weight > 0)
      place = frame.point_in_frame(place);
    hints.direction_of = [&samples, viewpoint](Index i) -> Vector {
      double direction[3];
      viewpoint.find_direction(samples.positions[i].data(), direction);
      return Eigen::Map<Vector>(direction);
    };
  }
  return hints;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SIDE_HINTS_H
