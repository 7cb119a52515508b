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

#include <CGAL/L0_resampling/Attribute_values.h>
#include <CGAL/L0_resampling/Near_points.h>

#include <CGAL/IO/Color.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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

/// The number of the type `T` that is nearest to `value`.
template <typename T>
T nearest_number(double value)
{
  return T(std::is_floating_point<T>::value ? value : std::floor(value + 0.5));
}

/// Replaces the numbers of the nearest points by the means of the near ones, if they have the type
/// `T`, and there are means of them.
/// \param property its name and its type
/// \param index_of called with an index of `near_points`, gives one of `points`
template <typename T, typename PointSet, typename IndexOf>
void average_if_of_type(const PointSet& points, const Near_points& near_points,
                        const std::pair<std::string, std::type_index>& property,
                        const IndexOf& index_of, PointSet& carried)
{
  if (property.second != std::type_index(typeid(T)))
    return;
  const auto from = map_of(points.template property_map<T>(property.first));
  std::optional<double> no_data;
  if (!is_color_channel(property.first))
  {
    if (std::is_integral<T>::value)
      return;
    Attribute_values values;
    for (const auto& i : points)
      values.add(double(from[i]));
    if (values.are_labels())
      return;
    no_data = values.no_data();
  }
  const auto value_of = [&](Index j) {
    const double value = double(from[index_of(j)]);
    return value == no_data ? std::numeric_limits<double>::quiet_NaN() : value;
  };
  auto to = map_of(carried.template property_map<T>(property.first));
  for (std::size_t i = 0; i < carried.size(); ++i)
    if (const double mean = near_points.mean(i, value_of); std::isfinite(mean))
      to[typename PointSet::Index(i)] = nearest_number<T>(mean);
}

/// The same of numbers of any of the types.
template <typename... T, typename... Arguments>
void average_if_of_types(Arguments&&... arguments)
{
  (average_if_of_type<T>(arguments...), ...);
}

/// The same of colors.
template <typename PointSet, typename IndexOf>
void average_if_colors(const PointSet& points, const Near_points& near_points,
                       const std::pair<std::string, std::type_index>& property,
                       const IndexOf& index_of, PointSet& carried)
{
  using Color = CGAL::IO::Color;
  if (property.second != std::type_index(typeid(Color)))
    return;
  const auto from = map_of(points.template property_map<Color>(property.first));
  auto to = map_of(carried.template property_map<Color>(property.first));
  for (std::size_t i = 0; i < carried.size(); ++i)
  {
    const auto channel = [&](std::size_t c) {
      return nearest_number<unsigned char>(
        near_points.mean(i, [&](Index j) { return double(from[index_of(j)][c]); }));
    };
    to[typename PointSet::Index(i)] = Color(channel(0), channel(1), channel(2), channel(3));
  }
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

  for (const auto& property : points.properties_and_types())
  {
    average_if_of_types<float, double, std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                        std::int32_t, std::uint32_t>(points, near_points, property, input_index,
                                                     carried);
    average_if_colors(points, near_points, property, input_index, carried);
  }

  result.copy_properties(carried);
  result.join(carried);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CARRY_PROPERTIES_H
