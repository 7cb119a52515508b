// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_WEIGHT_OF_PAIR_H
#define CGAL_L0_RESAMPLING_INTERNAL_WEIGHT_OF_PAIR_H

#include <CGAL/L0_resampling/internal/core/weights.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// \f$ h_{ik}^2 \f$, by the larger of the heights of each sample over the plane of the other.
/// \param height_i, height_k \f$ n_i^T (p_i - p_k) \f$ and \f$ n_k^T (p_i - p_k) \f$
template <typename T>
CGAL_L0_HOST_DEVICE inline T squared_height_of_pair(T height_i, T height_k)
{
  return at_least(height_i * height_i, height_k * height_k);
}

/// The weights of the pairs in Eq. (7),
/// \f$ a_{ik} = \alpha \bar\theta_{ik} e^{-h_{ik}^2/J^2} (1/w_i + 1/w_k) \f$: the pair comes once
/// with i and once with k. Where neighbors are looked for in every turn, these weights, and those
/// that \f$ w_i \f$ sums up, end softly at the range of the pair (`share_in_ball()`): else a
/// rounding that decides whether two samples are neighbors moves them.
/// \tparam T a floating-point number
template <typename T>
struct Weight_of_pair
{
  T squared_radius; ///< \f$ r_p^2 \f$
  T squared_jump;   ///< \f$ J^2 \f$, infinite in LOR and ALOR

  /// What depends on where the two samples are.
  /// \tparam A a number, or an array of numbers
  /// \param factor `share_in_ball()`, and what else there is to multiply with
  /// \param squared_distance, squared_height of the pair, at scale 1
  template <typename A>
  CGAL_L0_HOST_DEVICE A by_place(const A& factor, const A& squared_distance,
                                 const A& squared_height) const
  {
    return factor * pair_weight(squared_distance, squared_radius, squared_height, squared_jump);
  }

  /// Times what depends on the density of the samples.
  /// \param by_place of the pair
  /// \param inverse_i, inverse_k \f$ 1/w_i \f$ and \f$ 1/w_k \f$, or both times the same factor
  CGAL_L0_HOST_DEVICE static T by_density(T by_place, T inverse_i, T inverse_k)
  {
    return by_place * (inverse_i + inverse_k);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_WEIGHT_OF_PAIR_H
