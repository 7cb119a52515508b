// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_EXACT_BALL_H
#define CGAL_L0_RESAMPLING_INTERNAL_EXACT_BALL_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/random_bits.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/kernels/levels_of_scales.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// Samples are shared out by sums of areas, where the last digit of one area would decide where all
// later samples start. So areas are whole numbers, from counts of points in balls that are decided
// exactly, and moments in whole numbers: processors that round differently find the same ones.

/// Units of the fixed-point coordinates in which neighbors are looked for. Points that a query sees
/// are at most four cells and a ball apart on an axis, so that the difference of two such
/// coordinates fits into 31 bits.
/// \param cell_size, longest_query at scale 1
/// \param has_scales whether others may be as large as `maximum_scale`
inline double units_per_length_for(double cell_size, double longest_query, bool has_scales = false)
{
  const double largest = has_scales ? double(maximum_scale) : 1;
  return std::ldexp(1., 29 - std::ilogb(largest * (4 * cell_size + longest_query)));
}

/// A ball in fixed-point coordinates, whose points are counted exactly.
struct Exact_ball
{
  std::uint64_t squared_radius;
  int shift; // of coordinates in sums of products, so that those of 2^18 points fit into 63 bits

  /// \param units per length
  CGAL_L0_HOST_DEVICE Exact_ball(double radius, double units)
    : squared_radius(std::uint64_t(radius * units * (radius * units))), shift(0)
  {
    while (squared_radius >> 2 * shift >> 44)
      ++shift;
  }

  /// Whether the ball around one point holds another, from the differences of their coordinates.
  CGAL_L0_HOST_DEVICE bool holds(std::int64_t dx, std::int64_t dy, std::int64_t dz) const
  {
    return std::uint64_t(dx * dx) + std::uint64_t(dy * dy) + std::uint64_t(dz * dz)
           < squared_radius;
  }

  /// Adds a point of the ball, relative to its middle.
  CGAL_L0_HOST_DEVICE void add(std::int64_t dx, std::int64_t dy, std::int64_t dz,
                               Plane_moments<std::int64_t>& moments) const
  {
    moments.add(dx >> shift, dy >> shift, dz >> shift, 1);
  }

  /// In the unit of the moments.
  CGAL_L0_HOST_DEVICE double radius_of_moments() const
  {
    return std::ldexp(std::sqrt(double(squared_radius)), -shift);
  }
};

/// How the points of a ball are spread: their covariance, without bias, per squared radius.
struct Spread_in_ball
{
  float minors = 0; ///< the sum of the three principal 2 x 2 minors
  float trace = 0;

  Spread_in_ball() = default;

  /// \param moments of the points of weight 1, relative to the middle of the ball
  /// \param radius in the unit of the moments
  CGAL_L0_HOST_DEVICE Spread_in_ball(const Plane_moments<double>& moments, double radius)
  {
    if (!(moments.sum > 1)) // thinning may have left all of them out
      return;
    const Symmetric_matrix c = moments.covariance();
    const double of_rows = c.xx * c.yy - c.xy * c.xy + c.xx * c.zz - c.xz * c.xz + c.yy * c.zz
                           - c.yz * c.yz;
    const double to_unit = moments.sum / (moments.sum - 1) / square(radius);
    minors = float(of_rows > 0 ? of_rows * square(to_unit) : 0); // rounding may make it less
    trace = float((c.xx + c.yy + c.zz) * to_unit);
  }

  /// Which share of the disk through the middle a surface through the points covers: that of a disk
  /// with the same minors. An even disk has 1/16, one cut by a straight border through the middle
  /// about a fourth of that, and points on a line or at one place none. These stand for a strip as
  /// wide as samples are apart, or for the place of one sample: to within 15 %, that is what a 20th
  /// of the squared spacing adds to the variances, if samples are at most 0.8 radii apart.
  /// \param spacing of the samples, per radius
  CGAL_L0_HOST_DEVICE double share_of_disk(double spacing) const
  {
    const double added = square(spacing) / 20, in_all = 3 * square(added);
    return std::sqrt((minors + 2 * added * trace + in_all) / (1. / 16 + added + in_all));
  }
};

/// What a point of scale 1 stands for that has the disk of its ball for itself. 2^32 of them add up
/// in 64 bits, more than a call or a tile has points, and so do points of other scales, as half of
/// the area is of points of about this scale and less. The tiles of a cloud may be more than that,
/// see `sum_of_areas()`.
constexpr std::uint64_t area_units_of_disk = std::uint64_t(1) << 31;

/// What each of `count` points stands for that share a ball. They are 1 at least, so that each
/// point counts.
/// \param level of the ball, whose disk is twice as large as that of the level before
/// \param share of the disk that the surface covers
CGAL_L0_HOST_DEVICE inline std::uint64_t area_units_of_point(std::uint64_t count, int level,
                                                             double share)
{
  const double of_disk = std::ldexp(double(area_units_of_disk), level - level_of_one);
  // thinning may have left the point itself out
  const double units = of_disk * share / double(count > 0 ? count : 1);
  return units > 1 ? std::uint64_t(units) : 1;
}

/// What each point of a cell stands for, that share evenly what they stand for together.
CGAL_L0_HOST_DEVICE inline std::uint64_t area_units_in_cell(std::uint64_t sum, std::uint64_t count)
{
  return sum / count; // 1 at least, as each is
}

/// Where the k-th of m samples starts on the line on which all points lie side by side, each as
/// long as its area: at random in its part of the whole.
CGAL_L0_HOST_DEVICE inline std::uint64_t area_threshold(std::uint64_t k, std::uint64_t m,
                                                        std::uint64_t seed, std::uint64_t total)
{
  const double in_part = double(random_bits(seed, k) >> 11) / 9007199254740992.; // 2^53
  return std::uint64_t((double(k) + in_part) / double(m) * double(total));
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_EXACT_BALL_H
