// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIT_OF_NEIGHBORS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIT_OF_NEIGHBORS_H

#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Sum_of_vectors.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the fit term of Eq. (6) takes from the original neighbors of a sample: \f$ W_i \f$, and
/// \f$ W_i (c_i - p_i) \f$.
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Fit_of_neighbors
{
  S weight = S();           ///< \f$ \sum_j 1/v_j \f$
  Sum_of_vectors<S> places; ///< \f$ \sum_j (q_j - p_i)/v_j \f$

  /// \param dx, dy, dz \f$ q_j - p_i \f$, of a point that may be outside of the ball
  /// \param squared_distance of the two
  /// \param squared_radius \f$ r_p^2 \f$
  /// \param inverse_density \f$ 1/v_j \f$
  template <typename T>
  CGAL_L0_HOST_DEVICE void add(const S& dx, const S& dy, const S& dz, const S& squared_distance,
                               T squared_radius, const S& inverse_density)
  {
    const S w = where_less(squared_distance, squared_radius, inverse_density);
    weight += w;
    places.add(dx, dy, dz, w);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIT_OF_NEIGHBORS_H
