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

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The largest standard deviation across the plane through n points of a ball, per radius, with
/// which they are a sheet. Points that fill the ball have \f$ 1/\sqrt 5 \f$; of n of them the plane
/// of least variance, which goes through their gaps, leaves about \f$ 1 - 3/(2 \sqrt n) \f$ of
/// that.
inline double largest_deviation_of_sheet(double n)
{
  const double share_of_filled_ball = 0.85;
  return share_of_filled_ball * (1 - 1.5 / std::sqrt((std::max)(n, 9.))) / std::sqrt(5.);
}

/// A sheet with Gaussian noise, as seen in a ball around one of its points.
struct Sheet_in_ball
{
  double noise;           ///< standard deviation, per radius; at most 2
  double share_of_points; ///< of those over the disk in the middle of the ball, how many it holds
};

/// How many of the points over the disk in the middle of a ball it holds: \f$ m_0 - m_2 \f$ of
/// `sheet_of_deviations()`.
/// \param noise standard deviation, per radius
inline double share_of_sheet_in_ball(double noise)
{
  const double pi = 3.141592653589793, u = noise, squared = u * u;
  if (!(u > 1e-3))
    return 1 - squared;
  const double at_end = std::sqrt(2 / pi) / u * std::exp(-0.5 / squared),
               m_0 = std::erf(1 / (u * std::sqrt(2.)));
  return m_0 - squared * (m_0 - at_end);
}

/*!
The sheet whose points have these standard deviations across it, per radius, as far as balls hold
them: a ball cuts off the noisiest ones, and at a given height it has room for those over a smaller
disk. With \f$ h \f$ for the height over the sheet, in radii, and the center of the ball in the
sheet, noise \f$ u \f$ leaves the deviation \f$ d \f$ and the share \f$ s \f$ of the points:

\f[ d^2 = \frac{m_2 - m_4}{m_0 - m_2}, \qquad s = m_0 - m_2, \qquad m_k
= \int_{-1}^1 \frac{h^k}{\sqrt{2 \pi} u} e^{-h^2/(2 u^2)} \, dh . \f]

The deviation ascends with u, up to \f$ 1/\sqrt 5 \f$. The third tenth of the deviations in balls of
some hundred points around points, which are off the sheet themselves, is smaller by six percent
(simulated).

\param third_tenth of the deviations
*/
CGAL_L0_HOST_DEVICE inline Sheet_in_ball sheet_of_deviations(double third_tenth)
{
  const double pi = 3.141592653589793, deviation = 1.06 * third_tenth;
  double low = 0, high = 2, share_of_points = 1;
  for (int step = 0; step < 40; ++step)
  {
    const double u = (low + high) / 2, squared = u * u,
                 at_end = std::sqrt(2 / pi) / u * std::exp(-0.5 / squared);
    const double m_0 = std::erf(1 / (u * std::sqrt(2.)));
    const double m_2 = squared * (m_0 - at_end), m_4 = squared * (3 * m_2 - at_end);
    share_of_points = m_0 - m_2;
    (m_2 - m_4 < square(deviation) * share_of_points ? low : high) = u;
  }
  return {high, share_of_points};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DEVIATION_IN_BALL_H
