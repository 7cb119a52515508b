// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Several threads read a range, and write its normals: what they read is that of one thread, and
// what property maps throw passes through.

#include "test_support.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_orient_normals.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/range/irange.hpp>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <list>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::L0_resampling::internal;
namespace parameters = CGAL::parameters;
using CGAL::L0_resampling::Report;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Normal = Kernel::Vector_3;
using Pair = std::pair<Point, Normal>;
using Pairs = std::vector<Pair>;
using Point_map = CGAL::First_of_pair_property_map<Pair>;
using Normal_map = CGAL::Second_of_pair_property_map<Pair>;
using Parallel = CGAL::Parallel_if_available_tag;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Calls `f` with that many threads, also on a machine with fewer.
template <typename F>
void with_threads(int number, const F& f)
{
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    std::size_t(number));
  tbb::task_arena(number).execute(f);
}

/// Points of a sphere, and their normals with signs and lengths by chance.
Pairs sphere(std::size_t n)
{
  test::Generator generator(1);
  Pairs pairs;
  for (std::size_t i = 0; i < n; ++i)
  {
    const test::Vector p = test::random_unit_vector(generator);
    const double length = test::random_number(-2, 2, generator);
    pairs.emplace_back(Point(p[0], p[1], p[2]),
                       Normal(length * p[0], length * p[1], length * p[2]));
  }
  return pairs;
}

// What is read

template <typename ConcurrencyTag, typename Range, typename A_point_map, typename A_normal_map>
Input read(const Range& range, A_point_map point_map, A_normal_map normal_map, bool drop_non_finite)
{
  Report report;
  Input input;
  read_points<ConcurrencyTag>(range, point_map, drop_non_finite, report, input);
  read_normals<ConcurrencyTag>(range, normal_map, input);
  CHECK(report.number_of_input_points == input.points.size());
  CHECK(report.number_of_dropped_points == input.size_of_range - input.points.size());
  return input;
}

/// Compares with a loop over the finite ones.
void check_input(const Input& input, const Pairs& pairs)
{
  std::size_t place = 0;
  bool is_right = true;
  Vector low = Vector::Constant(1e9), high = -low;
  for (const auto& [point, normal] : pairs)
  {
    const Vector p = as_vector(point);
    if (!p.allFinite())
      continue;
    if (place == input.points.size())
      break;
    const Vector n = input.normals[place].cast<double>();
    is_right = is_right && input.points[place++] == p
               && std::abs(n.dot(as_vector(normal).normalized())) > 1 - 1e-6;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  CHECK(is_right && place == input.points.size() && input.normals.size() == place);
  CHECK(place == 0 || (input.low == low && input.high == high));
}

bool are_same(const Input& a, const Input& b)
{
  return a.points == b.points && a.normals == b.normals && a.low == b.low && a.high == b.high;
}

void check_ranges(const Pairs& pairs, bool drop_non_finite)
{
  const Input expected = read<CGAL::Sequential_tag>(pairs, Point_map(), Normal_map(),
                                                    drop_non_finite);
  check_input(expected, pairs);
  const std::list<Pair> list(pairs.begin(), pairs.end());
  const auto indices = boost::irange(std::size_t(0), pairs.size());
  const auto point_of_index = boost::make_function_property_map<std::size_t, const Point&>(
    [&](std::size_t i) -> const Point& { return pairs[i].first; });
  const auto normal_of_index = boost::make_function_property_map<std::size_t, const Normal&>(
    [&](std::size_t i) -> const Normal& { return pairs[i].second; });
  CGAL::Point_set_3<Point> set(true);
  for (const auto& [point, normal] : pairs)
    set.insert(point, normal);
  CHECK(has_random_access<decltype(pairs.begin())> && has_random_access<decltype(indices.begin())>
        && has_random_access<decltype(set.begin())> && !has_random_access<decltype(list.begin())>);
  for (const int threads : {1, 2, 3})
    with_threads(threads, [&] {
      CHECK(are_same(read<Parallel>(pairs, Point_map(), Normal_map(), drop_non_finite), expected));
      CHECK(are_same(read<Parallel>(list, Point_map(), Normal_map(), drop_non_finite), expected));
      CHECK(are_same(read<Parallel>(indices, point_of_index, normal_of_index, drop_non_finite),
                     expected));
      CHECK(are_same(read<Parallel>(set, set.point_map(), set.normal_map(), drop_non_finite),
                     expected));
    });
}

/// The first one is named, and those of several blocks are dropped.
void check_non_finite_points(Pairs pairs)
{
  const auto message = [&] {
    try
    {
      read<Parallel>(pairs, Point_map(), Normal_map(), false);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::size_t first = points_per_look + 77;
  for (const std::size_t i : {first, first + 1, 3 * points_per_look, pairs.size() - 1})
    pairs[i].first = Point(0, 0, nan);
  for (int run = 0; run < 10; ++run)
    with_threads(3, [&] {
      CHECK(message().find("point " + std::to_string(first) + " has") != std::string::npos);
    });
  check_ranges(pairs, true);
  for (std::size_t i = 2 * points_per_look; i < 3 * points_per_look; ++i) // a whole block
    pairs[i].first = Point(nan, 0, 0);
  check_ranges(pairs, true);
}

// Maps of the caller

/// A map that calls a function at each access, which may throw.
template <typename Map>
struct Hooked_map
{
  using key_type = Pair;
  using value_type = typename boost::property_traits<Map>::value_type;
  using reference = const value_type&;
  using category = boost::read_write_property_map_tag;
  using Hook = std::function<void(const Pair&)>;

  Hook on_get = [](const Pair&) {}, on_put = on_get;

  friend reference get(const Hooked_map& map, const Pair& pair)
  {
    map.on_get(pair);
    return get(Map(), pair);
  }
  friend void put(const Hooked_map& map, Pair& pair, const value_type& value)
  {
    map.on_put(pair);
    put(Map(), pair, value);
  }
};

/// Counts the threads that come by. Each waits some time for a second one.
class Thread_count
{
  std::mutex m_mutex;
  std::set<std::thread::id> m_threads;
  std::atomic<std::size_t> m_number{0};
  std::atomic<bool> m_waits{true};

public:
  void wait_for_second(std::chrono::milliseconds patience)
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_threads.insert(std::this_thread::get_id());
      m_number = m_threads.size();
    }
    const auto end = std::chrono::steady_clock::now() + patience;
    while (m_waits && m_number < 2)
    {
      std::this_thread::yield();
      if (std::chrono::steady_clock::now() > end)
        m_waits = false;
    }
  }
  std::size_t number() const { return m_number; }
};

/// Reads and writes with maps that call `hook` for the first point of each block but the first,
/// which is read alone.
/// \returns how many of the loops had the expected number of threads
template <typename ConcurrencyTag>
int number_of_loops_with_threads(std::size_t expected, Pairs pairs)
{
  const std::chrono::milliseconds patience(expected == 1 ? 100 : 20000);
  int number_of_loops = 0;
  const auto count_threads = [&](const auto& f) {
    Thread_count count;
    with_threads(2, [&] {
      f([&](const Pair& pair) {
        const std::size_t i = std::size_t(&pair - pairs.data());
        if (i % points_per_look == 0 && i > 0)
          count.wait_for_second(patience);
      });
    });
    number_of_loops += count.number() == expected;
  };
  pairs[3].second = CGAL::NULL_VECTOR; // left as it is, without one that was estimated
  const Input all = read<CGAL::Sequential_tag>(pairs, Point_map(), Normal_map(), false);
  Oriented_representatives x_axis;
  x_axis.of_points.assign(pairs.size(), 0);
  x_axis.mean_normals.assign(1, Local_vector::UnitX());
  using Hook = Hooked_map<Point_map>::Hook;
  Report report;
  count_threads([&](const Hook& hook) {
    Input input;
    read_points<ConcurrencyTag>(pairs, Hooked_map<Point_map>{hook}, false, report, input);
  });
  count_threads([&](const Hook& hook) {
    Input input;
    input.size_of_range = pairs.size();
    find_finite_points<ConcurrencyTag>(pairs, Hooked_map<Point_map>{hook}, input);
  });
  count_threads([&](const Hook& hook) {
    Input input = all;
    read_normals<ConcurrencyTag>(pairs, Hooked_map<Normal_map>{hook}, input);
  });
  count_threads([&](const Hook& hook) {
    write_oriented_normals<ConcurrencyTag>(pairs, Hooked_map<Normal_map>{hook}, x_axis, all);
  });
  CHECK(
    std::all_of(pairs.begin(), pairs.end(), [](const Pair& pair) { return pair.second.x() >= 0; }));
  return number_of_loops;
}

/// Of no standard type, so that nothing in between can catch it as one.
struct Callers_exception
{};

/// Throws at the n-th call.
Hooked_map<Point_map>::Hook throw_after(std::size_t n, std::atomic<std::size_t>& number_of_calls)
{
  number_of_calls = 0;
  return [n, &number_of_calls](const Pair&) {
    if (++number_of_calls > n)
      throw Callers_exception();
  };
}

/// What is thrown in the midst of a range passes through; up to the first normal that is written
/// nothing has changed, and the next call works.
template <typename ConcurrencyTag>
void check_maps_that_throw(const Pairs& given, const Pairs& oriented)
{
  Pairs pairs = given;
  std::atomic<std::size_t> calls;
  const auto orient = [&](const Hooked_map<Point_map>& point_map,
                          const Hooked_map<Normal_map>& normal_map) {
    with_threads(3, [&] {
      CGAL::l0_orient_normals<ConcurrencyTag>(
        pairs, parameters::point_map(point_map).normal_map(normal_map).geom_traits(Kernel()));
    });
  };
  for (const std::size_t n : {std::size_t(0), points_per_look + 5, pairs.size() - 1})
  {
    CHECK_THROWS(orient({throw_after(n, calls)}, {}), Callers_exception);
    CHECK_THROWS(orient({}, {throw_after(n, calls)}), Callers_exception);
    CHECK(pairs == given);
  }
  Hooked_map<Normal_map> normal_map;
  normal_map.on_put = throw_after(points_per_look / 2, calls);
  CHECK_THROWS(orient({}, normal_map), Callers_exception);
  CHECK(pairs != given && pairs != oriented);
  orient({}, {});
  CHECK(pairs == oriented);
}

/// A call cannot be cancelled once some normals are written.
void check_callback_while_writing(Pairs pairs, const Pairs& oriented)
{
  std::atomic<bool> is_writing{false};
  Hooked_map<Normal_map> normal_map;
  normal_map.on_put = [&](const Pair&) {
    if (!is_writing.exchange(true)) // longer than the callback is left in peace
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
  };
  CGAL::l0_orient_normals<Parallel>(
    pairs, parameters::point_map(Point_map()).normal_map(normal_map).callback([&](double) {
      return !is_writing;
    }));
  CHECK(is_writing);
  CHECK(pairs == oriented);
}

} // namespace

int main()
{
  const Pairs pairs = sphere(4 * points_per_look + 1234);
  check_ranges(pairs, false);
  check_ranges(pairs, true);
  check_ranges({}, true);
  check_non_finite_points(pairs);

  CHECK(number_of_loops_with_threads<CGAL::Parallel_tag>(2, pairs) == 4);
  CHECK(number_of_loops_with_threads<CGAL::Sequential_tag>(1, pairs) == 4);

  const Pairs fewer(pairs.begin(), pairs.begin() + 2 * points_per_look + 99);
  Pairs oriented = fewer;
  for (Pair& pair : oriented)
    if (pair.second * (pair.first - CGAL::ORIGIN) < 0)
      pair.second = -pair.second;
  std::list<Pair> list(fewer.begin(), fewer.end());
  CGAL::l0_orient_normals<Parallel>(list,
                                    parameters::point_map(Point_map()).normal_map(Normal_map()));
  CHECK(std::equal(list.begin(), list.end(), oriented.begin(), oriented.end()));
  check_maps_that_throw<CGAL::Sequential_tag>(fewer, oriented);
  check_maps_that_throw<Parallel>(fewer, oriented);
  check_callback_while_writing(fewer, oriented);
  return test::result();
}
