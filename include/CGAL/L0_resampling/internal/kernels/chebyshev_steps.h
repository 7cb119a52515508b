// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CHEBYSHEV_STEPS_H
#define CGAL_L0_RESAMPLING_INTERNAL_CHEBYSHEV_STEPS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The defaults of `Block_chebyshev_solver_traits`, which are those of the device.
constexpr double default_chebyshev_tolerance = 4e-3;
constexpr std::size_t maximum_number_of_chebyshev_steps = 100;

/// `Quadratic_problem::low_end_of_spectrum`.
/// \param regularization_weight \f$ \alpha \f$
/// \param penalty \f$ \beta \f$
/// \param coupling how much more the samples hold each other, in relation to the points that hold
/// them, than in an even cloud
inline double low_end_of_spectrum(double regularization_weight, double penalty, double coupling)
{
  return 1 / (1.1 + coupling * (2 * regularization_weight + 2.3 * penalty));
}

/// Where the spacing of the points varies, many samples are held by few points: the more, the more
/// the radii differ.
/// \param maximum_ratio of two radii
inline double coupling_of_radii(double maximum_ratio)
{
  const double most = 20;
  return maximum_ratio * maximum_ratio < most ? maximum_ratio * maximum_ratio : most;
}

/*!
The coefficients of Chebyshev steps for \f$ D^{-1} H \f$ on the interval from `low` to 2 - `low`:
\f$ p' = \mathrm{keep} \cdot p + \mathrm{gain} \cdot D^{-1} r \f$.

All eigenvalues lie between 0 and 2, since \f$ H \f$ is D less symmetric couplings, and the same
with a plus is positive definite too. In the middle between these, the interval is such that no
eigenvector grows, whether its eigenvalue is within or not.
*/
class Chebyshev_steps
{
  double m_half_width, m_ratio;

public:
  double keep = 0, gain = 1; ///< of the step that comes next

  /// \param low in (0, 1)
  CGAL_L0_HOST_DEVICE explicit Chebyshev_steps(double low)
    : m_half_width(1 - low), m_ratio(m_half_width)
  {}

  CGAL_L0_HOST_DEVICE void advance()
  {
    const double last_ratio = m_ratio;
    m_ratio = 1 / (2 / m_half_width - last_ratio);
    keep = m_ratio * last_ratio;
    gain = 2 * m_ratio / m_half_width;
  }

  /// How many steps lessen all eigenvectors of the interval to this share.
  static double number_for(double low, double share)
  {
    return std::ceil(std::acosh(1 / share) / std::acosh(1 / (1 - low)));
  }
};

/// How many steps lessen the residual to the tolerance: to a quarter of it, since a few eigenvalues
/// are lower, and converge more slowly.
inline std::size_t number_of_chebyshev_steps(double low, double tolerance, std::size_t most)
{
  const double number = Chebyshev_steps::number_for(low, tolerance / 4);
  return number < double(most) ? std::size_t(number) : most;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CHEBYSHEV_STEPS_H
