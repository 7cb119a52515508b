// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORS_OF_TILE_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORS_OF_TILE_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// How many numbers are of which size.
class Histogram
{
  std::map<double, std::uint64_t> m_counts;

public:
  void add(double number, std::uint64_t count = 1) { m_counts[number] += count; }

  Histogram& operator+=(const Histogram& other)
  {
    for (const auto& [number, count] : other.m_counts)
      add(number, count);
    return *this;
  }

  /// How often a number was there.
  struct Count
  {
    double number;
    std::uint64_t count;
  };

  std::vector<Count> sorted_counts() const
  {
    std::vector<Count> counts;
    for (const auto& [number, count] : m_counts)
      counts.push_back({number, count});
    return counts;
  }

  /// As `median_of()`; none if there are no numbers.
  std::optional<double> median() const
  {
    std::uint64_t rank = 0;
    for (const auto& [number, count] : m_counts)
      rank += count;
    rank /= 2;
    for (const auto& [number, count] : m_counts)
    {
      if (rank < count)
        return number;
      rank -= count;
    }
    return std::nullopt;
  }
};

/// Facts of a cloud that follow from the counts of all of its tiles.
struct Medians_of_cloud
{
  std::optional<Range_of_scales> scales;     ///< `Facts_of_cloud::range_of_scales`
  std::optional<double> number_of_neighbors; ///< `Facts_of_cloud::median_number_of_neighbors`
};

/// Of the points of a tile's own, or of all of a cloud.
struct Neighbor_counts
{
  Histogram neighbors; ///< in the balls of `find_outliers()`, if that is asked for
  Histogram scales;    ///< if they follow a field: to within half a percent
  float minimum_scale = (std::numeric_limits<float>::max)(), maximum_scale = 0;

  void add_scale(float scale)
  {
    const double steps_per_octave = 64;
    minimum_scale = (std::min)(minimum_scale, scale);
    maximum_scale = (std::max)(maximum_scale, scale);
    scales.add(std::exp2(std::round(std::log2(scale) * steps_per_octave) / steps_per_octave));
  }

  Neighbor_counts& operator+=(const Neighbor_counts& other)
  {
    neighbors += other.neighbors;
    scales += other.scales;
    minimum_scale = (std::min)(minimum_scale, other.minimum_scale);
    maximum_scale = (std::max)(maximum_scale, other.maximum_scale);
    return *this;
  }

  Medians_of_cloud medians() const
  {
    Medians_of_cloud result;
    result.number_of_neighbors = neighbors.median();
    if (const std::optional<double> median = scales.median())
      result.scales = Range_of_scales{minimum_scale, float(*median), maximum_scale};
    return result;
  }
};

/// What is found of the points of a tile and its halo, once the field of scales is known.
struct Neighbors_of_tile
{
  Neighbor_counts counts; ///< of the tile's own
  Buffer<float> scales;   ///< of all of the points, in their order; none if all are 1

  static constexpr std::size_t bytes_per_point = sizeof(float);
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORS_OF_TILE_H
