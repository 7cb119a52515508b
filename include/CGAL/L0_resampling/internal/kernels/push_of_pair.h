// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PUSH_OF_PAIR_H
#define CGAL_L0_RESAMPLING_INTERNAL_PUSH_OF_PAIR_H

#include <CGAL/L0_resampling/internal/core/weights.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// How samples repel each other in `repel_tangentially()`.

/// What the difference of a pair is multiplied with to be a push, see `Repulsion`.
/// \tparam A a number, or an array of numbers
/// \param share `share_in_ball()`, where the neighbors were found
template <typename A, typename T>
CGAL_L0_HOST_DEVICE inline A strength_of_push(T strength, const A& share, const A& squared_distance,
                                              T squared_bandwidth)
{
  return strength * share * gaussian_weight(squared_distance, squared_bandwidth);
}

/// By what squared distances are multiplied where samples have spreading radii of their own: pairs
/// are as far apart as they would be in an even set.
/// \param of_even_set the spreading radius of that
/// \param of_pair the sum of the two
template <typename T>
CGAL_L0_HOST_DEVICE inline T squared_stretch_of_pair(T of_even_set, T of_pair)
{
  const T stretch = 2 * of_even_set / of_pair;
  return stretch * stretch;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PUSH_OF_PAIR_H
