// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_LOCAL_SURFACE_H
#define CGAL_L0_RESAMPLING_INTERNAL_LOCAL_SURFACE_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/kernels/Quadric_moments.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A surface through the points of a ball, as the point or sample at its center sees it.
struct Local_surface
{
  double share;  ///< how much it counts, `share_of_surface()`
  double height; ///< at the center, along the center's normal
  Triple normal; ///< there, of unit length, on the side of the center's
};

/// How much a surface counts that was fitted to points: the less the fewer they are, the further
/// from them the center is, the more the surface is turned from the center's normal, and the more
/// they scatter about it.
/// \param number of the points
/// \param number_of_unknowns of the surface beside its height. Through as many points, and the
/// center, there always is one
/// \param leverage the variance of the surface's height at the center, per that of the mean height
/// of the points
/// \param cosine of the angle between the surface's normal and the center's
/// \param excess the variance of the points about it, per the largest that is believed
CGAL_L0_HOST_DEVICE inline double share_of_surface(double number, int number_of_unknowns,
                                                   double leverage, double cosine, double excess)
{
  const double minimum_cosine = 0.5, full_cosine = 0.6;
  return as_share(number / number_of_unknowns - 1) * as_share(2 - leverage / maximum_leverage)
         * as_share((cosine - minimum_cosine) / (full_cosine - minimum_cosine))
         * decay(square(excess));
}

/*!
Of degree 1: a plane near the smallest eigenvector of the covariance C of the points. Its normal
comes from two steps of inverse iteration that begin at the center's normal, with a hundredth of the
trace added to C: smaller eigenvalues are rounding. So it hardly moves from there in a strip of
points, which has no plane and where a rounding would choose an eigenvector.

\param own the center's normal, of unit length but for rounding
\param believed the largest variance of points about a surface that is believed; may be infinite
*/
CGAL_L0_HOST_DEVICE inline Local_surface fit_local_surface(const Plane_moments<double>& moments,
                                                           const Triple& own, double believed)
{
  const int number_of_unknowns = 2, number_of_steps = 2;
  const double number = moments.sum, ridge = 0.01;
  const Local_surface none = {0, 0, normalized(own)};
  if (!(number > number_of_unknowns))
    return none;
  const Symmetric_matrix c = moments.covariance();
  const double trace = c.xx + c.yy + c.zz;
  if (!(trace > 0))
    return none;
  const double unit = 1 / trace;
  const Symmetric_matrix a = {unit * c.xx + ridge, unit * c.xy, unit * c.xz,
                              unit * c.yy + ridge, unit * c.yz, unit * c.zz + ridge},
                         inverse = adjugate(a); // but for the determinant
  const double determinant = a.xx * inverse.xx + a.xy * inverse.xy + a.xz * inverse.xz;
  Triple normal = none.normal;
  for (int step = 0; step < number_of_steps; ++step)
    normal = normalized(multiply(inverse, normal));

  const Triple mean = {moments.x / number, moments.y / number, moments.z / number};
  const double cosine = dot(normal, none.normal), distance = dot(normal, mean),
               variance = dot(normal, multiply(c, normal));
  const Triple offset = mean + -distance * normal; // of the mean, in the plane
  const double leverage = 1 + unit * dot(offset, multiply(inverse, offset)) / determinant,
               share = share_of_surface(number, number_of_unknowns, leverage, cosine,
                                        (variance < 0 ? 0 : variance) / believed);
  return share > 0 ? Local_surface{share, distance / cosine, normal} : none;
}

/// Of degree 2: the quadric of least squared heights over the plane across the center's normal,
/// which is (0, 0, 1).
/// \param believed as above
CGAL_L0_HOST_DEVICE inline Local_surface fit_local_surface(const Quadric_moments<double>& moments,
                                                           double believed)
{
  const int number_of_unknowns = Quadric_moments<double>::number_of_unknowns - 1;
  const double number = moments.products[0];
  const Local_surface none = {0, 0, {0, 0, 1}};
  if (!(number > number_of_unknowns))
    return none;
  const Fitted_quadric quadric = moments.quadric();
  if (!quadric.is_determined)
    return none;
  const Triple normal = normalized({-quadric.slope_u, -quadric.slope_v, 1});
  const double share = share_of_surface(number, number_of_unknowns, quadric.leverage, normal.z,
                                        quadric.variance / believed);
  return share > 0 ? Local_surface{share, quadric.height, normal} : none;
}

/// The unit normal halfway between `own` and that of the plane through the points that agree with
/// it, as far as the plane counts.
/// \param own of unit length but for rounding
CGAL_L0_HOST_DEVICE inline Triple lean_to_plane(const Plane_moments<double>& moments,
                                                const Triple& own)
{
  const double any_scatter = HUGE_VAL;
  const Local_surface plane = fit_local_surface(moments, own, any_scatter);
  return normalized(normalized(own) + plane.share * plane.normal);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_LOCAL_SURFACE_H
