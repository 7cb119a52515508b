// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRIC_H
#define CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRIC_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/kernels/Quadric_moments.h>

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
struct Settled_sample
{
  double height; ///< by which it moves along its normal
  Triple normal;
};

/// How much a surface counts that was fitted to support points: the less the fewer they are, the
/// further from them the sample is, and the more they scatter about it.
/// \param number of the support points
/// \param leverage the variance of its height at the sample, per that of the mean height of the
/// support points
/// \param excess the variance of the support points about it, per the largest that is believed
CGAL_L0_HOST_DEVICE inline double share_of_surface(double number, int number_of_unknowns,
                                                   double leverage, double excess)
{
  return share_of_support(number, number_of_unknowns) * as_share(2 - leverage / largest_leverage)
         * decay(square(excess));
}

/// See `project_to_local_quadrics()`.
/// \param moments of the others, in the frame, relative to the sample, lengths in units of `radius`
/// \param noise \f$ W \tau^2 \f$, in the same units
/// \param radius of the ball
CGAL_L0_HOST_DEVICE inline Settled_sample project_to_local_quadric(
  const Quadric_moments<double>& moments, double noise, const Tangent_frame& frame, double radius)
{
  const int unknowns_of_plane = 3,
            unknowns_of_quadric = Quadric_moments<double>::number_of_unknowns;
  const double number = moments.products[0], least_cosine = 0.5;
  if (!(number > unknowns_of_quadric && noise > 0))
    return {0, frame.normal};
  const double believed = square(largest_roughness) * noise / number;
  double height = 0;
  Triple normal = {0, 0, 1}; // in the frame
  const auto settle = [&](double share, double height_of_surface, const Triple& normal_of_surface) {
    const double rest = 1 - share;
    height = rest * height + share * height_of_surface;
    normal = {rest * normal.x + share * normal_of_surface.x,
              rest * normal.y + share * normal_of_surface.y,
              rest * normal.z + share * normal_of_surface.z};
  };

  const Plane_moments<double> plane = moments.plane_moments();
  const Eigen_decomposition eigen = plane.eigen_decomposition();
  const double determined = share_of_plane(eigen);

  const Fitted_quadric quadric = moments.quadric();
  const Triple of_quadric = normalized({-quadric.slope_u, -quadric.slope_v, 1});
  if (quadric.is_determined && of_quadric.z > least_cosine)
    settle(determined
             * share_of_surface(number, unknowns_of_quadric, quadric.leverage,
                                quadric.variance / believed),
           quadric.height, of_quadric);

  const Triple n = eigen.smallest_vector,
               mean = {plane.x / number, plane.y / number, plane.z / number};
  const double sign = n.z < 0 ? -1 : 1, across = eigen.values[0] < 0 ? 0 : eigen.values[0];
  const double height_of_plane = dot(n, mean);
  if (sign * n.z > least_cosine && determined > 0)
    settle(determined
             * share_of_surface(number, unknowns_of_plane,
                                1 + (dot(mean, mean) - square(height_of_plane)) / eigen.values[1],
                                across * number / (number - unknowns_of_plane) / believed),
           height_of_plane / n.z, {sign * n.x, sign * n.y, sign * n.z});

  return {radius * height,
          normalized({normal.x * frame.u.x + normal.y * frame.v.x + normal.z * frame.normal.x,
                      normal.x * frame.u.y + normal.y * frame.v.y + normal.z * frame.normal.y,
                      normal.x * frame.u.z + normal.y * frame.v.z + normal.z * frame.normal.z})};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRIC_H
