// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 9: the callback learns the progress, from one thread at a time, and can end the call.

#include "promise_support.h"

#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using CGAL::L0_resampling::Outcome;
namespace params = CGAL::parameters;

namespace {

/// Says no at one call, and keeps what must not happen.
struct Observer
{
  int refused_call; // 0 for none
  std::atomic<int> calls{0};
  double last_value = 0;
  bool stays_in_range = true, never_falls = true, call_is_running = true;
  std::atomic<bool> is_alone{true};
  std::atomic<int> inside{0};

  explicit Observer(int refused) : refused_call(refused) {}

  bool operator()(double value)
  {
    is_alone = is_alone && ++inside == 1;
    stays_in_range = stays_in_range && value >= 0 && value <= 1;
    never_falls = never_falls && value >= last_value;
    last_value = value;
    CHECK(call_is_running);
    const bool answer = ++calls != refused_call;
    --inside;
    return answer;
  }
};

Points cloud(std::size_t n)
{
  test::Generator generator(1);
  test::Oriented_points cube = test::cube_points(n, 1, generator);
  test::add_gaussian_noise(cube.points, 0.005, generator);
  return test::kernel_points<Kernel>(cube.points);
}

/// Runs with an observer and checks what holds whether the call is cancelled or not.
template <typename ConcurrencyTag, typename NamedParameters>
test::Resampled<Kernel> observe(const Points& points, Observer& observer, const NamedParameters& np)
{
  const std::function<bool(double)> callback = std::ref(observer);
  auto result = test::resample<Kernel, ConcurrencyTag>(points, np.callback(callback));
  observer.call_is_running = false;
  CHECK(observer.stays_in_range);
  CHECK(observer.never_falls);
  CHECK(observer.is_alone);
  return result;
}

template <typename ConcurrencyTag, typename NamedParameters>
void test_cancellation(const Points& points, const NamedParameters& np)
{
  Observer patient(0);
  const auto uncalled = test::resample<Kernel, ConcurrencyTag>(points, np);
  const auto complete = observe<ConcurrencyTag>(points, patient, np);
  CHECK(complete.report.outcome == Outcome::COMPLETED);
  CHECK(test::are_identical<Kernel>(complete.pairs, uncalled.pairs));
  const int stages = int(complete.report.stages.size()); // asked at the begin of each, however fast the machine
  CHECK(patient.calls >= stages);

  for (int refused : {1, 2, 3, 5, 8, 13, 21, 34})
  {
    if (refused > stages && 2 * refused > patient.calls) // the next run may be twice as fast
      break;
    Observer observer(refused);
    const auto result = observe<ConcurrencyTag>(points, observer, np);
    CHECK(observer.calls == refused);
    CHECK(result.report.outcome == Outcome::CANCELLED);
    CHECK(result.pairs.empty());
    CHECK(result.report.number_of_output_points == 0);
  }

  // a report that was used before, and a callback that has said no before
  Observer again(0);
  CHECK(test::are_identical<Kernel>(observe<ConcurrencyTag>(points, again, np).pairs, uncalled.pairs));
}

/// While one thread waits for a slow callback, the others do not call it too.
void test_slow_callback()
{
  Observer observer(0);
  const std::function<bool(double)> callback = [&](double value) {
    ++observer.inside;
    std::this_thread::sleep_for(std::chrono::milliseconds(60)); // three times what lies between two calls
    observer.is_alone = observer.is_alone && observer.inside == 1;
    --observer.inside;
    ++observer.calls;
    return value >= 0;
  };
  test::resample<Kernel, CGAL::Parallel_if_available_tag>(cloud(20000), params::callback(callback));
  CHECK(observer.is_alone);
  CHECK(observer.calls > 0);
}

/// A call of microseconds can be ended too.
void test_short_call()
{
  Observer observer(1);
  const auto result = observe<CGAL::Sequential_tag>(cloud(10), observer,
                                                    params::resampling_method(CGAL::L0_resampling::Method::LOR));
  CHECK(observer.calls == 1);
  CHECK(result.report.outcome == Outcome::CANCELLED);
  CHECK(result.pairs.empty());
}

/// An empty function is none.
void test_empty_callback()
{
  const auto result = test::resample<Kernel, CGAL::Sequential_tag>(cloud(500),
                                                                   params::callback(std::function<bool(double)>()));
  CHECK(result.report.outcome == Outcome::COMPLETED);
  CHECK(result.pairs.size() == 250);
}

} // namespace

int main()
{
  using CGAL::L0_resampling::Method;
  const Points points = cloud(40000);
  test_cancellation<CGAL::Sequential_tag>(points, params::resampling_method(Method::LOR));
  test_cancellation<CGAL::Parallel_if_available_tag>(points, params::resampling_method(Method::ALOR));
  test_cancellation<CGAL::Parallel_if_available_tag>(points, params::number_of_output_points(80000).neighbor_radius(0.03));
  test_cancellation<CGAL::Sequential_tag>(
    cloud(4000), params::sparse_linear_solver(CGAL::L0_resampling::Eigen_least_squares_solver_traits<double>()));
  test_slow_callback();
  test_short_call();
  test_empty_callback();
  return test::result();
}
