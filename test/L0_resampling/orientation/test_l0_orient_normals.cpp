// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/orientation_support.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_orient_normals.h>

#include <boost/property_map/function_property_map.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace test;
namespace parameters = CGAL::parameters;
using CGAL::L0_resampling::Report;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Pair = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Pairs = std::vector<Pair>;
using Cloud = test::Oriented_points;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Kernel::Vector_3 as_kernel_vector(const Vector& v) { return {v[0], v[1], v[2]}; }
Vector normal_of(const Pair& pair) { return {pair.second.x(), pair.second.y(), pair.second.z()}; }

Pairs pairs_of(const Cloud& cloud)
{
  Pairs pairs;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    pairs.emplace_back(CGAL::ORIGIN + as_kernel_vector(cloud.points[i]),
                       as_kernel_vector(cloud.normals[i]));
  return pairs;
}

/// The same with signs by chance.
Pairs turned_by_chance(Pairs pairs, Generator& generator)
{
  for (Pair& pair : pairs)
    if (std::bernoulli_distribution()(generator))
      pair.second = -pair.second;
  return pairs;
}

auto maps()
{
  return parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
    .normal_map(CGAL::Second_of_pair_property_map<Pair>());
}

template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag, typename NamedParameters>
Report orient(Pairs& pairs, const NamedParameters& np)
{
  Report report;
  CGAL::l0_orient_normals<ConcurrencyTag>(pairs, np | parameters::resampling_report(&report));
  return report;
}
Report orient(Pairs& pairs) { return orient(pairs, maps()); }

std::size_t number_on_side_of(const Pairs& pairs, const Cloud& truth)
{
  std::size_t number = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    number += normal_of(pairs[i]).dot(truth.normals[i]) > 0;
  return number;
}

Cloud moved(Cloud cloud, const Vector& shift)
{
  for (Vector& p : cloud.points)
    p += shift;
  return cloud;
}

/// Two plates above each other, each of two sheets.
Cloud two_plates(std::size_t n, Generator& generator)
{
  Cloud result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double height = double(i % 4) * 0.25;
    result.points.push_back(Vector(0, 0, height) + random_vector(Vector(1, 1, 0), generator));
    result.normals.push_back(i % 2 == 0 ? -Vector::UnitZ() : Vector(Vector::UnitZ()));
  }
  return result;
}

/// Turns signs by chance and asks for the true ones back: the very numbers, in their places.
void check_shape(const Cloud& truth, Generator& generator)
{
  const Pairs expected = pairs_of(truth);
  Pairs pairs = turned_by_chance(expected, generator);
  const Report report = orient(pairs);
  CHECK(pairs == expected);
  CHECK(report.oriented_share == 1 && report.hinted_share == 0);
  CHECK(report.number_of_input_points == pairs.size());
  CHECK(!report.stages.empty() && report.peak_bytes > 0);
  const Pairs once = pairs;
  orient(pairs);
  CHECK(pairs == once);

  for (Pair& pair : pairs)
    pair.second = CGAL::NULL_VECTOR;
  orient(pairs);
  CHECK(double(number_on_side_of(pairs, truth)) >= 0.99 * double(pairs.size()));
  CHECK(std::all_of(pairs.begin(), pairs.end(),
                    [](const Pair& pair) { return std::abs(normal_of(pair).norm() - 1) < 1e-6; }));
}

/// Lengths stay, and of coordinates too large to be squared and too small too; useless normals are
/// estimated, one by one.
void check_normals_of_any_length(const Cloud& sphere, Generator& generator)
{
  Pairs expected = pairs_of(sphere);
  for (std::size_t i = 0; i < expected.size(); ++i)
    expected[i].second = expected[i].second * (i % 3 == 0 ? 1e200 : i % 3 == 1 ? 1e-200 : 7);
  Pairs pairs = turned_by_chance(expected, generator);
  pairs[5].second = {nan, 0, 1};
  pairs[6].second = {std::numeric_limits<double>::infinity(), 0, 0};
  pairs[7].second = CGAL::NULL_VECTOR;
  orient(pairs);
  for (const std::size_t i : {5, 6, 7})
  {
    CHECK(normal_of(pairs[i]).dot(sphere.normals[i]) > 0.9);
    CHECK(std::abs(normal_of(pairs[i]).norm() - 1) < 1e-6);
    pairs[i] = expected[i];
  }
  CHECK(pairs == expected);
}

/// Neither the order of the points nor the number of threads changes a normal.
void check_order_and_threads(Pairs pairs, Generator& generator)
{
  const Pairs given = pairs;
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  orient<CGAL::Sequential_tag>(pairs, maps());
  for (const int threads : {1, 3})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      std::size_t(threads));
    std::shuffle(order.begin(), order.end(), generator);
    Pairs shuffled;
    for (const std::size_t i : order)
      shuffled.push_back(given[i]);
    shuffled = turned_by_chance(shuffled, generator); // the given sign does not matter either
    orient(shuffled);
    bool are_same = true;
    for (std::size_t k = 0; k < order.size(); ++k)
      are_same = are_same && shuffled[k] == pairs[order[k]];
    CHECK(are_same);
  }
}

/// Points at one place turn to the side of each other, if their normals say one at all.
void check_coincident_points(const Cloud& sphere, Generator& generator)
{
  Cloud truth = sphere;
  for (std::size_t i = 0; i < 200; ++i)
  {
    truth.points.push_back(sphere.points[i]);
    truth.normals.push_back((sphere.normals[i] + 0.5 * random_unit_vector(generator)).normalized());
  }
  const Pairs expected = pairs_of(truth);
  Pairs pairs = turned_by_chance(expected, generator);
  CHECK(orient(pairs).number_of_distinct_points == sphere.points.size());
  CHECK(pairs == expected);
  for (std::size_t i = 0; i < 200; ++i)
    pairs[i].second = CGAL::NULL_VECTOR; // their doubles have one
  orient(pairs);
  bool are_those_of_doubles = true;
  for (std::size_t i = 0; i < 200; ++i)
    are_those_of_doubles = are_those_of_doubles
                           && (normal_of(pairs[i]) - truth.normals[sphere.points.size() + i]).norm()
                                < 1e-6;
  CHECK(are_those_of_doubles);
  check_order_and_threads(turned_by_chance(expected, generator), generator);

  Cloud crowd = sphere;
  crowd.points.resize(100000, sphere.points[3]);
  crowd.normals.resize(100000, sphere.normals[3]);
  for (std::size_t i = 99500; i < 100000; ++i) // almost there
    crowd.points[i] = (crowd.points[i] + 1e-5 * random_unit_vector(generator)).normalized();
  const Pairs all = pairs_of(crowd);
  pairs = turned_by_chance(all, generator);
  orient(pairs);
  CHECK(pairs == all);
}

/// Points off the surface get a side and leave the others theirs.
void check_outliers(const Cloud& sphere, Generator& generator)
{
  Cloud truth = sphere;
  for (std::size_t i = 0; i < sphere.points.size() / 20; ++i)
  {
    truth.points.push_back(random_vector(2, generator));
    truth.normals.push_back(random_unit_vector(generator));
  }
  Pairs pairs = turned_by_chance(pairs_of(truth), generator);
  orient(pairs);
  pairs.resize(sphere.points.size());
  CHECK(double(number_on_side_of(pairs, sphere)) >= 0.995 * double(pairs.size()));
}

/// Where the noise is many times the spacing, some points represent the others.
void check_noise(Generator& generator)
{
  Cloud truth = sphere_points(60000, 1, generator);
  add_gaussian_noise(truth.points, 0.02, generator);
  const Pairs expected = pairs_of(truth);
  Pairs pairs = turned_by_chance(expected, generator);
  const Report report = orient(pairs);
  CHECK(report.estimated_noise > report.estimated_spacing);
  CHECK(double(number_on_side_of(pairs, truth)) >= 0.9999 * double(pairs.size()));
  CHECK(report.right_side_share > 0.9);
  check_order_and_threads(turned_by_chance(expected, generator), generator);
}

/// An angle of sheet metal, both legs 40 long, 25 wide and 1.5 thick, without noise: the balls of
/// the first normals reach through it.
void check_thin_profile(Generator& generator)
{
  const double width = 25, length = 40, thickness = 1.5;
  Cloud profile;
  while (profile.points.size() < 6000)
  {
    const double x = random_number(0, width, generator), t = random_number(0, length, generator);
    const bool is_inside = random_number(0, 1, generator) < 0.5;
    if (is_inside && t < thickness)
      continue; // behind the other leg
    const double height = is_inside ? thickness : 0, side = is_inside ? 1 : -1;
    if (random_number(0, 1, generator) < 0.5)
    {
      profile.points.emplace_back(x, height, t);
      profile.normals.push_back(side * Vector::UnitY());
    }
    else
    {
      profile.points.emplace_back(x, t, height);
      profile.normals.push_back(side * Vector::UnitZ());
    }
  }
  Pairs pairs = pairs_of(profile);
  for (auto& pair : pairs)
    pair.second = CGAL::NULL_VECTOR;
  orient(pairs);
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    sum += std::acos((std::min)(1., std::abs(normal_of(pairs[i]).dot(profile.normals[i]))))
           * (180 / EIGEN_PI);
  std::cout << "thin profile: " << sum / double(pairs.size()) << " degrees" << std::endl;
  CHECK(sum < 4 * double(pairs.size())); // 6 by planes through all points
}

/// Normals that lean by chance: the mean of those around tells their sides, also where points
/// represent others.
void check_leaning_normals(Generator& generator)
{
  Cloud truth = sphere_points(60000, 1, generator);
  add_gaussian_noise(truth.points, 0.02, generator);
  Cloud leaning = truth;
  for (Vector& normal : leaning.normals)
    normal = (normal + 0.95 * random_unit_vector(generator)).normalized();
  Pairs pairs = turned_by_chance(pairs_of(leaning), generator);
  const Report report = orient(pairs);
  CHECK(report.estimated_noise > report.estimated_spacing);
  CHECK(double(number_on_side_of(pairs, truth)) >= 0.995 * double(pairs.size()));
}

/// Scales of places are looked for only where they have a say.
void check_scales(Generator& generator)
{
  Cloud cloud;
  while (cloud.points.size() < 10000)
  {
    const Vector p = random_unit_vector(generator);
    if (random_number(0, 1, generator) < std::pow(100, (p[2] - 1) / 2))
    {
      cloud.points.push_back(p);
      cloud.normals.push_back(p);
    }
  }
  const Pairs expected = pairs_of(cloud);
  Pairs pairs = turned_by_chance(expected, generator);
  const Report given = orient(pairs);
  CHECK(pairs == expected);
  CHECK(given.least_neighbor_radius == given.largest_neighbor_radius);
  pairs[0].second = CGAL::NULL_VECTOR;
  const Report estimated = orient(pairs);
  CHECK(estimated.least_neighbor_radius < 0.5 * estimated.largest_neighbor_radius);
}

void check_hints(const Cloud& sphere, Generator& generator)
{
  const Pairs outwards = pairs_of(sphere);
  const auto turn_all = [](Pairs pairs) {
    for (Pair& pair : pairs)
      pair.second = -pair.second;
    return pairs;
  };
  const auto turned = [&](const auto& np) {
    Pairs pairs = turned_by_chance(outwards, generator);
    CHECK(orient(pairs, np).hinted_share == 1);
    return pairs;
  };
  CHECK(turned(maps() | parameters::viewpoint(Kernel::Point_3(0.1, 0, 0))) == turn_all(outwards));
  // a map of the pairs: their points lie on the unit sphere, their viewpoints nine times as far
  const auto nine_times = [](const Pair& pair) {
    return CGAL::ORIGIN + 9 * (pair.first - CGAL::ORIGIN);
  };
  const auto viewpoint_map = boost::make_function_property_map<Pair, Kernel::Point_3>(nine_times);
  CHECK(turned(maps() | parameters::viewpoint_map(viewpoint_map)) == outwards);
  const auto hint_map = boost::make_function_property_map<Pair, Kernel::Vector_3>(
    [](const Pair& pair) { return CGAL::ORIGIN - pair.first; });
  CHECK(turned(maps() | parameters::orientation_hint_map(hint_map)) == turn_all(outwards));

  Cloud plane = plane_points(500, 1, generator);
  Pairs pairs = turned_by_chance(pairs_of(plane), generator);
  const Kernel::Vector_3 down(0, 0, -2);
  CHECK(orient(pairs, maps() | parameters::up_direction(down)).hinted_share == 1);
  CHECK(number_on_side_of(pairs, plane) == 0);
}

/// Of points at one place, that one tells the side which has a hint, wherever it points to.
void check_hints_of_coincident_points(Generator& generator)
{
  Pairs pairs;
  std::vector<Kernel::Vector_3> hints;
  for (std::size_t i = 0; i < 500; ++i)
  {
    const Kernel::Point_3 p(0, random_number(-1, 1, generator), random_number(-1, 1, generator));
    for (const double hint : {-1, 0})
    {
      pairs.emplace_back(p, Kernel::Vector_3(1, 0, 0));
      hints.emplace_back(hint, 0, 0);
    }
  }
  std::vector<std::size_t> indices(pairs.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  const auto point_map = boost::make_function_property_map<std::size_t, Kernel::Point_3>(
    [&](std::size_t i) { return pairs[i].first; });
  std::vector<Kernel::Vector_3> normals(pairs.size(), {1, 0, 0});
  Report report;
  CGAL::l0_orient_normals<CGAL::Sequential_tag>(
    indices, parameters::point_map(point_map).normal_map(CGAL::make_property_map(normals))
               | parameters::resampling_report(&report)
               | parameters::orientation_hint_map(CGAL::make_property_map(hints)));
  CHECK(report.hinted_share == 1);
  CHECK(std::all_of(normals.begin(), normals.end(),
                    [](const Kernel::Vector_3& n) { return n == Kernel::Vector_3(-1, 0, 0); }));
}

void check_few_points()
{
  Pairs none;
  CHECK(orient(none).number_of_input_points == 0);
  for (const std::size_t n : {1, 2, 3})
  {
    Pairs pairs;
    for (std::size_t i = 0; i < n; ++i)
      pairs.emplace_back(Kernel::Point_3(double(i), 0, 0), Kernel::Vector_3(0, 0, -3));
    orient(pairs);
    for (const Pair& pair : pairs)
      CHECK(pair.second == Kernel::Vector_3(0, 0, 3));
    pairs.front().second = CGAL::NULL_VECTOR;
    orient(pairs);
    CHECK(std::abs(normal_of(pairs.front()).norm() - 1) < 1e-6);
  }
}

/// Of a call that ends in another way nothing is written.
void check_refusals(const Cloud& sphere, Generator& generator)
{
  Pairs given = turned_by_chance(pairs_of(sphere), generator);
  given[3].second = CGAL::NULL_VECTOR;
  Pairs pairs = given;
  const auto message_of = [&](const auto& np) {
    std::string message;
    try
    {
      orient(pairs, np);
    }
    catch (const std::invalid_argument& error)
    {
      message = error.what();
    }
    CHECK(message.find("l0_orient_normals: ") == 0);
    return message;
  };
  const auto says = [&](const auto& np, const char* part) {
    return message_of(np).find(part) != std::string::npos;
  };
  using namespace parameters;
  CHECK(says(maps().neighbor_radius(-1.), "neighbor_radius is -1"));
  CHECK(says(maps().neighbor_radius(nan), "neighbor_radius is nan"));
  CHECK(says(maps() | number_of_orientation_neighbors(2), "number_of_orientation_neighbors is 2"));
  CHECK(says(maps() | number_of_orientation_neighbors(-1), "number_of_orientation_neighbors"));
  CHECK(says(maps() | viewpoint(Kernel::Point_3(nan, 0, 0)), "viewpoint is nan"));
  CHECK(says(maps() | up_direction(Kernel::Vector_3(0, 0, 0)), "up_direction is 0, 0, 0"));
  CHECK(says(maps() | up_direction(Kernel::Vector_3(0, 0, 1)) | viewpoint(Kernel::Point_3(0, 0, 1)),
             "no up_direction beside it"));
  CHECK_THROWS(orient(pairs, maps() | maximum_memory(1000)), std::bad_alloc);
  CHECK_THROWS(orient(pairs, maps() | maximum_memory(pairs.size() * 100)), std::bad_alloc);
  CHECK(pairs == given);

  for (const int last : {0, 1, 2})
  {
    int calls = 0;
    const Report report = orient(pairs, maps().callback([&](double) { return calls++ < last; }));
    CHECK(report.outcome == CGAL::L0_resampling::Outcome::CANCELLED && calls == last + 1);
    CHECK(report.number_of_output_points == 0);
  }
  CHECK_THROWS(orient(pairs, maps().callback([](double) -> bool { throw 1.5f; })), float);
  CHECK(pairs == given);

  double largest = -1;
  bool is_rising = true;
  orient(pairs, maps().callback([&](double share) {
    is_rising = is_rising && share >= largest && share <= 1;
    largest = share;
    return true;
  }));
  CHECK(is_rising && largest > 0);

  pairs = given;
  pairs[17].first = Kernel::Point_3(0, nan, 0);
  const auto is_normal_kept = [&]() { return pairs[17].second == given[17].second; };
  CHECK(says(maps(), "point 17 has a coordinate that is not finite"));
  const Report report = orient(pairs, maps() | drop_non_finite(true));
  CHECK(report.number_of_dropped_points == 1 && is_normal_kept());
  pairs.erase(pairs.begin() + 17);
  Cloud rest = sphere;
  rest.normals.erase(rest.normals.begin() + 17);
  CHECK(number_on_side_of(pairs, rest) == pairs.size());
}

/// Far from the origin the result is the same.
void check_utm(const Cloud& cloud, Generator& generator)
{
  const Pairs expected = pairs_of(moved(cloud, {500000, 5400000, 300}));
  Pairs pairs = turned_by_chance(expected, generator);
  orient(pairs);
  CHECK(pairs == expected);
}

void check_point_set(const Cloud& sphere, Generator& generator)
{
  using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
  Point_set points;
  const Pairs pairs = pairs_of(sphere);
  for (const Pair& pair : pairs)
    points.insert(pair.first);
  const auto number_outwards = [&]() {
    std::size_t number = 0, i = 0;
    for (const Point_set::Index& index : points)
      number += points.normal(index) * pairs[i++].second > 0;
    return number;
  };
  CGAL::l0_orient_normals<CGAL::Parallel_if_available_tag>(points, parameters::callback(
                                                                     [](double) { return false; }));
  CHECK(!points.has_normal_map());
  CGAL::l0_orient_normals<CGAL::Parallel_if_available_tag>(points);
  CHECK(points.has_normal_map() && number_outwards() == pairs.size());
  const Pairs turned = turned_by_chance(pairs, generator);
  std::size_t i = 0;
  for (const Point_set::Index& index : points)
    points.normal(index) = turned[i++].second;
  CGAL::l0_orient_normals<CGAL::Sequential_tag>(points);
  CHECK(number_outwards() == pairs.size());
  auto others = points.add_property_map<Kernel::Vector_3>("others", CGAL::NULL_VECTOR).first;
  CGAL::l0_orient_normals<CGAL::Sequential_tag>(
    points, parameters::normal_map(others) | parameters::viewpoint(Kernel::Point_3(0, 0, 0)));
  CHECK(number_outwards() == pairs.size());
  CHECK(std::all_of(points.begin(), points.end(), [&](const Point_set::Index index) {
    return get(others, index) * points.normal(index) < -0.9;
  }));
}

} // namespace

int main()
{
  Generator generator(11);
  const Cloud sphere = evenly(1500, [&](std::size_t n) { return sphere_points(n, 1, generator); });
  check_shape(sphere, generator);
  check_shape(evenly(1500, [&](std::size_t n) { return torus_points(n, generator); }), generator);
  check_shape(evenly(2000, [&](std::size_t n) { return cube_points(n, 2, generator); }), generator);
  {
    const Cloud plates = two_plates(8000, generator);
    Pairs pairs = turned_by_chance(pairs_of(plates), generator);
    orient(pairs);
    for (std::size_t sheet = 0; sheet < 4; ++sheet) // each as a whole
    {
      std::size_t number = 0;
      for (std::size_t i = sheet; i < pairs.size(); i += 4)
        number += pairs[i].second.z() > 0;
      CHECK(number == 0 || number == pairs.size() / 4);
    }
  }
  check_normals_of_any_length(sphere, generator);
  check_order_and_threads(turned_by_chance(pairs_of(sphere), generator), generator);
  check_coincident_points(sphere, generator);
  check_outliers(evenly(3000, [&](std::size_t n) { return sphere_points(n, 1, generator); }),
                 generator);
  check_noise(generator);
  check_thin_profile(generator);
  check_leaning_normals(generator);
  check_scales(generator);
  check_hints(sphere, generator);
  check_hints_of_coincident_points(generator);
  check_few_points();
  check_refusals(sphere, generator);
  check_utm(sphere, generator);
  check_point_set(sphere, generator);
  return result();
}
