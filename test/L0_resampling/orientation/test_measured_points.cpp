// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What orienting does for points as they were measured and not for samples: heights are compared
// with the spacing and the noise around each point, and points turn where neighbors outvote them.

#include "orientation/orientation_support.h"

#include <CGAL/L0_resampling/internal/orientation/orient_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

using namespace test;

/// The middle one of an odd number of them, between the two middle ones of an even number.
void check_median(Generator& generator)
{
  CHECK(median_of<float>(0, [](unsigned) { return 1.f; }) == 0);
  CHECK(median_of<float>(5, [](unsigned) { return 0.f; }) == 0);
  for (const std::size_t count : {1, 2, 3, 12, 13, 200})
  {
    std::vector<float> numbers;
    for (std::size_t k = 0; k < count; ++k)
      numbers.push_back(float(random_number(0, 7, generator)));
    const float median = median_of<float>(unsigned(count), [&](unsigned k) { return numbers[k]; });
    std::sort(numbers.begin(), numbers.end());
    const float rounding = 0.001f * numbers.back();
    CHECK(median >= numbers[(count - 1) / 2] - rounding);
    CHECK(median <= numbers[count / 2] + rounding);
  }
}

/// Of an even noisy disk, that of the cloud or its own, whichever is larger; a minority on another
/// face leaves the noise as it is.
void check_tolerance(Generator& generator)
{
  const unsigned count = 2000;
  const float spacing = 0.3f, noise = 0.05f, radius = spacing * std::sqrt(float(count) / 3.14159f);
  std::vector<float> squared_distances, heights;
  for (unsigned k = 0; k < count; ++k)
  {
    squared_distances.push_back(radius * radius * float(random_number(0, 1, generator)));
    heights.push_back(float(std::abs(std::normal_distribution<>(0, noise)(generator))));
  }
  const auto tolerance = [&](float squared_spacing, float squared_noise) {
    return squared_height_tolerance(
      count, [&](unsigned k) { return squared_distances[k]; },
      [&](unsigned k) { return heights[k]; }, squared_spacing, squared_noise);
  };
  const float own = spacing * spacing + 16 * noise * noise;
  CHECK(std::abs(tolerance(0, 0) - own) < 0.1f * own);
  CHECK(tolerance(1, 2) == 3);
  for (unsigned k = 0; k < count / 5; ++k)
    heights[k] = 3 * spacing;
  CHECK(std::abs(tolerance(0, 0) - own) < 0.3f * own);
  const auto nothing = [](unsigned) { return 0.f; };
  CHECK(squared_height_tolerance(0, nothing, nothing, 1.f, 2.f) == 3);
}

/// The ground around a scanner: spacing and noise grow with the distance. Heights there are as
/// large as those of folds.
void check_ground(Generator& generator)
{
  Buffer<Vector> positions, normals;
  for (double radius = 1; radius < 16; radius *= 1.04)
    for (double angle = 0; angle < 2 * EIGEN_PI; angle += 0.04)
    {
      const double turned = angle + random_number(-0.02, 0.02, generator);
      positions.push_back({radius * std::cos(turned), radius * std::sin(turned),
                           std::normal_distribution<>(0, 0.03 * radius)(generator)});
      const Vector normal =
        (Vector(Vector::UnitZ()) + 0.1 * random_unit_vector(generator)).normalized();
      normals.push_back(std::bernoulli_distribution()(generator) ? normal : Vector(-normal));
    }
  const Buffer<Index> order = Search_grid_3::sorted_order<CGAL::Sequential_tag>(positions, 0.5);
  apply_order<CGAL::Sequential_tag>(order, positions);
  apply_order(order, normals);
  Unwatched unwatched;
  orient_normals<CGAL::Parallel_if_available_tag>(positions, 12, 0.05, Side_hints(),
                                                  unwatched.progress, normals, 4 * 0.03);
  const auto number_up = std::size_t(
    std::count_if(normals.begin(), normals.end(), [](const Vector& n) { return n[2] > 0; }));
  CHECK(number_up == 0 || number_up == normals.size());
}

/// Points of one plane in a row, of which some are turned: those that the others outvote turn, in
/// one sweep after the other, and where their neighbors are turned as they are they stay.
void check_outvoted()
{
  const Index m = 12;
  Buffer<Vector> positions, normals;
  for (Index i = 0; i < m; ++i)
    positions.push_back({double(i), 0, 0});
  Unwatched unwatched;
  const auto turned = [&](const std::vector<Index>& joined_wrongly, Index fixed,
                          Index of_another_set, Buffer<Vector>& sums) {
    const Nearest_samples nearest =
      find_nearest_samples<CGAL::Parallel_if_available_tag>(positions, 2, 4, 2, unwatched.progress);
    Signed_union_find sets(m, {});
    for (Index i = 1; i < m; ++i)
      if (i != of_another_set)
        sets.join(0, i, 1);
    normals.assign(m, Vector::UnitZ());
    for (Index i : joined_wrongly)
      normals[i] = -normals[i];
    sums = turn_outvoted<CGAL::Parallel_if_available_tag>(
      positions, nearest, sets, Buffer<double>(m, 1.), [&](Index i) { return i != fixed; },
      normals);
    std::vector<Index> result;
    for (Index i = 0; i < m; ++i)
      if (normals[i][2] < 0)
        result.push_back(i);
    return result;
  };
  using Indices = std::vector<Index>;
  Buffer<Vector> sums;
  CHECK(turned({5}, m, m, sums).empty());
  CHECK(sums[5] == 5 * Vector::UnitZ() && sums[0] == 5 * Vector::UnitZ());
  CHECK(turned({5}, 5, m, sums) == Indices{5});
  CHECK(sums[5] == -Vector::UnitZ());
  // in the first sweep 3 turns as well, between 1, 2 and 5; in the second it turns back
  CHECK(turned({1, 2, 5}, m, m, sums).empty());
  CHECK((turned({6, 7, 8, 9, 10, 11}, m, m, sums) == Indices{6, 7, 8, 9, 10, 11}));
  // what is of another set does not vote, and is not voted on
  CHECK(turned({5}, m, 5, sums) == Indices{5});
}

/// Two points of a plane whose normals lie nearly in it and are nearly opposite: the surest edge of
/// all leads from one to the other, and turns one of them. All others vote for the sides of both.
/// \param hints that leave doubt at these two, or not
/// \returns on which side each one is, relative to the first
std::pair<bool, bool> sides_of_misled_pair(const Side_hints& hints)
{
  Buffer<Vector> positions, normals;
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y)
    {
      positions.push_back({double(x), double(y), 0});
      normals.push_back(Vector::UnitZ());
    }
  const Index first = 210, second = 211;
  const double height = 0.0955, width = std::sqrt(1 - height * height);
  positions[second] = positions[first] + Vector(0, 0.1, 0);
  normals[first] = Vector(width, 0, height);
  normals[second] = Vector(-width, 0, height);
  Unwatched unwatched;
  orient_normals<CGAL::Parallel_if_available_tag>(positions, 12, 1, hints, unwatched.progress,
                                                  normals, 100.);
  return {normals[first][2] * normals[0][2] > 0, normals[second][2] * normals[0][2] > 0};
}

void check_misled_pair()
{
  CHECK((sides_of_misled_pair(Side_hints()) == std::pair(true, true)));
  Side_hints hints; // the first shows the viewpoint its back
  hints.direction_of = [](Index i) -> Vector {
    return i == 210 ? Vector(-Vector::UnitX()) : Vector(Vector::UnitZ());
  };
  hints.are_viewpoints = true;
  CHECK((sides_of_misled_pair(hints) == std::pair(false, true)));
}

int main()
{
  Generator generator(1);
  check_median(generator);
  check_tolerance(generator);
  check_ground(generator);
  check_outvoted();
  check_misled_pair();
  return result();
}
