// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SHARE_OF_EXTENT_H
#define CGAL_L0_RESAMPLING_INTERNAL_SHARE_OF_EXTENT_H

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
The diagonal of the box of the result per that of the input. What lies outside the surface does not
count for the input: the outermost points (`trimmed_extent()`) and the noise, which moves no more
points than these further out than `noise_reach` standard deviations. The result counts half a
spacing further at either end, as an even set ends that far from the border in the mean.

\param of_input for each axis, `trimmed_extent()` of the points, outliers included
\param noise standard deviation across the surface; 0 if it is not known
\param of_result for each axis, `plain_extent()` of the samples
\param spacing of the samples
\returns a number in [0, 1]; 1 if the input has no extent
*/
inline double share_of_extent(const double* of_input, double noise, const double* of_result,
                              double spacing)
{
  const double noise_reach =
    2.6; // 0.5 % of normally distributed numbers lie further out on one side
  double squared_input = 0, squared_result = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double input = of_input[axis] - 2 * noise_reach * noise,
                 result = of_result[axis] + spacing;
    squared_input += input > 0 ? input * input : 0;
    squared_result += result * result;
  }
  const double share = std::sqrt(squared_result) / std::sqrt(squared_input);
  return share < 1 ? share
                   : 1; // also if coordinates are so large that their squares are not finite
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SHARE_OF_EXTENT_H
