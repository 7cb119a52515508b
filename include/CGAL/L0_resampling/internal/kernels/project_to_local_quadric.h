// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRIC_H
#define CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRIC_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Quadric_moments.h>
#include <CGAL/L0_resampling/internal/kernels/local_surface.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Two unit vectors that span the plane across a third one, with which they form a right-handed
/// frame.
struct Tangent_frame
{
  Triple u, v, normal;

  /// \param direction of unit length but for rounding
  CGAL_L0_HOST_DEVICE explicit Tangent_frame(const Triple& direction)
    : u(any_orthogonal(direction)), v(), normal(normalized(direction))
  {
    v = cross(normal, u);
  }
};

/// What becomes of a sample among others that agree with it.
struct Projected_sample
{
  double height; ///< by which it moves along its normal
  Triple normal;
};

/// See `project_to_local_quadrics()`.
/// \param moments of the others, in the frame, relative to the sample, lengths in units of `radius`
/// \param noise \f$ W \tau^2 \f$, in the same units
/// \param radius of the ball
CGAL_L0_HOST_DEVICE inline Projected_sample project_to_local_quadric(
  const Quadric_moments<double>& moments, double noise, const Tangent_frame& frame, double radius)
{
  if (!(noise > 0))
    return {0, frame.normal};
  const double believed = square(maximum_roughness) * noise / moments.products[0];
  double height = 0;
  Triple normal = {0, 0, 1}; // in the frame
  const auto settle_on = [&](const Local_surface& surface) {
    height = (1 - surface.share) * height + surface.share * surface.height;
    normal = (1 - surface.share) * normal + surface.share * surface.normal;
  };
  settle_on(fit_local_surface(moments, believed));
  settle_on(fit_local_surface(moments.plane_moments(), {0, 0, 1}, believed));
  return {radius * height,
          normalized(normal.x * frame.u + normal.y * frame.v + normal.z * frame.normal)};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRIC_H
