// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_ORACLE_H
#define CGAL_L0_RESAMPLING_TEST_ORACLE_H

#include "Attack.h"
#include "call.h"

#include <cstddef>
#include <string>

namespace attack {

/// How often the point map may be asked for each point: more than once where points coincide, and
/// for the nearest points.
constexpr std::size_t maximum_number_of_readings = 3;

/// The number of points that the documentation promises, for parameters that are not refused.
std::size_t documented_size(const Attack& attack);

/// What of the promises 1 to 5 the answer breaks, as text; empty if none. Written from the
/// documentation, without the code that it is to judge.
std::string broken_promises(const Attack& attack, const Answer& answer);

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_ORACLE_H
