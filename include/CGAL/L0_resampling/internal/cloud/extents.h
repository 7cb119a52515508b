// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_H

#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// How far the points reach on each axis, without the points that `margin_of_extent()` leaves out
/// at either end.
template <typename ConcurrencyTag>
Vector trimmed_extent(const Buffer<Vector>& points)
{
  Vector extent;
  for_each_axis_of<ConcurrencyTag>(points, [&](int axis, Buffer<double>& coordinates) {
    const std::ptrdiff_t margin = std::ptrdiff_t(margin_of_extent(points.size()));
    const auto first = coordinates.begin() + margin, last = coordinates.end() - 1 - margin;
    select_nth(coordinates.begin(), first, coordinates.end());
    const double low = *first;
    select_nth(first, last, coordinates.end());
    extent[axis] = *last - low;
  });
  return extent;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_H
