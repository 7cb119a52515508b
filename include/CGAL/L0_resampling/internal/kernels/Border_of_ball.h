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

/// The mean of points lies away from the middle by chance, and gaps between them are no border: so
/// many of its variances are taken for chance where no edge is near. Near an edge none is: samples
/// that gaps hold back leave smaller gaps than those that are pushed over an edge do harm.
constexpr double variances_of_chance = 1.8;

/// No edge is near where the mean \f$ \sin^2 \f$ of the angles between the normals of the points
/// and that of the sample is below the first of these, and one is from the second on. On the edge
/// of a cube it is a half.
constexpr double squared_sine_of_face = 0.05, squared_sine_of_edge = 0.15;

/// How the points of a ball, each weighted by \f$ e^{-d^2/\sigma^2} \f$, tell a border: by how far
/// away their mean lies within the surface, compared with what it would if the border went through
/// the middle.
struct Border_of_ball
{
  double mean_distance;    ///< of the points of half a disk from its straight side
  double squared_distance; ///< of the points of a disk from its center, in the mean

  /// The integrals over the disk, with \f$ s = radius / \sigma \f$: \f$ \sigma / \sqrt\pi \f$ and
  /// \f$ \sigma^2 \f$ for large s, times what the cut at the radius leaves.
  Border_of_ball(double radius, double bandwidth)
  {
    const double pi = 3.141592653589793, s = radius / bandwidth, cut = std::exp(-s * s);
    mean_distance = bandwidth * (std::erf(s) / std::sqrt(pi) - 2 / pi * s * cut) / (1 - cut);
    squared_distance = bandwidth * bandwidth * (1 - (1 + s * s) * cut) / (1 - cut);
  }

  /// The share of the outward part of a push that is left out.
  /// \param distance of the mean of the points
  /// \param effective_number \f$ (\sum w)^2 / \sum w^2 \f$ of them
  /// \param squared_sine the mean of all points of the ball, those of other faces too
  CGAL_L0_HOST_DEVICE double share_held_back(double distance, double effective_number,
                                             double squared_sine) const
  {
    const double share_of_edge = as_share((squared_sine - squared_sine_of_face)
                                          / (squared_sine_of_edge - squared_sine_of_face));
    const double chance = (1 - share_of_edge) * variances_of_chance * squared_distance
                          / effective_number;
    const double beyond_chance = distance * distance - chance;
    if (!(beyond_chance > 0))
      return 0;
    return as_share((std::sqrt(beyond_chance) / mean_distance - held_back_from)
                    / (held_back_to - held_back_from));
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
