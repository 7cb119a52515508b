// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The same calls compile with CGAL's WLOP and EAR and with this package in their place: ranges,
// property maps, output iterators and named parameters.

#include "promise_support.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/edge_aware_upsample_point_set.h>
#include <CGAL/property_map.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Pair = std::pair<Point, Vector>;
using Tuple = std::tuple<Point, Vector, int>;
using Row = std::array<double, 6>; // a point and its normal
using Point_of_pair = CGAL::First_of_pair_property_map<Pair>;
using Normal_of_pair = CGAL::Second_of_pair_property_map<Pair>;
using Point_of_tuple = CGAL::Nth_of_tuple_property_map<0, Tuple>;
using Normal_of_tuple = CGAL::Nth_of_tuple_property_map<1, Tuple>;
namespace params = CGAL::parameters;

/// What users write for types of their own.
template <typename Value, std::size_t first>
struct Map_of_row
{
  using key_type = Row;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;
  friend Value get(const Map_of_row&, const Row& row)
  {
    return Value(row[first], row[first + 1], row[first + 2]);
  }
};
using Point_of_row = Map_of_row<Point, 0>;
using Normal_of_row = Map_of_row<Vector, 3>;

struct Wlop
{
  template <typename... Arguments>
  static auto call(Arguments&&... arguments)
  {
    return CGAL::wlop_simplify_and_regularize_point_set<CGAL::Sequential_tag>(
      std::forward<Arguments>(arguments)...);
  }
};

struct Ear
{
  template <typename... Arguments>
  static auto call(Arguments&&... arguments)
  {
    return CGAL::edge_aware_upsample_point_set<CGAL::Sequential_tag>(
      std::forward<Arguments>(arguments)...);
  }
};

struct L0
{
  template <typename... Arguments>
  static auto call(Arguments&&... arguments)
  {
    return CGAL::l0_resample_point_set<CGAL::Sequential_tag>(std::forward<Arguments>(arguments)...);
  }
};

/// A noisy cube with normals, which EAR needs, in each form that users have.
struct Input
{
  std::vector<Point> points;
  std::vector<Pair> pairs;
  std::vector<Tuple> tuples;
  std::vector<Row> rows;
  CGAL::Point_set_3<Point> point_set{true};

  explicit Input(std::size_t n)
  {
    for (const test::Vector& p : test::noisy_cube(n))
    {
      const Point point(p[0], p[1], p[2]);
      const Vector normal = unit(point - Point(0.5, 0.5, 0.5));
      points.push_back(point);
      pairs.emplace_back(point, normal);
      tuples.emplace_back(point, normal, int(points.size()));
      rows.push_back({point.x(), point.y(), point.z(), normal.x(), normal.y(), normal.z()});
      point_set.insert(point, normal);
    }
  }

  static Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }
};

/// The results of calls of WLOP, in their order.
template <typename Function>
std::vector<std::vector<Point>> results_of_wlop_calls(std::size_t n)
{
  Input input(n);
  std::vector<std::vector<Point>> results(9);

  Function::call(input.points, std::back_inserter(results[0]));
  Function::call(input.points, std::back_inserter(results[1]),
                 params::select_percentage(50)
                   .neighbor_radius(0.3)
                   .number_of_iterations(2)
                   .require_uniform_sampling(true));
  results[2].resize(n / 2);
  const auto end =
    Function::call(input.points, results[2].begin(),
                   params::select_percentage(50).callback([](double) { return true; }));
  if constexpr (std::is_same<Function, L0>::value) // WLOP returns the iterator that it was given
    CHECK(end == results[2].end());
  Function::call(input.pairs, std::back_inserter(results[3]),
                 params::select_percentage(50).point_map(Point_of_pair()));
  Function::call(input.tuples, std::back_inserter(results[4]),
                 params::select_percentage(50).point_map(Point_of_tuple()).geom_traits(Kernel()));
  Function::call(input.rows, std::back_inserter(results[5]),
                 params::select_percentage(50).point_map(Point_of_row()));
  Function::call(input.points, boost::make_function_output_iterator([&](const Point& point) {
                   results[6].push_back(point);
                 }),
                 params::select_percentage(50));

  CGAL::Point_set_3<Point> simplified;
  Function::call(input.point_set, simplified.point_back_inserter(), params::select_percentage(50));
  results[7].assign(simplified.points().begin(), simplified.points().end());
  Function::call(input.point_set, std::back_inserter(results[8]),
                 input.point_set.parameters().select_percentage(50));
  return results;
}

/// The results of calls of EAR, in their order.
template <typename Function>
std::vector<std::vector<Pair>> results_of_ear_calls(std::size_t n)
{
  Input input(n);
  const std::size_t m = n + 20;
  std::vector<std::vector<Pair>> results(6);

  const auto of_pairs = params::point_map(Point_of_pair()).normal_map(Normal_of_pair());
  Function::call(
    input.pairs, std::back_inserter(results[0]),
    of_pairs.sharpness_angle(25).edge_sensitivity(0).neighbor_radius(0.3).number_of_output_points(
      m));
  Function::call(input.tuples, std::back_inserter(results[1]),
                 params::point_map(Point_of_tuple())
                   .normal_map(Normal_of_tuple())
                   .neighbor_radius(0.3)
                   .number_of_output_points(m));
  Function::call(input.rows, std::back_inserter(results[2]),
                 params::point_map(Point_of_row())
                   .normal_map(Normal_of_row())
                   .neighbor_radius(0.3)
                   .number_of_output_points(m));
  Function::call(input.point_set, std::back_inserter(results[3]),
                 input.point_set.parameters().neighbor_radius(0.3).number_of_output_points(m));
  Function::call(input.pairs, boost::make_function_output_iterator([&](const Pair& pair) {
                   results[4].push_back(pair);
                 }),
                 of_pairs.neighbor_radius(0.3).number_of_output_points(m));
  // into the container of the input
  Function::call(input.pairs, std::back_inserter(input.pairs),
                 of_pairs.neighbor_radius(0.3).number_of_output_points(m));
  results[5].assign(input.pairs.begin() + std::ptrdiff_t(n), input.pairs.end());
  return results;
}

void test_calls_of_wlop()
{
  for (const std::vector<Point>& result : results_of_wlop_calls<Wlop>(60))
    CHECK(!result.empty());

  const std::vector<std::vector<Point>> results = results_of_wlop_calls<L0>(600);
  test::Pairs<Kernel> pairs;
  L0::call(Input(600).points, std::back_inserter(pairs));
  std::vector<Point> expected;
  for (const Pair& pair : pairs)
    expected.push_back(pair.first);
  CHECK(expected.size() == 300);
  for (std::size_t i = 0; i + 1 < results.size(); ++i)
    CHECK((results[i] == expected) == (i != 1)); // that has another radius
  CHECK(results[1].size() == 300);
  // `Point_set_3::parameters()` has the normals too
  CHECK(results.back().size() == 300 && results.back() != expected);
}

void test_calls_of_ear()
{
  for (const std::vector<Pair>& result : results_of_ear_calls<Ear>(60))
    CHECK(!result.empty());

  const std::vector<std::vector<Pair>> results = results_of_ear_calls<L0>(600);
  for (std::size_t i = 0; i < results.size(); ++i)
    CHECK(results[i].size() == 620);
  for (std::size_t i = 2; i < results.size(); ++i)
    CHECK(test::are_identical<Kernel>(results[i], results[1]));
  CHECK(!test::are_identical<Kernel>(results[0], results[1])); // another sharpness_angle
}

/// Pairs are preferred by iterators that take both; positions can be
/// printed.
void test_other_iterators()
{
  const Input input(600);
  std::vector<std::tuple<Point, Vector>> tuples;
  L0::call(input.points, std::back_inserter(tuples));
  CHECK(tuples.size() == 300 && std::get<1>(tuples[0]) != CGAL::NULL_VECTOR);

  std::ostringstream text;
  L0::call(input.points, std::ostream_iterator<Point>(text, "\n"),
           params::number_of_output_points(10));
  std::istringstream lines(text.str());
  std::size_t number_of_lines = 0;
  for (Point point; lines >> point;)
    ++number_of_lines;
  CHECK(number_of_lines == 10);
}

} // namespace

int main()
{
  test_calls_of_wlop();
  test_calls_of_ear();
  test_other_iterators();
  return test::result();
}
