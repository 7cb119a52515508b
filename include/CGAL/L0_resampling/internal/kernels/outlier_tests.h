// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_OUTLIER_TESTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_OUTLIER_TESTS_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// What tells an outlier by numbers of points. `median` is how many the median ball of the cloud
// holds.

/// How many points the ball of a point has to hold.
/// \param mean_around of the balls of the points around
CGAL_L0_HOST_DEVICE inline double least_count_of_ball(const Outlier_thresholds& thresholds,
                                                      double mean_around, double median)
{
  return at_least(thresholds.share_of_surroundings * mean_around,
                  thresholds.share_of_median * median);
}

/// Whether points whose ball holds so many are of the sparse end of a scan or of a crowd.
CGAL_L0_HOST_DEVICE inline bool is_sparse(double count, double median)
{
  return count < share_of_sparse_points * median;
}

/// Whether sparse points fill space, by how the numbers of points grow from their balls of r_p/2 to
/// those of 2 r_p.
/// \param others_in_outer, others_in_inner sums over the sparse points around, themselves not
/// counted
/// \param least_ratio of the two from where on points fill space
CGAL_L0_HOST_DEVICE inline bool is_space_filled(double others_in_outer, double others_in_inner,
                                                double least_ratio)
{
  return others_in_outer > least_ratio * (others_in_inner + count_prior);
}

/// Whether a part of the cloud has too few points to be one of the surface.
/// \param share_of_part of the points of a median ball that a part has, at least
CGAL_L0_HOST_DEVICE inline bool is_part_small(double size, double share_of_part, double median)
{
  return size < share_of_part * median;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_OUTLIER_TESTS_H
