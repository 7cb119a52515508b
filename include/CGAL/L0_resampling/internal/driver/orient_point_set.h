// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENT_POINT_SET_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENT_POINT_SET_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What a call that only orients takes at its peak, at the least.
/// \param n number of points that are used
inline std::size_t minimum_memory_to_orient(std::size_t n)
{
  return n * (2 * sizeof(Vector) + sizeof(Local_vector) + sizeof(Index));
}

/// The normals of the points that stand for all points of a set.
struct Oriented_representatives
{
  Buffer<Index> of_points; ///< for each point of the input, the place of the one that stands for it
  Buffer<Local_vector> normals;      ///< oriented, of unit length; may be none if all are given
  Buffer<Local_vector> mean_normals; ///< of those around, which tell the sides; of any length
};

/*!
Finds the sides of the normals of a point set. Points at one place, points of a crowd and, where the
noise is larger than the spacing, points within it have one that stands for them.

\param positions finite, at least one; used up
\param given_normals unit or zero vectors, one a point, or none at all; used up. Where there is none
it is estimated.
\param hints unit or zero vectors on the side that normals shall point to, or to the viewpoints of
the points, one a point, or none at all; used up
\param parameters checked, for as many output points as there are points
*/
template <typename ConcurrencyTag>
Oriented_representatives orient_point_set(Buffer<Vector>& positions,
                                          Buffer<Local_vector>& given_normals,
                                          Buffer<Local_vector>& hints, const Parameters& parameters,
                                          Progress& progress, Report& report);

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENT_POINT_SET_H
