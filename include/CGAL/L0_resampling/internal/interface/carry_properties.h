// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CARRY_PROPERTIES_H
#define CGAL_L0_RESAMPLING_INTERNAL_CARRY_PROPERTIES_H

#include <CGAL/L0_resampling/Near_points.h>

#include <CGAL/IO/Color.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// CGAL 5 answers a question for a property map with a pair, CGAL 6 with an optional.
template <typename Map>
Map map_of(const std::pair<Map, bool>& found)
{
  return found.first;
}
template <typename Map>
Map map_of(const std::optional<Map>& found)
{
  return *found;
}

/// Whether there is more than points and normals.
template <typename PointSet>
bool has_other_properties(const PointSet& points)
{
  for (const std::string& name : points.properties())
    if (name != "normal")
      return true;
  return false;
}

/// Whether no value has a fraction: then they may be labels, of which there is no mean.
template <typename PointSet, typename Map>
bool are_all_whole(const PointSet& points, const Map& map)
{
  return std::all_of(points.begin(), points.end(), [&](const typename PointSet::Index& i) {
    const auto value = map[i];
    return !std::isfinite(value) || std::floor(value) == value;
  });
}

/// Replaces the property of the nearest points by the mean of the near ones, if it has the type
/// `T`, unless it may be a label.
/// \param mean_of called with a point of `carried` and a function that gives a number for a
/// property value
template <typename T, typename PointSet, typename MeanOf>
void average_if_of_type(const PointSet& points,
                        const std::pair<std::string, std::type_index>& property,
                        const MeanOf& mean_of, PointSet& carried)
{
  if (property.second != std::type_index(typeid(T)))
    return;
  const auto from = map_of(points.template property_map<T>(property.first));
  if constexpr (std::is_floating_point<T>::value)
    if (!is_color_channel(property.first) && are_all_whole(points, from))
      return;
  auto to = map_of(carried.template property_map<T>(property.first));
  for (std::size_t i = 0; i < carried.size(); ++i)
    to[typename PointSet::Index(i)] = mean_of(i, from);
}

/*!
Appends the points of a result to `result`, each with the properties of the nearest input point, of
any type, or with the mean of those near it where numbers have one.

\param pair_of gives the i-th pair of the result
*/
template <typename PointSet, typename PairOf>
void append_with_properties(const PointSet& points, const Near_points& near_points,
                            std::size_t size, const PairOf& pair_of, PointSet& result)
{
  using Point_index = typename PointSet::Index;
  const auto input_index = [&](Index j) { return *(points.begin() + std::ptrdiff_t(j)); };

  // The same properties in the same order: what insert() asks for. A normal map that is not there
  // comes later.
  PointSet carried;
  carried.copy_properties(points);
  carried.reserve(size);
  for (std::size_t i = 0; i < size; ++i)
    carried.insert(points, input_index(near_points.nearest(i)));
  carried.add_normal_map();
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto pair = pair_of(i);
    carried.point(Point_index(i)) = pair.first;
    carried.normal(Point_index(i)) = pair.second;
  }

  const auto number = [&](std::size_t i, const auto& map) {
    return near_points.mean(i, [&](Index j) { return double(map[input_index(j)]); });
  };
  const auto rounded = [&](std::size_t i, const auto& map) {
    return std::uint8_t(std::floor(number(i, map) + 0.5));
  };
  const auto color = [&](std::size_t i, const auto& map) {
    const auto channel = [&](std::size_t c) {
      return static_cast<unsigned char>(std::floor(
        near_points.mean(i, [&](Index j) { return double(map[input_index(j)][c]); }) + 0.5));
    };
    return CGAL::IO::Color(channel(0), channel(1), channel(2), channel(3));
  };
  for (const auto& property : points.properties_and_types())
  {
    average_if_of_type<float>(
      points, property, [&](std::size_t i, const auto& map) { return float(number(i, map)); },
      carried);
    average_if_of_type<double>(points, property, number, carried);
    average_if_of_type<CGAL::IO::Color>(points, property, color, carried);
    if (is_color_channel(property.first))
      average_if_of_type<std::uint8_t>(points, property, rounded, carried);
  }

  result.copy_properties(carried);
  result.join(carried);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CARRY_PROPERTIES_H
