// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which blocks can hold the points nearest to a place: all that do, and no more than numbers tell.

#include "test_support.h"

#include "tiles/Nearest_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace l0_tool;
using namespace test;
using CGAL::L0_resampling::Block_lattice;

namespace {

using Counted_blocks = std::vector<std::pair<Block, std::uint64_t>>;
using Place = std::array<double, 3>;

/// A crowd, a few strays around it, and some far away.
std::vector<Place> places(std::size_t size, std::mt19937& generator)
{
  std::vector<Place> result;
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double scale = i % 10 == 0 ? 12 : i % 31 == 0 ? 300 : 2;
    result.push_back({scale * normal(generator), scale * normal(generator), normal(generator)});
  }
  return result;
}

Block block_of(const Place& place) { return Block_lattice(0).block_of(place); }

Counted_blocks blocks_of(const std::vector<Place>& points)
{
  std::map<Block, std::uint64_t> counts;
  for (const Place& point : points)
    ++counts[block_of(point)];
  return {counts.begin(), counts.end()};
}

double squared_distance(const Place& a, const Place& b)
{
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

std::set<Block> found(const Counted_blocks& blocks, std::uint64_t k, const Block& block)
{
  std::set<Block> result;
  Nearest_blocks(blocks, k).for_each(block, [&](std::size_t i) {
    CHECK(result.insert(blocks[i].first).second);
  });
  return result;
}

/// As the definition says.
std::set<Block> expected(const Counted_blocks& blocks, std::uint64_t k, const Block& block)
{
  const auto squared = [&](const Block& other, double margin) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum += std::pow((std::max)(std::abs(double(block[axis] - other[axis])) + margin, 0.), 2);
    return sum;
  };
  Counted_blocks sorted = blocks;
  std::sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) {
    return squared(a.first, 1) < squared(b.first, 1);
  });
  std::uint64_t number = 0;
  std::size_t last = 0;
  while (last < sorted.size() && (number += sorted[last].second) < k)
    ++last;
  std::set<Block> result;
  for (const auto& [other, count] : blocks)
    if (last == sorted.size() || squared(other, -1) <= squared(sorted[last].first, 1))
      result.insert(other);
  return result;
}

} // namespace

int main()
{
  std::mt19937 generator(4);
  bool are_as_defined = true, have_nearest = true;
  std::size_t most = 0, least = 1000000;
  for (const std::size_t size : {1, 7, 8, 300, 3000})
  {
    const std::vector<Place> points = places(size, generator);
    const Counted_blocks blocks = blocks_of(points);
    for (const Place& place : places(60, generator))
      for (const std::size_t k : {1, 8})
      {
        const std::set<Block> some = found(blocks, k, block_of(place));
        are_as_defined = are_as_defined && some == expected(blocks, k, block_of(place));
        std::vector<Place> sorted = points;
        std::sort(sorted.begin(), sorted.end(), [&](const Place& a, const Place& b) {
          return squared_distance(place, a) < squared_distance(place, b);
        });
        for (std::size_t i = 0; i < (std::min)(k, sorted.size()); ++i)
          have_nearest = have_nearest && some.count(block_of(sorted[i])) == 1;
        if (size == 3000)
        {
          most = (std::max)(most, some.size());
          least = (std::min)(least, some.size());
        }
      }
  }
  CHECK(are_as_defined);
  CHECK(have_nearest);
  CHECK(least < most); // places in the crowd need fewer than those far away
  return result();
}
