// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_EXACT_BALL_H
#define CGAL_L0_RESAMPLING_INTERNAL_EXACT_BALL_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/random_bits.h>
#include <CGAL/L0_resampling/internal/kernels/levels_of_scales.h>

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
/// \param cell_size, longest_query at scale 1
/// \param has_scales whether others may be as large as `largest_scale`
inline double units_per_length_for(double cell_size, double longest_query, bool has_scales = false)
{
  const double largest = has_scales ? double(largest_scale) : 1;
  return std::ldexp(1., 29 - std::ilogb(largest * (4 * cell_size + longest_query)));
}

/// A ball in fixed-point coordinates, whose points are counted exactly.
struct Exact_ball
{
  double units_per_length;
  std::uint64_t squared_radius; // in units

  CGAL_L0_HOST_DEVICE Exact_ball(double radius, double units)
    : units_per_length(units), squared_radius(std::uint64_t(radius * units * (radius * units)))
  {}

  /// The ball of half the radius.
  CGAL_L0_HOST_DEVICE Exact_ball half() const
  {
    Exact_ball ball = *this;
    ball.squared_radius /= 4;
    return ball;
  }

  /// Whether the ball around one point holds another, from the differences of their coordinates.
  CGAL_L0_HOST_DEVICE bool holds(std::int64_t dx, std::int64_t dy, std::int64_t dz) const
  {
    return std::uint64_t(dx * dx) + std::uint64_t(dy * dy) + std::uint64_t(dz * dz)
           < squared_radius;
  }
};

/// What a point of scale 1 stands for that is alone in its ball. 2^32 of them add up in 64 bits,
/// and so do points of other scales, as half of the area is of points of about this scale and less.
constexpr std::uint64_t area_units_of_ball = std::uint64_t(1) << 31;

/// Where radii differ, disks can hold few points: in one of fewer points than this, each weighs as
/// if there were this many.
constexpr std::uint64_t fewest_points_of_disk = 8;

/// What each of `count` points stands for that share a ball. They are 1 at least, so that each
/// point counts.
/// \param level of the ball, whose disk is twice as large as that of the level before
/// \param fewest points that share one
CGAL_L0_HOST_DEVICE inline std::uint64_t area_units_of_point(std::uint64_t count, int level,
                                                             std::uint64_t fewest)
{
  const std::uint64_t of_ball = level < level_of_one ? area_units_of_ball >> (level_of_one - level)
                                                     : area_units_of_ball << (level - level_of_one);
  // thinning may have left the point itself out
  const std::uint64_t units = of_ball / (count > fewest ? count : fewest);
  return units > 0 ? units : 1;
}

/// The others in the balls of the points of a cell, and in those of half the radius: a quarter of
/// them in a surface, and a half on a line, as the rings of a scanner are that have nothing in
/// between.
struct Growth_of_balls
{
  std::uint64_t in_balls = 0, in_half_balls = 0;

  /// In how many parts of `whole` the points are on lines.
  static constexpr std::uint64_t whole = 256;
  CGAL_L0_HOST_DEVICE std::uint64_t share_of_line() const
  {
    const std::uint64_t from = 32, to = 42; // in hundredths of the balls
    if (100 * in_half_balls <= from * in_balls)
      return 0;
    const std::uint64_t share = whole * (100 * in_half_balls - from * in_balls)
                                / ((to - from) * in_balls);
    return share < whole ? share : whole;
  }

  /// What the points of the cell stand for together.
  /// \param units as if all were of a surface
  /// \param strip `part_of_strip()` of their balls
  CGAL_L0_HOST_DEVICE std::uint64_t units_of_all(std::uint64_t units, std::uint64_t strip) const
  {
    const std::uint64_t share = share_of_line();
    return units / (whole * whole) * (whole * (whole - share) + strip * share)
           + units % (whole * whole) * (whole * (whole - share) + strip * share) / (whole * whole);
  }
};

/// Which part a strip across a ball, as wide as samples are apart, is of its disk: in 256 parts.
/// \param spacing of the samples, per radius of the ball
CGAL_L0_HOST_DEVICE inline std::uint64_t part_of_strip(double spacing)
{
  const double two_by_pi = 0.6366197723675814;
  const double part = double(Growth_of_balls::whole) * two_by_pi * spacing;
  return part < double(Growth_of_balls::whole) ? std::uint64_t(part) : Growth_of_balls::whole;
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
