// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_BORDER_OF_BALL_H
#define CGAL_L0_RESAMPLING_INTERNAL_BORDER_OF_BALL_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A sample is pushed less and less outwards where the mean of its points lies further away than
/// the first of these shares of what it does in half a ball, and from the second on not at all.
constexpr double held_back_from = 0.35, held_back_to = 0.55;

/// How the points of a ball, each weighted by \f$ e^{-d^2/\sigma^2} \f$, tell a border: by how far
/// away their mean lies within the surface, compared with what it would if the border went through
/// the middle.
struct Border_of_ball
{
  double mean_distance; ///< of the points of half a disk from its straight side

  /// The integral over the disk, with \f$ s = radius / \sigma \f$: \f$ \sigma / \sqrt\pi \f$ for
  /// large s, times what the cut at the radius leaves.
  Border_of_ball(double radius, double bandwidth)
  {
    const double pi = 3.141592653589793, s = radius / bandwidth, cut = std::exp(-s * s);
    mean_distance = bandwidth * (std::erf(s) / std::sqrt(pi) - 2 / pi * s * cut) / (1 - cut);
  }

  /// The share of the outward part of a push that is left out.
  /// \param distance of the mean of the points
  CGAL_L0_HOST_DEVICE double share_held_back(double distance) const
  {
    return as_share((distance / mean_distance - held_back_from) / (held_back_to - held_back_from));
  }

  /// How far back a sample beyond the border is drawn: the mean of a Gaussian cut off at x moves by
  /// \f$ 2x/\pi \f$ for small x.
  /// \param distance of the mean of the points
  CGAL_L0_HOST_DEVICE double way_back(double distance) const
  {
    const double pi = 3.141592653589793;
    return distance > mean_distance ? pi / 2 * (distance - mean_distance) : 0;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_BORDER_OF_BALL_H
