// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SHRINKAGE_H
#define CGAL_L0_RESAMPLING_INTERNAL_SHRINKAGE_H

#include <CGAL/L0_resampling/internal/host_device.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// \f$ \sqrt{\lambda/\beta} \f$ as a length, in the unit in which \f$ \lambda \f$ is read, but no longer than `largest_shrunk_jump`.
inline double shrinkage_threshold(double normal_weight, double penalty, double sparsity_unit, double largest_shrunk_jump)
{
  return (std::min)(sparsity_unit * std::sqrt(normal_weight / penalty), largest_shrunk_jump);
}

/// Eq. (9), the minimizer of Eq. (8) for one pair.
/// \param normal_distance \f$ n_i^T(p_i - p_{i'}) \f$
/// \param threshold `shrinkage_threshold()`
template <typename FT>
CGAL_L0_HOST_DEVICE inline FT shrink(FT normal_distance, FT threshold)
{
  using std::abs;
  // Eq. (9) prints no absolute value; minimizing Eq. (8) needs it, since delta = 0 costs beta * distance^2 for either sign.
  return abs(normal_distance) < threshold ? FT(0) : normal_distance;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SHRINKAGE_H
