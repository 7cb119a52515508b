// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SOLVER_SETTINGS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SOLVER_SETTINGS_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Solver_report.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// \returns `tolerance`
/// \throws std::invalid_argument if `tolerance` is not in (0, 1), a NaN included
inline double checked_tolerance(double tolerance)
{
  if (!(tolerance > 0 && tolerance < 1))
  {
    std::ostringstream message;
    message.precision(17);
    message << "tolerance must lie in (0, 1), but is " << tolerance;
    throw std::invalid_argument(message.str());
  }
  return tolerance;
}

/// What a residual is measured by.
/// \param right_hand_side_norm \f$ \|g\| \f$
template <typename FT>
double residual_scale(const Quadratic_problem<FT>& problem, double right_hand_side_norm)
{
  return (std::max)(right_hand_side_norm, problem.right_hand_side_scale);
}

[[noreturn]] inline void throw_values_not_finite()
{
  throw Solver_error("The quadratic problem or its initial guess has values that are not finite.");
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SOLVER_SETTINGS_H
