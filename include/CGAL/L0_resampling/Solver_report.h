// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_SOLVER_REPORT_H
#define CGAL_L0_RESAMPLING_SOLVER_REPORT_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/internal/words/require_exceptions.h>

#include <cstddef>
#include <stdexcept>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

What one solve of Eq. (10) did. Running out of iterations is a report and not an exception:
Algorithm 1 lives well with an inexact solve.
*/
struct Solver_report
{
  std::size_t iterations = 0; ///< iterations spent, 0 for a direct solver

  /// \f$ \|A^T(b - Ax)\| \f$ on exit, divided by \f$ \|A^T b\| \f$ or by
  /// `Quadratic_problem::right_hand_side_scale`, whichever is larger; 0 where \f$ A^T b = 0 \f$
  double relative_residual = 0;

  bool converged = true; ///< whether the relative residual reached the solver's tolerance
};

/*!
\ingroup PkgL0ResamplingRef

Thrown by every solver, of whatever back end, when it has no answer at all: non-finite values, or a
factorization that broke down.
*/
class Solver_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*!
\ingroup PkgL0ResamplingRef

Thrown when a device was asked for and cannot be used, or failed while it worked.
*/
class Device_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_SOLVER_REPORT_H
