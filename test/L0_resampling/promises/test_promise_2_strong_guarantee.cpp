// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 2: the input stays as it is, bit by bit; exceptions of the caller's own types pass;
// nothing is written before the end.

#include "promise_support.h"

#include <CGAL/property_map.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <atomic>
#include <cstring>
#include <limits>
#include <list>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Pair = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

/// Of no standard type, so that nothing in between can catch it as one.
struct Callers_exception
{
  int number;
};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A noisy cube with its normals, of random lengths and signs.
std::vector<Pair> oriented_cube(std::size_t n)
{
  test::Generator generator(1);
  test::Oriented_points cube = test::cube_points(n, 1, generator);
  test::add_gaussian_noise(cube.points, 0.01, generator);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector p = cube.points[i],
                 normal = test::random_number(-3, 3, generator) * cube.normals[i];
    pairs.emplace_back(Kernel::Point_3(p[0], p[1], p[2]),
                       Kernel::Vector_3(normal[0], normal[1], normal[2]));
  }
  return pairs;
}

/// A map that throws at the k-th access.
template <typename Value, Value Pair::*member>
struct Throwing_map
{
  using key_type = Pair;
  using value_type = Value;
  using reference = const Value&;
  using category = boost::readable_property_map_tag;

  std::atomic<int>* accesses_left;

  friend reference get(const Throwing_map& map, const Pair& pair)
  {
    if (--*map.accesses_left < 0)
      throw Callers_exception{42};
    return pair.*member;
  }
};

using Point_map = CGAL::First_of_pair_property_map<Pair>;
using Normal_map = CGAL::Second_of_pair_property_map<Pair>;

/// The bits of the coordinates: `==` would not see a zero change its sign, nor a NaN stay one.
std::vector<double> numbers(const std::vector<Pair>& pairs)
{
  std::vector<double> result;
  for (const auto& [p, n] : pairs)
    result.insert(result.end(), {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()});
  return result;
}

bool are_same_bits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Calls `f(out)`, which must throw `Callers_exception{42}` and write nothing.
template <typename F>
void check_passes_through(const F& f)
{
  std::vector<Pair> result;
  try
  {
    f(std::back_inserter(result));
    CHECK(!"an exception came through");
  }
  catch (const Callers_exception& exception)
  {
    CHECK(exception.number == 42);
  }
  CHECK(result.empty());
}

template <typename ConcurrencyTag>
void test_input_is_unchanged()
{
  std::vector<Pair> pairs = oriented_cube(2000);
  pairs[3].first = Kernel::Point_3(-0., 0.5, 0.5);
  pairs[7].first = Kernel::Point_3(nan, -infinity, 0.5);
  pairs[9].second = Kernel::Vector_3(nan, infinity, -0.);
  const std::vector<double> before = numbers(pairs);
  std::vector<Pair> result;
  for (std::size_t m : {500, 5000})
    CGAL::l0_resample_point_set<ConcurrencyTag>(
      pairs, std::back_inserter(result),
      params::point_map(Point_map()).normal_map(Normal_map()).number_of_output_points(m)
        | params::drop_non_finite(true));
  CHECK(result.size() == 5500);
  CHECK_THROWS(CGAL::l0_resample_point_set<ConcurrencyTag>(pairs, std::back_inserter(result),
                                                           params::point_map(Point_map())),
               std::invalid_argument);
  CHECK(are_same_bits(before, numbers(pairs)));
}

template <typename ConcurrencyTag>
void test_property_maps_that_throw()
{
  const int few = 300, many = 200000; // which several threads read
  for (const auto& [size, accesses] :
       {std::pair(few, 0), {few, 1}, {few, few - 1}, {many, many / 2}, {many, many - 1}})
  {
    const std::vector<Pair> pairs = oriented_cube(std::size_t(size));
    std::atomic<int> left{accesses};
    check_passes_through([&](auto out) {
      CGAL::l0_resample_point_set<ConcurrencyTag>(
        pairs, out,
        params::point_map(Throwing_map<Kernel::Point_3, &Pair::first>{&left})
          .geom_traits(Kernel()));
    });
    left = accesses;
    check_passes_through([&](auto out) {
      CGAL::l0_resample_point_set<ConcurrencyTag>(
        pairs, out,
        params::point_map(Point_map())
          .normal_map(Throwing_map<Kernel::Vector_3, &Pair::second>{&left}));
    });
  }
}

/// In whatever stage and thread, and it is not called again.
template <typename ConcurrencyTag>
void test_callback_that_throws()
{
  const std::vector<Pair> pairs = oriented_cube(30000);
  for (int throwing_call : {1, 2, 5, 9})
  {
    std::atomic<int> calls{0};
    check_passes_through([&](auto out) {
      CGAL::l0_resample_point_set<ConcurrencyTag>(
        pairs, out, params::point_map(Point_map()).callback([&](double) -> bool {
          if (++calls >= throwing_call)
            throw Callers_exception{42};
          return true;
        }));
    });
    CHECK(calls == throwing_call);
  }
}

template <typename ConcurrencyTag>
void test_output_iterator_that_throws()
{
  const std::vector<Pair> pairs = oriented_cube(300);
  std::size_t written = 0;
  const auto write = [&](const Pair&) {
    if (written == 100)
      throw Callers_exception{42};
    ++written;
  };
  check_passes_through([&](auto) {
    CGAL::l0_resample_point_set<ConcurrencyTag>(pairs, boost::make_function_output_iterator(write),
                                                params::point_map(Point_map()));
  });
  CHECK(written == 100);
}

/// The returned iterator is behind the last pair, also where that is the first.
template <typename ConcurrencyTag>
void test_returned_iterator()
{
  const std::vector<Pair> pairs = oriented_cube(300);
  std::vector<Pair> result(150);
  const auto end = CGAL::l0_resample_point_set<ConcurrencyTag>(pairs, result.begin(),
                                                               params::point_map(Point_map()));
  CHECK(end == result.end());
  const std::vector<Pair> nothing;
  CHECK(CGAL::l0_resample_point_set<ConcurrencyTag>(nothing, result.begin(),
                                                    params::point_map(Point_map()))
        == result.begin());
}

/// Normals of no use are replaced by PCA's, for those points alone; the length of the others does
/// not matter.
template <typename ConcurrencyTag>
void test_given_normals_of_no_use()
{
  const std::vector<Pair> pairs = oriented_cube(2000);
  const auto resampled = [](const std::vector<Pair>& input, const auto& np) {
    test::Pairs<Kernel> result;
    CGAL::l0_resample_point_set<ConcurrencyTag>(input, std::back_inserter(result), np);
    return result;
  };
  const auto with_normals = params::point_map(Point_map()).normal_map(Normal_map());
  const test::Pairs<Kernel> by_pca = resampled(pairs, params::point_map(Point_map()));
  for (const Vector& useless : {Vector(0, 0, 0), Vector(-0., 0, 0), Vector(nan, 0, 0),
                                Vector(0, infinity, 0), Vector(1, 1, -infinity)})
  {
    std::vector<Pair> input = pairs;
    for (Pair& pair : input)
      pair.second = Kernel::Vector_3(useless[0], useless[1], useless[2]);
    CHECK(test::are_identical<Kernel>(resampled(input, with_normals), by_pca));
  }
  const test::Pairs<Kernel> by_given = resampled(pairs, with_normals);
  CHECK(!test::are_identical<Kernel>(by_given, by_pca));
  for (int exponent : {-1000, 1020})
  {
    std::vector<Pair> input = pairs;
    for (Pair& pair : input)
      pair.second = Kernel::Vector_3(std::ldexp(pair.second.x(), exponent),
                                     std::ldexp(pair.second.y(), exponent),
                                     std::ldexp(pair.second.z(), exponent));
    CHECK(test::are_identical<Kernel>(resampled(input, with_normals), by_given));
  }
}

template <typename ConcurrencyTag>
void test_all()
{
  test_input_is_unchanged<ConcurrencyTag>();
  test_property_maps_that_throw<ConcurrencyTag>();
  test_callback_that_throws<ConcurrencyTag>();
  test_output_iterator_that_throws<ConcurrencyTag>();
  test_returned_iterator<ConcurrencyTag>();
  test_given_normals_of_no_use<ConcurrencyTag>();
}

} // namespace

int main()
{
  test_all<CGAL::Sequential_tag>();
  test_all<CGAL::Parallel_if_available_tag>();
  return test::result();
}
