// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 11: the report says what the call did. Small clouds: valgrind runs this test too.

#include "promise_support.h"

#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;
using CGAL::Sequential_tag;
using test::Vector;
using test::noisy_cube;
namespace params = CGAL::parameters;

namespace {

void test_completed_call()
{
  std::vector<Vector> cube = noisy_cube(1000);
  cube.push_back(cube[0]);
  const auto points = test::kernel_points<Kernel>(cube);
  for (Method method : {Method::LOR, Method::ALOR, Method::DEFAULT})
  {
    const Report report =
      test::resample<Kernel, Sequential_tag>(points, params::neighbor_radius(0.25)
                                                       | params::resampling_method(method))
        .report;
    CHECK(report.outcome == CGAL::L0_resampling::Outcome::COMPLETED);
    CHECK(report.number_of_input_points == 1001 && report.number_of_distinct_points == 1000);
    CHECK(report.number_of_output_points == 500 && report.number_of_dropped_points == 0);
    CHECK(report.neighbor_radius == 0.25);
    CHECK(report.least_neighbor_radius == 0.25 && report.median_neighbor_radius == 0.25
          && report.largest_neighbor_radius == 0.25);
    CHECK(report.number_of_lonely_samples == 0 && report.number_of_self_neighbor_pairs > 500);
    CHECK(report.oriented_share > 0.9 && report.oriented_share <= 1);
    CHECK(report.converged && report.device == "cpu" && !report.device_reason.empty());
    const double growth = method == Method::DEFAULT ? 2.7 : 1.5;
    CHECK(report.iterations.size()
          == (method == Method::DEFAULT ? 4u : 8u)); // 0.1 * 2.7^3 = 1.97, 0.1 * 1.5^7 = 1.71
    double penalty = 0.1;
    for (std::size_t k = 0; k < report.iterations.size(); ++k, penalty *= growth)
    {
      const CGAL::L0_resampling::Iteration_report& iteration = report.iterations[k];
      CHECK(test::is_close(iteration.penalty, penalty, 1e-12));
      CHECK(iteration.regularized == (method != Method::ALOR || k % 2 == 0));
      CHECK(iteration.fit_energy > 0 && iteration.normal_energy > 0
            && iteration.sparsity_energy >= 0);
      CHECK((iteration.regularization_energy > 0) == iteration.regularized);
      CHECK(iteration.active_pair_share >= 0 && iteration.active_pair_share <= 1);
      CHECK(iteration.solver.converged && iteration.solver.iterations > 0
            && iteration.solver.relative_residual < 1e-3);
    }
    std::size_t largest = 0;
    CHECK(report.stages.size() >= 5);
    for (const CGAL::L0_resampling::Stage_report& stage : report.stages)
    {
      CHECK(!stage.name.empty() && stage.seconds >= 0);
      largest = (std::max)(largest, stage.peak_bytes);
    }
    CHECK(report.peak_bytes == largest && largest > 1001 * sizeof(Vector));
  }
  CHECK((test::resample<Kernel, Sequential_tag>(points, params::neighbor_radius(1e-9)
                                                          | params::resampling_method(Method::LOR))
           .report.number_of_degenerate_neighborhoods
         == 1001));
}

/// It is reset on entry, and filled as far as the call came.
void test_failed_call()
{
  auto points = test::kernel_points<Kernel>(noisy_cube(1000));
  Report report = test::resample<Kernel, Sequential_tag>(points, params::default_values()).report;
  const auto call = [&](const auto& np) {
    test::Pairs<Kernel> result;
    CGAL::l0_resample_point_set<Sequential_tag>(points, std::back_inserter(result),
                                                np | params::resampling_report(&report));
  };
  CHECK_THROWS(call(params::maximum_memory(100000)), std::bad_alloc);
  CHECK(report.number_of_input_points == 1000 && report.number_of_output_points == 0);
  CHECK_THROWS(call(params::normal_weight(-1)), std::invalid_argument);
  CHECK(report.number_of_input_points == 0 && report.stages.empty() && report.iterations.empty());
  call(params::number_of_output_points(0));
  CHECK(report.outcome == CGAL::L0_resampling::Outcome::COMPLETED
        && report.number_of_output_points == 0);
}

/// Running out of iterations is an answer, and said.
template <typename Solver>
void test_solver_that_does_not_converge()
{
  const auto points = test::kernel_points<Kernel>(noisy_cube(1000));
  for (Method method : {Method::LOR, Method::DEFAULT})
  {
    const auto result = test::resample<Kernel, Sequential_tag>(
      points, params::resampling_method(method).sparse_linear_solver(Solver(1e-12, 1)));
    test::check_clean<Kernel>("one iteration", points, result, 500);
    CHECK(!result.report.converged);
    for (const CGAL::L0_resampling::Iteration_report& iteration : result.report.iterations)
      CHECK(iteration.solver.iterations == 1 && !iteration.solver.converged
            && iteration.solver.relative_residual > 1e-12);
  }
}

/// One turn that does not converge is enough, whichever it is.
struct Solver_that_fails_once
  : public CGAL::L0_resampling::Block_conjugate_gradient_solver_traits<double>
{
  using Base = CGAL::L0_resampling::Block_conjugate_gradient_solver_traits<double>;
  int calls_left;

  explicit Solver_that_fails_once(int call) : calls_left(call) {}

  CGAL::L0_resampling::Solver_report solve(
    const CGAL::L0_resampling::Quadratic_problem<double>& problem, Eigen::Ref<Eigen::VectorXd> x)
  {
    CGAL::L0_resampling::Solver_report report = Base::solve(problem, x);
    report.converged = report.converged && calls_left-- != 0;
    return report;
  }
};

void test_turn_that_does_not_converge()
{
  const auto points = test::kernel_points<Kernel>(noisy_cube(1000));
  for (Method method : {Method::LOR, Method::DEFAULT})
  {
    const auto run = [&](int call) {
      Solver_that_fails_once solver(call);
      return test::resample<Kernel, Sequential_tag>(
               points, params::resampling_method(method).sparse_linear_solver(std::ref(solver)))
        .report;
    };
    const int number_of_turns = int(run(-1).iterations.size());
    CHECK(number_of_turns > 2 && run(-1).converged);
    for (int call : {0, number_of_turns / 2, number_of_turns - 1})
      CHECK(!run(call).converged);
  }
}

/// Points that are left out, samples that no point is near to, and normals whose side is a guess.
void test_exceptional_points()
{
  std::vector<Vector> cube = noisy_cube(1000);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i : {0, 17, 999})
    cube[i][1] = nan;
  const Report dropped = test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(cube),
                                                                params::drop_non_finite(true))
                           .report;
  CHECK(dropped.number_of_dropped_points == 3 && dropped.number_of_input_points == 997
        && dropped.number_of_output_points == 498);

  // half of the samples start around a point that is alone, and have it in their balls
  const auto points = test::kernel_points<Kernel>(noisy_cube(1000));
  for (Method method : {Method::LOR, Method::DEFAULT})
  {
    const Report lonely = test::resample<Kernel, Sequential_tag>(
                            points, params::neighbor_radius(1e-6).number_of_output_points(2000)
                                      | params::resampling_method(method))
                            .report;
    CHECK(lonely.number_of_lonely_samples == 0 && lonely.number_of_output_points == 2000);
  }

  // no surface at all
  test::Generator generator(2);
  std::vector<Vector> fog;
  for (int i = 0; i < 5000; ++i)
    fog.push_back(test::random_vector(0.5, generator));
  const Report unsure =
    test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(fog),
                                           params::neighbor_radius(0.06)
                                             | params::number_of_normal_filter_iterations(0)
                                             | params::resampling_method(Method::LOR))
      .report;
  CHECK(unsure.oriented_share > 0 && unsure.oriented_share < 1);
}

} // namespace

int main()
{
  test_completed_call();
  test_failed_call();
  test_solver_that_does_not_converge<CGAL::L0_resampling::Block_chebyshev_solver_traits<double>>();
  test_solver_that_does_not_converge<
    CGAL::L0_resampling::Block_conjugate_gradient_solver_traits<double>>();
  test_turn_that_does_not_converge();
  test_exceptional_points();
  return test::result();
}
