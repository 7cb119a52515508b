// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_RESULT_HASHES_CASES_H
#define CGAL_L0_RESAMPLING_TEST_RESULT_HASHES_CASES_H

#include "../attack/Attack.h"

#include <string>
#include <vector>

namespace result_hashes {

/// A point set with parameters, under a name without blanks. The method is left to the caller.
using Case = attack::Attack;

/// The point sets of `data_directory`, generated point sets, and one of these with various
/// parameters: 2 to 10000 points each, the same from run to run.
/// \throws std::runtime_error if a file cannot be read
std::vector<Case> all_cases(const std::string& data_directory);

} // namespace result_hashes

#endif // CGAL_L0_RESAMPLING_TEST_RESULT_HASHES_CASES_H
