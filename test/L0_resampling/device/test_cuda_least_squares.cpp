// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device/test_cuda_support.h"

#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/CUDA_least_squares_solver_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

// The paper's rows on the device, beside stages of the CPU, find what the matrix-free solver of the
// CPU finds.

namespace {

using namespace test_cuda;
using namespace CGAL::L0_resampling;
namespace parameters = CGAL::parameters;

template <typename Solver>
Result resample(const Points& points, Method method, const Solver& solver, Report& report)
{
  Result result;
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(points, std::back_inserter(result),
                                                    parameters::resampling_method(method)
                                                      .resampling_report(&report)
                                                      .number_of_output_points(2000)
                                                      .sparse_linear_solver(solver));
  return result;
}

void check_agreement(Method method)
{
  const double tolerance = 1e-9;
  const Points points = noisy_cube(4000, 0.01, 1);
  Report report, device_report;
  const Result expected =
    resample(points, method, Block_conjugate_gradient_solver_traits<double>(tolerance), report);
  const Result result = resample(
    points, method, CUDA_least_squares_solver_traits<double>(tolerance, 1000), device_report);
  if (!CHECK(result.size() == expected.size()))
    return;
  CHECK(device_report.converged);
  CHECK(device_report.iterations.front().solver.iterations
        > report.iterations.front().solver.iterations);
  // Algorithm 1 is not continuous: the last digits of a solve may decide a jump, and move a few
  // samples.
  std::size_t number_of_others = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
    number_of_others += CGAL::squared_distance(result[i].first, expected[i].first)
                        > std::pow(1e-4 * report.neighbor_radius, 2);
  std::cout << "method " << int(method) << ": " << number_of_others << " other samples, "
            << device_report.iterations.front().solver.iterations << " iterations" << std::endl;
  CHECK(number_of_others <= result.size() / 100);

  Report again_report;
  CHECK(resample(points, method, CUDA_least_squares_solver_traits<double>(tolerance, 1000),
                 again_report)
        == result); // to the bit
}

void check_reports()
{
  const Points points = noisy_cube(4000, 0.01, 2);
  Report report;
  resample(points, Method::LOR, CUDA_least_squares_solver_traits<double>(1e-3, 200), report);
  CHECK(report.converged);
  resample(points, Method::LOR, CUDA_least_squares_solver_traits<double>(1e-12, 2), report);
  CHECK(!report.converged && report.iterations.front().solver.iterations == 2);
  CHECK_THROWS(CUDA_least_squares_solver_traits<double>(0.), std::invalid_argument);
}

} // namespace

int main()
{
  if (!has_device())
    return number_of_skip;
  check_agreement(Method::LOR);
  check_agreement(Method::ALOR);
  check_reports();
  return test::result();
}
