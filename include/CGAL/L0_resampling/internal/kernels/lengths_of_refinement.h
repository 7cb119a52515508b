// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_LENGTHS_OF_REFINEMENT_H
#define CGAL_L0_RESAMPLING_INTERNAL_LENGTHS_OF_REFINEMENT_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/kernels/clearance.h>
#include <CGAL/L0_resampling/internal/kernels/disk_of_sample.h>
#include <CGAL/L0_resampling/internal/kernels/project_to_local_quadric.h>
#include <CGAL/L0_resampling/internal/kernels/risk_of_surface.h>
#include <CGAL/L0_resampling/internal/kernels/surface_of_disks.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// How often the refinement is repeated, and how often samples then slide clear of creases.
constexpr int number_of_refinements = 2, number_of_clearances = 2;

/// The unit of the refinement per spacing of the points: a disk that large has two of them.
constexpr double unit_per_point_spacing = 1.4;

/// The lengths of the refinement.
struct Lengths_of_refinement
{
  double unit;                 ///< of all radii
  double noise;                ///< standard deviation of the points across the surface
  double spacing;              ///< of the samples
  bool is_noise_known = false; ///< by the caller: then it is not looked for around samples

  /// The lengths at a sample.
  /// \param noise_ratio of the noise there to that of the cloud
  CGAL_L0_HOST_DEVICE Lengths_of_refinement at(double scale, double noise_ratio) const
  {
    return {unit * scale, noise * noise_ratio, spacing, is_noise_known};
  }

  CGAL_L0_HOST_DEVICE Lengths_of_refinement widened(double widening) const
  {
    return {unit, widening * noise, spacing, is_noise_known};
  }

  CGAL_L0_HOST_DEVICE double noise_of_disk() const
  {
    const double least = minimum_noise_per_unit * unit;
    return noise > least ? noise : least;
  }
  CGAL_L0_HOST_DEVICE Disk_kernel<float> kernel_of_disk() const
  {
    return disk_kernel(unit, noise_of_disk(), spacing);
  }
  /// The reach of a disk.
  double reach_of_disk() const
  {
    return internal::reach_of_disk * std::sqrt(squared_extent_of_disk(unit, noise_of_disk()));
  }

  /// How many points of the noise of scale 1 a disk stands for.
  /// \param noise_of_cloud `noise_of_disk()` of that
  CGAL_L0_HOST_DEVICE float information(const Disk& disk, double noise_of_cloud) const
  {
    const double least = 1e-6; // so that disks without points stand for something
    return float((disk.weight > least ? disk.weight : least)
                 * square(noise_of_cloud / noise_of_disk()));
  }
  /// Of the height of the points of a disk.
  CGAL_L0_HOST_DEVICE double deviation(const Disk& disk) const
  {
    const double of_height = noise_of_disk() * std::sqrt(double(disk.variance)),
                 least = minimum_deviation_of_disk * unit;
    return of_height > least ? of_height : least;
  }

  /// Of the quadric of the smallest balls in the reference: exact points need no larger ones.
  CGAL_L0_HOST_DEVICE float share_of_smallest_reference() const
  {
    const double exact = 0.05;
    return float(as_share(2 - noise_of_disk() / (exact * unit)));
  }

  /// Whether a sample may move so far along its normal.
  CGAL_L0_HOST_DEVICE bool is_near(double height) const
  {
    return std::abs(height) < noise_of_disk() + 0.5 * unit;
  }
  /// Whether there is such a surface, and it is near.
  CGAL_L0_HOST_DEVICE bool can_move_to(const Mean_surface& mean) const
  {
    return mean.weight > 0 && is_near(double(mean.height) / double(mean.weight));
  }
};

/// A sample on the mean of its surfaces; where it is if there is none, or that is far off.
struct Settled_on_mean
{
  double height = 0; ///< by which it moves along its normal
  Triple normal;
  Bend bend;

  CGAL_L0_HOST_DEVICE Settled_on_mean(const Mean_surface& mean, const Triple& old_normal,
                                      const Lengths_of_refinement& lengths)
    : normal(old_normal)
  {
    const double weight = mean.weight;
    if (!lengths.can_move_to(mean))
      return;
    const Tangent_frame frame(old_normal);
    height = mean.height / weight;
    normal = normalized(frame.normal + -mean.slope_u / weight * frame.u
                        + -mean.slope_v / weight * frame.v);
    bend = bend_of(mean.uu / weight, mean.uv / weight, mean.vv / weight, frame.u, frame.v);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_LENGTHS_OF_REFINEMENT_H
