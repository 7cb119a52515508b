// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 9: the callback learns the progress, from one thread at a time, and can end the call.

#include "promise_support.h"

#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Sequential = CGAL::Sequential_tag;
using Parallel = CGAL::Parallel_if_available_tag;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Outcome;
using CGAL::L0_resampling::Report;
namespace params = CGAL::parameters;

namespace {

/// One call of the callback. Both numbers count from 1.
struct Place
{
  std::size_t stage; ///< number of the running stage; 0 before the first one
  std::size_t call;  ///< number of the call within the stage
};
constexpr Place nowhere{0, 0};

/// A callback that returns `false` at one place, and records what must not happen.
struct Observer
{
  const Place refused;
  std::vector<std::size_t> calls_in_stage; ///< by the number of the stage
  std::atomic<int> calls{0};
  double last_value = 0;
  bool stays_in_range = true, never_falls = true, call_is_running = true, has_refused = false;
  std::atomic<bool> is_alone{true};
  std::atomic<int> inside{0};

  explicit Observer(Place place) : refused(place) {}

  bool operator()(double value, std::size_t stage)
  {
    is_alone = is_alone && ++inside == 1;
    stays_in_range = stays_in_range && value >= 0 && value <= 1;
    never_falls = never_falls && value >= last_value;
    last_value = value;
    CHECK(call_is_running && !has_refused);
    ++calls;
    calls_in_stage.resize((std::max)(calls_in_stage.size(), stage + 1));
    const std::size_t call = ++calls_in_stage[stage];
    has_refused = stage == refused.stage && call == refused.call;
    const bool answer = !has_refused;
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

/// What one call gave: the points, the report and, if asked for, what it wrote to the output maps.
struct Observed
{
  test::Pairs<Kernel> pairs;
  Report report;
  std::vector<std::size_t> sources;
  std::vector<float> confidences;
};

enum class Output
{
  PAIRS,
  PAIRS_AND_MAPS
};

constexpr std::size_t no_source = std::size_t(-1);
constexpr float no_confidence = -1;

/// Runs with an observer and checks what holds whether the call is cancelled or not.
template <typename ConcurrencyTag, typename NamedParameters>
Observed observe(const Points& points, Output output, Observer& observer, const NamedParameters& np)
{
  Observed result;
  const std::size_t maximum_number_of_outputs = 2 * points.size();
  result.sources.assign(maximum_number_of_outputs, no_source);
  result.confidences.assign(maximum_number_of_outputs, no_confidence);
  auto source_map = std::make_optional(CGAL::make_property_map(result.sources));
  auto confidence_map = std::make_optional(CGAL::make_property_map(result.confidences));
  if (output == Output::PAIRS)
  {
    source_map.reset();
    confidence_map.reset();
  }
  const std::function<bool(double)> callback = [&](double value) {
    const std::size_t stage = result.report.stages.size();
    return observer(value, stage);
  };
  const auto asked = np.callback(callback) | params::resampling_report(&result.report);
  const auto with_maps = asked | params::source_index_map(source_map)
                         | params::feature_confidence_map(confidence_map); // may be empty
  CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result.pairs), with_maps);
  observer.call_is_running = false;
  CHECK(observer.stays_in_range);
  CHECK(observer.never_falls);
  CHECK(observer.is_alone);
  return result;
}

/// Runs with a callback that returns `false` at this place, and checks that nothing comes out.
/// \returns whether the callback was called there
template <typename ConcurrencyTag, typename NamedParameters>
bool is_cancelled_at(Place place, const Points& points, Output output, const NamedParameters& np)
{
  Observer observer(place);
  const Observed result = observe<ConcurrencyTag>(points, output, observer, np);
  if (!observer.has_refused)
  {
    CHECK(result.report.outcome == Outcome::COMPLETED);
    return false;
  }
  const auto holds_only = [](const auto& values, auto value) {
    return std::all_of(values.begin(), values.end(), [&](auto x) { return x == value; });
  };
  bool is_good = CHECK(result.report.outcome == Outcome::CANCELLED);
  is_good = CHECK(result.report.stages.size() == place.stage) && is_good;
  is_good = CHECK(result.report.number_of_output_points == 0 && result.pairs.empty()) && is_good;
  is_good = CHECK(holds_only(result.sources, no_source)) && is_good;
  is_good = CHECK(holds_only(result.confidences, no_confidence)) && is_good;
  if (!is_good)
    std::cerr << "  call " << place.call << " in stage " << place.stage << std::endl;
  return true;
}

/// Cancels a call in each of its stages: at the begin, soon after it, and in the middle.
template <typename ConcurrencyTag, typename NamedParameters>
void test_every_stage(const Points& points, Output output, const NamedParameters& np)
{
  const auto uncalled = test::resample<Kernel, ConcurrencyTag>(points, np);
  Observer patient(nowhere);
  const Observed complete = observe<ConcurrencyTag>(points, output, patient, np);
  CHECK(complete.report.outcome == Outcome::COMPLETED);
  CHECK(test::are_identical<Kernel>(complete.pairs, uncalled.pairs));

  for (std::size_t stage = 1; stage <= complete.report.stages.size(); ++stage)
  {
    // called at the begin of each stage, however fast the machine
    const bool has_begin = is_cancelled_at<ConcurrencyTag>({stage, 1}, points, output, np);
    if (!CHECK(has_begin))
    {
      std::cerr << "  " << complete.report.stages[stage - 1].name << std::endl;
      continue;
    }
    // the other calls depend on time: the next run may be faster, and have fewer of them
    const std::size_t calls = patient.calls_in_stage.at(stage);
    for (std::size_t call : std::set<std::size_t>{2, (calls + 1) / 2})
      if (call > 1 && call <= calls)
        is_cancelled_at<ConcurrencyTag>({stage, call}, points, output, np);
  }

  Observer again(nowhere); // that calls were cancelled before has no influence
  const Observed last = observe<ConcurrencyTag>(points, output, again, np);
  CHECK(test::are_identical<Kernel>(last.pairs, uncalled.pairs));
}

template <typename NamedParameters>
void test_method(const NamedParameters& np)
{
  const Points few = cloud(3000), many = cloud(30000);
  for (const Output output : {Output::PAIRS, Output::PAIRS_AND_MAPS})
  {
    test_every_stage<Sequential>(few, output, np);
    test_every_stage<Parallel>(few, output, np);
  }
  test_every_stage<Parallel>(many, Output::PAIRS, np);
}

/// While one thread waits for a slow callback, the others do not call it too.
void test_slow_callback()
{
  std::atomic<int> inside{0}, calls{0};
  std::atomic<bool> is_alone{true};
  const std::function<bool(double)> callback = [&](double value) {
    ++inside;
    std::this_thread::sleep_for(std::chrono::milliseconds(60)); // three times the interval of calls
    is_alone = is_alone && inside == 1;
    --inside;
    ++calls;
    return value >= 0;
  };
  const auto np = params::callback(callback);
  test::resample<Kernel, Parallel>(cloud(20000), np);
  CHECK(is_alone);
  CHECK(calls > 0);
}

/// A call of microseconds can be cancelled too, as can one with more stages or other parameters.
void test_other_calls()
{
  using CGAL::L0_resampling::Eigen_least_squares_solver_traits;
  const Output pairs = Output::PAIRS;
  test_every_stage<Sequential>(cloud(10), pairs, params::resampling_method(Method::LOR));
  const auto more_points = params::number_of_output_points(20000).neighbor_radius(0.05);
  test_every_stage<Parallel>(cloud(10000), pairs, more_points);
  const Eigen_least_squares_solver_traits<double> solver; // has a stage of its own
  const auto alor = params::resampling_method(Method::ALOR);
  const auto explicit_rows = params::sparse_linear_solver(solver) | alor;
  test_every_stage<Sequential>(cloud(2000), pairs, explicit_rows);
}

/// An empty function is none.
void test_empty_callback()
{
  const std::function<bool(double)> none;
  const auto np = params::callback(none);
  const auto result = test::resample<Kernel, Sequential>(cloud(500), np);
  CHECK(result.report.outcome == Outcome::COMPLETED);
  CHECK(result.pairs.size() == 250);
}

} // namespace

int main()
{
  for (const Method method : {Method::LOR, Method::ALOR, Method::DEFAULT})
    test_method(params::resampling_method(method));
  test_slow_callback();
  test_other_calls();
  test_empty_callback();
  return test::result();
}
