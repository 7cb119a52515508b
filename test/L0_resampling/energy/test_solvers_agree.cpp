// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The whole function with each solver: the same result, since all solve the same Eq. (10).

#include "promise_support.h"

#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace CGAL::L0_resampling;
using Kernel = CGAL::Simple_cartesian<double>;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

/// A solver of the caller's own, with a state.
struct Counting_solver_traits
{
  using FT = double;
  static constexpr bool needs_explicit_rows = false;
  std::size_t calls = 0;
  Block_conjugate_gradient_solver_traits<double> solver{1e-10};

  Solver_report solve(const Quadratic_problem<double>& problem, Eigen::Ref<Eigen::VectorXd> x)
  {
    ++calls;
    return solver.solve(problem, x);
  }
};

/// A solver that has no answer.
struct Failing_solver_traits
{
  using FT = double;
  static constexpr bool needs_explicit_rows = false;

  Solver_report solve(const Quadratic_problem<double>&, Eigen::Ref<Eigen::VectorXd>) const
  {
    throw Solver_error("no answer");
  }
};

std::vector<Kernel::Point_3> noisy_cube(std::size_t n)
{
  return test::kernel_points<Kernel>(test::noisy_cube(n));
}

template <typename Solver>
test::Resampled<Kernel> resample(Method method, const Solver& solver)
{
  return test::resample<Kernel, CGAL::Sequential_tag>(
    noisy_cube(600),
    params::resampling_method(method).neighbor_radius(0.3).sparse_linear_solver(solver));
}

/// Share of the samples of `a` with no sample of `b` within 1e-4 radii; the order may differ.
/// Algorithm 1 is not continuous: the last digits of a solve may decide a jump at the threshold of
/// Eq. (9), and move a few samples.
double share_of_different(const test::Pairs<Kernel>& a, const test::Pairs<Kernel>& b)
{
  if (a.size() != b.size() || a.empty())
    return 1;
  const auto is_different = [&](const auto& pair) {
    return std::none_of(b.begin(), b.end(), [&](const auto& other) {
      return (test::as_vector(pair.first) - test::as_vector(other.first)).norm() <= 1e-4 * 0.3;
    });
  };
  return double(std::count_if(a.begin(), a.end(), is_different)) / double(a.size());
}

void test_models_agree(Method method)
{
  const double tolerance = 1e-10;
  const std::size_t many = 10000;
  const auto expected = resample(method,
                                 Block_conjugate_gradient_solver_traits<double>(tolerance, many));
  const auto check = [&](const std::string& name, const auto& solver) {
    const auto result = resample(method, solver);
    const double share = share_of_different(result.pairs, expected.pairs);
    if (!CHECK(share <= 0.01 && result.report.converged))
      std::cerr << "  " << name << ", method " << int(method) << ": " << share << std::endl;
  };
  check("parallel", Block_conjugate_gradient_solver_traits<double, CGAL::Parallel_if_available_tag>(
                      tolerance, many));
  if (method
      != Method::
        DEFAULT) // which looks for neighbors anew in every turn: that amplifies what a solve leaves
    check("default tolerance", Block_conjugate_gradient_solver_traits<double>());
  // whose steps are counted beforehand: what is left of eigenvectors below its interval is more
  // than the tolerance, if that is small
  const auto by_chebyshev = resample(method,
                                     Block_chebyshev_solver_traits<double>(tolerance, many));
  CHECK(share_of_different(by_chebyshev.pairs, expected.pairs) <= 0.01);
  for (const Iteration_report& iteration : by_chebyshev.report.iterations)
    CHECK(iteration.solver.relative_residual < std::sqrt(tolerance));
  check("Cholesky", Eigen_cholesky_solver_traits<double>());
  check("least squares", Eigen_least_squares_solver_traits<double>(tolerance, many));
  check("own", Counting_solver_traits());
}

/// Passed by value it is copied, in a `std::reference_wrapper` it is used itself.
void test_reference_to_solver()
{
  Counting_solver_traits solver;
  const auto copied = resample(Method::LOR, solver);
  CHECK(solver.calls == 0);
  const auto referred = resample(Method::LOR, std::ref(solver));
  CHECK(solver.calls == referred.report.iterations.size());
  CHECK(test::are_identical<Kernel>(copied.pairs, referred.pairs));
}

void test_solver_without_answer()
{
  for (Method method : {Method::LOR, Method::ALOR, Method::DEFAULT})
    CHECK_THROWS(resample(method, Failing_solver_traits()), Solver_error);
}

} // namespace

int main()
{
  for (Method method : {Method::LOR, Method::ALOR, Method::DEFAULT})
    test_models_agree(method);
  test_reference_to_solver();
  test_solver_without_answer();
  return test::result();
}
