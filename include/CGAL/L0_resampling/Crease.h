// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_CREASE_H
#define CGAL_L0_RESAMPLING_CREASE_H

#include <CGAL/license/L0_resampling.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

A line along which two faces of the surface meet, as `l0_resample_point_set()` gives it to the
`crease_output_iterator`. Points of the result lie on it, about one spacing of the result apart;
a point that ends several creases is a `Crease_corner`.

\tparam Kernel of the points
*/
template <typename Kernel>
struct Crease
{
  /// The places in the result of the points on the crease, two at least, in the order along it.
  std::vector<std::size_t> points;

  /// Unit vectors along the crease, in the direction of `points`, one for each of them.
  std::vector<typename Kernel::Vector_3> tangents;

  /// The unit normals of the two faces at each point: of that to the left, as one who walks along
  /// the crease outside of the surface sees it, and of that to the right.
  std::vector<std::array<typename Kernel::Vector_3, 2>> normals;

  /// The angle between the two normals at each point, in degrees: near 0 where the crease fades,
  /// 90 at a right angle.
  std::vector<double> angles;

  /// Whether the first point follows the last one again.
  bool is_closed = false;

  /// Whether the surface bends away from the side of the normals, as at the edges of a box, and not
  /// towards it, as in its inner edges.
  bool is_convex = false;

  /// How sure the crease is, in [0, 1]: the share of its length where samples of both faces are
  /// seen, on the sides where the faces say, and as many as an edge has.
  double confidence = 0;
};

/*!
\ingroup PkgL0ResamplingRef

A point of the result that several creases meet at, or that one of them turns at sharply, as
`l0_resample_point_set()` gives it to the `corner_output_iterator`.

\tparam Kernel of the points
*/
template <typename Kernel>
struct Crease_corner
{
  /// The place in the result.
  std::size_t point = 0;

  /// The unit normals of the faces that meet there, in no particular order.
  std::vector<typename Kernel::Vector_3> normals;
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_CREASE_H
