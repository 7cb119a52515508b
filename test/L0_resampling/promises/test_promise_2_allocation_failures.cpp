// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 2 where memory runs out: whichever allocation fails, the call ends in std::bad_alloc,
// writes nothing and keeps nothing.

#include "promise_support.h"
#include "promises/failing_allocation.h"

#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>

#include <cstddef>
#include <functional>
#include <new>

using Kernel = CGAL::Simple_cartesian<double>;
namespace params = CGAL::parameters;

namespace {

/// Lets the first, the second, the third ... allocation fail until the call succeeds.
template <typename ConcurrencyTag, typename NamedParameters>
void test_every_allocation(std::size_t expected_size, const NamedParameters& np)
{
  test::Generator generator(1);
  const auto points = test::kernel_points<Kernel>(test::sphere_points(60, 1, generator).points);
  test::Pairs<Kernel> result;
  result.reserve(2 * expected_size);
  // what is made once and kept, by threads for instance, is made here
  CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result), np);
  result.clear();

  long number_of_failures = 0;
  bool all_clean = true, succeeded = false;
  while (!succeeded)
  {
    const long living = test::number_of_living_allocations();
    test::fail_after_allocations(number_of_failures);
    try
    {
      CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result), np);
      succeeded = true;
    }
    catch (const std::bad_alloc&)
    {
      ++number_of_failures;
    }
    test::stop_failing_allocations();
    all_clean = all_clean && test::number_of_living_allocations() == living
                && result.empty() != succeeded;
  }
  CHECK(all_clean);
  CHECK(number_of_failures > 30);
  CHECK(result.size() == expected_size);
}

/// Lets the call have more and more memory until it succeeds. A refusal keeps nothing, in the
/// caller's solver neither.
template <typename ConcurrencyTag, typename NamedParameters>
void test_every_limit(std::size_t expected_size, const NamedParameters& np)
{
  test::Generator generator(1);
  const auto points = test::kernel_points<Kernel>(test::sphere_points(60, 1, generator).points);
  test::Pairs<Kernel> result;
  result.reserve(2 * expected_size);
  CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result), np);
  result.clear();

  const long living = test::number_of_living_allocations();
  long number_of_refusals = 0;
  bool all_clean = true;
  for (std::size_t limit = 0; result.empty(); limit += 64)
  {
    try
    {
      CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result),
                                                  np | params::maximum_memory(limit));
    }
    catch (const std::bad_alloc&)
    {
      ++number_of_refusals;
    }
    all_clean = all_clean && test::number_of_living_allocations() == living;
  }
  CHECK(all_clean);
  CHECK(number_of_refusals > 30);
  CHECK(result.size() == expected_size);
}

} // namespace

int main()
{
  CGAL::L0_resampling::Block_conjugate_gradient_solver_traits<double> solver;
  test_every_allocation<CGAL::Sequential_tag>(30, params::sparse_linear_solver(std::ref(solver)));
  test_every_limit<CGAL::Sequential_tag>(30, params::random_seed(0));
  test_every_limit<CGAL::Sequential_tag>(30, params::sparse_linear_solver(std::ref(solver)));
  test_every_limit<CGAL::Parallel_if_available_tag>(120, params::number_of_output_points(120));
  test_every_allocation<CGAL::Sequential_tag>(30, params::default_values());
  test_every_allocation<CGAL::Sequential_tag>(120, params::number_of_output_points(120)
                                                     | params::normal_filter_radius(1e-3));
  test_every_allocation<CGAL::Sequential_tag>(
    30,
    params::sparse_linear_solver(CGAL::L0_resampling::Eigen_least_squares_solver_traits<double>()));
  test_every_allocation<CGAL::Parallel_if_available_tag>(30, params::default_values());
  return test::result();
}
