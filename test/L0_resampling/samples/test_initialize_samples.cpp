// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/initialize_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <vector>

using namespace test;

const double radius = 0.4;

/// What the stage returns, and what it was asked for.
struct Start
{
  Gridded_points input;
  std::vector<Vector> positions;
  std::vector<Vector> sources; ///< the input point of each sample

  /// \param areas what each point of the cloud stands for; none, for all alike
  Start(const Oriented_points& cloud, std::size_t number_of_samples, std::uint64_t seed,
        const std::vector<double>& areas = {}, double isolated_radius = radius)
    : input(cloud.points, radius / 2)
  {
    Unwatched unwatched;
    std::optional<std::uint64_t> total;
    const Initial_samples samples = start_samples<CGAL::Parallel_if_available_tag>(
      input.grid, input.points, to_local_vectors<float>(permuted(input.order, cloud.normals)), {},
      sources_of_samples(distinct_points(input.points), areas_in_order(areas), number_of_samples,
                         seed, total),
      radius, isolated_radius, seed, unwatched.progress);
    positions.assign(samples.positions.begin(), samples.positions.end());
    for (Index j : samples.sources)
      sources.push_back(input.vector[j]);
  }

  Buffer<std::uint64_t> areas_in_order(const std::vector<double>& areas) const
  {
    Buffer<std::uint64_t> result;
    if (!areas.empty())
      for (Index i : input.order)
        result.push_back(std::uint64_t(areas[i]));
    return result;
  }
};

using Key = std::array<double, 3>;
Key key(const Vector& p) { return {p[0], p[1], p[2]}; }

std::set<Key> distinct(const std::vector<Vector>& points)
{
  std::set<Key> keys;
  for (const Vector& p : points)
    keys.insert(key(p));
  return keys;
}

/// Whatever number is asked for comes, and no two samples are one; up to the number of distinct
/// points each starts on one of them.
void check_counts(const Oriented_points& cloud)
{
  const std::set<Key> places = distinct(cloud.points);
  for (std::size_t n : {std::size_t(1), std::size_t(2), std::size_t(37), places.size() / 2,
                        places.size() - 1, places.size(), places.size() + 1, cloud.points.size(),
                        2 * places.size(), 5 * places.size() + 3})
  {
    const Start start(cloud, n, 0);
    CHECK(start.positions.size() == n && start.sources.size() == n);
    CHECK(distinct(start.positions).size() == n);
    std::size_t number_on_sources = 0, number_near_sources = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      number_on_sources += start.positions[i] == start.sources[i];
      number_near_sources += (start.positions[i] - start.sources[i]).norm() < radius / 2;
    }
    CHECK(number_on_sources == (std::min)(n, places.size()));
    CHECK(number_near_sources == n);
    // sorted, as the next stages need them
    CHECK(Gridded_points(start.positions, radius / 2).vector == start.positions);
  }
}

/// The choice is that of the points and not of the order they came in.
void check_order(Oriented_points cloud, Generator& generator)
{
  for (std::size_t n : {100, 900})
  {
    const std::vector<Vector> positions = Start(cloud, n, 7).positions;
    for (std::size_t j = cloud.points.size() - 1; j > 0; --j)
    {
      const std::size_t k = std::uniform_int_distribution<std::size_t>(0, j)(generator);
      std::swap(cloud.points[j], cloud.points[k]);
      std::swap(cloud.normals[j], cloud.normals[k]);
    }
    CHECK(Start(cloud, n, 7).positions == positions);
  }
}

/// Another seed is another choice, the same seed the same.
void check_seeds(const Oriented_points& cloud)
{
  for (std::size_t n : {100, 900})
  {
    std::set<std::set<Key>> choices;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
      choices.insert(distinct(Start(cloud, n, seed).positions));
    CHECK(choices.size() == 20);
    CHECK(Start(cloud, n, 5).positions == Start(cloud, n, 5).positions);
  }
}

/// Samples are spread as the points are: each part of the cloud gets its share of them.
void check_spread(const Oriented_points& cloud)
{
  for (std::size_t n : {200, 400, 1500})
  {
    const Start start(cloud, n, 1);
    const std::set<Key> places = distinct(cloud.points);
    for (int part = 0; part < 8; ++part)
    {
      const auto is_in_part = [&](const Key& p) {
        return (p[0] > 0) + 2 * (p[1] > 0) + 4 * (p[2] > 0) == part;
      };
      std::size_t count = 0;
      for (const Vector& p : start.sources)
        count += is_in_part(key(p));
      const double share = double(std::count_if(places.begin(), places.end(), is_in_part))
                           / double(places.size());
      CHECK(std::abs(double(count) / double(n) - share) < 0.04);
    }
  }
}

/// Where more samples are asked for than there are places, the others start on the way from their
/// source to a point of its ball with a similar normal: on a cube, inside its faces and not across
/// its edges.
void check_upsampling(Generator& generator)
{
  const Oriented_points cube = cube_points(600, 2, generator);
  std::map<Key, Vector> normals;
  for (std::size_t j = 0; j < cube.points.size(); ++j)
    normals[key(cube.points[j])] = cube.normals[j];
  const Start start(cube, 1800, 0);
  bool are_on_faces = true, are_between = true;
  for (std::size_t i = 0; i < 1800; ++i)
  {
    const Vector way = start.positions[i] - start.sources[i],
                 normal = normals[key(start.sources[i])];
    are_on_faces = are_on_faces && std::abs(normal.dot(way)) < 1e-12;
    if (start.positions[i] == start.sources[i])
      continue;
    const auto is_on_way = [&](const Vector& partner) {
      const Vector whole = partner - start.sources[i];
      const double share = way.norm() / whole.norm();
      return whole.norm() < radius && share > 0.19 && share < 0.46
             && (share * whole - way).norm() < 1e-12;
    };
    are_between = are_between && std::any_of(cube.points.begin(), cube.points.end(), is_on_way);
  }
  CHECK(are_on_faces);
  CHECK(are_between);
}

/// They stay on their face of a wall, though its other face lies in the same balls and has similar
/// normals, and so they do where the normal of the source is wrong.
void check_walls(Generator& generator)
{
  Oriented_points wall = plane_points(800, 2, generator);
  const double thickness = 0.7 * radius;
  for (std::size_t j = 0; j < wall.points.size(); ++j)
  {
    if (j % 2 == 1)
      wall.points[j].z() = thickness;
    wall.normals[j] = j % 3 == 0 ? Vector(-Vector::UnitZ()) : Vector(Vector::UnitZ());
  }
  wall.normals[0] = Vector(0, 0.8, 0.6);
  wall.normals[1] = Vector::UnitX();
  const Start start(wall, 4000, 0);
  bool are_on_faces = true;
  std::array<std::size_t, 2> numbers_of_wrong_normals{0, 0};
  for (std::size_t i = 0; i < start.positions.size(); ++i)
  {
    are_on_faces = are_on_faces && start.positions[i].z() == start.sources[i].z();
    for (std::size_t j = 0; j < 2; ++j)
      numbers_of_wrong_normals[j] += start.sources[i] == wall.points[j];
  }
  CHECK(are_on_faces);
  CHECK(numbers_of_wrong_normals[0] > 1 && numbers_of_wrong_normals[1] > 1);
}

/// With areas, samples are spread as the area is: each point gets as many as its own is worth, up
/// to one, and no two are one.
void check_areas(Generator& generator)
{
  Oriented_points cloud = plane_points(2000, 2, generator);
  std::vector<double> areas;
  double total = 0;
  for (const Vector& p : cloud.points)
  {
    areas.push_back(p[0] < 0 ? 1e6 : 9e6);
    total += areas.back();
  }
  for (std::size_t n : {1, 300, 1500, 6000})
  {
    const Start start(cloud, n, 3, areas);
    CHECK(start.positions.size() == n && distinct(start.positions).size() == n);
    CHECK(Gridded_points(start.positions, radius / 2).vector == start.positions);
    std::map<Key, int> counts;
    for (const Vector& p : start.sources)
      ++counts[key(p)];
    bool are_fair = true;
    double worst = 0, sum = 0, counted = 0;
    const Gridded_points& input = start.input;
    for (std::size_t i = 0; i < input.vector.size(); ++i)
    {
      const double share = double(n) * areas[input.order[i]] / total,
                   count = counts[key(input.vector[i])];
      are_fair = are_fair
                 && std::abs(count - share)
                      < 2; // the ends of its part may lie inside two more thresholds' parts
      sum += share;
      counted += count;
      worst = (std::max)(worst, std::abs(counted - sum)); // nor do the differences add up
    }
    CHECK(are_fair);
    CHECK(worst < 1.001);
  }
}

/// Around a lone point samples start within its ball and its plane, wherever the others are.
void check_lone_points()
{
  const Vector x = Vector::UnitX(), z = Vector::UnitZ();
  Oriented_points cloud{{Vector(0, 0, 0), Vector(0.1, 0, 0), Vector(7, 0, 0)}, {z, z, x}};
  std::set<Key> around_lone;
  for (const double place : {1., 50., 100.})
  {
    cloud.points[1] = Vector(place, 0, 0);
    for (std::size_t n : {4, 9, 90})
    {
      const Start start(cloud, n, 0);
      CHECK(distinct(start.positions).size() == n);
      Vector least = Vector::Zero(), largest = Vector::Zero();
      std::set<Key> around_last;
      for (std::size_t i = 0; i < n; ++i)
      {
        const Vector way = start.positions[i] - start.sources[i];
        const bool is_last = start.sources[i] == cloud.points[2];
        CHECK(std::abs(way.dot(is_last ? x : z)) < 1e-12 && way.norm() < radius / 2);
        CHECK(way.norm() == 0 || way.norm() > 0.19 * radius);
        least = least.cwiseMin(way);
        largest = largest.cwiseMax(way);
        if (is_last)
          around_last.insert(key(start.positions[i]));
      }
      if (n < 90)
        continue;
      CHECK(least.maxCoeff() < -radius / 4 && largest.minCoeff() > radius / 4); // all around
      if (place == 50.)
        around_lone = around_last;
      else if (place == 100.)
        CHECK(around_last == around_lone);
    }
  }
}

/// All samples of a single place start on it.
void check_single_place()
{
  const Oriented_points place{std::vector<Vector>(5, Vector(1, 2, 3)),
                              std::vector<Vector>(5, Vector::UnitX())};
  for (std::size_t n : {1, 5, 12})
  {
    const Start start(place, n, 0, {}, 0);
    CHECK(start.positions == std::vector<Vector>(n, Vector(1, 2, 3)));
  }
}

/// Where samples start of a cloud does not depend on the parts that it comes in.
void check_parts(Generator& generator)
{
  Buffer<Index> distinct;
  Buffer<std::uint64_t> areas;
  for (Index i = 0; i < 1000; ++i)
  {
    areas.push_back(std::uniform_int_distribution<std::uint64_t>(1, 1000)(generator));
    if (i % 3 != 1)
      distinct.push_back(i);
  }
  const auto sources = [&](std::uint64_t m, bool by_area, const std::vector<std::size_t>& ends) {
    std::uint64_t total = 0;
    for (const Index i : distinct)
      total += areas[i];
    Sources result;
    std::uint64_t sum = 0;
    std::size_t begin = 0;
    for (const std::size_t end : ends)
    {
      const Buffer<Index> part(distinct.begin() + std::ptrdiff_t(begin),
                               distinct.begin() + std::ptrdiff_t(end));
      if (by_area)
        add_sources_by_area(part, areas, sum, total, m, 3, result);
      else
        add_sources_by_points(part, begin, distinct.size(), m, 3, result);
      for (const Index i : part)
        sum += areas[i];
      begin = end;
    }
    return result;
  };
  for (const std::uint64_t m : {1u, 5u, 300u, 667u, 668u, 2000u, 5001u})
    for (const bool by_area : {false, true})
    {
      const Sources whole = sources(m, by_area, {distinct.size()});
      CHECK(whole.on_points.size() + whole.near_points.size() == m);
      for (const std::vector<std::size_t>& ends : {std::vector<std::size_t>{1, distinct.size()},
                                                   {0, 17, 18, 400, distinct.size()},
                                                   {distinct.size() - 1, distinct.size()}})
      {
        const Sources parts = sources(m, by_area, ends);
        CHECK(parts.on_points == whole.on_points);
        CHECK(parts.near_points == whole.near_points);
      }
    }
}

int main()
{
  Generator generator(9);
  Oriented_points cloud = sphere_points(500, 1, generator);
  for (int n = 0; n < 100; ++n) // duplicates
  {
    cloud.points.push_back(cloud.points[std::size_t(n % 10)]);
    cloud.normals.push_back(cloud.normals[std::size_t(n % 10)]);
  }
  check_counts(cloud);
  check_order(cloud, generator);
  check_seeds(cloud);
  check_spread(cloud);
  check_upsampling(generator);
  check_walls(generator);
  check_areas(generator);
  check_parts(generator);
  check_lone_points();
  check_single_place();
  return result();
}
