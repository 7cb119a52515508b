// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PLANE_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PLANE_H

#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A plane through the points of a ball.
struct Plane_of_ball : Fitted_plane
{
  std::size_t number_of_points;

  template <typename T>
  Eigen::Matrix<T, 3, 1> normal_as() const
  {
    return {T(normal.x), T(normal.y), T(normal.z)};
  }
};

/// Fits a plane to the candidates in the ball around `center`, as `Plane_moments::plane()` does.
template <typename T>
Plane_of_ball fit_plane(const Eigen::Matrix<T, 3, 1>& center, Local_points<T>& candidates,
                        T squared_radius)
{
  using L = Lanes<T>;
  Plane_moments<L> lanes;
  candidates.for_each_run_in_ball(
    center, squared_radius, [&](std::size_t k, const L& squared_distance) {
      lanes.add(L::load(&candidates.x[k]) - center[0], L::load(&candidates.y[k]) - center[1],
                L::load(&candidates.z[k]) - center[2],
                where_less(squared_distance, squared_radius, L(T(1))));
    });
  const Plane_moments<double> moments = sum_of_lanes(lanes);

  return {moments.plane(double(squared_radius), double(std::numeric_limits<T>::epsilon())),
          std::size_t(moments.sum)};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PLANE_H
