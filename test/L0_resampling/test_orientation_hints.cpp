// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters viewpoint and orientation_hint_map: which side the normals point to, and
// that the report says what decided.

#include "promise_support.h"

#include <CGAL/property_map.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Normals = std::vector<Kernel::Vector_3>;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

constexpr double noise = 0.005;

/// A scan: of the open side of half a sphere, or of a plane with a bump.
std::vector<Vector> half_sphere(std::size_t n, test::Generator& generator)
{
  std::vector<Vector> points;
  while (points.size() < n)
  {
    const Vector p = test::random_unit_vector(generator);
    if (p[2] < 0)
      points.push_back(p);
  }
  test::add_gaussian_noise(points, noise, generator);
  return points;
}

std::vector<Vector> plane_with_bump(std::size_t n, test::Generator& generator)
{
  std::vector<Vector> points = test::plane_points(n, 2, generator).points;
  for (Vector& p : points)
    p[2] = 0.4 * std::exp(-8 * p.squaredNorm());
  test::add_gaussian_noise(points, noise, generator);
  return points;
}

std::vector<Vector> noisy(std::vector<Vector> points, test::Generator& generator)
{
  test::add_gaussian_noise(points, noise, generator);
  return points;
}

/// Checks which share of the normals is on the side of `side_of(position)`, and what share the
/// report says was hinted.
template <typename NamedParameters>
void check_side(const std::string& name, const std::vector<Vector>& input,
                const NamedParameters& np, const std::function<Vector(const Vector&)>& side_of,
                double hinted_share)
{
  const Points points = test::kernel_points<Kernel>(input);
  const auto result = test::resample<Kernel, CGAL::Parallel_if_available_tag>(points, np);
  test::check_clean<Kernel>(name, points, result, input.size() / 2);
  CHECK(test::are_identical<Kernel>(
    result.pairs, test::resample<Kernel, CGAL::Sequential_tag>(points, np).pairs));
  std::size_t number_right = 0;
  for (const auto& [p, n] : result.pairs)
    number_right += test::as_vector(n).dot(side_of(test::as_vector(p))) > 0;
  const double share = double(number_right) / double(result.pairs.size());
  if (!CHECK(share >= 0.995 && result.report.hinted_share == hinted_share))
    std::cerr << "  " << name << ": " << share << " on the right side, "
              << result.report.hinted_share << " hinted" << std::endl;
}

void test_open_scans(test::Generator& generator)
{
  const std::vector<Vector> bowl = half_sphere(4000, generator),
                            bump = plane_with_bump(4000, generator);
  const auto inwards = [](const Vector& p) -> Vector { return -p; };
  const auto outwards = [](const Vector& p) { return p; };
  for (double distance : {0.5, 4., 1e6, 1e300})
  {
    check_side("bowl from above", bowl, params::viewpoint(Kernel::Point_3(0, 0, distance)), inwards,
               1);
    check_side(
      "bump from above", bump, params::viewpoint(Kernel::Point_3(0.3 * distance, 0, distance)),
      [](const Vector&) -> Vector { return Vector::UnitZ(); }, 1);
  }
  for (double distance : {4., 1e6, 1e300})
  {
    check_side("bowl from below", bowl, params::viewpoint(Kernel::Point_3(0, 0, -distance)),
               outwards, 1);
    check_side(
      "bump from below", bump, params::viewpoint(Kernel::Point_3(0, 0, -distance)),
      [](const Vector&) -> Vector { return -Vector::UnitZ(); }, 1);
  }
  // without a hint a bowl is turned like a part of a sphere
  check_side("bowl", bowl, params::default_values(), outwards, 0);
}

void test_closed_shapes(test::Generator& generator)
{
  const std::vector<Vector> sphere = noisy(test::sphere_points(4000, 1, generator).points,
                                           generator);
  const std::vector<Vector> cube = noisy(test::cube_points(4000, 2, generator).points, generator);
  const auto outwards = [](const Vector& p) { return p; };
  for (const auto& shape : {sphere, cube})
  {
    for (const Kernel::Point_3& inside :
         {Kernel::Point_3(0, 0, 0), Kernel::Point_3(0.3, -0.4, 0.2)})
      check_side(
        "from inside", shape, params::viewpoint(inside),
        [](const Vector& p) -> Vector { return -p; }, 1);
    for (const Kernel::Point_3& outside :
         {Kernel::Point_3(2, 1, 1), Kernel::Point_3(0, 0, 3), Kernel::Point_3(-40, 7, 0)})
      check_side("from outside", shape, params::viewpoint(outside), outwards, 0);
  }
}

/// Given normals, a third of them with the wrong sign and any length; and none for one of two
/// parts.
void test_hint_map(test::Generator& generator)
{
  const test::Oriented_points sphere = test::sphere_points(3000, 1, generator),
                              cube = test::cube_points(3000, 2, generator);
  std::vector<Vector> points = noisy(sphere.points, generator);
  Normals inward;
  std::bernoulli_distribution is_wrong(1. / 3);
  for (const Vector& n : sphere.normals)
  {
    const Vector hint = (is_wrong(generator) ? 1e-200 : -1e-200) * n;
    inward.emplace_back(hint[0], hint[1], hint[2]);
  }
  const auto np = [&](Normals& hints, const Points& range) {
    return params::orientation_hint_map(CGAL::make_property_map(hints))
      .point_map(CGAL::make_property_map(range));
  };
  const auto check_hints = [&](const std::string& name, const std::vector<Vector>& input,
                               Normals& hints, const std::function<Vector(const Vector&)>& side_of,
                               double hinted_share) {
    const Points range = test::kernel_points<Kernel>(input);
    std::vector<std::size_t> indices(range.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
      indices[i] = i;
    test::Resampled<Kernel> result;
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
      indices, std::back_inserter(result.pairs),
      np(hints, range).resampling_report(&result.report));
    std::size_t number_right = 0;
    for (const auto& [p, n] : result.pairs)
      number_right += test::as_vector(n).dot(side_of(test::as_vector(p))) > 0;
    const double share = double(number_right) / double(result.pairs.size());
    if (!CHECK(share >= 0.995
               && std::abs(result.report.hinted_share - hinted_share) < 0.1 * hinted_share + 1e-9))
      std::cerr << "  " << name << ": " << share << " on the right side, "
                << result.report.hinted_share << " hinted" << std::endl;
  };
  const auto inwards = [](const Vector& p) -> Vector { return -p; };
  const auto outwards = [](const Vector& p) { return p; };
  check_hints("sphere turned inwards", points, inward, inwards, 1);

  Normals none(points.size(), Kernel::Vector_3(0, 0, 0));
  none[3] = Kernel::Vector_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  check_hints("hints of no use", points, none, outwards, 0);

  const Vector shift(10, 0, 0);
  for (const Vector& p : noisy(cube.points, generator))
  {
    points.push_back(p + shift);
    inward.emplace_back(0, 0, 0);
  }
  check_hints(
    "cube without hints beside a sphere with", points, inward,
    [&](const Vector& p) -> Vector { return p[0] < 5 ? -p : Vector(p - shift); },
    0.5 * 4 * EIGEN_PI / (2 * EIGEN_PI + 12));
}

/// A viewpoint moves and scales with the points.
void test_invariance(test::Generator& generator)
{
  const std::vector<Vector> bowl = half_sphere(2000, generator);
  const Vector viewpoint(0.2, 0.1, 3);
  const auto resampled = [&](double scale) {
    std::vector<Vector> points = bowl;
    for (Vector& p : points)
      p *= scale;
    const Vector v = scale * viewpoint;
    return test::resample<Kernel, CGAL::Parallel_if_available_tag>(
      test::kernel_points<Kernel>(points), params::viewpoint(Kernel::Point_3(v[0], v[1], v[2])));
  };
  const auto expected = resampled(1);
  for (int exponent : {-300, -20, 20, 300})
  {
    const auto result = resampled(std::ldexp(1., exponent));
    bool are_scaled = result.pairs.size() == expected.pairs.size();
    for (std::size_t i = 0; i < result.pairs.size(); ++i)
      are_scaled = are_scaled && result.pairs[i].second == expected.pairs[i].second;
    CHECK(are_scaled && result.report.hinted_share == 1);
  }
  std::vector<Vector> at_a_map = bowl;
  const Vector far(500000, 5000000, 100);
  for (Vector& p : at_a_map)
    p += far;
  check_side(
    "bowl on a map", at_a_map, params::viewpoint(Kernel::Point_3(far[0], far[1], far[2] + 2)),
    [&](const Vector& p) -> Vector { return far - p; }, 1);
}

} // namespace

int main()
{
  test::Generator generator(1);
  test_open_scans(generator);
  test_closed_shapes(generator);
  test_hint_map(generator);
  test_invariance(generator);
  return test::result();
}
