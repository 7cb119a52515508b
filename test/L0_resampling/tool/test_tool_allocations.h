// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TEST_TOOL_ALLOCATIONS_H
#define L0_RESAMPLE_TEST_TOOL_ALLOCATIONS_H

#include <cstddef>

namespace tool_test {

/// What a reader may take for a file of few points: its fixed buffer, and what a message takes.
constexpr std::size_t maximum_memory_of_a_refusal = 512 * 1024;

/// The most bytes that one call of `operator new` has asked for, in all threads together, since the
/// last call of `forget_allocations()`.
std::size_t maximum_allocation();

void forget_allocations();

} // namespace tool_test

#endif // L0_RESAMPLE_TEST_TOOL_ALLOCATIONS_H
