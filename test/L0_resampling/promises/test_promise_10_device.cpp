// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "promise_support.h"

#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/CUDA_resampler.h>
#include <CGAL/L0_resampling/Solver_report.h>

#include <cuda_runtime_api.h>
#endif

#include <string>

// P10: a call runs where it was asked to, and its report says where that was and why. Where no
// device can be used, CUDA_tag throws, and nothing of that stays behind. Run with
// CUDA_VISIBLE_DEVICES=-1, so that the same holds on a machine that has one; what is owed where a
// device fails is in test_cuda_faults.cpp, and what the tool does that may choose in
// test_tool_cli.sh.

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using CGAL::L0_resampling::Method;
using test::resample;

std::vector<Kernel::Point_3> points() { return test::kernel_points<Kernel>(test::noisy_cube(400)); }

template <typename ConcurrencyTag>
void check_processor()
{
  for (const Method method : {Method::LOR, Method::ALOR, Method::DEFAULT})
  {
    const auto result =
      resample<Kernel, ConcurrencyTag>(points(), CGAL::parameters::resampling_method(method));
    CHECK(result.pairs.size() == 200);
    CHECK(result.report.device == "cpu");
    CHECK(!result.report.device_reason.empty());
  }
}

#ifdef CGAL_L0_LINKED_WITH_CUDA
void check_without_device()
{
  using CGAL::L0_resampling::Device_error;
  const cudaError_t error_before = cudaPeekAtLastError(); // not success where there is no driver
  std::string reason;
  CHECK(!CGAL::L0_resampling::is_cuda_device_usable(&reason));
  CHECK(!reason.empty());
  const auto before = resample<Kernel, CGAL::Parallel_tag>(points(),
                                                           CGAL::parameters::random_seed(0));
  test::Pairs<Kernel> pairs;
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points(), std::back_inserter(pairs)),
                 Device_error);
    CHECK_THROWS(CGAL::L0_resampling::CUDA_resampler<Kernel>(), Device_error);
    CHECK(cudaPeekAtLastError() == error_before);
  }
  // what the caller asked for is wrong on any machine
  CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points(), std::back_inserter(pairs),
                                                           CGAL::parameters::neighbor_radius(-1.)),
               std::exception);
  CHECK(pairs.empty());
  const auto after = resample<Kernel, CGAL::Parallel_tag>(points(),
                                                          CGAL::parameters::random_seed(0));
  CHECK(!after.pairs.empty() && test::are_identical<Kernel>(before.pairs, after.pairs));
  CHECK(after.report.device == "cpu");
}
#endif

} // namespace

int main()
{
  check_processor<CGAL::Sequential_tag>();
  check_processor<CGAL::Parallel_tag>();
#ifdef CGAL_L0_LINKED_WITH_CUDA
  check_without_device();
#endif
  return test::result();
}
