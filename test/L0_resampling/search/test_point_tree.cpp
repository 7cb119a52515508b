// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The nearest points, against a search of all of them: ties by index, duplicates, coordinates of
// any size.

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/search/nearest_input_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace test;

namespace {

using CGAL::L0_resampling::Near_points;
using Candidate = Point_tree_3::Candidate;

template <typename ConcurrencyTag = CGAL::Sequential_tag>
Point_tree_3 tree_of(const std::vector<Vector>& points)
{
  Buffer<Index> indices;
  for (Index i = 0; i < points.size(); ++i)
    indices.push_back(i);
  return Point_tree_3(ConcurrencyTag(), to_buffer(points), indices);
}

void check_nearest(const std::vector<Vector>& points, const std::vector<Vector>& queries,
                   std::size_t k)
{
  const Point_tree_3 tree = tree_of(points);
  std::vector<Candidate> found(k), expected;
  bool are_nearest = true;
  for (const Vector& query : queries)
  {
    expected.clear();
    for (Index i = 0; i < points.size(); ++i)
      expected.emplace_back((points[i] - query).squaredNorm(), i);
    std::sort(expected.begin(), expected.end());
    const std::size_t size = tree.find_nearest(query, k, found.data());
    are_nearest = are_nearest && size == (std::min)(k, points.size());
    for (std::size_t n = 0; n < size; ++n)
      are_nearest = are_nearest && found[n].second == expected[n].second;
  }
  CHECK(are_nearest);
}

std::vector<Vector> random_points(std::size_t n, Generator& generator)
{
  std::vector<Vector> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back(random_number(0.1, 1, generator) * random_unit_vector(generator));
  return points;
}

/// More than one thread builds alone.
void test_tree_of_all_threads(Generator& generator)
{
  const std::vector<Vector> points = random_points(100000, generator),
                            queries = random_points(2000, generator);
  const Point_tree_3 by_one = tree_of(points),
                     by_all = tree_of<CGAL::Parallel_if_available_tag>(points);
  const std::size_t k = 5;
  std::vector<Candidate> expected(k), found(k);
  std::size_t number_of_others = 0;
  for (const Vector& query : queries)
  {
    by_one.find_nearest(query, k, expected.data());
    number_of_others += by_all.find_nearest(query, k, found.data()) != k || found != expected;
  }
  CHECK(number_of_others == 0);
  bool are_all_there = true;
  for (Index i = 0; i < points.size(); ++i)
    are_all_there = are_all_there && by_all.find_nearest(points[i], 1, found.data()) == 1
                    && found[0] == Candidate(0, i);
  CHECK(are_all_there);
}

/// Small integers, so that many distances are equal; not in the order of their coordinates.
std::vector<Vector> lattice(Generator& generator)
{
  std::vector<Vector> points;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -2; z <= 2; ++z)
        points.emplace_back(x, y, z);
  std::shuffle(points.begin(), points.end(), generator);
  return points;
}

/// A few places with up to 40 points each, which more than one leaf of the tree holds.
std::vector<Vector> crowded_places(Generator& generator)
{
  std::vector<Vector> points;
  std::size_t crowd = 1;
  for (const Vector& place : random_points(40, generator))
    points.insert(points.end(), crowd++, place);
  std::shuffle(points.begin(), points.end(), generator);
  return points;
}

/// Of a place that holds many points the ones with the smallest indices are nearest, and it is not
/// searched point by point.
void test_crowd(Generator& generator)
{
  std::vector<Vector> points = random_points(50, generator);
  const std::size_t first = points.size(), n = 200000;
  points.insert(points.end(), n, Vector(2, 0, 0));
  const Point_tree_3 tree = tree_of(points);
  std::vector<Candidate> found(3);
  bool is_first = true;
  for (std::size_t query = 0; query < n; ++query) // one by one in the crowd this would take hours
  {
    tree.find_nearest(Vector(2, 0, 0), 3, found.data());
    for (Index n = 0; n < 3; ++n)
      is_first = is_first && found[n] == Candidate(0, Index(first) + n);
  }
  CHECK(is_first);
}

void test_means()
{
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<Vector> points = {{0, 0, 0}, {1, 0, 0}, {0, 3, 0}};
  const Point_tree_3 tree = tree_of(points);
  Unwatched unwatched;
  Near_points near;
  near.count = 4; // more than there are
  nearest_input_points<CGAL::Sequential_tag, double>(
    tree, Buffer<std::array<double, 3>>{{0.5, 0, 0}, {0.1, 0, 0}, {0, 2.9, 0}}, unwatched.progress,
    near);
  CHECK(near.nearest(0) == 0 && near.nearest(1) == 0 && near.nearest(2) == 2);
  const auto mean = [&](std::size_t i, float a, float b, float c) {
    const std::array<float, 3> values = {a, b, c};
    return near.mean(i, [&](Index j) { return double(values[j]); });
  };
  CHECK(mean(0, 0, 1, 0.5f)
        == 0.5); // as far from the first as from the second, and the third is in the middle
  CHECK(mean(1, 0, 1, 0) > 0 && mean(1, 0, 1, 0) < 0.5);
  CHECK(mean(1, 0.1f, 0.1f, 0.1f) == double(0.1f));
  CHECK(mean(1, infinity, 7, infinity) == 7); // what is not finite does not count
  CHECK(mean(1, infinity, infinity, infinity) == double(infinity));

  Near_points parallel;
  parallel.count = 4;
  nearest_input_points<CGAL::Parallel_if_available_tag, double>(
    tree, Buffer<std::array<double, 3>>{{0.5, 0, 0}, {0.1, 0, 0}, {0, 2.9, 0}}, unwatched.progress,
    parallel);
  CHECK(parallel.indices == near.indices && parallel.weights == near.weights);
}

} // namespace

int main()
{
  Generator generator(1);
  const std::vector<Vector> cloud = random_points(1000, generator),
                            queries = random_points(200, generator);
  for (std::size_t k : {1, 8, 1001})
    check_nearest(cloud, queries, k);
  check_nearest({Vector(1, 2, 3)}, queries, 2);
  const std::vector<Vector> grid = lattice(generator);
  std::vector<Vector> halves = grid;
  for (std::size_t i = 0; i < halves.size(); ++i)
    halves[i] += Vector(i % 2, i / 2 % 2, i / 4 % 2) / 2;
  for (std::size_t k : {1, 8})
  {
    check_nearest(grid, grid, k);
    check_nearest(grid, halves, k);
  }
  std::vector<Vector> twice = cloud;
  twice.insert(twice.end(), cloud.rbegin(), cloud.rend());
  check_nearest(twice, queries, 1);
  check_nearest(crowded_places(generator), queries, 8);
  for (double scale : {1e-300, 1e300}) // whose squares are not numbers
  {
    std::vector<Vector> scaled = cloud;
    for (Vector& p : scaled)
      p *= scale;
    const Point_tree_3 tree = tree_of(scaled);
    Candidate found;
    bool is_itself = true;
    for (Index i = 0; i < scaled.size(); ++i)
      is_itself = is_itself && tree.find_nearest(scaled[i], 1, &found) == 1
                  && found == Candidate(0, i);
    CHECK(is_itself);
  }
  test_tree_of_all_threads(generator);
  test_crowd(generator);
  test_means();
  return result();
}
