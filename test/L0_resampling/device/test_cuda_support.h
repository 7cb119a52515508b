// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_CUDA_SUPPORT_H
#define CGAL_L0_RESAMPLING_TEST_CUDA_SUPPORT_H

#include "test_support.h"

#include <CGAL/L0_resampling/CUDA_resampler.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace test_cuda {

using CGAL::L0_resampling::Report;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Normal = Kernel::Vector_3;
using Points = std::vector<Point>;
using Result = std::vector<std::pair<Point, Normal>>;

/// What `main()` returns without a device: CTest counts the test as skipped.
constexpr int number_of_skip = 77;

inline bool has_device()
{
  std::string reason;
  if (CGAL::L0_resampling::is_cuda_device_usable(&reason))
    return true;
  std::cout << "skipped: " << reason << std::endl;
  return false;
}

/// Of each point of `a` the one of `b` that it is compared with: the one of its own place, unless
/// that is further than a thousandth of a radius away. Then the order differs, as where a rounding
/// puts a sample into the next cell, or the point: the nearest.
inline std::vector<std::size_t> counterparts(const Result& a, const Result& b, double radius)
{
  std::vector<std::size_t> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    result[i] = i;
    double least = CGAL::squared_distance(a[i].first, b[i].first);
    if (least <= 1e-6 * radius * radius)
      continue;
    for (std::size_t k = 0; k < b.size(); ++k)
    {
      const double distance = CGAL::squared_distance(a[i].first, b[k].first);
      if (distance < least)
      {
        least = distance;
        result[i] = k;
      }
    }
  }
  return result;
}

inline Points noisy_cube(std::size_t n, double noise, unsigned seed)
{
  test::Generator generator(seed);
  std::normal_distribution<double> gauss(0, noise);
  Points points;
  for (std::size_t i = 0; i < n; ++i)
  {
    test::Vector p = test::random_vector(1, generator);
    p[Eigen::Index(i % 3)] = i % 2 ? 1 : -1;
    for (Eigen::Index c = 0; c < 3; ++c)
      p[c] += gauss(generator);
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

inline Points noisy_sphere(std::size_t n, double noise, unsigned seed)
{
  test::Generator generator(seed);
  std::normal_distribution<double> gauss(0, noise);
  Points points;
  for (std::size_t i = 0; i < n; ++i)
  {
    const test::Vector p = (1 + gauss(generator)) * test::random_unit_vector(generator);
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

/// Radii 1 and 0.4.
inline Points noisy_torus(std::size_t n, double noise, unsigned seed)
{
  test::Generator generator(seed);
  std::normal_distribution<double> gauss(0, noise);
  Points points;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double u = test::random_number(0, 2 * CGAL_PI, generator),
                 v = test::random_number(0, 2 * CGAL_PI, generator),
                 tube_radius = 0.4 + gauss(generator), from_axis = 1 + tube_radius * std::cos(v);
    points.emplace_back(from_axis * std::cos(u), from_axis * std::sin(u),
                        tube_radius * std::sin(v));
  }
  return points;
}

inline Points moved(Points points, const Normal& translation)
{
  for (Point& p : points)
    p = p + translation;
  return points;
}

/// Every point twice.
inline Points duplicated(Points points)
{
  const Points copy(points);
  points.insert(points.end(), copy.begin(), copy.end());
  return points;
}

/// With outliers: 5 % of the points uniform in a box around them, and a cluster of a few that is
/// off by half the box.
inline Points with_outliers(Points points, unsigned seed)
{
  test::Generator generator(seed);
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const auto random_point = [&](double low, double high) {
    const auto coordinate = [&](int axis) {
      const double size = (box.max)(axis) - (box.min)(axis);
      return (box.min)(axis) + test::random_number(low, high, generator) * size;
    };
    return Point(coordinate(0), coordinate(1), coordinate(2));
  };
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n / 20; ++i)
    points.push_back(random_point(-0.2, 1.2));
  for (std::size_t i = 0; i < 12; ++i)
    points.push_back(random_point(1.49, 1.5));
  return points;
}

/// With `size` outliers in a box around the origin that reaches `half_side` along each axis.
inline Points with_crowd(Points points, std::size_t size, double half_side, unsigned seed)
{
  test::Generator generator(seed);
  const auto coordinate = [&] { return test::random_number(-half_side, half_side, generator); };
  for (std::size_t i = 0; i < size; ++i)
  {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  return points;
}

/// With `size` points more that almost coincide with the first.
inline Points with_crowd_in_one_place(Points points, std::size_t size, unsigned seed)
{
  const Point place = points.front();
  for (const Point& p : with_crowd({}, size, 1e-9, seed))
    points.push_back(place + (p - Point(0, 0, 0)));
  return points;
}

/// Of a sphere, ten times as dense at one pole as at the other.
inline Points graded_sphere(std::size_t n, double noise, unsigned seed)
{
  test::Generator generator(seed);
  Points points;
  for (const Point& p : noisy_sphere(8 * n, noise, seed + 1))
    if (points.size() < n && test::random_number(0, 1, generator) < 0.1 + 0.45 * (1 + p.x()))
      points.push_back(p);
  return points;
}

/// Of a sphere, 300 times as dense at one pole as at the other, as a scan near and far is.
inline Points steeply_graded_sphere(std::size_t n, double noise, unsigned seed)
{
  test::Generator generator(seed);
  Points points;
  for (const Point& p : noisy_sphere(8 * n, noise, seed + 1))
    if (points.size() < n && test::random_number(0, 1, generator) < std::pow(300, (p.x() - 1) / 2))
      points.push_back(p);
  return points;
}

/// Two sheets that are closer to each other than the radius of a ball.
inline Points noisy_plate(std::size_t n, double thickness, double noise, unsigned seed)
{
  test::Generator generator(seed);
  std::normal_distribution<double> gauss(0, noise > 0 ? noise : 1);
  Points points;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = test::random_number(-1, 1, generator),
                 y = test::random_number(-1, 1, generator);
    points.emplace_back(x, y,
                        (i % 2 ? 0.5 : -0.5) * thickness + (noise > 0 ? gauss(generator) : 0));
  }
  return points;
}

} // namespace test_cuda

#endif // CGAL_L0_RESAMPLING_TEST_CUDA_SUPPORT_H
