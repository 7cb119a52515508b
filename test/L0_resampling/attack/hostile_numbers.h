// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_HOSTILE_NUMBERS_H
#define CGAL_L0_RESAMPLING_TEST_HOSTILE_NUMBERS_H

#include <limits>

namespace attack {

using Numbers = std::numeric_limits<double>;

inline constexpr double nan = Numbers::quiet_NaN();
inline constexpr double infinity = Numbers::infinity();
inline constexpr double largest = 1.7976931348623157e308;

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_HOSTILE_NUMBERS_H
