// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/separate_coincident_points.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>

using namespace test;

template <typename FT>
using Points = std::vector<std::array<FT, 3>>;

template <typename FT>
struct Box
{
  std::array<FT, 3> low, high;
  FT length; // below which coordinates count as zero

  /// The bounding box, grown on all sides.
  Box(const Points<FT>& points, FT margin)
    : low(points.front()), high(points.front()), length(margin)
  {
    for (const auto& p : points)
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = (std::min)(low[axis], p[axis] - margin);
        high[axis] = (std::max)(high[axis], p[axis] + margin);
      }
  }
};

/// Afterwards all points differ and lie in the box. Points that were alone are as they were, as is
/// one of each group; the others move by at most so many units in the last place.
template <typename FT>
void check_separation(const Points<FT>& points, FT margin, double units)
{
  const Box<FT> box(points, margin);
  Buffer<std::array<FT, 3>> separated(points.begin(), points.end());
  separate_coincident_points<CGAL::Parallel_if_available_tag>(box.low, box.high, box.length,
                                                              separated);
  const std::set<std::array<FT, 3>> before(points.begin(), points.end()),
    after(separated.begin(), separated.end());
  CHECK(separated.size() == points.size());
  CHECK(after.size() == points.size());
  CHECK(std::includes(after.begin(), after.end(), before.begin(), before.end()));

  std::size_t number_of_moved = 0;
  bool are_inside = true, are_near = true;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    number_of_moved += separated[i] != points[i];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const FT size = (std::max)(
        {std::abs(points[i][axis]), margin, (std::numeric_limits<FT>::min)()});
      const FT way = std::abs(separated[i][axis] - points[i][axis]);
      are_inside = are_inside && separated[i][axis] >= box.low[axis]
                   && separated[i][axis] <= box.high[axis];
      are_near = are_near && way <= FT(units) * std::numeric_limits<FT>::epsilon() * size;
    }
  }
  CHECK(number_of_moved == points.size() - before.size());
  CHECK(are_inside);
  CHECK(are_near);
}

template <typename FT>
void check(Generator& generator)
{
  Points<FT> points;
  for (int n = 0; n < 300; ++n)
  {
    const Vector p = random_unit_vector(generator);
    points.push_back({FT(p[0]), FT(p[1]), FT(p[2])});
  }
  check_separation(points, FT(0.1), 0);

  Points<FT> with_duplicates = points;
  for (int n = 0; n < 500; ++n)
    with_duplicates.push_back(points[std::uniform_int_distribution<std::size_t>(0, 99)(generator)]);
  std::shuffle(with_duplicates.begin(), with_duplicates.end(), generator);
  check_separation(with_duplicates, FT(0.1), 8);

  const Points<FT> places{
    {0, 0, 0}, {1, 0, 0}, {448262, 5411932, 35}, {FT(0.999999999), -2, FT(1e-20)}};
  for (const std::array<FT, 3>& place : places)
    check_separation(Points<FT>(3000, place), FT(100), 40); // 15 nodes of the lattice for an axis
  check_separation(Points<FT>(3000, {FT(1e-30), FT(-1e-30), 0}), FT(1e-30), 40);
  check_separation(Points<FT>(3000, {FT(1e30), FT(1e30), FT(-1e30)}), FT(1e30), 40);

  // neighbors in the last place, where a group finds nodes taken
  Points<FT> crowd(50, std::array<FT, 3>{1, 1, 1});
  for (int n = 1; n <= 40; ++n)
    crowd.insert(crowd.end(), 2,
                 std::array<FT, 3>{1 + FT(n) * std::numeric_limits<FT>::epsilon(), 1, 1});
  check_separation(crowd, FT(0.1), 40);
}

/// Where the points are large against the margin, and so the steps, there is room for a way along
/// another axis only.
void check_small_boxes()
{
  for (std::size_t n : {3, 10, 3000})
    check_separation(Points<float>(n, {456075, 5935300, 120}), 0.28f, 1e5);
  check_separation(Points<float>(100, {0, 0, 0}), 1e-41f, 1e3); // a margin of few digits
}

/// In a corner of the box, or a few steps from it, all ways but those few lead inwards, and there
/// is room enough.
template <typename FT>
void check_corners()
{
  const std::array<FT, 3> corners[2] = {{-1, 2, -3}, {5, 4, 0}};
  for (int corner = 0; corner < 16; ++corner)
  {
    const FT inset = corner < 8 ? FT(0) : 16 * std::numeric_limits<FT>::epsilon();
    const auto coordinate = [&](std::size_t axis, int side) {
      return corners[side][axis] + (side == 0 ? inset : -inset);
    };
    const std::array<FT, 3> place{coordinate(0, corner % 2), coordinate(1, corner / 2 % 2),
                                  coordinate(2, corner / 4 % 2)};
    Buffer<std::array<FT, 3>> points(3000, place);
    separate_coincident_points<CGAL::Parallel_if_available_tag>(corners[0], corners[1], FT(1),
                                                                points);
    CHECK((std::set<std::array<FT, 3>>(points.begin(), points.end()).size() == points.size()));
    CHECK(std::all_of(points.begin(), points.end(), [&](const std::array<FT, 3>& p) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (p[axis] < corners[0][axis] || p[axis] > corners[1][axis])
          return false;
      return true;
    }));
  }
}

/// More points than the box has numbers come to lie next to it, and not a million units away.
void check_full_box()
{
  const double margin = 4 * std::numeric_limits<double>::epsilon();
  Buffer<std::array<double, 3>> points(3000, std::array<double, 3>{1, 1, 1});
  separate_coincident_points<CGAL::Parallel_if_available_tag>(
    {1 - margin, 1 - margin, 1 - margin}, {1 + margin, 1 + margin, 1 + margin}, margin, points);
  CHECK((std::set<std::array<double, 3>>(points.begin(), points.end()).size() == points.size()));
  for (const std::array<double, 3>& p : points)
    for (double x : p)
      CHECK(std::abs(x - 1) <= 10 * margin);
}

/// At the largest number there is one way only, whether the box has room or not, and a radius may
/// be no number any more.
template <typename FT>
void check_largest_numbers()
{
  const FT largest = (std::numeric_limits<FT>::max)();
  const FT infinity = std::numeric_limits<FT>::infinity();
  const auto check_box = [&](FT low, FT length) {
    Buffer<std::array<FT, 3>> points(200, std::array<FT, 3>{largest, largest, -largest});
    separate_coincident_points<CGAL::Parallel_if_available_tag>(
      {low, low, -largest}, {largest, largest, -low}, length, points);
    CHECK((std::set<std::array<FT, 3>>(points.begin(), points.end()).size() == points.size()));
    for (const std::array<FT, 3>& p : points)
      for (FT x : p)
        CHECK(std::isfinite(x));
  };
  check_box(-largest, infinity);
  check_box(-largest, largest);
  check_box(largest, FT(1));
}

/// Where the points stand in the array does not matter to what comes out.
void check_order(Generator& generator)
{
  Points<double> points(100, std::array<double, 3>{1, 2, 3});
  points.insert(points.end(), 50, std::array<double, 3>{-1, 0, 0});
  const Box<double> box(points, 1);
  std::set<std::set<std::array<double, 3>>> results;
  for (int n = 0; n < 5; ++n)
  {
    std::shuffle(points.begin(), points.end(), generator);
    Buffer<std::array<double, 3>> separated(points.begin(), points.end());
    separate_coincident_points<CGAL::Parallel_if_available_tag>(box.low, box.high, box.length,
                                                                separated);
    results.emplace(separated.begin(), separated.end());
  }
  CHECK(results.size() == 1);

  Buffer<std::array<double, 3>> none;
  separate_coincident_points<CGAL::Parallel_if_available_tag>(box.low, box.high, box.length, none);
  CHECK(none.empty());
}

int main()
{
  Generator generator(12);
  check<double>(generator);
  check<float>(generator);
  check_order(generator);
  check_small_boxes();
  check_corners<double>();
  check_corners<float>();
  check_full_box();
  check_largest_numbers<double>();
  check_largest_numbers<float>();
  return result();
}
