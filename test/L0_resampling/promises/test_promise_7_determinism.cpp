// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 7: the same bits from run to run, with one thread or many, sequential or parallel.

#include "promise_support.h"

#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <string>
#include <thread>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using CGAL::L0_resampling::Method;
namespace params = CGAL::parameters;

namespace {

/// A noisy cube, a crowd of points in one cell, duplicates and an outlier.
Points cloud(std::size_t n)
{
  test::Generator generator(1);
  test::Oriented_points cube = test::cube_points(n, 1, generator);
  test::add_gaussian_noise(cube.points, 0.005, generator);
  for (std::size_t i = 0; i < n / 4; ++i)
    cube.points.push_back(test::Vector(0.5, 0.5, 0.5) + 1e-4 * test::random_unit_vector(generator));
  for (std::size_t i = 0; i < n / 10; ++i)
    cube.points.push_back(cube.points[i]);
  cube.points.emplace_back(1e9, 0, 0);
  return test::kernel_points<Kernel>(cube.points);
}

/// All that the report says and that is no time, memory or text.
std::vector<double> numbers(const CGAL::L0_resampling::Report& report)
{
  std::vector<double> result{double(report.number_of_distinct_points),
                             double(report.number_of_degenerate_neighborhoods),
                             double(report.number_of_lonely_samples),
                             double(report.number_of_unexplained_samples),
                             report.unexplained_center[0],
                             report.unexplained_center[1],
                             report.unexplained_center[2],
                             report.unexplained_radius,
                             double(report.number_of_self_neighbor_pairs),
                             report.neighbor_radius,
                             report.oriented_share,
                             report.hinted_share};
  for (const CGAL::L0_resampling::Iteration_report& iteration : report.iterations)
    result.insert(result.end(),
                  {iteration.fit_energy, iteration.regularization_energy, iteration.normal_energy,
                   iteration.sparsity_energy, iteration.active_pair_share,
                   double(iteration.solver.iterations), iteration.solver.relative_residual});
  return result;
}

bool are_identical(const test::Resampled<Kernel>& a, const test::Resampled<Kernel>& b)
{
  return test::are_identical<Kernel>(a.pairs, b.pairs) && numbers(a.report) == numbers(b.report);
}

template <typename NamedParameters>
void test_tags_and_threads(const std::string& name, const Points& points, const NamedParameters& np)
{
  const test::Resampled<Kernel> expected = test::resample<Kernel, CGAL::Sequential_tag>(points, np);
  CHECK(are_identical(expected, test::resample<Kernel, CGAL::Sequential_tag>(points, np)));
  CHECK(!expected.pairs.empty());
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1, 2, 3, 8})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (int run = 0; run < 2; ++run)
      if (!CHECK(are_identical(expected, test::resample<Kernel, CGAL::Parallel_tag>(points, np))))
        std::cerr << "  " << name << ", " << threads << " threads" << std::endl;
  }
#else
  std::cout << name << ": without TBB, sequential runs only" << std::endl;
#endif
}

/// Calls at the same time from threads of the caller do not disturb each other.
void test_calls_at_once()
{
  const Points points = cloud(1500);
  std::vector<test::Resampled<Kernel>> expected(4), results(4);
  const auto run = [&](std::size_t i) {
    return test::resample<Kernel, CGAL::Parallel_if_available_tag>(points, params::random_seed(i));
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < results.size(); ++i)
    expected[i] = run(i);
  for (std::size_t i = 0; i < results.size(); ++i)
    threads.emplace_back([&, i]() { results[i] = run(i); });
  for (std::thread& thread : threads)
    thread.join();
  for (std::size_t i = 0; i < results.size(); ++i)
    CHECK(are_identical(expected[i], results[i]));
}

/// The seed is what chooses among the possible results, and the only thing. Samples start by area
/// in the default method and by number in the paper's.
void test_seed(Method method)
{
  const Points points = cloud(1500);
  const auto with_seed = [&](auto seed) {
    return test::resample<Kernel, CGAL::Sequential_tag>(
      points, params::resampling_method(method).random_seed(seed));
  };
  const test::Resampled<Kernel> without =
    test::resample<Kernel, CGAL::Sequential_tag>(points, params::resampling_method(method));
  CHECK(are_identical(without, with_seed(0)));
  CHECK(are_identical(with_seed(7), with_seed(7u)));
  CHECK(!are_identical(with_seed(7), with_seed(8)));
}

} // namespace

int main()
{
  const Points points = cloud(3000);
  test_tags_and_threads("default", points, params::default_values());
  test_tags_and_threads("more than the input", points,
                        params::number_of_output_points(2 * points.size()));
  test_tags_and_threads("LOR", points, params::resampling_method(Method::LOR));
  test_tags_and_threads("ALOR", points, params::resampling_method(Method::ALOR));
  test_tags_and_threads("kept density, seen from a point", points,
                        params::keep_density(true).viewpoint(Kernel::Point_3(0, 0, 3)));
  test_tags_and_threads("radius that reaches everybody", points,
                        params::neighbor_radius(1e300).select_percentage(20));
  test_tags_and_threads("radius that reaches nobody", points, params::neighbor_radius(1e-300));
  const Points few = cloud(800);
  test_tags_and_threads("Cholesky", few,
                        params::sparse_linear_solver(
                          CGAL::L0_resampling::Eigen_cholesky_solver_traits<double>()));
  test_tags_and_threads("least squares", few,
                        params::sparse_linear_solver(
                          CGAL::L0_resampling::Eigen_least_squares_solver_traits<double>())
                          .neighbor_radius(0.2));
  test_calls_at_once();
  test_seed(Method::DEFAULT);
  test_seed(Method::LOR);
  return test::result();
}
