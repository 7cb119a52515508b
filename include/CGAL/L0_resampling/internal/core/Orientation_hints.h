// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_HINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_HINTS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A place that the points were seen from, or a direction that all of them were seen from: in
/// homogeneous coordinates, so that a direction is a place infinitely far away.
struct Viewpoint
{
  double coordinates[3] = {0, 0, 0}; ///< of the place, or a unit vector towards the viewpoint
  double weight = 1;                 ///< 1 for a place, 0 for a direction

  /// \param position three coordinates
  /// \param direction out: unit vector from there towards the viewpoint; zero at the viewpoint
  CGAL_L0_HOST_DEVICE void find_direction(const double* position, double (&direction)[3]) const
  {
    using std::sqrt;
    double squared_length = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] = coordinates[axis] - weight * position[axis];
      squared_length += direction[axis] * direction[axis];
    }
    const double scale = squared_length > 0 ? 1 / sqrt(squared_length) : 0;
    for (double& coordinate : direction)
      coordinate *= scale;
  }
};

/// Brings a place nearer to a cloud, in the direction that it has from there, if it lies too far
/// off for finite squares of distances.
/// \param in_frame the place in the frame of the cloud, in and out; may be infinite
/// \param place the same in the coordinates of the input: where the frame has no number for it, it
/// is so far from the cloud that the cloud is where these begin
inline void bring_nearer(double (&in_frame)[3], const double* place)
{
  const double farthest = 1e100; // whose square is finite
  const auto maximum_of = [](const double* p) {
    return (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  };
  if (maximum_of(in_frame) <= farthest)
    return;
  if (std::isfinite(maximum_of(in_frame)))
    place = in_frame;
  const double scale = farthest / maximum_of(place);
  for (int axis = 0; axis < 3; ++axis)
    in_frame[axis] = scale * place[axis];
}

/// Where the cosine of the angle between a normal and the direction to its viewpoint is above this,
/// the viewpoint decides the sign: about the sine of 10 degrees, which is more than the error of
/// most normals. Of a surface that is seen at a smaller angle a viewpoint knows no side.
constexpr double minimum_certain_cosine = 0.17;

/// Which of its two sides a sample shows its viewpoint: 1 that of its normal, -1 the other one; 0
/// if the angle leaves it in doubt.
/// \param cosine of the angle between normal and direction to the viewpoint
CGAL_L0_HOST_DEVICE inline int certain_side(double cosine)
{
  return cosine > minimum_certain_cosine ? 1 : cosine < -minimum_certain_cosine ? -1 : 0;
}

/// What hints say of the side of a set of samples whose normals are fixed relative to each other.
struct Side_votes
{
  /// Hints that contradict each other more than this, as a share of all, decide nothing.
  static constexpr double clear_share = 0.1;

  double certain_sum = 0; ///< of `certain_side()`, all of one sign; decides where it is not 0
  double sum = 0;         ///< of the cosines between normals and hints
  double total = 0;       ///< of their absolute values

  CGAL_L0_HOST_DEVICE bool are_clear() const
  {
    using std::abs;
    return certain_sum != 0 || (total > 0 && abs(sum) >= clear_share * total);
  }

  /// Whether they ask to turn the set; only if they are clear.
  CGAL_L0_HOST_DEVICE bool say_turn() const { return certain_sum != 0 ? certain_sum < 0 : sum < 0; }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_HINTS_H
