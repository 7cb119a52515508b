// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_cuda_support.h"

#include <CGAL/L0_resampling/Solver_report.h>

// G1: nothing on the device that is not there. Run with CUDA_VISIBLE_DEVICES=-1.

int main()
{
  using namespace test_cuda;
  std::string reason;
  CHECK(!CGAL::L0_resampling::is_cuda_device_usable(&reason));
  CHECK(!reason.empty());
  const Points points = noisy_cube(100, 0.01, 1);
  Result result;
  for (int attempt = 0; attempt < 2; ++attempt)
    CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(result)),
                 CGAL::L0_resampling::Device_error);
  CHECK(result.empty());
  // what the caller asked for is wrong on any machine
  CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(result),
                                                           CGAL::parameters::neighbor_radius(-1.)),
               std::exception);
  return test::result();
}
