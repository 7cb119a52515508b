// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters crease_output_iterator and corner_output_iterator, on shapes whose edges are
// known.

#include "promise_support.h"

#include <CGAL/IO/read_points.h>
#include <CGAL/L0_resampling/Crease.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Crease = CGAL::L0_resampling::Crease<Kernel>;
using Corner = CGAL::L0_resampling::Crease_corner<Kernel>;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

struct Result
{
  test::Pairs<Kernel> points;
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  CGAL::L0_resampling::Report report;

  Vector position(std::size_t i) const { return test::as_vector(points[i].first); }
  std::set<std::size_t> points_on_creases() const
  {
    std::set<std::size_t> marked;
    for (const Crease& crease : creases)
      marked.insert(crease.points.begin(), crease.points.end());
    for (const Corner& corner : corners)
      marked.insert(corner.point);
    return marked;
  }
};

template <typename Tag>
Result resample(const Points& points, std::size_t number_of_output_points)
{
  Result result;
  CGAL::l0_resample_point_set<Tag>(
    points, std::back_inserter(result.points),
    params::number_of_output_points(number_of_output_points)
      | params::crease_output_iterator(std::back_inserter(result.creases))
      | params::corner_output_iterator(std::back_inserter(result.corners))
      | params::resampling_report(&result.report));
  CHECK(result.points.size() == number_of_output_points);
  return result;
}

template <typename Tag>
Result resample(const Points& points)
{
  return resample<Tag>(points, (std::max)(points.size() / 2, std::size_t(!points.empty())));
}

/// What holds of every crease.
void check_each_crease(const Result& result)
{
  for (const Crease& crease : result.creases)
  {
    CHECK(crease.points.size() >= 2);
    CHECK(crease.tangents.size() == crease.points.size());
    CHECK(crease.normals.size() == crease.points.size());
    CHECK(crease.angles.size() == crease.points.size());
    CHECK(0 <= crease.confidence && crease.confidence <= 1);
    for (std::size_t k = 0; k < crease.points.size(); ++k)
    {
      const Vector tangent = test::as_vector(crease.tangents[k]),
                   left = test::as_vector(crease.normals[k][0]),
                   right = test::as_vector(crease.normals[k][1]),
                   normal = test::as_vector(result.points[crease.points[k]].second);
      CHECK(std::abs(tangent.norm() - 1) < 1e-9 && std::abs(left.norm() - 1) < 1e-9);
      CHECK(normal.dot(left) > 0 && normal.dot(right) > 0);
      // the left face of a convex crease leans to the left
      CHECK((left.dot((left + right).cross(tangent)) > 0) == crease.is_convex);
      CHECK(std::abs(std::cos(crease.angles[k] * EIGEN_PI / 180) - left.dot(right)) < 1e-6);
      if (k + 1 < crease.points.size())
        CHECK(
          (result.position(crease.points[k + 1]) - result.position(crease.points[k])).dot(tangent)
          > 0);
    }
  }
}

void test_cube()
{
  test::Generator generator(1);
  std::vector<Vector> points = test::cube_points(20000, 1, generator).points;
  test::add_gaussian_noise(points, 0.005 * std::sqrt(3.), generator);
  const Result result = resample<CGAL::Parallel_if_available_tag>(
    test::kernel_points<Kernel>(points));
  const double spacing = result.report.sample_spacing;
  CHECK(std::abs(spacing / std::sqrt(6. / 10000) - 1) < 0.1);
  check_each_crease(result);
  CHECK(result.creases.size() == 12);
  CHECK(result.corners.size() == 8);
  for (const Corner& corner : result.corners)
  {
    CHECK(corner.normals.size() == 3);
    CHECK((result.position(corner.point).cwiseAbs() - Vector::Constant(0.5)).norm()
          < 0.5 * spacing);
  }
  double sum_of_squares = 0;
  std::size_t number = 0;
  for (const Crease& crease : result.creases)
  {
    CHECK(crease.is_convex && !crease.is_closed && crease.confidence > 0.8);
    for (std::size_t k = 0; k < crease.points.size(); ++k)
    {
      // on an edge, two coordinates are half the side
      Vector offs = (result.position(crease.points[k]).cwiseAbs() - Vector::Constant(0.5));
      std::sort(offs.data(), offs.data() + 3,
                [](double a, double b) { return std::abs(a) < std::abs(b); });
      sum_of_squares += offs[0] * offs[0] + offs[1] * offs[1];
      ++number;
      CHECK(std::abs(crease.angles[k] - 90) < 15);
    }
  }
  CHECK(number > std::size_t(0.9 * 12 / spacing));
  CHECK(std::sqrt(sum_of_squares / double(number)) < 0.25 * spacing);
}

/// The gaps beside edges of clean points are as wide as their spacing, however many samples there
/// are.
void test_samples_denser_than_the_points()
{
  test::Generator generator(1);
  const std::vector<Vector> points = test::cube_points(6000, 1, generator).points;
  const Result result =
    resample<CGAL::Parallel_if_available_tag>(test::kernel_points<Kernel>(points), 12000);
  check_each_crease(result);
  CHECK(result.creases.size() == 12);
  std::set<int> octants; // of the corners at corners of the cube
  for (const Corner& corner : result.corners)
  {
    const Vector p = result.position(corner.point);
    if ((p.cwiseAbs() - Vector::Constant(0.5)).norm() < result.report.estimated_spacing)
      octants.insert((p.x() > 0) + 2 * (p.y() > 0) + 4 * (p.z() > 0));
  }
  CHECK(octants.size() >= 7 && octants.size() == result.corners.size());
  double length = 0;
  for (const Crease& crease : result.creases)
    for (std::size_t k = 1; k < crease.points.size(); ++k)
      length += (result.position(crease.points[k]) - result.position(crease.points[k - 1])).norm();
  if (!CHECK(length > 11.5 && length < 12.5))
    std::cerr << "  " << length << " for 12\n";
}

void test_cylinder()
{
  // of radius 1 and height 1, with its lids
  test::Generator generator(2);
  std::vector<Vector> points;
  for (std::size_t i = 0; i < 20000; ++i)
  {
    const double angle = 2 * EIGEN_PI * test::random_number(0, 1, generator);
    const std::size_t part = std::size_t(
      4 * test::random_number(0, 1, generator)); // 2, 1 and 1 times pi
    const double r = part < 2 ? 1 : std::sqrt(test::random_number(0, 1, generator)),
                 z = part < 2 ? test::random_number(0, 1, generator) : double(part - 2);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  test::add_gaussian_noise(points, 0.005, generator);
  const Result result = resample<CGAL::Parallel_if_available_tag>(
    test::kernel_points<Kernel>(points));
  const double spacing = result.report.sample_spacing;
  check_each_crease(result);
  CHECK(result.corners.empty());
  CHECK(result.creases.size() == 2);
  for (const Crease& crease : result.creases)
  {
    CHECK(crease.is_closed && crease.is_convex);
    CHECK(std::abs(double(crease.points.size()) * spacing / (2 * EIGEN_PI) - 1) < 0.1);
    for (const std::size_t i : crease.points)
    {
      const Vector p = result.position(i);
      CHECK(std::abs(std::hypot(p.x(), p.y()) - 1) < 0.5 * spacing);
      CHECK((std::min)(std::abs(p.z()), std::abs(p.z() - 1)) < 0.5 * spacing);
    }
  }
}

Points points_of(const std::string& name)
{
  Points points;
  CHECK(CGAL::IO::read_points(L0_TEST_DATA "/" + name + ".ply", std::back_inserter(points)));
  return points;
}

void test_inner_edges()
{
  const Result result = resample<CGAL::Parallel_if_available_tag>(points_of("staircase_noisy"));
  check_each_crease(result);
  std::size_t number_of_convex = 0;
  for (const Crease& crease : result.creases)
    number_of_convex += std::size_t(crease.is_convex);
  CHECK(number_of_convex > 0 && number_of_convex < result.creases.size());
}

void test_smooth_shapes()
{
  CHECK(resample<CGAL::Parallel_if_available_tag>(points_of("torus_noisy")).creases.empty());
  test::Generator generator(3);
  std::vector<Vector> points = test::sphere_points(5000, 1, generator).points;
  test::add_gaussian_noise(points, 0.02, generator);
  const Result result = resample<CGAL::Parallel_if_available_tag>(
    test::kernel_points<Kernel>(points));
  CHECK(result.creases.empty() && result.corners.empty());
}

/// Points away from creases are those of a call that asks for none; beside one, none is left nearer
/// to it than its points are to each other.
void test_only_points_beside_creases_move()
{
  const Points points = points_of("bracket_noisy");
  const Result result = resample<CGAL::Sequential_tag>(points);
  CHECK(!result.creases.empty());
  test::Pairs<Kernel> without;
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(points, std::back_inserter(without));
  const std::set<std::size_t> marked = result.points_on_creases();
  std::size_t number_of_moved = 0, number_too_near = 0;
  for (std::size_t i = 0; i < without.size(); ++i)
  {
    const bool has_moved = without[i] != result.points[i];
    number_of_moved += std::size_t(has_moved);
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t k : marked)
      if (k != i)
        nearest = (std::min)(nearest, (result.position(i) - result.position(k)).norm());
    number_too_near += std::size_t(marked.count(i) == 0
                                   && nearest < 0.6 * result.report.sample_spacing);
    CHECK(!has_moved || marked.count(i) == 1 || nearest < 2 * result.report.sample_spacing);
  }
  CHECK(number_of_moved > marked.size());
  CHECK(number_too_near < marked.size() / 50);
}

void test_threads_do_not_matter()
{
  const Points points = points_of("bracket_noisy");
  const Result a = resample<CGAL::Sequential_tag>(points),
               b = resample<CGAL::Parallel_if_available_tag>(points);
  CHECK(a.points == b.points && a.creases.size() == b.creases.size());
  for (std::size_t k = 0; k < (std::min)(a.creases.size(), b.creases.size()); ++k)
    CHECK(a.creases[k].points == b.creases[k].points
          && a.creases[k].tangents == b.creases[k].tangents);
}

void test_few_points()
{
  for (const std::size_t n : {0, 1, 2, 3, 10})
  {
    Points points;
    for (std::size_t i = 0; i < n; ++i)
      points.emplace_back(double(i), double(i * i), 0);
    CHECK(resample<CGAL::Sequential_tag>(points).creases.empty());
  }
  const Points at_one_place(50, Kernel::Point_3(1, 2, 3));
  CHECK(resample<CGAL::Sequential_tag>(at_one_place).creases.empty());
}

} // namespace

int main()
{
  test_cube();
  test_samples_denser_than_the_points();
  test_cylinder();
  test_inner_edges();
  test_smooth_shapes();
  test_only_points_beside_creases_move();
  test_threads_do_not_matter();
  test_few_points();
  return test::result();
}
