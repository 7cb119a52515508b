// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MERGED_DISK_H
#define CGAL_L0_RESAMPLING_INTERNAL_MERGED_DISK_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Disks are merged in cells of this share of the radius of the fit.
constexpr double cell_of_merged_disks = 0.2;

/// Merged disks have normals within 18 degrees, and the points of each are no further off the
/// plane of those before than this share of the cell.
constexpr double minimum_cosine_of_merged = 0.95, maximum_height_of_merged = 0.2;

/// Sums over disks, weighted by what they tell.
struct Merged_disk
{
  double information;
  Triple positions, feet, normals; ///< feet: where the points of the disks are

  CGAL_L0_HOST_DEVICE Merged_disk(const Triple& position, const Triple& normal, double height,
                                  double weight)
    : information(weight > 1e-6 ? weight : 1e-6), positions(information * position),
      feet(information * (position + height * normal)), normals(information * normal)
  {}

  CGAL_L0_HOST_DEVICE Triple normal() const { return normalized(normals); }
  CGAL_L0_HOST_DEVICE Triple position() const { return 1 / information * positions; }
  CGAL_L0_HOST_DEVICE double height() const
  {
    return dot(normal(), 1 / information * (feet + -1. * positions));
  }

  CGAL_L0_HOST_DEVICE bool is_of_face(const Merged_disk& other, double height_of_face) const
  {
    // without roots and divisions, as every disk of a cell asks
    const double squared_length = dot(other.normals, other.normals),
                 cosine = dot(normals, other.normals),
                 distance = dot(other.normals,
                                information * other.feet + -other.information * feet);
    return square(cosine)
             > square(minimum_cosine_of_merged) * dot(normals, normals) * squared_length
           && square(distance)
                < square(height_of_face * information * other.information) * squared_length;
  }

  CGAL_L0_HOST_DEVICE void add(const Merged_disk& other)
  {
    information += other.information;
    positions = positions + other.positions;
    feet = feet + other.feet;
    normals = normals + (dot(normals, other.normals) < 0 ? -1. : 1.) * other.normals;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MERGED_DISK_H
