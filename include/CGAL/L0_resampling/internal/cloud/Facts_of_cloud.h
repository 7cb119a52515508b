// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_CLOUD_H
#define CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_CLOUD_H

#include <CGAL/L0_resampling/internal/cloud/estimate_scale_field.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
All numbers that a call on the CPU takes from the cloud as a whole. A call finds those that it is
not given, each in one place, and notes them here. A call that is given those of a larger cloud
treats the points of a part of it as the call for all of it does.

Lengths are in the frame before its unit is set.
*/
struct Facts_of_cloud
{
  std::optional<Place_of_frame> frame;
  std::optional<Facts> extents; ///< all but the scales
  std::optional<Scales> scales; ///< in units of `paper_radius()`
  /// Of the radii. If all are 1, no field of scales is looked for.
  std::optional<Range_of_scales> range_of_scales;
  std::shared_ptr<const Scale_field>
    field; ///< of scales; null if each tile gets its points' scales
  std::optional<double> median_number_of_neighbors; ///< in the balls of `find_outliers()`
  std::optional<double> mean_number_of_neighbors;   ///< in the balls of the normal filter
  /// Whether these balls are plain, see `has_plain_blocks_only()`: then sums go over pairs.
  std::optional<bool> has_plain_blocks;
  /// In units of `Areas`, of all points, as if each disk was covered.
  std::optional<std::uint64_t> units_of_disks;
  std::optional<double> area; ///< of the surface, in units of \f$ r_p^2 \f$
  /// In units of `Areas`, of those points that samples start on.
  std::optional<std::uint64_t> units_of_starts;
  std::optional<std::size_t> number_of_points; ///< without outliers, and thinned
  std::optional<std::size_t> number_of_places; ///< where these are
};

/// The fact; if it is not known, what `find()` returns, which is noted.
template <typename T, typename F>
const T& known_or_found(std::optional<T>& fact, const F& find)
{
  if (!fact)
    fact = find();
  return *fact;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_CLOUD_H
