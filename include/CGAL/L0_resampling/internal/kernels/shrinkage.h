// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SHRINKAGE_H
#define CGAL_L0_RESAMPLING_INTERNAL_SHRINKAGE_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// \f$ \sqrt{\lambda/\beta} \f$ as a length, in the unit in which \f$ \lambda \f$ is read, but no
/// longer than `maximum_jump`.
inline double shrinkage_threshold(double normal_weight, double penalty, double sparsity_unit,
                                  double maximum_jump)
{
  return (std::min)(sparsity_unit * std::sqrt(normal_weight / penalty), maximum_jump);
}

/// The jumps that are shrunk to 0, and those that are kept as they are; both are equal in Eq. (9).
template <typename FT>
struct Shrunk_jumps
{
  FT zero_below, kept_from;

  /// \param threshold `shrinkage_threshold()`
  /// \param half_width of the passage from one to the other, per threshold, in [0, 1)
  Shrunk_jumps(double threshold, double half_width)
    : zero_below(FT(threshold * (1 - half_width))), kept_from(FT(threshold * (1 + half_width)))
  {}
};

/// Eq. (9), the minimizer of Eq. (8) for one pair; or firm shrinkage (Gao and Bruce 1997), which
/// passes from 0 to the jump itself without a step, as the minimizer does whose penalty is not L0
/// but rises to it (Zhang 2010).
/// \param normal_distance \f$ n_i^T(p_i - p_{i'}) \f$
template <typename FT>
CGAL_L0_HOST_DEVICE inline FT shrink(FT normal_distance, const Shrunk_jumps<FT>& jumps)
{
  using std::abs;
  // Eq. (9) prints no absolute value; minimizing Eq. (8) needs it, since delta = 0 costs beta *
  // distance^2 for either sign.
  const FT size = abs(normal_distance);
  if (size < jumps.zero_below)
    return FT(0);
  if (size < jumps.kept_from)
    return normal_distance * ((size - jumps.zero_below) / size)
           * (jumps.kept_from / (jumps.kept_from - jumps.zero_below));
  return normal_distance;
}

/// A pair in the third term of Eq. (7), as one of its samples sees it.
template <typename FT>
struct Jump_of_pair
{
  FT offset; ///< \f$ \delta_{ik} \f$, as far as the pair counts in full
  FT misfit; ///< \f$ n_i^T(p_i - p_k) - \delta_{ik} \f$, weighed

  /// \param normal_distance \f$ n_i^T(p_i - p_k) \f$
  /// \param scale of the pair: jumps are shrunk as they would be at scale 1
  /// \param weight of the misfit; near the end of the range of neighbors, as much of a jump is kept
  /// as `share_in_ball()` lacks there
  CGAL_L0_HOST_DEVICE Jump_of_pair(FT normal_distance, FT scale, FT weight,
                                   const Shrunk_jumps<FT>& jumps)
    : offset(scale * shrink(normal_distance / scale, jumps)),
      misfit(weight * (normal_distance - offset))
  {}
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SHRINKAGE_H
