// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device/test_cuda_support.h"

#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/property_map.h>

#include <limits>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>

// What PROMISE.md says of the device beside agreement with the CPU.

namespace {

using namespace test_cuda;
using CGAL::L0_resampling::CUDA_resampler;
using CGAL::L0_resampling::Method;
namespace parameters = CGAL::parameters;

const Method methods[] = {Method::LOR, Method::ALOR, Method::DEFAULT};

template <typename NamedParameters>
Result resample(const Points& points, const NamedParameters& np)
{
  Result result;
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(result), np);
  return result;
}

/// P7: bitwise the same from run to run, whatever the device did before.
void check_determinism()
{
  const Points points = with_outliers(noisy_cube(30000, 0.01, 1), 8);
  for (const Method method : methods)
  {
    const auto np = parameters::resampling_method(method).drop_outliers(true).select_percentage(60);
    const Result first = resample(points, np);
    CUDA_resampler<Kernel> resampler;
    resampler.upload(points);
    for (int run = 0; run < 50; ++run)
    {
      Result other;
      if (run % 10 == 0)
        resampler.resample(std::back_inserter(other), np.number_of_output_points(1000 + run));
      other.clear();
      resampler.resample(std::back_inserter(other), np);
      if (!CHECK(other == first))
        break;
    }
  }
}

/// P1, P3: refused before anything is brought to the device, so that the object goes on working.
void check_refusals()
{
  Points points = noisy_cube(2000, 0.01, 2);
  CUDA_resampler<Kernel> resampler;
  Result result;
  resampler.resample(std::back_inserter(result), parameters::number_of_output_points(10));
  CHECK(result.empty()); // no points yet
  resampler.upload(points);
  CHECK_THROWS(resampler.resample(std::back_inserter(result),
                                  parameters::neighbor_radius(std::nan(""))),
               std::invalid_argument);
  CHECK_THROWS(resampler.resample(std::back_inserter(result), parameters::penalty_growth(1.)),
               std::invalid_argument);
  CHECK(result.empty());
  resampler.resample(std::back_inserter(result), parameters::number_of_output_points(500));
  CHECK(result.size() == 500);

  const Points good(points);
  points[1234] = Point(0, std::numeric_limits<double>::infinity(), 0);
  CHECK_THROWS(resampler.upload(points), std::invalid_argument);
  result.clear();
  resampler.resample(std::back_inserter(result), parameters::number_of_output_points(500));
  CHECK(result.empty()); // the old points are gone
  Report report;
  resampler.upload(points, parameters::drop_non_finite(true));
  resampler.resample(std::back_inserter(result), parameters::number_of_output_points(500)
                                                   | parameters::resampling_report(&report));
  CHECK(result.size() == 500 && report.number_of_dropped_points == 1
        && report.number_of_input_points == good.size() - 1);
}

/// P8, G4: too little memory is an exception, and the next call works.
void check_memory()
{
  const Points points = noisy_cube(50000, 0.01, 3);
  const auto np = parameters::resampling_method(Method::LOR).select_percentage(60);
  Report report;
  const Result result = resample(points, np.resampling_report(&report));
  CHECK(report.peak_bytes > 0);
  for (const double share : {1e-6, 0.1, 0.3, 0.5, 0.8, 0.99})
    CHECK_THROWS(resample(points,
                          np.maximum_memory(std::size_t(double(report.peak_bytes) * share))),
                 std::bad_alloc);
  CHECK(resample(points, np.maximum_memory(report.peak_bytes)) == result);
  CHECK(resample(points, np) == result);
}

/// P9: progress, cancellation, exceptions of the callback.
void check_callback()
{
  const Points points = noisy_cube(300000, 0.003, 4);
  const auto np = parameters::select_percentage(60);
  double last = 0;
  bool falls = false;
  std::size_t calls = 0;
  const std::function<bool(double)> watch = [&](double share) {
    falls = falls || share < last || share > 1;
    last = share;
    ++calls;
    return true;
  };
  Report report;
  const Result all = resample(points, np.callback(watch) | parameters::resampling_report(&report));
  CHECK(!falls
        && calls >= report.stages.size()); // asked at the begin of each, however fast the device
  CHECK(all == resample(points, np));

  for (const Points& refused : {points, noisy_cube(10, 0.003, 4)}) // short calls too
  {
    CHECK(resample(refused, np.callback([](double) { return false; })
                              | parameters::resampling_report(&report))
            .empty());
    CHECK(report.outcome == CGAL::L0_resampling::Outcome::CANCELLED);
  }
  struct Own
  {};
  CHECK_THROWS(resample(points, np.callback([](double) -> bool { throw Own(); })), Own);
  CHECK(resample(points, np) == all);
}

/// P9: one call of the function is cancelled at each call of the callback, the last one included.
void check_cancellation_at_every_call()
{
  const Points points = noisy_cube(5000, 0.01, 9);
  for (const Method method : methods)
  {
    const auto np = parameters::resampling_method(method).select_percentage(60);
    int calls = 0, refused_call = 0;
    const std::function<bool(double)> callback = [&](double) { return ++calls != refused_call; };
    Report report;
    const auto watched = np.callback(callback) | parameters::resampling_report(&report);
    const Result all = resample(points, watched);
    const int number_of_calls = calls; // depends on the iterations only, not on the time they take
    const std::size_t number_of_stages = report.stages.size();
    std::set<std::size_t> stages;
    for (refused_call = 1; refused_call <= number_of_calls; ++refused_call)
    {
      calls = 0;
      CHECK(resample(points, watched).empty());
      CHECK(calls == refused_call);
      CHECK(report.outcome == CGAL::L0_resampling::Outcome::CANCELLED);
      CHECK(report.number_of_output_points == 0);
      stages.insert(report.stages.size());
    }
    CHECK(stages.size() == number_of_stages && *stages.begin() == 1);
    CHECK(resample(points, np) == all);
  }
}

/// G6: two threads at once, each with its own call, and both with one object.
void check_threads()
{
  const Points cube = noisy_cube(20000, 0.01, 5), sphere = noisy_sphere(20000, 0.01, 6);
  const auto np = parameters::select_percentage(60);
  const Result of_cube = resample(cube, np), of_sphere = resample(sphere, np);
  Result other_of_cube, other_of_sphere;
  std::thread first([&]() {
    for (int i = 0; i < 5; ++i)
      other_of_cube = resample(cube, np);
  });
  std::thread second([&]() {
    for (int i = 0; i < 5; ++i)
      other_of_sphere = resample(sphere, np);
  });
  first.join();
  second.join();
  CHECK(other_of_cube == of_cube);
  CHECK(other_of_sphere == of_sphere);
}

/// Given normals replace PCA; their sign and length do not matter.
void check_given_normals()
{
  const Points points = noisy_sphere(5000, 0.01, 7);
  Result with_normals, with_other_signs, result, other_result;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Normal n = points[i] - CGAL::ORIGIN;
    with_normals.emplace_back(points[i], i % 50 == 0 ? CGAL::NULL_VECTOR : n);
    with_other_signs.emplace_back(points[i], i % 50 == 0 ? CGAL::NULL_VECTOR : i % 2 ? -2 * n : n);
  }
  const auto np = parameters::point_map(CGAL::First_of_pair_property_map<Result::value_type>())
                    .normal_map(CGAL::Second_of_pair_property_map<Result::value_type>())
                    .select_percentage(50);
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(with_normals, std::back_inserter(result), np);
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(with_other_signs, std::back_inserter(other_result),
                                              np);
  CHECK(result.size() == 2500 && result == other_result);
  for (const auto& [p, n] : result)
    CHECK(n * (p - CGAL::ORIGIN) > 0.95 * std::sqrt((p - CGAL::ORIGIN).squared_length()));
}

} // namespace

int main()
{
  if (!has_device())
    return number_of_skip;
  check_determinism();
  check_refusals();
  check_memory();
  check_callback();
  check_cancellation_at_every_call();
  check_threads();
  check_given_normals();
  return test::result();
}
