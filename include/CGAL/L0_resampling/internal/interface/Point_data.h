// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_POINT_DATA_H
#define CGAL_L0_RESAMPLING_INTERNAL_POINT_DATA_H

#include <CGAL/L0_resampling/Near_points.h>
#include <CGAL/L0_resampling/internal/creases/Placed_creases.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What callers may want to know of each point of the result beside its position and its normal.
struct Point_data
{
  Near_points near_points; ///< if some are asked for
  // if they are asked for
  Buffer<float> feature_confidences, side_confidences, neighbor_radii, noises, position_deviations,
    normal_deviations;
  Placed_creases creases;
  Buffer<Index> outliers; ///< points of the range
};

/// Lengths in the unit of the input.
/// \param lengths in the unit of the frame, which is the radius
inline Buffer<float> lengths_of_input(Buffer<float> lengths, double neighbor_radius)
{
  for (float& length : lengths)
    length = float(double(length) * neighbor_radius);
  return lengths;
}

/// The radii of samples, from their scales.
/// \param scales of the samples; none if all are 1
inline Buffer<float> neighbor_radii(Buffer<float> scales, std::size_t number_of_samples,
                                    double neighbor_radius)
{
  if (scales.empty())
    scales.assign(number_of_samples, 1.f);
  return lengths_of_input(std::move(scales), neighbor_radius);
}

/// How many near points a call with these parameters has to find, of which `others` are asked for
/// elsewhere.
inline std::size_t number_of_near_points(const Given_parameters& given, std::size_t others)
{
  return (std::max)(others, std::size_t(given.source_index_map.value));
}

/// Writes the data to the maps among the named parameters.
/// \param key_of called with the place of a point in the result
template <typename NamedParameters, typename KeyOf>
void write_point_data(const NamedParameters& np, const Point_data& data, std::size_t size,
                      const KeyOf& key_of)
{
  using boost::put;
  const auto write = [&](const auto& map, const auto& value_of) {
    using Value = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
    for (std::size_t i = 0; i < size; ++i)
      put(map, key_of(i), Value(value_of(i)));
  };
  if_given(np, internal_np::source_index_map, [&](const auto& map) {
    write(map, [&](std::size_t i) { return data.near_points.nearest(i); });
  });
  if_given(np, internal_np::feature_confidence_map, [&](const auto& map) {
    write(map, [&](std::size_t i) { return data.feature_confidences[i]; });
  });
  if_given(np, internal_np::side_confidence_map, [&](const auto& map) {
    write(map, [&](std::size_t i) { return data.side_confidences[i]; });
  });
  if_given(np, internal_np::neighbor_radius_map, [&](const auto& map) {
    write(map, [&](std::size_t i) { return data.neighbor_radii[i]; });
  });
  if_given(np, internal_np::noise_map,
           [&](const auto& map) { write(map, [&](std::size_t i) { return data.noises[i]; }); });
  if_given(np, internal_np::position_deviation_map, [&](const auto& map) {
    write(map, [&](std::size_t i) { return data.position_deviations[i]; });
  });
  if_given(np, internal_np::normal_deviation_map, [&](const auto& map) {
    write(map, [&](std::size_t i) { return data.normal_deviations[i]; });
  });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_POINT_DATA_H
