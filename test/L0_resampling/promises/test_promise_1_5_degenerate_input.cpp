// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promises 1 and 5: degenerate and extreme input gives a clean result. What is refused is in
// test_promise_3_refusals.cpp.

#include "promise_support.h"

#include <array>
#include <iostream>
#include <set>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using CGAL::L0_resampling::Method;
using test::Generator;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

template <typename NamedParameters>
test::Resampled<Kernel> resample(const Points& points, const NamedParameters& np)
{
  return test::resample<Kernel, CGAL::Parallel_if_available_tag>(points, np);
}

std::vector<Vector> scaled(const std::vector<Vector>& points, double scale)
{
  std::vector<Vector> result;
  for (const Vector& p : points)
    result.push_back(scale * p);
  return result;
}

std::vector<Vector> moved(const std::vector<Vector>& points, const Vector& translation)
{
  std::vector<Vector> result;
  for (const Vector& p : points)
    result.push_back(p + translation);
  return result;
}

std::vector<Vector> joined(std::vector<Vector> a, const std::vector<Vector>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Case
{
  std::string name;
  std::vector<Vector> points;
};

std::vector<Case> cases()
{
  Generator generator(1);
  const std::vector<Vector> sphere = test::sphere_points(300, 1, generator).points;
  const std::vector<Vector> plane = test::plane_points(300, 1, generator).points;
  std::vector<Vector> oblique_line, axis_line;
  for (int i = 0; i < 200; ++i)
  {
    oblique_line.push_back(test::random_number(-1, 1, generator) * Vector(1, 2, 3));
    axis_line.push_back(double(i) * Vector::UnitX());
  }
  return {
    {"one point", {Vector(1, 2, 3)}},
    {"the origin", {Vector(0, 0, 0)}},
    {"two points", {Vector(1, 2, 3), Vector(1, 2, 4)}},
    {"two equal points", {Vector(1, 2, 3), Vector(1, 2, 3)}},
    {"three points", {Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)}},
    {"all equal", std::vector<Vector>(300, Vector(1, 2, 3))},
    {"oblique line", oblique_line},
    {"line along an axis", axis_line},
    {"plane along the axes", plane},
    {"plane at z = 1e-3", moved(plane, Vector(0, 0, 1e-3))},
    {"lattice", test::lattice_points(7, 0.1)},
    {"each point three times", joined(sphere, joined(sphere, sphere))},
    {"two clusters", joined(sphere, moved(sphere, Vector(1e4, 0, 0)))},
    {"two clusters of duplicates",
     joined(std::vector<Vector>(50, Vector(0, 0, 0)), std::vector<Vector>(50, Vector(1, 1, 1)))},
    {"UTM", moved(sphere, Vector(256075.1, 3935300.5, 120))},
    {"1e7", moved(sphere, Vector(1e7, -1e7, 1e7))},
    {"scale 1e-12", scaled(sphere, 1e-12)},
    {"scale 1e12", scaled(sphere, 1e12)},
    {"scale 1e-300", scaled(sphere, 1e-300)},
    {"scale 1e300", scaled(sphere, 1e300)},
    {"scale 1.7e308", scaled(sphere, 1.7e308)},
    {"denormal numbers", scaled(sphere, 1e-315)},
    {"a few least denormal numbers", scaled(sphere, 1e-322)},
    {"outlier at 1e9", joined(sphere, {Vector(1e9, 1e9, 1e9)})},
    {"outlier at 1e300", joined(sphere, {Vector(1e300, 0, -1e300)})},
    {"outlier at 1.7e308 and denormal numbers",
     joined(scaled(sphere, 1e-315), {Vector(1.7e308, -1.7e308, 0)})},
  };
}

void test_counts()
{
  for (const Case& c : cases())
  {
    const Points points = test::kernel_points<Kernel>(c.points);
    const std::size_t n = points.size();
    test::check_clean<Kernel>(c.name, points, resample(points, params::default_values()),
                              (std::max)(n / 2, std::size_t(1)));
    for (std::size_t m : {std::size_t(0), std::size_t(1), n, n + 1, 2 * n, 10 * n})
      test::check_clean<Kernel>(c.name + ", " + std::to_string(m), points,
                                resample(points, params::number_of_output_points(m)), m);
    for (Method method : {Method::LOR, Method::ALOR})
      for (std::size_t m : {(n + 1) / 2, 3 * n})
        test::check_clean<Kernel>(c.name + ", the paper's method, " + std::to_string(m), points,
                                  resample(points, params::number_of_output_points(m)
                                                     | params::resampling_method(method)),
                                  m);
  }
}

/// Clouds of as many points that crowd in one way or another.
std::vector<Case> crowds(std::size_t n)
{
  Generator generator(3);
  const std::vector<Vector> cube = test::noisy_cube(n);
  const auto with_crowd = [&](std::size_t size, const auto& place) {
    std::vector<Vector> points = cube;
    for (std::size_t i = 0; i < size; ++i)
      points[i] = place(i);
    return points;
  };
  const auto scattered = [&](double extent) -> Vector {
    return Vector(1, 0.4, 0.5) + extent * test::random_unit_vector(generator);
  };
  return {
    {"all at one place", std::vector<Vector>(n, Vector(1, 2, 3))},
    {"half at one place", with_crowd(n / 2, [](std::size_t) { return Vector(1, 0.4, 0.5); })},
    {"half within 1e-9", with_crowd(n / 2, [&](std::size_t) { return scattered(1e-9); })},
    {"all but 100 in a cell", with_crowd(n - 100, [&](std::size_t) { return scattered(1e-3); })},
    {"half in ten places",
     with_crowd(n / 2, [&](std::size_t i) -> Vector { return cube[n - 1 - i % 10]; })},
  };
}

/// However points crowd, no array is much longer than it is for an even cloud of as many points.
void test_memory_of_crowds()
{
  const std::size_t n = 20000;
  for (Method method : {Method::DEFAULT, Method::LOR})
  {
    const auto resample_points = [&](const std::vector<Vector>& points) {
      return resample(test::kernel_points<Kernel>(points),
                      params::number_of_output_points(n / 2) | params::resampling_method(method));
    };
    const std::size_t of_even_cloud = resample_points(test::noisy_cube(n)).report.peak_bytes;
    for (const Case& c : crowds(n))
    {
      const auto result = resample_points(c.points);
      std::set<std::array<double, 3>> distinct;
      for (const Vector& p : c.points)
        distinct.insert({p[0], p[1], p[2]});
      std::cout << c.name << ": " << double(result.report.peak_bytes) / double(of_even_cloud)
                << " times the memory of an even cloud" << std::endl;
      CHECK(result.pairs.size() == n / 2);
      CHECK(result.report.peak_bytes <= 2 * of_even_cloud);
      if (result.report.number_of_outliers == 0)
        CHECK(result.report.number_of_distinct_points == distinct.size());
    }
    // all neighborhoods are one place: the report counts the points, not those that stand for them
    const auto one_place = resample_points(std::vector<Vector>(n, Vector(1, 2, 3)));
    CHECK(one_place.report.number_of_degenerate_neighborhoods == n);
    // a point that everything has to start from
    const auto result = resample(Points{Kernel::Point_3(1, 2, 3)},
                                 params::number_of_output_points(n)
                                   | params::resampling_method(method));
    CHECK(result.pairs.size() == n && result.report.peak_bytes <= 2 * of_even_cloud);
    CHECK(result.report.number_of_self_neighbor_pairs < n);
  }
}

/// Two points with no number between them. There is no room for more, so no more are asked for.
void test_points_next_to_each_other()
{
  const Points points{Kernel::Point_3(1, 1, 1),
                      Kernel::Point_3(1, 1, 1 + std::numeric_limits<double>::epsilon())};
  for (std::size_t m : {1, 2})
    for (double radius : {1e-300, 1e-16, 1e300})
      test::check_clean<Kernel>(
        "next to each other", points,
        resample(points, params::neighbor_radius(radius).number_of_output_points(m)), m);
}

void test_percentages()
{
  Generator generator(2);
  const Points points = test::kernel_points<Kernel>(test::sphere_points(250, 1, generator).points);
  test::check_clean<Kernel>("1e-300 %", points, resample(points, params::select_percentage(1e-300)),
                            1);
  test::check_clean<Kernel>("0.5 %", points, resample(points, params::select_percentage(0.5)), 1);
  test::check_clean<Kernel>("33 %", points, resample(points, params::select_percentage(33)), 82);
  test::check_clean<Kernel>("100 %", points, resample(points, params::select_percentage(100)), 250);
}

/// Radii that reach nobody and everybody, alone and together.
void test_radii()
{
  for (const Case& c : cases())
  {
    const Points points = test::kernel_points<Kernel>(c.points);
    const std::size_t n = points.size();
    for (double radius : {1e-300, 1e300, std::numeric_limits<double>::denorm_min(),
                          (std::numeric_limits<double>::max)()})
      for (std::size_t m : {(n + 1) / 2, 2 * n})
        for (Method method : {Method::DEFAULT, Method::LOR})
        {
          const std::string name =
            c.name + (radius < 1 ? ", radius of nobody, " : ", radius of everybody, ")
            + std::to_string(m);
          test::check_clean<Kernel>(
            name, points,
            resample(points, params::neighbor_radius(radius).number_of_output_points(m)
                               | params::resampling_method(method)),
            m);
        }
  }
}

/// A sample that sees nobody stays where it started, which is on an input point.
void test_radius_that_reaches_nobody()
{
  Generator generator(3);
  for (double scale : {1e-300, 1., 1e300})
  {
    const Points points = test::kernel_points<Kernel>(
      scaled(test::sphere_points(300, 1, generator).points, scale));
    for (double radius : {1e-12 * scale, 1e-5 * scale, std::numeric_limits<double>::denorm_min()})
      for (Method method : {Method::DEFAULT, Method::LOR})
      {
        std::size_t on_input = 0;
        const test::Resampled<Kernel> result =
          resample(points, params::neighbor_radius(radius) | params::resampling_method(method));
        for (const auto& [p, n] : result.pairs)
          on_input +=
            std::any_of(points.begin(), points.end(), [&, &point = p](const Kernel::Point_3& q) {
              return (test::as_vector(point) / scale - test::as_vector(q) / scale).norm() < 1e-12;
            });
        if (!CHECK(on_input == 150))
          std::cerr << "  scale " << scale << ", radius " << radius << ", method " << int(method)
                    << ": " << on_input << std::endl;
      }
  }
}

/// However small the neighborhoods and large the filter.
void test_filter_radius_far_above_neighbor_radius()
{
  Generator generator(4);
  const Points points = test::kernel_points<Kernel>(test::sphere_points(300, 1, generator).points);
  for (double radius : {1e-300, 1e-12, 1e-6, 1e-3})
    test::check_clean<Kernel>(
      "filter radius 1e300", points,
      resample(points, params::neighbor_radius(radius) | params::normal_filter_radius(1e300)), 150);
  test::check_clean<Kernel>("filter radius 1e-300", points,
                            resample(points, params::normal_filter_radius(1e-300)), 150);
}

double mean_distance_to_unit_sphere(const test::Pairs<Kernel>& pairs, const Vector& center,
                                    double scale)
{
  double sum = 0;
  for (const auto& [p, n] : pairs)
    sum += (std::min)(1., std::abs(((test::as_vector(p) - center) / scale).norm() - 1));
  return sum / double(pairs.size());
}

/// A scale, a place or an outlier does not make the rest worse than it is without.
void test_sphere_stays_a_sphere()
{
  Generator generator(5);
  std::vector<Vector> sphere = test::sphere_points(3000, 1, generator).points;
  test::add_gaussian_noise(sphere, 0.01, generator);
  const auto distance = [](const std::vector<Vector>& vectors, const Vector& center, double scale) {
    const test::Resampled<Kernel> result = resample(test::kernel_points<Kernel>(vectors),
                                                    params::default_values());
    return mean_distance_to_unit_sphere(result.pairs, center, scale);
  };
  const double bound = 1.05 * distance(sphere, Vector::Zero(), 1);
  for (double scale : {1e-12, 1e12, 1e-300, 1e300})
    CHECK(distance(scaled(sphere, scale), Vector::Zero(), scale) < bound);
  CHECK(distance(scaled(sphere, 1e-310), Vector::Zero(), 1e-310) < bound);
  const Vector utm(256075.1, 3935300.5, 120);
  CHECK(distance(moved(sphere, utm), utm, 1) < bound);
  for (double place : {1e3, 1e9, 1e15})
    CHECK(distance(joined(sphere, {place * Vector(1, 1, 1)}), Vector::Zero(), 1)
          < bound + 1. / 1500);
}

/// Twenty thousand points in one cell of the search grid: neighborhoods are thinned, not quadratic.
void test_crowded_cell()
{
  Generator generator(6);
  std::vector<Vector> crowd;
  for (int i = 0; i < 20000; ++i)
    crowd.push_back(Vector(0.5, 0.5, 0.5) + 1e-4 * test::random_unit_vector(generator));
  const Points points = test::kernel_points<Kernel>(
    joined(crowd, test::sphere_points(500, 1, generator).points));
  test::check_clean<Kernel>("crowd", points, resample(points, params::neighbor_radius(0.2)), 10250);
  test::check_clean<Kernel>("crowd, default radius", points,
                            resample(points, params::default_values()), 10250);
}

} // namespace

int main()
{
  test_counts();
  test_memory_of_crowds();
  test_points_next_to_each_other();
  test_percentages();
  test_radii();
  test_radius_that_reaches_nobody();
  test_filter_radius_far_above_neighbor_radius();
  test_sphere_stays_a_sphere();
  test_crowded_cell();
  return test::result();
}
