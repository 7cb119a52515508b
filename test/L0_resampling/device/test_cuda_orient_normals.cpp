// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device/device_faults.h"
#include "device/test_cuda_support.h"

#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/l0_orient_normals.h>

#include <cuda_runtime_api.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <new>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

// Normals that are oriented on the device have the sides of the CPU, and calls that fail leave
// everything as it was.

namespace {

using namespace test_cuda;
using CGAL::L0_resampling::Device_error;
namespace parameters = CGAL::parameters;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

auto maps()
{
  using Pair = Result::value_type;
  return parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
    .normal_map(CGAL::Second_of_pair_property_map<Pair>());
}

/// Without normals.
Result pairs_of(const Points& points)
{
  Result pairs;
  for (const Point& p : points)
    pairs.emplace_back(p, CGAL::NULL_VECTOR);
  return pairs;
}

/// What the CPU makes of the points, with signs by chance.
Result with_given_normals(const Points& points, unsigned seed)
{
  Result pairs = pairs_of(points);
  CGAL::l0_orient_normals<CGAL::Parallel_if_available_tag>(pairs, maps());
  test::Generator generator(seed);
  for (auto& pair : pairs)
    if (std::bernoulli_distribution()(generator))
      pair.second = -2 * pair.second;
  return pairs;
}

template <typename ConcurrencyTag, typename NamedParameters>
Report orient(Result& pairs, const NamedParameters& np)
{
  Report report;
  CGAL::l0_orient_normals<ConcurrencyTag>(pairs, np | parameters::resampling_report(&report));
  return report;
}

double share_of_other_sides(const Result& pairs, const Result& others)
{
  std::size_t number = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    number += pairs[i].second * others[i].second < 0;
  return double(number) / double(pairs.size());
}

std::size_t free_memory()
{
  std::size_t free = 0, total = 0;
  CHECK(cudaMemGetInfo(&free, &total) == cudaSuccess);
  return free;
}

/// \param other_sides the share of them that float rounding may turn
template <typename NamedParameters>
void compare(const char* name, const Result& pairs, double other_sides, const NamedParameters& np)
{
  Result on_cpu = pairs, on_device = pairs, again = pairs;
  const Report cpu = orient<CGAL::Parallel_if_available_tag>(on_cpu, np),
               device = orient<CGAL::CUDA_tag>(on_device, np);
  orient<CGAL::CUDA_tag>(again, np);
  const double share = share_of_other_sides(on_cpu, on_device);
  std::cout << name << ": " << pairs.size() << " points, other sides " << share << ", oriented "
            << cpu.oriented_share << " / " << device.oriented_share << ", hinted "
            << cpu.hinted_share << " / " << device.hinted_share << ", right sides "
            << cpu.right_side_share << " / " << device.right_side_share << ", distinct "
            << cpu.number_of_distinct_points << " / " << device.number_of_distinct_points
            << ", bytes a point " << double(device.peak_bytes) / double(pairs.size()) << std::endl;
  CHECK(share <= other_sides);
  CHECK(std::abs(cpu.oriented_share - device.oriented_share) <= 0.02);
  CHECK(std::abs(cpu.hinted_share - device.hinted_share) <= 0.02);
  CHECK(std::abs(cpu.right_side_share - device.right_side_share) <= 0.03);
  CHECK(cpu.number_of_distinct_points == device.number_of_distinct_points);
  CHECK(cpu.number_of_output_points == device.number_of_output_points);
  CHECK(std::abs(cpu.estimated_noise - device.estimated_noise) <= 0.01 * cpu.estimated_noise);
  CHECK(device.device == "cuda" && device.device_reason == "asked for");
  CHECK(!device.stages.empty() && device.peak_bytes > 0);
  CHECK(on_device == again);
  std::size_t number_of_others = 0; // than a normal, or its opposite
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].second == CGAL::NULL_VECTOR)
      number_of_others += std::abs(on_cpu[i].second * on_device[i].second) < 0.99;
    else
      number_of_others += on_device[i].second != pairs[i].second
                          && on_device[i].second != -pairs[i].second;
  // points that lie alone have no plane, and sides and normals of their own
  CHECK(double(number_of_others) <= (std::max)(1e-3, other_sides) * double(pairs.size()));
}

void check_shapes()
{
  const Points sphere = noisy_sphere(20000, 0.003, 1), torus = noisy_torus(20000, 0.003, 2),
               cube = noisy_cube(20000, 0.003, 3);
  compare("sphere, estimated", pairs_of(sphere), 0, maps());
  compare("sphere, given", with_given_normals(sphere, 4), 0, maps());
  compare("torus, given", with_given_normals(torus, 5), 0.002, maps());
  compare("cube, estimated", pairs_of(cube), 0.01, maps());
  compare("cube, far away", pairs_of(moved(cube, {5e5, 5.4e6, 300})), 0.01, maps());
  compare("graded sphere", pairs_of(graded_sphere(20000, 0.003, 6)), 0.002, maps());
  compare("outliers", pairs_of(with_outliers(sphere, 7)), 0.02, maps());
  Result half_given = with_given_normals(sphere, 8);
  for (std::size_t i = 0; i < half_given.size(); i += 2)
    half_given[i].second = CGAL::NULL_VECTOR;
  compare("sphere, half given", half_given, 0, maps());
  compare("radius, neighbors", pairs_of(sphere), 0,
          maps().neighbor_radius(0.1) | parameters::number_of_orientation_neighbors(20));
}

/// Points that others stand for: at one place, in crowds, and within the noise.
void check_represented_points()
{
  const Points sphere = noisy_sphere(20000, 0.003, 11);
  compare("every point twice", with_given_normals(duplicated(sphere), 12), 0.002, maps());
  Result crowd = with_given_normals(sphere, 13);
  crowd.resize(120000, crowd[3]);
  for (std::size_t i = 119000; i < crowd.size(); ++i) // almost there
    crowd[i].first = crowd[i].first + 1e-5 * double(i % 100) / 100 * Normal(1, 0.5, 0.2);
  compare("crowd", crowd, 0.002, maps());
  for (std::size_t i = 20000; i < crowd.size(); ++i)
    crowd[i].second = CGAL::NULL_VECTOR;
  compare("crowd with one normal", crowd, 0.002, maps());
  compare("much noise", with_given_normals(noisy_sphere(60000, 0.02, 14), 15), 0.002, maps());
}

void check_hints()
{
  const Points sphere = noisy_sphere(20000, 0.003, 21);
  const Result given = with_given_normals(sphere, 22);
  compare("viewpoint", given, 0, maps() | parameters::viewpoint(Point(0.1, 0, 0)));
  // Near the equator of a sphere this direction knows no side. Elsewhere it tells all, and of the
  // half below, as seen from above, all together.
  Result on_cpu = given, on_device = given;
  orient<CGAL::Parallel_if_available_tag>(on_cpu,
                                          maps() | parameters::up_direction(Normal(0, 0, 1)));
  orient<CGAL::CUDA_tag>(on_device, maps() | parameters::up_direction(Normal(0, 0, 1)));
  for (std::size_t i = 0; i < given.size(); ++i)
    if (std::abs(given[i].first.z()) > 0.2)
      CHECK(on_cpu[i].second == on_device[i].second);
  Points bowl;
  for (const Point& p : sphere)
    if (p.z() < 0)
      bowl.push_back(p);
  compare("up", with_given_normals(bowl, 22), 0.002,
          maps() | parameters::up_direction(Normal(0, 0, 1)));
  const Result inwards = [&] {
    Result pairs = pairs_of(sphere);
    for (auto& pair : pairs)
      pair.second = CGAL::ORIGIN - pair.first;
    return pairs;
  }();
  std::vector<Point> viewpoints;
  std::vector<Normal> hints;
  for (const auto& pair : inwards)
  {
    viewpoints.push_back(CGAL::ORIGIN + 9 * (pair.first - CGAL::ORIGIN));
    hints.push_back(pair.second);
  }
  // maps of the indices, as the tool has
  const auto oriented = [&](const auto& np) {
    std::vector<Normal> normals;
    for (const auto& pair : given)
      normals.push_back(pair.second);
    std::vector<std::size_t> indices(sphere.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = i;
    Report report;
    CGAL::l0_orient_normals<CGAL::CUDA_tag>(indices,
                                            parameters::point_map(CGAL::make_property_map(sphere))
                                                .normal_map(CGAL::make_property_map(normals))
                                              | np | parameters::resampling_report(&report));
    CHECK(report.hinted_share == 1);
    std::size_t number_inwards = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
      number_inwards += normals[i] * hints[i] > 0;
    return number_inwards;
  };
  CHECK(oriented(parameters::viewpoint_map(CGAL::make_property_map(viewpoints))) == 0);
  CHECK(oriented(parameters::orientation_hint_map(CGAL::make_property_map(hints)))
        == sphere.size());
}

void check_few_points()
{
  Result none;
  CHECK(orient<CGAL::CUDA_tag>(none, maps()).number_of_input_points == 0);
  for (const std::size_t n : {1, 2, 3, 31, 32, 33})
  {
    Result pairs;
    for (std::size_t i = 0; i < n; ++i)
      pairs.emplace_back(Point(double(i), 0, 0), Normal(0, 0, -3));
    orient<CGAL::CUDA_tag>(pairs, maps());
    for (const auto& pair : pairs)
      CHECK(pair.second == Normal(0, 0, 3));
    pairs.assign(n, {Point(1, 2, 3), CGAL::NULL_VECTOR});
    orient<CGAL::CUDA_tag>(pairs, maps());
    for (const auto& pair : pairs)
      CHECK(std::abs(pair.second.squared_length() - 1) < 1e-6);
  }
}

/// Of a call that ends in another way nothing is written, and no memory is lost.
void check_refusals()
{
  const Result given = with_given_normals(noisy_cube(20000, 0.003, 31), 32);
  Result pairs = given;
  CHECK_THROWS(orient<CGAL::CUDA_tag>(pairs, maps().neighbor_radius(-1.)), std::invalid_argument);
  pairs[17].first = Point(0, nan, 0);
  CHECK_THROWS(orient<CGAL::CUDA_tag>(pairs, maps()), std::invalid_argument);
  const Report report = orient<CGAL::CUDA_tag>(pairs, maps() | parameters::drop_non_finite(true));
  CHECK(report.number_of_dropped_points == 1 && pairs[17].second == given[17].second);

  pairs = given;
  const std::size_t free_before = free_memory();
  for (const int last : {0, 1})
  {
    int calls = 0;
    const auto np = maps().callback([&](double) { return calls++ < last; });
    CHECK(orient<CGAL::CUDA_tag>(pairs, np).outcome == CGAL::L0_resampling::Outcome::CANCELLED);
    CHECK(calls == last + 1);
  }
  CHECK_THROWS(orient<CGAL::CUDA_tag>(pairs, maps().callback([](double) -> bool { throw 1.5f; })),
               float);
  CHECK(pairs == given && free_memory() == free_before);
}

/// The limit holds, and what is needed suffices.
void check_limit()
{
  const Result given = with_given_normals(noisy_cube(20000, 0.003, 41), 42);
  Result expected = given;
  const std::size_t peak = orient<CGAL::CUDA_tag>(expected, maps()).peak_bytes;
  Result pairs = given;
  for (const double share : {1e-6, 0.1, 0.5, 0.95})
    CHECK_THROWS(orient<CGAL::CUDA_tag>(
                   pairs, maps() | parameters::maximum_memory(std::size_t(share * double(peak)))),
                 std::bad_alloc);
  CHECK(pairs == given);
  CHECK(orient<CGAL::CUDA_tag>(pairs, maps() | parameters::maximum_memory(peak)).peak_bytes
        <= peak);
  CHECK(pairs == expected);
}

/// Whichever allocation fails, the memory is there again, and the next call works.
void check_allocations()
{
  const Result given = with_given_normals(duplicated(noisy_cube(20000, 0.01, 51)), 52);
  Result expected = given;
  orient<CGAL::CUDA_tag>(expected, maps());
  const std::size_t free_before = free_memory();
  std::size_t number_of_failures = 0;
  for (std::size_t k = 1; k < 200; ++k)
  {
    Result pairs = given;
    bool has_failed = false;
    fail_allocation(k);
    try
    {
      orient<CGAL::CUDA_tag>(pairs, maps());
    }
    catch (const std::bad_alloc&)
    {
      has_failed = true;
    }
    fail_allocation(0);
    CHECK(free_memory() == free_before);
    CHECK(pairs == (has_failed ? given : expected));
    if (!has_failed)
      break;
    ++number_of_failures;
  }
  CHECK(number_of_failures >= 2);
}

/// The last check: the device is lost for this process.
void check_kernel_error()
{
  const Result given = with_given_normals(noisy_cube(2000, 0.01, 61), 62);
  Result pairs = given;
  bool is_broken = false;
  const std::function<bool(double)> break_at_first_call = [&](double) {
    if (!std::exchange(is_broken, true))
      break_device();
    return true;
  };
  for (int attempt = 0; attempt < 2; ++attempt)
    CHECK_THROWS(orient<CGAL::CUDA_tag>(pairs, maps().callback(break_at_first_call)), Device_error);
  CHECK(is_broken);
  CHECK(pairs == given);
  orient<CGAL::Sequential_tag>(pairs, maps());
}

} // namespace

int main()
{
  if (!has_device())
    return number_of_skip;
  check_shapes();
  check_represented_points();
  check_hints();
  check_few_points();
  check_refusals();
  check_limit();
  check_allocations();
  check_kernel_error();
  return test::result();
}
