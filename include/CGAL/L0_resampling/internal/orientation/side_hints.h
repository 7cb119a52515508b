// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SIDE_HINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SIDE_HINTS_H

#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/orientation/orient_normals.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the caller says of the sides of the samples, where they are when it is asked for.
/// \param positions, hints of the samples, in the frame; no hints, or one each. Both outlive the
/// result.
template <typename T>
Side_hints side_hints(const Parameters& parameters, const Working_frame& frame,
                      const Buffer<Vector>& positions,
                      const Buffer<Eigen::Matrix<T, 3, 1>>& hints_of_samples)
{
  Side_hints hints;
  hints.are_viewpoints = parameters.has_viewpoint || parameters.hints_are_viewpoints;
  if (!hints_of_samples.empty())
    hints.direction_of = [&](Index i) -> Vector {
      return hints_of_samples[i].template cast<double>();
    };
  else if (parameters.has_viewpoint)
  {
    Viewpoint viewpoint = parameters.viewpoint;
    Eigen::Map<Vector> place(viewpoint.coordinates);
    if (viewpoint.weight > 0)
      place = frame.point_in_frame(place);
    hints.direction_of = [&positions, viewpoint](Index i) -> Vector {
      double direction[3];
      viewpoint.find_direction(positions[i].data(), direction);
      return Eigen::Map<Vector>(direction);
    };
  }
  return hints;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SIDE_HINTS_H
