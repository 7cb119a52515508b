// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DEVIATION_OF_SAMPLE_H
#define CGAL_L0_RESAMPLING_INTERNAL_DEVIATION_OF_SAMPLE_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/lengths_of_refinement.h>
#include <CGAL/L0_resampling/internal/kernels/risk_of_surface.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// By how much the errors of the positions of refined samples exceed the standard deviations of
/// their fits. A mean by risk is as wide as its bias allows, so that bias and deviation grow
/// together; measured on ten shapes at six noises, see the manual.
constexpr double deviation_per_deviation_of_fit = 2.5;

/// Within how far normals are compared: the standard deviation of their weights, per that of where
/// the points of a disk lie. Measured like the factor above.
constexpr double extent_of_normals = 1.2;

/// The mean square of the angle to a normal of which nothing is known, whichever side it points to:
/// \f$ \int_0^{\pi/2} \theta^2 \sin\theta \, d\theta \f$.
constexpr double squared_angle_of_any_normal = 1.1415926535897931;

/// How far a sample may be off the surface, and its normal off that of the surface.
struct Deviations
{
  float position; ///< standard deviation along the normal
  float normal;   ///< standard deviation of the angle, in radians
};

/// What the fits of the last round tell of a sample.
struct Variances_of_fit
{
  float position = 0, normal = 0;

  Variances_of_fit() = default;
  /// \param lengths at the sample
  CGAL_L0_HOST_DEVICE Variances_of_fit(const Mean_surface& mean,
                                       const Lengths_of_refinement& lengths)
  {
    if (!lengths.can_move_to(mean))
    {
      position = float(square(lengths.noise_of_disk())); // that of a point
      normal = float(squared_angle_of_any_normal);
      return;
    }
    position = float(square(deviation_per_deviation_of_fit) * mean.height_variance / mean.weight);
    normal = float(2 * double(mean.slope_variance) / mean.weight); // of both slopes
  }
};

/// A ball around a sample that the normals around are compared in: what the noise, and the unit
/// that surfaces are resolved to, let it be mistaken for.
struct Ball_of_normals
{
  float per_squared_distance, squared_radius;

  /// \param lengths at the sample
  CGAL_L0_HOST_DEVICE explicit Ball_of_normals(const Lengths_of_refinement& lengths)
    : per_squared_distance(float(0.5 / squared_extent(lengths))),
      squared_radius(float(square(reach_of_disk) * squared_extent(lengths)))
  {}

  /// \param lengths at scale 1
  static double maximum_radius(const Lengths_of_refinement& lengths)
  {
    return reach_of_disk * std::sqrt(squared_extent(lengths));
  }

private:
  CGAL_L0_HOST_DEVICE static double squared_extent(const Lengths_of_refinement& lengths)
  {
    return square(extent_of_normals) * (square(lengths.noise_of_disk()) + square(lengths.unit));
  }
};

/// The squared length of the difference of two normals, whichever side they point to.
/// \tparam S a number, or lanes of numbers
template <typename S>
CGAL_L0_HOST_DEVICE S squared_difference_of_normals(const S& ax, const S& ay, const S& az,
                                                    const S& bx, const S& by, const S& bz)
{
  const auto squared_length = [](const S& x, const S& y, const S& z) {
    return S(x * x + y * y + z * z);
  };
  const S difference = squared_length(ax - bx, ay - by, az - bz),
          sum = squared_length(ax + bx, ay + by, az + bz);
  return difference - at_least(S(difference - sum), 0);
}

/// Sums over the samples of such a ball.
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Angles_around
{
  S weight = S(), squared_angles = S();

  /// \param squared_angle between a normal there and that in the middle
  CGAL_L0_HOST_DEVICE void add(const Ball_of_normals& ball, const S& squared_distance,
                               const S& squared_angle)
  {
    const S w = where_less(S(squared_distance - ball.squared_radius), 0.f,
                           decay(S(squared_distance * ball.per_squared_distance)));
    weight += w;
    squared_angles += w * squared_angle;
  }
};

/// \param around of all samples of the ball, itself among them
CGAL_L0_HOST_DEVICE inline Deviations deviations_of_sample(const Variances_of_fit& of_fit,
                                                           const Angles_around<float>& around)
{
  // the difference of two normals has twice the variance of each
  const double spread = around.weight > 0 ? 0.5 * around.squared_angles / around.weight : 0,
               most = squared_angle_of_any_normal, squared_angle = of_fit.normal + spread;
  return {float(std::sqrt(double(of_fit.position))),
          float(std::sqrt(squared_angle < most ? squared_angle : most))};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DEVIATION_OF_SAMPLE_H
