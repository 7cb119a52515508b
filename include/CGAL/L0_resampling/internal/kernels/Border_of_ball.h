// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_BORDER_OF_BALL_H
#define CGAL_L0_RESAMPLING_INTERNAL_BORDER_OF_BALL_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Where the mean of the points lies more standard deviations away than the first of these shares
/// of what it does on a border, a sample is pushed less and less outwards, and at the second not at
/// all.
constexpr double held_back_from = 0.15, held_back_to = 0.5;

/// Where the mean of points lies within the surface, as seen from a sample: in the direction in
/// which it is the most standard deviations of the points away, which is Fisher's (1936) linear
/// discriminant. Along a line of few points their mean is off by chance; across it, it tells that
/// the sample is beside the line. A few points vary less than what they are taken from does: what a
/// mean of points on a border varies by is added, which is all there is of a single point.
struct Offset_of_mean
{
  Triple direction = {0, 0, 0};        ///< of unit length, if the mean is elsewhere
  double distance = 0, deviations = 0; ///< in that direction

  /// \param points relative to the sample; with `sum` positive
  /// \param number of points that vary as much as these do with their weights
  /// \param normal of the surface, of unit length
  /// \param variance_on_border of points in any direction
  CGAL_L0_HOST_DEVICE Offset_of_mean(const Plane_moments<double>& points, double number,
                                     const Triple& normal, double variance_on_border)
  {
    const Triple u = any_orthogonal(normal), v = cross(normal, u),
                 mean = 1 / points.sum * Triple{points.x, points.y, points.z};
    const Symmetric_matrix covariance = points.covariance();
    const Triple along_covariance_of_u = multiply(covariance, u);
    const double added = variance_on_border / number;
    const double uu = dot(u, along_covariance_of_u) + added, uv = dot(v, along_covariance_of_u),
                 vv = dot(v, multiply(covariance, v)) + added;
    const double mean_u = dot(mean, u), mean_v = dot(mean, v);
    const double along_u = vv * mean_u - uv * mean_v, along_v = uu * mean_v - uv * mean_u,
                 length = std::sqrt(square(along_u) + square(along_v));
    if (!(length > 0))
      return;
    const double product = along_u * mean_u + along_v * mean_v;
    direction = 1 / length * (along_u * u + along_v * v);
    distance = product / length;
    deviations = std::sqrt(product / (uu * vv - square(uv)));
  }
};

/// How the points of a ball, each weighted by \f$ e^{-d^2/\sigma^2} \f$, tell a border: by how
/// many standard deviations away their mean lies, compared with what that is on a straight border.
/// So a strip that is narrower than the ball ends where its points do.
struct Border_of_ball
{
  double variance;   ///< of the points of half a disk across its straight side, at scale 1
  double deviations; ///< how many of its roots their mean is away from that side

  /// By the integrals over half a disk, with \f$ s = radius / \sigma \f$: for large s the mean is
  /// \f$ \sigma / \sqrt\pi \f$ away, and the points vary by \f$ \sigma^2 (1/2 - 1/\pi) \f$ about
  /// it; times what the cut at the radius leaves.
  Border_of_ball(double radius, double squared_bandwidth)
  {
    const double bandwidth = std::sqrt(squared_bandwidth), pi = 3.141592653589793,
                 s = radius / bandwidth, cut = std::exp(-s * s),
                 second_moment = squared_bandwidth / 2 * (1 - s * s * cut / (1 - cut)),
                 distance = bandwidth * (std::erf(s) / std::sqrt(pi) - 2 / pi * s * cut)
                            / (1 - cut);
    variance = second_moment - square(distance);
    deviations = distance / std::sqrt(variance);
  }

  /// The share of the outward part of a push that is left out.
  CGAL_L0_HOST_DEVICE double share_held_back(const Offset_of_mean& offset) const
  {
    return as_share((offset.deviations / deviations - held_back_from)
                    / (held_back_to - held_back_from));
  }

  /// How far back a sample beyond the border is drawn.
  CGAL_L0_HOST_DEVICE double way_back(const Offset_of_mean& offset) const
  {
    return offset.deviations > deviations ? offset.distance * (1 - deviations / offset.deviations)
                                          : 0;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_BORDER_OF_BALL_H
