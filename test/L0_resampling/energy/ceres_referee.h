// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_CERES_REFEREE_H
#define CGAL_L0_RESAMPLING_TEST_CERES_REFEREE_H

#include "energy/random_problem.h"

#include <Eigen/Core>

namespace test {

/// The displacements from the current positions to the minimum of Eq. (10), found by Ceres, which
/// gets the terms as the paper prints them. In a source file of its own, since Ceres' logging
/// library has a macro `CHECK` too.
/// \throws std::runtime_error if Ceres finds none
Eigen::VectorXd solve_with_ceres(const Paper_problem& paper);

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_CERES_REFEREE_H
