// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_HINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_HINTS_H

#include <CGAL/L0_resampling/internal/Search_grid_3.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
What hints say of the side of a set of samples whose normals are fixed relative to each other: a
vote, in which each counts \f$ n_i^T h_i \f$, where \f$ h_i \f$ points to the side that its normal
shall be on, and is the longer the more it counts.
*/
struct Hint_votes
{
  /// Hints that contradict each other more than this, as a share of all, decide nothing.
  static constexpr double clear_share = 0.1;

  double sum = 0, total = 0;

  void add(const Vector& normal, const Vector& hint)
  {
    const double vote = normal.dot(hint);
    sum += vote;
    total += std::abs(vote);
  }

  bool are_clear() const { return total > 0 && std::abs(sum) >= clear_share * total; }

  /// Whether they ask to turn the set; only if they are clear.
  bool say_turn() const { return sum < 0; }
};

/*!
The hint of a viewpoint: towards it, as long as the solid angle that an area of 1 would fill, seen
from there. A closed surface around the viewpoint fills all of it with one side; one that is seen
from outside fills as much with its front as with its back, so that the votes cancel and it is
turned outwards as if there were no viewpoint.

\param squared_spacing of the samples: those nearer than that do not count more
*/
inline Vector hint_of_viewpoint(const Vector& viewpoint, const Vector& position,
                                double squared_spacing)
{
  const Vector to_viewpoint = viewpoint - position;
  const double length = to_viewpoint.stableNorm();
  return length > 0 ? Vector(to_viewpoint / length / (length * length + squared_spacing))
                    : Vector(Vector::Zero());
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_HINTS_H
