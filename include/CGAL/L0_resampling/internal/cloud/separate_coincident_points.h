// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SEPARATE_COINCIDENT_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SEPARATE_COINCIDENT_POINTS_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_sort.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Whether two points are equal: true whenever they are, and next to never when they are not.
/// Sorting one number a point is a tenth of the work of sorting the points.
template <typename ConcurrencyTag, typename FT>
bool may_have_equal_points(const Buffer<std::array<FT, 3>>& points)
{
  Buffer<std::size_t> hashes(points.get_allocator());
  hashes.reserve(points.size());
  for_each_in_order(points.size(), [&](std::size_t i) {
    hashes.push_back(boost::hash_range(points[i].begin(), points[i].end()));
  });
  sort_by_key<ConcurrencyTag>(
    hashes, [](std::size_t hash) -> std::uint64_t { return hash; },
    [](std::size_t, std::size_t) { return false; });
  return std::adjacent_find(hashes.begin(), hashes.end()) != hashes.end();
}

/// Makes points that are equal, after rounding to the caller's number type, differ by a few units
/// in the last place: no two results may be one. They fall together where a radius reaches the
/// whole cloud, or where `float` is too coarse for UTM coordinates.
/// \param points finite; those that coincide with an earlier one in lexicographic order of
/// (coordinates, index) are moved
/// \param low, high corners of the box that they have to stay in, where it has room
/// \param length below which coordinates count as zero: its rounding is the least step; may be
/// infinite
template <typename ConcurrencyTag, typename FT>
void separate_coincident_points(const std::array<FT, 3>& low, const std::array<FT, 3>& high,
                                FT length, Buffer<std::array<FT, 3>>& points)
{
  if (!may_have_equal_points<ConcurrencyTag>(points))
    return;
  using Point = std::array<FT, 3>;
  const auto allocator = points.get_allocator();
  Buffer<std::size_t> order(allocator);
  order.reserve(points.size());
  for_each_in_order(points.size(), [&](std::size_t i) { order.push_back(i); });
  const auto comes_first = [&](std::size_t a, std::size_t b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  };
  std::size_t number_of_comparisons = 0;
  std::sort(order.begin(), order.end(), watched_order(comes_first, number_of_comparisons));

  const auto coincides = [&](std::size_t k) {
    return k > 0 && points[order[k]] == points[order[k - 1]];
  };
  Buffer<std::size_t> to_move(allocator);
  for_each_in_order(order.size(), [&](std::size_t k) {
    if (coincides(k))
      to_move.push_back(order[k]);
  });
  if (to_move.empty())
    return;

  // Each group takes the nodes of a lattice around its place, one after the other, and skips those
  // that are taken, and those beyond the largest number.
  const auto is_finite = [](const Point& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  std::set<Point> taken;
  for_each_in_order(order.size(),
                    [&](std::size_t k) { taken.insert(taken.end(), points[order[k]]); });
  Point place = points[to_move.front()];
  std::size_t node = 0;
  for (std::size_t i : to_move)
  {
    poll_for_cancellation();
    if (points[i] != place)
    {
      place = points[i];
      node = 0;
    }
    Point step;
    std::array<int, 3> bits; // an axis has room for 2^bits nodes
    std::array<std::size_t, 3> steps_to_nearer_side;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const FT size = (std::max)({std::abs(place[a]), length, (std::numeric_limits<FT>::min)()});
      step[a] = 2 * std::numeric_limits<FT>::epsilon()
                * (std::min)(size, (std::numeric_limits<FT>::max)());
      const auto room = [&](FT distance) {
        const FT many = FT(1 << 20);
        return std::size_t((std::max)((std::min)(distance / step[a], many), FT(0)));
      };
      const std::size_t above = room(high[a] - place[a]), below = room(place[a] - low[a]);
      bits[a] = std::ilogb(double(above + below + 1));
      steps_to_nearer_side[a] = (std::min)(above, below);
      if (above < below)
        step[a] = -step[a];
    }
    const int maximum_number_of_bits = *std::max_element(bits.begin(), bits.end());
    Point moved;
    do
    {
      ++node;
      // nodes 0, 1, -1, 2, -2 ... of each axis up to the nearer side of the box, those of the other
      // side after that; the counter's bits go round the axes that have room for one more, so that
      // the lattice grows evenly, and round all axes once the box is full
      std::array<std::size_t, 3> coordinates{};
      std::size_t rest = node;
      for (int bit = 0; rest > 0; ++bit)
        for (std::size_t a = 0; a < 3; ++a)
          if (bit < bits[a] || bit >= maximum_number_of_bits)
          {
            coordinates[a] |= (rest & 1) << bit;
            rest >>= 1;
          }
      for (std::size_t a = 0; a < 3; ++a)
      {
        const std::size_t node_of_axis = coordinates[a], nearer = steps_to_nearer_side[a];
        const bool is_on_both_sides = node_of_axis <= 2 * nearer;
        const FT steps = is_on_both_sides
                           ? FT((node_of_axis + 1) / 2) * (node_of_axis % 2 ? FT(1) : FT(-1))
                           : FT(node_of_axis - nearer);
        moved[a] = place[a] + steps * step[a];
      }
    } while (!is_finite(moved) || !taken.insert(moved).second);
    points[i] = moved;
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SEPARATE_COINCIDENT_POINTS_H
