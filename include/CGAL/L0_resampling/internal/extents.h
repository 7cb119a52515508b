// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_H

#include <CGAL/L0_resampling/internal/Parameters.h>
#include <CGAL/L0_resampling/internal/working_frame.h>

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

/// How far the points reach on each axis.
inline Vector plain_extent(const Buffer<Vector>& points)
{
  Vector low = points.front(), high = points.front();
  for_each_in_order(points.size(), [&](std::size_t i) {
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  });
  return high - low;
}

/*!
The diagonal of the box of the result per that of the input. What lies outside the surface does not
count for the input: the outermost points (`trimmed_extent()`) and the noise, which moves no more
points than these further out than `noise_reach` standard deviations. The result counts half a
spacing further at either end, as an even set ends that far from the border in the mean.

\param of_input `trimmed_extent()` of the points, outliers included
\param noise standard deviation across the surface; 0 if it is not known
\param of_result `plain_extent()` of the samples
\param spacing of the samples
\returns a number in [0, 1]; 1 if the input has no extent
*/
inline double extent_share(const Vector& of_input, double noise, const Vector& of_result,
                           double spacing)
{
  const double noise_reach =
    2.6; // 0.5 % of normally distributed numbers lie further out on one side
  const Vector input = (of_input.array() - 2 * noise_reach * noise).max(0);
  const double share = (of_result.array() + spacing).matrix().norm() / input.norm();
  return share < 1 ? share
                   : 1; // also if coordinates are so large that their squares are not finite
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_H
