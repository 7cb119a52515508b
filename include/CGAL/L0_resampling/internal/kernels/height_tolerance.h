// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_HEIGHT_TOLERANCE_H
#define CGAL_L0_RESAMPLING_INTERNAL_HEIGHT_TOLERANCE_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/kernels/spacing_to_orient.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The median of numbers of at least 0, to a thousandth of the largest. Bisection needs no array
/// of them.
/// \param number_of called with 0, ..., `count` - 1
template <typename T, typename F>
CGAL_L0_HOST_DEVICE T median_of(unsigned count, const F& number_of)
{
  T low = 0, high = 0;
  for (unsigned k = 0; k < count; ++k)
    high = number_of(k) > high ? number_of(k) : high;
  for (int step = 0; step < 10; ++step)
  {
    const T middle = (low + high) / 2;
    unsigned count_below = 0;
    for (unsigned k = 0; k < count; ++k)
      count_below += unsigned(number_of(k) <= middle);
    (2 * count_below > count ? high : low) = middle;
  }
  return high;
}

/*!
The square of the height over a point's tangent plane up to which its neighbors tell nothing of a
fold: the spacing and the noise, both of the cloud or, where these are larger, of the point. Far
from a scanner points are sparse and noisy, and what is less than either looks like folds.

The spacing of \f$ k \f$ neighbors is \f$ \sqrt{2 \pi / k} \f$ times the root mean square of their
distances, as in an even disk. Their noise is told by the median of their heights, which those on
another face leave as it is.

\param count of the neighbors
\param squared_distance_of, height_of of each neighbor; heights of at least 0
\param squared_spacing, squared_noise of the cloud
*/
template <typename T, typename Distance, typename Height>
CGAL_L0_HOST_DEVICE T squared_height_tolerance(unsigned count, const Distance& squared_distance_of,
                                               const Height& height_of, T squared_spacing,
                                               T squared_noise)
{
  if (count == 0)
    return squared_spacing + squared_noise;
  const T pi = T(3.141592653589793), median_per_deviation = T(0.6745);
  T sum = 0;
  for (unsigned k = 0; k < count; ++k)
    sum += squared_distance_of(k);
  const T own_spacing = 2 * pi * sum / (T(count) * T(count)),
          noise = T(deviations_of_heights) / median_per_deviation * median_of<T>(count, height_of),
          own_noise = noise * noise;
  return (own_spacing > squared_spacing ? own_spacing : squared_spacing)
         + (own_noise > squared_noise ? own_noise : squared_noise);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_HEIGHT_TOLERANCE_H
