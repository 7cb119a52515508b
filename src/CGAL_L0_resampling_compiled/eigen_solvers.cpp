// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The solvers that are Eigen's.

#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>

namespace CGAL {
namespace L0_resampling {

template class Eigen_cholesky_solver_traits<double>;
template class Eigen_least_squares_solver_traits<double>;

} // namespace L0_resampling
} // namespace CGAL
