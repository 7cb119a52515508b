// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The ways to call the function: kernels, containers, property maps, and both forms of named
// parameters.

#include "promise_support.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <list>
#include <tuple>
#include <vector>

using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;
using CGAL::Sequential_tag;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

std::vector<Vector> noisy_cube(std::size_t n)
{
  std::vector<Vector> points = test::noisy_cube(n);
  for (Vector& p : points) // to what a float holds: the same cloud in every kernel
    p = test::as_vector(
      CGAL::Simple_cartesian<float>::Point_3(float(p[0]), float(p[1]), float(p[2])));
  return points;
}

/// The largest distance between points of the same place in the sequence.
template <typename A, typename B>
double distance(const A& a, const B& b)
{
  double largest = a.size() == b.size() && !a.empty() ? 0 : 1e9;
  for (std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i)
    largest = (std::max)(largest,
                         (test::as_vector(a[i].first) - test::as_vector(b[i].first)).norm());
  return largest;
}

/// All kernels give the same result, up to the rounding of their numbers.
template <typename Kernel>
void test_kernel(double rounding)
{
  const auto expected = test::resample<CGAL::Simple_cartesian<double>, Sequential_tag>(
    test::kernel_points<CGAL::Simple_cartesian<double>>(noisy_cube(2000)),
    params::default_values());
  const auto points = test::kernel_points<Kernel>(noisy_cube(2000));
  const auto result = test::resample<Kernel, Sequential_tag>(points, params::default_values());
  test::check_clean<Kernel>("kernel", points, result, 1000);
  if (!CHECK(distance(result.pairs, expected.pairs) <= rounding))
    std::cerr << "  " << distance(result.pairs, expected.pairs) << " instead of " << rounding
              << std::endl;
  const auto more = test::resample<Kernel, CGAL::Parallel_if_available_tag>(
    points, params::number_of_output_points(5000));
  test::check_clean<Kernel>("more points than the input", points, more, 5000);
}

template <typename Kernel>
void test_containers_and_maps()
{
  using Point = typename Kernel::Point_3;
  using Normal = typename Kernel::Vector_3;
  const std::vector<Point> points = test::kernel_points<Kernel>(noisy_cube(1500));
  const std::size_t n = points.size();
  const auto expected =
    test::resample<Kernel, Sequential_tag>(points, params::default_values()).pairs;
  const auto check = [&](const auto& range, const auto& np) {
    test::Pairs<Kernel> result;
    CGAL::l0_resample_point_set<Sequential_tag>(range, std::back_inserter(result), np);
    CHECK(test::are_identical<Kernel>(result, expected));
  };

  check(std::list<Point>(points.begin(), points.end()), params::default_values());
  std::vector<std::pair<Point, Normal>> pairs;
  std::vector<std::tuple<int, Point>> tuples;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < n; ++i)
  {
    pairs.emplace_back(points[i], Normal(0, 0, 0));
    tuples.emplace_back(int(i), points[i]);
    indices.push_back(i);
  }
  using Pair_map = CGAL::First_of_pair_property_map<std::pair<Point, Normal>>;
  check(pairs, params::point_map(Pair_map()));
  check(pairs, params::point_map(Pair_map())
                 .normal_map(CGAL::Second_of_pair_property_map<std::pair<Point, Normal>>()));
  check(tuples, params::point_map(CGAL::Nth_of_tuple_property_map<1, std::tuple<int, Point>>())
                  .geom_traits(Kernel()));
  check(indices, params::point_map(CGAL::make_property_map(points)));

  CGAL::Surface_mesh<Point> mesh;
  for (const Point& p : points)
    mesh.add_vertex(p);
  check(mesh.vertices(), params::point_map(mesh.points()));

  CGAL::Point_set_3<Point> point_set, result;
  for (const Point& p : points)
    point_set.insert(p);
  check(point_set, params::point_map(point_set.point_map()));
  result.insert(Point(9, 9, 9));
  CGAL::l0_resample_point_set<Sequential_tag>(point_set, result);
  CHECK(point_set.size() == n && !point_set.has_normal_map());
  CHECK(result.has_normal_map() && result.size() == 1 + expected.size());
  for (std::size_t i = 0; i < expected.size() && i + 1 < result.size(); ++i)
    CHECK(result.point(i + 1) == expected[i].first && result.normal(i + 1) == expected[i].second);

  // given normals count only if they are passed
  point_set.add_normal_map(Normal(1, 0, 0));
  CGAL::Point_set_3<Point> without, with;
  Report report;
  CGAL::l0_resample_point_set<Sequential_tag>(point_set, without,
                                              params::resampling_report(&report));
  CGAL::l0_resample_point_set<Sequential_tag>(point_set, with,
                                              params::normal_map(point_set.normal_map()));
  CHECK(report.number_of_output_points == expected.size() && without.size() == expected.size()
        && with.size() == expected.size());
  CHECK(without.point(0) == expected[0].first);
  bool differ = false;
  for (std::size_t i = 0; i < with.size() && i < without.size(); ++i)
    differ = differ || with.point(i) != without.point(i);
  CHECK(differ);
}

void test_named_parameter_chains()
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const auto points = test::kernel_points<Kernel>(noisy_cube(1000));
  const auto result = [&](const auto& np) {
    test::Pairs<Kernel> pairs;
    CGAL::l0_resample_point_set<Sequential_tag>(points, std::back_inserter(pairs), np);
    return pairs;
  };
  const auto a = result(params::normal_weight(0.5)
                          .neighbor_radius(0.2)
                          .resampling_method(Method::LOR)
                          .select_percentage(30));
  CHECK(a.size() == 300);
  CHECK(test::are_identical<Kernel>(a, result(params::neighbor_radius(0.2).select_percentage(30)
                                              | params::normal_weight(0.5)
                                              | params::resampling_method(Method::LOR))));
  CHECK(test::are_identical<Kernel>(
    a, result((params::select_percentage(30) | params::normal_weight(0.5))
                .neighbor_radius(0.2)
                .resampling_method(Method::LOR))));
  // each one matters: a name that were read from the wrong place would not be seen
  const auto plain = params::resampling_method(Method::LOR);
  const auto b = result(plain);
  const auto differs = [&](const auto& np) { return !test::are_identical<Kernel>(b, result(np)); };
  CHECK(differs(plain.neighbor_radius(0.15)));
  CHECK(differs(plain.normal_filter_radius(0.15)));
  CHECK(differs(plain.sharpness_angle(30)));
  CHECK(differs(plain.number_of_normal_filter_iterations(1)));
  CHECK(differs(plain.normal_weight(0.1)));
  CHECK(differs(plain.regularization_weight(0.5)));
  CHECK(differs(plain.initial_penalty(0.5)));
  CHECK(differs(plain.maximum_penalty(5)));
  CHECK(differs(plain.penalty_growth(2)));
  CHECK(differs(plain.random_seed(1)));
  CHECK(differs(plain.select_percentage(49)));
  CHECK(differs(plain.number_of_output_points(501)));
  CHECK(differs(params::resampling_method(Method::ALOR)));
  CHECK(differs(params::resampling_method(Method::DEFAULT)));
  // defaults are what the documentation says
  CHECK(!differs(plain.sharpness_angle(15)
                   .number_of_normal_filter_iterations(3)
                   .normal_weight(0.9)
                   .regularization_weight(0.15)
                   .initial_penalty(0.1)
                   .maximum_penalty(2)
                   .penalty_growth(1.5)
                   .random_seed(0)
                   .select_percentage(50)
                   .number_of_orientation_neighbors(12)));
}

} // namespace

int main()
{
  test_kernel<CGAL::Simple_cartesian<double>>(0);
  test_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(0);
  test_kernel<CGAL::Simple_cartesian<float>>(1e-6);
  test_containers_and_maps<CGAL::Simple_cartesian<double>>();
  test_containers_and_maps<CGAL::Simple_cartesian<float>>();
  test_containers_and_maps<CGAL::Exact_predicates_inexact_constructions_kernel>();
  test_named_parameter_chains();
  return test::result();
}
