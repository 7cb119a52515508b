// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_OF_SOURCE_H
#define CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_OF_SOURCE_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/tiles/Counted_cloud.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The coordinate of a rank on an axis, of points that are read twice: the blocks tell in which
/// layer of them it is, the first look in which part of that layer, and the second the coordinate.
class Coordinate_of_rank
{
  std::size_t m_axis;
  std::uint64_t m_rank; // within the layer, and then within the part
  std::int64_t m_layer;
  double m_low, m_parts_per_length;
  std::vector<std::uint64_t> m_counts; // of the parts
  std::size_t m_part = 0;
  std::map<double, std::uint64_t> m_counts_of_values; // of the part

  /// The first of them, in their order, whose count is more than the rank says; the rank among it.
  template <typename Counted, typename CountOf>
  auto place_of_rank(const Counted& counted, const CountOf& count_of)
  {
    auto place = counted.begin();
    for (; place != counted.end() && m_rank >= count_of(*place); ++place)
      m_rank -= count_of(*place);
    if (place == counted.end())
      throw std::invalid_argument("l0_resample_tiles: the source has changed");
    return place;
  }

  std::size_t part_of(const std::array<double, 3>& point) const
  {
    const double place = (point[m_axis] - m_low) * m_parts_per_length;
    return std::size_t((std::min)((std::max)(place, 0.), double(m_counts.size() - 1)));
  }

public:
  /// \param rank less than the number of points
  Coordinate_of_rank(const Counted_cloud& cloud, std::size_t axis, std::uint64_t rank)
    : m_axis(axis), m_rank(rank), m_counts(std::size_t(1) << 16, 0)
  {
    std::map<std::int64_t, std::uint64_t> layers;
    for (const auto& [block, count] : cloud.blocks())
      layers[block[axis]] += count;
    m_layer = place_of_rank(layers, [](const auto& layer) { return layer.second; })->first;
    m_low = double(m_layer) * cloud.lattice().side();
    m_parts_per_length = double(m_counts.size()) / cloud.lattice().side();
  }

  void count(const Block& block, const std::array<double, 3>& point)
  {
    if (block[m_axis] == m_layer)
      ++m_counts[part_of(point)];
  }

  /// Once all points were counted.
  void choose_part()
  {
    m_part = std::size_t(place_of_rank(m_counts, [](std::uint64_t count) { return count; })
                         - m_counts.begin());
  }

  void look(const Block& block, const std::array<double, 3>& point)
  {
    if (block[m_axis] == m_layer && part_of(point) == m_part)
      ++m_counts_of_values[point[m_axis]];
  }

  /// Once all points were looked at.
  double value()
  {
    return place_of_rank(m_counts_of_values, [](const auto& value) { return value.second; })->first;
  }
};

/// The frame and the extents of a cloud that is not in memory, as `Working_frame` and
/// `robust_diagonal()` find them.
/// \param source read twice; if there are points far away from the others, three times
/// \param on_progress called now and then with the share that is done
template <typename Source, typename OnProgress>
Facts_of_cloud extents_of_source(const Counted_cloud& cloud, const Source& source,
                                 const OnProgress& on_progress)
{
  std::uint64_t number_of_points_done = 0;
  const auto for_each_point = [&](const auto& f) {
    const std::uint64_t points_between_looks = std::uint64_t(1) << 16;
    source.for_each_point(cloud.source_box(cloud.box()), [&](const std::array<double, 3>& point) {
      f(cloud.lattice().block_of(point), point);
      if (++number_of_points_done % points_between_looks == 0)
        on_progress(
          (std::min)(double(number_of_points_done) / double(2 * cloud.number_of_points()), 1.));
    });
  };
  const std::uint64_t n = cloud.number_of_points(), margin = n / 20;
  enum
  {
    LOW,
    MIDDLE,
    HIGH
  };
  std::array<std::vector<Coordinate_of_rank>, 3> ranks; // of each axis
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const std::uint64_t rank : {margin, n / 2, n - 1 - margin})
      ranks[axis].emplace_back(cloud, axis, rank);
  const auto for_each_rank = [&](const auto& f) {
    for (std::vector<Coordinate_of_rank>& of_axis : ranks)
      for (Coordinate_of_rank& rank : of_axis)
        f(rank);
  };
  for_each_point([&](const Block& block, const std::array<double, 3>& point) {
    for_each_rank([&](Coordinate_of_rank& rank) { rank.count(block, point); });
  });
  for_each_rank([](Coordinate_of_rank& rank) { rank.choose_part(); });
  for_each_point([&](const Block& block, const std::array<double, 3>& point) {
    for_each_rank([&](Coordinate_of_rank& rank) { rank.look(block, point); });
  });

  const Vector lowest(cloud.low().data()), highest(cloud.high().data());
  const double largest = (std::max)(lowest.cwiseAbs().maxCoeff(), highest.cwiseAbs().maxCoeff());
  Place_of_frame frame = {Working_frame::exponent_of(largest), Vector::Zero()};
  const auto in_frame = [&](const Vector& point) -> Vector {
    return point.unaryExpr([&](double x) { return std::ldexp(x, frame.exponent); }) - frame.origin;
  };
  const auto coordinates = [&](int rank) {
    Vector point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      point[Eigen::Index(axis)] = ranks[axis][std::size_t(rank)].value();
    return in_frame(point);
  };
  frame.origin = coordinates(MIDDLE);
  Box_without_outliers box(coordinates(LOW), coordinates(HIGH));
  const Vector low = in_frame(lowest), high = in_frame(highest);
  if (box.is_in_reach(low) && box.is_in_reach(high))
  {
    box.add(low);
    box.add(high);
  }
  else
    for_each_point([&](const Block&, const std::array<double, 3>& point) {
      box.add(in_frame(Vector(point.data())));
    });

  Facts_of_cloud facts;
  facts.frame = frame;
  facts.extents = Facts{std::size_t(n), (high - low).norm(), box.diagonal(), frame.exponent};
  return facts;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_EXTENTS_OF_SOURCE_H
