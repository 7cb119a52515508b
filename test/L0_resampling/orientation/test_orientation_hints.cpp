// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters viewpoint, viewpoint_map, up_direction and orientation_hint_map: which side
// the normals point to, and that the report says what decided.

#include "promise_support.h"

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
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

double share_on_side(const test::Resampled<Kernel>& result,
                     const std::function<Vector(const Vector&)>& side_of)
{
  std::size_t number_right = 0;
  for (const auto& [p, n] : result.pairs)
    number_right += test::as_vector(n).dot(side_of(test::as_vector(p))) > 0;
  return double(number_right) / double(result.pairs.size());
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
  const double share = share_on_side(result, side_of);
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
  for (double distance : {1e6, 1e300})
    check_side("bowl from aside", bowl,
               params::viewpoint(Kernel::Point_3(0.1 * distance, 0, distance)), inwards, 1);
  // not from near, where the rim shows its inner side
  for (double distance : {1e6, 1e300})
    check_side("bowl from below", bowl, params::viewpoint(Kernel::Point_3(0, 0, -distance)),
               outwards, 1);
  for (double distance : {4., 1e6, 1e300})
    check_side(
      "bump from below", bump, params::viewpoint(Kernel::Point_3(0, 0, -distance)),
      [](const Vector&) -> Vector { return -Vector::UnitZ(); }, 1);
  // without a hint a bowl is turned like a part of a sphere
  check_side("bowl", bowl, params::default_values(), outwards, 0);
}

/// From inside all of it is seen, from outside the part that faces the viewpoint.
void test_closed_shapes(test::Generator& generator)
{
  const auto outwards = [](const Vector& p) { return p; };
  for (const test::Oriented_points& shape :
       {test::sphere_points(4000, 1, generator), test::cube_points(4000, 2, generator)})
  {
    for (const Kernel::Point_3& inside :
         {Kernel::Point_3(0, 0, 0), Kernel::Point_3(0.3, -0.4, 0.2)})
      check_side(
        "from inside", noisy(shape.points, generator), params::viewpoint(inside),
        [](const Vector& p) -> Vector { return -p; }, 1);
    for (const Vector& outside : {Vector(2, 2, 1.5), Vector(0, 0, 3), Vector(-40, 7, 0)})
    {
      std::vector<Vector> seen;
      for (std::size_t i = 0; i < shape.points.size(); ++i)
        if (shape.normals[i].dot(outside - shape.points[i]) > 0)
          seen.push_back(shape.points[i]);
      check_side("from outside", noisy(seen, generator),
                 params::viewpoint(Kernel::Point_3(outside[0], outside[1], outside[2])), outwards,
                 1);
    }
  }
}

/// Calls the function for points with further vectors, of the key that `parameters_of` makes
/// parameters of: positions of the input by index.
template <typename ParametersOf>
test::Resampled<Kernel> resample_by_index(const std::vector<Vector>& input,
                                          const ParametersOf& parameters_of)
{
  const Points points = test::kernel_points<Kernel>(input);
  std::vector<std::size_t> indices(points.size());
  for (std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = i;
  test::Resampled<Kernel> result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    indices, std::back_inserter(result.pairs),
    parameters_of(params::point_map(CGAL::make_property_map(points)))
      .resampling_report(&result.report));
  return result;
}

/// A table with flat objects, seen from above: at their borders, where the scan jumps, the surface
/// goes on at another height, which without a viewpoint looks like the two sides of a plate.
std::vector<Vector> table_with_objects(std::size_t n, test::Generator& generator)
{
  std::vector<Vector> points = test::plane_points(n, 2, generator).points;
  for (Vector& p : points)
    for (int x : {0, 1})
      for (int y : {0, 1})
        if ((p.head<2>() - Eigen::Vector2d(x - 0.5, y - 0.5)).cwiseAbs().maxCoeff() < 0.3)
          p[2] = 0.1 + 0.03 * (x + 2 * y);
  test::add_gaussian_noise(points, noise, generator);
  return points;
}

void test_jumps(test::Generator& generator)
{
  const std::vector<Vector> table = table_with_objects(8000, generator);
  const auto up = [](const Vector&) -> Vector { return Vector::UnitZ(); };
  const auto down = [](const Vector&) -> Vector { return -Vector::UnitZ(); };
  check_side("table from above", table, params::viewpoint(Kernel::Point_3(0.2, 0.1, 3)), up, 1);
  check_side("table from below", table, params::viewpoint(Kernel::Point_3(0.2, 0.1, -3)), down, 1);
  for (double length : {1e-310, 1., 1e308})
    check_side("table, told the way up", table,
               params::up_direction(Kernel::Vector_3(0.1 * length, 0, length)), up, 1);
  check_side("table, told the way down", table, params::up_direction(Kernel::Vector_3(0, 0, -1)),
             down, 1);
  for (const auto method : {CGAL::L0_resampling::Method::LOR, CGAL::L0_resampling::Method::ALOR})
    check_side("table from above, of the paper", table,
               params::viewpoint(Kernel::Point_3(0.2, 0.1, 3)).resampling_method(method), up, 1);
}

/// Walls on two sides of the sensor, joined by a floor that it sees at a small angle.
void test_facing_walls(test::Generator& generator)
{
  std::vector<Vector> points;
  for (const Vector& p : test::plane_points(4000, 2, generator).points)
    for (double side : {-1., 1.})
      points.emplace_back(side, p[0], p[1]);
  for (const Vector& p : test::plane_points(4000, 2, generator).points)
    points.emplace_back(p[0], p[1], -1);
  const Vector sensor(0.1, 0.2, -0.9);
  check_side(
    "between two walls", noisy(points, generator),
    params::viewpoint(Kernel::Point_3(sensor[0], sensor[1], sensor[2])),
    [&](const Vector& p) -> Vector { return sensor - p; }, 1);
}

/// A floor that the sensor sees ever flatter, so that the angle decides nothing from six times its
/// height on: the part that is seen steeply tells the side of the rest.
void test_flat_angle(test::Generator& generator)
{
  std::vector<Vector> floor;
  for (const Vector& p : test::plane_points(6000, 1, generator).points)
    floor.emplace_back(10 * p[0] + 6, 3 * p[1], 0);
  check_side(
    "floor seen flatly", noisy(floor, generator), params::viewpoint(Kernel::Point_3(0, 0, 1)),
    [](const Vector&) -> Vector { return Vector::UnitZ(); }, 1);
}

/// A board that two scanners saw, one from each side, their points mixed. Some points have no
/// viewpoint of use.
void test_two_scanners(test::Generator& generator)
{
  const Vector center(30, -20, 50);
  const Vector scanners[] = {center + Vector(0.3, 0, 2), center - Vector(0, 0.2, 3)};
  std::vector<Vector> points;
  for (const Vector& p : test::plane_points(8000, 2, generator).points)
    points.push_back(center + Vector(p[0], p[1], points.size() % 2 == 0 ? 0.1 : -0.1));
  points = noisy(points, generator);
  const double infinity = std::numeric_limits<double>::infinity();
  const Kernel::Point_3 nowhere(infinity, 0, 0);
  const auto check_share = [&](const std::function<Vector(std::size_t)>& viewpoint_of,
                               const std::function<Vector(const Vector&)>& side_of) {
    Points viewpoints;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Vector v = i % 32 == 1 ? points[i] : viewpoint_of(i);
      viewpoints.push_back(i % 16 == 0 ? nowhere : Kernel::Point_3(v[0], v[1], v[2]));
    }
    const test::Resampled<Kernel> result = resample_by_index(points, [&](const auto& np) {
      return np | params::viewpoint_map(CGAL::make_property_map(viewpoints));
    });
    CHECK(share_on_side(result, side_of) >= 0.995);
    CHECK(result.report.hinted_share == 1);
  };
  const auto scanner_of = [&](std::size_t i) { return scanners[i % 2]; };
  const auto out_of_board = [&](const Vector& p) -> Vector {
    return Vector(0, 0, p[2] - center[2]);
  };
  check_share(scanner_of, out_of_board);
  // as if each had seen the sheet from the other side
  check_share([&](std::size_t i) -> Vector { return 2 * points[i] - scanner_of(i); },
              [&](const Vector& p) -> Vector { return -out_of_board(p); });
  const Points nothing(points.size(), nowhere);
  CHECK(resample_by_index(points,
                          [&](const auto& np) {
                            return np | params::viewpoint_map(CGAL::make_property_map(nothing));
                          })
          .report.hinted_share
        == 0);
}

/// Neither the order of the points nor the signs of their normals matter to the sides.
void test_order_and_signs(test::Generator& generator)
{
  const std::vector<Vector> table = table_with_objects(3000, generator);
  std::vector<std::size_t> order(table.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  const auto resampled = [&]() {
    std::vector<Vector> points;
    Normals normals;
    Points viewpoints;
    for (const std::size_t i : order)
    {
      points.push_back(table[i]);
      normals.emplace_back(0, 0, std::bernoulli_distribution()(generator) ? 1 : -1);
      viewpoints.emplace_back(table[i][0] > 0 ? 3 : -3, 0, 2);
    }
    auto result = resample_by_index(points, [&](const auto& np) {
                    return (np | params::viewpoint_map(CGAL::make_property_map(viewpoints)))
                      .normal_map(CGAL::make_property_map(normals));
                  }).pairs;
    CHECK(std::all_of(result.begin(), result.end(), [](const auto& point_and_normal) {
      return point_and_normal.second.z() > 0;
    }));
    std::sort(result.begin(), result.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return result;
  };
  const auto expected = resampled();
  std::shuffle(order.begin(), order.end(), generator);
  CHECK(test::are_identical<Kernel>(resampled(), expected));
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
  const auto check_hints = [&](const std::string& name, const std::vector<Vector>& input,
                               Normals& hints, const std::function<Vector(const Vector&)>& side_of,
                               double hinted_share) {
    const test::Resampled<Kernel> result = resample_by_index(input, [&](const auto& np) {
      return np | params::orientation_hint_map(CGAL::make_property_map(hints));
    });
    const double share = share_on_side(result, side_of);
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
  // of a cloud so small that the frame has no number for the viewpoint
  std::vector<Vector> small = bowl;
  for (Vector& p : small)
    p *= 1e-200;
  check_side(
    "small bowl", small, params::viewpoint(Kernel::Point_3(1e299, 0, 1e300)),
    [](const Vector& p) -> Vector { return -1e200 * p; }, 1);
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
  test_jumps(generator);
  test_facing_walls(generator);
  test_flat_angle(generator);
  test_two_scanners(generator);
  test_order_and_signs(generator);
  test_hint_map(generator);
  test_invariance(generator);
  return test::result();
}
