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
#include <CGAL/L0_resampling/internal/kernels/scale_field.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// What tells an outlier by numbers of points. `median` is how many the median ball of the cloud
// holds.

/// How many points the ball of a point has to hold.
/// \param mean_around of the balls of the points around
CGAL_L0_HOST_DEVICE inline double minimum_count_of_ball(const Outlier_thresholds& thresholds,
                                                        double mean_around, double median)
{
  return at_least(thresholds.share_of_surroundings * mean_around,
                  thresholds.share_of_median * median);
}

/// Whether points whose ball holds so many are of the sparse end of a scan, lie beside a denser
/// surface, or are of a crowd.
CGAL_L0_HOST_DEVICE inline bool is_sparse(double count, double mean_around, double median)
{
  return count
         < at_least(outlier_share_of_surroundings * mean_around, share_of_sparse_points * median);
}

/// Whether points whose ball holds so many may tell the sheet that a sparse one lies in: those of a
/// sparse surface do that also where scales have risen far enough for them to be sparse no more.
CGAL_L0_HOST_DEVICE inline bool may_tell_sheet(double count, double mean_around, double median)
{
  return count
         < at_least(sheet_share_of_surroundings * mean_around, share_of_sparse_points * median);
}

/// Whether sparse points fill space, by how the numbers of points grow from their balls of r_p/2 to
/// those of 2 r_p.
/// \param others_in_outer, others_in_inner sums over the sparse points around, themselves not
/// counted
/// \param minimum_ratio of the two from where on points fill space
CGAL_L0_HOST_DEVICE inline bool is_space_filled(double others_in_outer, double others_in_inner,
                                                double minimum_ratio)
{
  return others_in_outer > minimum_ratio * (others_in_inner + count_prior);
}

/// How far sparse points may be from each other to tell a sheet.
/// \param radius \f$ r_p \f$, at scale 1
/// \param scale of the point
CGAL_L0_HOST_DEVICE inline double reach_of_sparse_sheet(double radius, double scale)
{
  return radii_of_sparse_sheet * radius * std::sqrt(scale);
}

/*!
Whether a sparse point lies in a sheet of others, as those of a sparse surface beside a dense one
do: where the nearest points of one span a plane, and it is in that. Not of all points, as those of
the dense surface would be the nearest, and in one plane. Points that fill space lie in none.

\param tellers the points that `may_tell_sheet()`, all sparse ones among them
\param i which of them
\param maximum_reach see `reach_of_sparse_sheet()`
*/
template <typename Team>
CGAL_L0_HOST_DEVICE bool lies_in_sheet(const Team& team, const Morton_points& tellers,
                                       std::uint64_t i, double maximum_reach)
{
  if (tellers.size <= std::uint64_t(points_of_seed))
    return false;
  const double reach = reach_of_nearest(team, tellers, i);
  if (!(reach <= maximum_reach))
    return false;
  const double radius = first_ball_of_seed * reach;
  const Plane_moments<double> moments = moments_around(team, tellers, tellers.xyz + 3 * i, radius);
  const Fitted_plane plane = moments.plane(radius * radius, 1e-12);
  const double height = dot(plane.normal, {moments.x, moments.y, moments.z}) / moments.sum;
  // a few outliers come near a plane by chance, the closer the fewer
  const double thickness = 1.5 * std::sqrt(plane.variance);
  return certainty_of_surface(moments) >= 0.25
         && certainty_of_plane(thickness, height, radius) >= 1;
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
