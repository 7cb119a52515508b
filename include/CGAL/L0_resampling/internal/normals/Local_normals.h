// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_LOCAL_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_LOCAL_NORMALS_H

#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Coordinates of the normals of some candidates, padded as they are.
template <typename T>
struct Local_normals
{
  Aligned_vector<T> x, y, z;

  void gather(const Local_points<T>& candidates, const Buffer<Eigen::Matrix<T, 3, 1>>& normals)
  {
    // the padding is too far away to count, but has to be finite
    x.resize(candidates.padded_size(), T(0));
    y.resize(candidates.padded_size(), T(0));
    z.resize(candidates.padded_size(), T(0));
    const T zero[3] = {0, 0, 0};
    candidates.gather_coordinates(coordinates(normals), zero, x, y, z);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_LOCAL_NORMALS_H
