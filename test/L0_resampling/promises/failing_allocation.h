// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_FAILING_ALLOCATION_H
#define CGAL_L0_RESAMPLING_TEST_FAILING_ALLOCATION_H

namespace test {

/// Lets `number` more calls of `operator new` succeed, in all threads together, and every later one
/// throw `std::bad_alloc`.
void fail_after_allocations(long number);

/// Ends that.
void stop_failing_allocations();

/// What `operator new` gave and `operator delete` has not got back yet.
long number_of_living_allocations();

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_FAILING_ALLOCATION_H
