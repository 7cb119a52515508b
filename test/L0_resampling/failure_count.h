// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Checks of the tests of the benchmarks' own code, with words for what is wrong.

#ifndef CGAL_L0_RESAMPLING_TEST_FAILURE_COUNT_H
#define CGAL_L0_RESAMPLING_TEST_FAILURE_COUNT_H

#include <iostream>
#include <string>

inline int number_of_failures = 0;

/// Says where and what fails unless the condition holds.
// The builtins give the place of the caller, in g++ and in clang.
inline void check(bool condition, const std::string& what, int line = __builtin_LINE(),
                  const char* file = __builtin_FILE())
{
  if (condition)
    return;
  std::cerr << file << ":" << line << ": " << what << "\n";
  ++number_of_failures;
}

#endif // CGAL_L0_RESAMPLING_TEST_FAILURE_COUNT_H
