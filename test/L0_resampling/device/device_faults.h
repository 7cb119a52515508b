// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_DEVICE_FAULTS_H
#define CGAL_L0_RESAMPLING_TEST_DEVICE_FAULTS_H

#include <cstddef>

namespace test_cuda {

/// Lets one of the next calls of `cudaMalloc()` fail, in place of any other that was to fail.
/// Programs with this are linked with `--wrap=cudaMalloc`, so that the library is the one that
/// ships.
/// \param countdown which one, from 1; 0 for none
void fail_allocation(std::size_t countdown);

/// Starts a kernel that writes where no memory is, on a stream of its own: the process will not get
/// the device back.
void break_device();

} // namespace test_cuda

#endif // CGAL_L0_RESAMPLING_TEST_DEVICE_FAULTS_H
