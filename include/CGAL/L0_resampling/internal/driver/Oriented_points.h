// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENTED_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENTED_POINTS_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <Eigen/Core>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// \tparam FT the number type of the solver
template <typename FT>
struct Oriented_points
{
  Buffer<Vector> positions;
  Buffer<Eigen::Matrix<FT, 3, 1>> normals; ///< of unit length but for rounding in `FT`
  // of each, if they are asked for; no scales if all are 1
  Buffer<float> feature_confidences, side_confidences, scales, noises, position_deviations,
    normal_deviations;
  /// Which of the points were left out as outliers, ascending, if that is asked for.
  Buffer<Index> outliers;
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENTED_POINTS_H
