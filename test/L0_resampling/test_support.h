// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_SUPPORT_H
#define CGAL_L0_RESAMPLING_TEST_SUPPORT_H

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <random>
#include <vector>

/// Counts and reports an expression that is false, in release builds too. The test goes on;
/// `test::result()` remembers. A macro because the report shows the expression and its line.
#define CHECK(expression)                                                                          \
  ::test::check(static_cast<bool>(expression), #expression, __FILE__, __LINE__)

/// Checks that the expression throws an `Exception`, or a type derived from it.
#define CHECK_THROWS(expression, Exception)                                                        \
  ::test::check(::test::throws<Exception>([&]() { static_cast<void>(expression); }),               \
                #expression " throws " #Exception, __FILE__, __LINE__)

namespace test {

inline std::size_t& number_of_checks()
{
  static std::size_t count = 0;
  return count;
}

inline std::size_t& number_of_failures()
{
  static std::size_t count = 0;
  return count;
}

inline bool check(bool holds, const char* expression, const char* file, int line)
{
  constexpr std::size_t number_of_reports = 20;
  ++number_of_checks();
  if (!holds && ++number_of_failures() <= number_of_reports)
    std::cerr << file << ":" << line << ": failed: " << expression << std::endl;
  return holds;
}

template <typename Exception, typename F>
bool throws(const F& f)
{
  try
  {
    f();
  }
  catch (const Exception&)
  {
    return true;
  }
  return false;
}

/// What `main()` returns: 0 if something was checked and all of it held.
inline int result()
{
  std::cout << number_of_checks() << " checks, " << number_of_failures() << " failed" << std::endl;
  return number_of_checks() > 0 && number_of_failures() == 0 ? 0 : 1;
}

using Vector = Eigen::Vector3d;
using Generator = std::mt19937_64;

inline double random_number(double low, double high, Generator& generator)
{
  return std::uniform_real_distribution<double>(low, high)(generator);
}

/// In a box. Here and below, components are drawn one after the other and not as arguments of one
/// call, whose order is the compiler's own: so all compilers test the same.
inline Vector random_vector(const Vector& low, const Vector& high, Generator& generator)
{
  Vector v;
  for (Eigen::Index c = 0; c < 3; ++c)
    v[c] = random_number(low[c], high[c], generator);
  return v;
}

/// In the box around the origin with that corner.
inline Vector random_vector(const Vector& corner, Generator& generator)
{
  return random_vector(-corner, corner, generator);
}

/// In the cube [-half_side, half_side]^3.
inline Vector random_vector(double half_side, Generator& generator)
{
  return random_vector(Vector::Constant(half_side), generator);
}

/// Of independent components of mean 0.
inline Vector gaussian_vector(double deviation, Generator& generator)
{
  std::normal_distribution<double> normal(0, deviation);
  Vector v;
  for (Eigen::Index c = 0; c < 3; ++c)
    v[c] = normal(generator);
  return v;
}

inline Vector random_unit_vector(Generator& generator)
{
  Vector v;
  do
    v = gaussian_vector(1, generator);
  while (v.norm() < 1e-3);
  return v.normalized();
}

inline Eigen::Matrix3d random_rotation(Generator& generator)
{
  const Vector axis = random_unit_vector(generator);
  return Eigen::AngleAxisd(random_number(0, 2 * EIGEN_PI, generator), axis).toRotationMatrix();
}

/// Points with the true outward unit normals of the surface they are on.
struct Oriented_points
{
  std::vector<Vector> points;
  std::vector<Vector> normals;
};

/// On the sphere around the origin, uniform by area.
inline Oriented_points sphere_points(std::size_t n, double radius, Generator& generator)
{
  Oriented_points result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vector normal = random_unit_vector(generator);
    result.points.push_back(radius * normal);
    result.normals.push_back(normal);
  }
  return result;
}

/// On the surface of the cube [-side/2, side/2]^3, uniform by area: planes, sharp edges and
/// corners.
inline Oriented_points cube_points(std::size_t n, double side, Generator& generator)
{
  Oriented_points result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Eigen::Index axis = std::uniform_int_distribution<Eigen::Index>(0, 2)(generator);
    const double sign = std::bernoulli_distribution()(generator) ? 1 : -1;
    Vector p = random_vector(side / 2, generator);
    p[axis] = sign * side / 2;
    result.points.push_back(p);
    result.normals.push_back(sign * Vector::Unit(axis));
  }
  return result;
}

/// On the square [-side/2, side/2]^2 of the plane z = 0.
inline Oriented_points plane_points(std::size_t n, double side, Generator& generator)
{
  Oriented_points result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = random_number(-side / 2, side / 2, generator);
    result.points.emplace_back(x, random_number(-side / 2, side / 2, generator), 0);
    result.normals.push_back(Vector::UnitZ());
  }
  return result;
}

/// The k^3 points with coordinates 0, ..., k-1 times `spacing`: every distance is there many times.
inline std::vector<Vector> lattice_points(std::size_t k, double spacing)
{
  std::vector<Vector> points;
  for (std::size_t x = 0; x < k; ++x)
    for (std::size_t y = 0; y < k; ++y)
      for (std::size_t z = 0; z < k; ++z)
        points.push_back(spacing * Vector(double(x), double(y), double(z)));
  return points;
}

inline void add_gaussian_noise(std::vector<Vector>& points, double deviation, Generator& generator)
{
  for (Vector& p : points)
    p += gaussian_vector(deviation, generator);
}

/// On the surface of the unit cube, with Gaussian noise of a hundredth of its side.
inline std::vector<Vector> noisy_cube(std::size_t n)
{
  Generator generator(1);
  std::vector<Vector> points = cube_points(n, 1, generator).points;
  add_gaussian_noise(points, 0.01, generator);
  return points;
}

/// For each query the points strictly closer than `radius`, by increasing index, in time O(queries
/// * points).
inline std::vector<std::vector<std::uint32_t>> brute_force_neighbors(
  const std::vector<Vector>& queries, const std::vector<Vector>& points, double radius)
{
  std::vector<std::vector<std::uint32_t>> result(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j)
      if ((queries[i] - points[j]).squaredNorm() < radius * radius)
        result[i].push_back(std::uint32_t(j));
  return result;
}

/// Whether two numbers differ by at most `tolerance` times the larger of them.
inline bool is_close(double a, double b, double tolerance)
{
  return std::abs(a - b) <= tolerance * (std::max)(std::abs(a), std::abs(b));
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_SUPPORT_H
