// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DEVIATION_IN_BALL_H
#define CGAL_L0_RESAMPLING_INTERNAL_DEVIATION_IN_BALL_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The third tenth of the standard deviations that n points of a sheet have across their plane,
/// per that of the noise: the third tenth of the chi-square distribution with n - 3 degrees of
/// freedom, by Wilson and Hilferty (1931). More than 500 points differ by more than chance.
CGAL_L0_HOST_DEVICE inline double third_tenth_of_deviations(double n)
{
  const double third_tenth_of_normal = -0.5244,
               degrees = n < 5     ? 2
                         : n > 500 ? 497
                                   : n - 3,
               a = 2 / (9 * degrees), root = 1 - a + third_tenth_of_normal * std::sqrt(a);
  return root * std::sqrt(root);
}

/*!
The standard deviation of the noise of a sheet whose points in a ball have the standard deviation d
across it. The ball cuts off the noisiest points, and at a given height it has room for those over a
smaller disk: however large the noise is, d is at most a share f of the radius. In between,
\f$ \sigma = d \, (1 - (d/fr)^3)^{-1/3} \f$ (simulated, for balls around points that are off
the sheet as others are). So the noise of a ball that it fills is any large number, and no radius of
that ball is large enough for it.

\param n number of points in the ball: the plane of least variance goes through the gaps of few
*/
CGAL_L0_HOST_DEVICE inline double noise_of_sheet(double deviation, double radius, double n)
{
  const double maximum_share = 0.36 + 0.05 * n / (n + 1000),
               filled = cube(deviation / (maximum_share * radius)), minimum_room = 1e-6;
  return filled < 1 - minimum_room ? deviation / std::cbrt(1 - filled)
                                   : deviation / std::cbrt(minimum_room) * filled;
}

/// How many of the points over the disk in the middle of a ball it holds, if that lies in the
/// sheet: \f$ m_0 - m_2 \f$, where
/// \f$ m_k = \int_{-1}^1 \frac{h^k}{\sqrt{2 \pi} u} e^{-h^2/(2 u^2)} \, dh \f$.
/// \param noise standard deviation u, per radius
inline double share_of_sheet_in_ball(double noise)
{
  const double pi = 3.141592653589793, u = noise, squared = u * u;
  if (!(u > 1e-3))
    return 1 - squared;
  if (u > 30) // where the difference below is of rounding: the points are as dense everywhere
    return std::sqrt(2 / pi) / u * 2 / 3;
  const double at_end = std::sqrt(2 / pi) / u * std::exp(-0.5 / squared),
               m_0 = std::erf(1 / (u * std::sqrt(2.)));
  return m_0 - squared * (m_0 - at_end);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DEVIATION_IN_BALL_H
