// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DISK_OF_SAMPLE_H
#define CGAL_L0_RESAMPLING_INTERNAL_DISK_OF_SAMPLE_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// The refinement sees the surface as a mixture of disks, one a sample, which the points scatter
// about: across by the noise, within by the size of the disk.

/// How wide a disk is, per unit of the refinement: with disks a unit apart the sum of all is flat.
constexpr double extent_of_disk = 0.5;

/// Points further off than so many standard deviations are not of the disk.
constexpr double reach_of_disk = 3;

/// The density of outliers, per that of the points of a whole surface in the middle of it.
constexpr double share_of_outliers = 0.01;

/// Noise that is less of a unit of the refinement is taken as this: exact points have some too.
constexpr double minimum_noise_per_unit = 0.01;

/*!
The density at a point of the disk of a sample,
\f[ w = \frac{a}{2 \pi \tau^2} e^{-h^2 / 2\sigma^2 - l^2 / 2\tau^2}, \qquad
\tau^2 = \sigma^2 + (u/2)^2, \f]
for a point at height h over the disk and l within its plane. a is the area that a sample stands
for, so that the sum over the disks of a whole surface is about 1 in its middle.
\tparam T a number, or lanes of numbers
*/
template <typename T>
struct Disk_kernel
{
  T per_squared_height; ///< \f$ 1 / 2\sigma^2 \f$
  T per_squared_extent; ///< \f$ 1 / 2\tau^2 \f$
  T density;            ///< \f$ a / 2\pi\tau^2 \f$
  T squared_reach;

  /// \param squared_distance of the point from the sample
  CGAL_L0_HOST_DEVICE T operator()(const T& squared_distance, const T& height) const
  {
    const T squared_height = height * height;
    return where_less(T(squared_distance - squared_reach), 0.f,
                      T(density
                        * decay(T(squared_height * per_squared_height
                                  + T(squared_distance - squared_height) * per_squared_extent))));
  }
};

CGAL_L0_HOST_DEVICE inline double squared_extent_of_disk(double unit, double noise)
{
  return noise * noise + square(extent_of_disk * unit);
}

/// \param unit of the refinement at the sample
/// \param noise at the sample
/// \param spacing of the samples there
CGAL_L0_HOST_DEVICE inline Disk_kernel<float> disk_kernel(double unit, double noise, double spacing)
{
  const double pi = 3.141592653589793, squared_extent = squared_extent_of_disk(unit, noise);
  return {float(0.5 / (noise * noise)), float(0.5 / squared_extent),
          float(spacing * spacing / (2 * pi * squared_extent)),
          float(reach_of_disk * reach_of_disk * squared_extent)};
}

/// Sums over the shares r of the points in one disk.
/// \tparam T a number, or lanes of numbers
template <typename T>
struct Shares_of_disk
{
  T shares = T(), squared_shares = T(), heights = T(), squared_heights = T(), fourth_powers = T();

  CGAL_L0_HOST_DEVICE void add(const T& share, const T& height)
  {
    const T moment = share * height;
    shares += share;
    squared_shares += share * share;
    heights += moment;
    squared_heights += moment * height;
    fourth_powers += T(moment * height) * T(height * height);
  }
};

/// What the points tell of the surface at a sample.
struct Disk
{
  float weight = 0;         ///< W, the sum of the shares
  float height = 0;         ///< Z, the mean height of the points over the sample
  float squared_height = 0; ///< the mean of the squares
  float fourth_power = 0;   ///< the mean of the fourth powers
  float variance = 1;       ///< of Z, per that of one point

  Disk() = default;
  CGAL_L0_HOST_DEVICE explicit Disk(const Shares_of_disk<float>& sums)
  {
    const float least = 1e-6f; // of a point
    if (!(sums.shares > least))
      return;
    weight = sums.shares;
    height = sums.heights / sums.shares;
    squared_height = sums.squared_heights / sums.shares;
    fourth_power = sums.fourth_powers / sums.shares;
    variance = sums.squared_shares / (sums.shares * sums.shares);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DISK_OF_SAMPLE_H
