// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgL0ResamplingConcepts

The points of a cloud that is resampled tile by tile, wherever they are. Where memory does
not hold the cloud, all of it is read about ten times.

\cgalConcept
*/
class L0ResamplingTileSource
{
public:
  /// Calls `f(point)` with each point of the box, a `std::array<double, 3>`: in the same order
  /// each time, and with the same points as long as the cloud is worked on.
  template <typename F>
  void for_each_point(const CGAL::L0_resampling::Source_box& box, const F& f) const;
};
