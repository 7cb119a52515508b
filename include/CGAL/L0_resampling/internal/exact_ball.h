// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_EXACT_BALL_H
#define CGAL_L0_RESAMPLING_INTERNAL_EXACT_BALL_H

#include <CGAL/L0_resampling/internal/host_device.h>
#include <CGAL/L0_resampling/internal/random_bits.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// Samples are shared out by sums of areas, where the last digit of one area would decide where all
// later samples start. So areas are whole numbers, from counts of points in balls that are decided
// exactly: processors that round differently find the same ones.

/// Units of the fixed-point coordinates in which neighbors are looked for. Points that a query sees
/// are at most four cells and a ball apart on an axis, so that the difference of two such
/// coordinates fits into 31 bits.
inline double units_per_length_for(double cell_size, double longest_query)
{
  return std::ldexp(1., 29 - std::ilogb(4 * cell_size + longest_query));
}

/// A ball in fixed-point coordinates, whose points are counted exactly.
struct Exact_ball
{
  double units_per_length;
  std::uint64_t squared_radius; // in units

  Exact_ball(double radius, double units)
    : units_per_length(units), squared_radius(std::uint64_t(radius * units * (radius * units)))
  {}

  /// Whether the ball around one point holds another, from the differences of their coordinates.
  CGAL_L0_HOST_DEVICE bool holds(std::int64_t dx, std::int64_t dy, std::int64_t dz) const
  {
    return std::uint64_t(dx * dx) + std::uint64_t(dy * dy) + std::uint64_t(dz * dz)
           < squared_radius;
  }
};

/// What a point stands for that is alone in its ball. 2^32 of them add up in 64 bits.
constexpr std::uint64_t area_units_of_ball = std::uint64_t(1) << 31;

/// What each of `count` points stands for that share a ball. They are 1 at least, so that each
/// point counts.
CGAL_L0_HOST_DEVICE inline std::uint64_t area_units_of_point(std::uint64_t count)
{
  const std::uint64_t units =
    area_units_of_ball / (count > 0 ? count : 1); // thinning may have left the point itself out
  return units > 0 ? units : 1;
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
