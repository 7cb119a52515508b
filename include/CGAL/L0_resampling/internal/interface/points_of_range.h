// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_RANGE_H
#define CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_RANGE_H

#include <CGAL/L0_resampling/internal/cloud/separate_coincident_points.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/search/nearest_input_points.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {

template <typename Point, typename Vector>
class Point_set_3;

namespace L0_resampling {
namespace internal {

template <typename Range>
struct Is_point_set : std::false_type
{};
template <typename Point, typename Vector>
struct Is_point_set<Point_set_3<Point, Vector>> : std::true_type
{};

/// The point map among the named parameters, or else that of a `Point_set_3`, or else the one that
/// takes the elements themselves.
template <typename PointRange, typename NamedParameters>
auto point_map_of(const PointRange& range, const NamedParameters& np)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::point_t>::value)
    return parameters::get_parameter(np, internal_np::point_map);
  else if constexpr (Is_point_set<PointRange>::value)
    return range.point_map();
  else
    return Identity_property_map<
      const typename std::iterator_traits<decltype(range.begin())>::value_type>();
}

/// The normal map among the named parameters, or `false`.
template <typename NamedParameters>
auto normal_map_of(const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value)
    return false;
  else
    return parameters::get_parameter(np, internal_np::normal_map);
}

constexpr std::size_t points_per_look = 65536; // at the loop: a few milliseconds

/// Anything with three coordinates.
template <typename Coordinates>
Vector as_vector(const Coordinates& p)
{
  return Vector(double(p.x()), double(p.y()), double(p.z()));
}

/// The caller's points in double precision, and their bounding box.
struct Input
{
  Buffer<Vector> points;
  Buffer<Local_vector> normals; // empty, or unit vectors, zero where the caller's is of no use
  Buffer<Local_vector> hints; // likewise, of the side that normals shall point to, or to viewpoints
  Buffer<unsigned char> is_kept; // one for each point of the range
  Vector low = Vector::Zero(), high = Vector::Zero();

  explicit Input(Memory_counter* memory = nullptr)
    : points(memory), normals(memory), hints(memory), is_kept(memory)
  {}
};

/// \throws std::invalid_argument for a point of the caller that is not finite
[[noreturn]] inline void refuse_non_finite_point(std::size_t index, const Vector& point,
                                                 const char* function = resampling_function)
{
  throw std::invalid_argument(std::string(function) + ": point " + std::to_string(index)
                              + " has a coordinate that is not finite (" + std::to_string(point[0])
                              + ", " + std::to_string(point[1]) + ", " + std::to_string(point[2])
                              + "); drop_non_finite(true) leaves such points out");
}

/// Reads the points of the range, without the non-finite ones if they are to be dropped.
/// \throws std::invalid_argument for the first non-finite point if they are not
template <typename PointRange, typename PointMap>
void read_points(const PointRange& range, PointMap point_map, bool drop_non_finite, Report& report,
                 Input& input, const char* function = resampling_function)
{
  const std::size_t many_points =
    1000000; // a buffer of more that grows is copied for longer than the callback can wait
  std::size_t index = 0;
  for (auto it = range.begin(); it != range.end(); ++it, ++index)
  {
    if (index % points_per_look == 0)
      poll_for_cancellation();
    if (index == many_points
        && !drop_non_finite) // among points to be dropped there may be few others
    {
      const std::size_t size = std::size_t(std::distance(range.begin(), range.end()));
      input.is_kept.reserve(size);
      input.points.reserve(size);
    }
    const Vector point = as_vector(get(point_map, *it));
    const bool is_finite = point.allFinite();
    if (!is_finite && !drop_non_finite)
      refuse_non_finite_point(index, point, function);
    input.is_kept.push_back(is_finite);
    if (!is_finite)
    {
      ++report.number_of_dropped_points;
      continue;
    }
    input.low = input.points.empty() ? point : Vector(input.low.cwiseMin(point));
    input.high = input.points.empty() ? point : Vector(input.high.cwiseMax(point));
    input.points.push_back(point);
  }
  report.number_of_input_points = input.points.size();
}

/// Reads the vectors of the points that are kept: to unit length, or zero where they are zero or
/// not finite.
/// \param vector_of called with an element of the range
template <typename PointRange, typename VectorOf>
void read_directions(const PointRange& range, const VectorOf& vector_of, const Input& input,
                     Buffer<Local_vector>& directions)
{
  std::size_t index = 0;
  directions.reserve(input.points.size());
  for (auto it = range.begin(); it != range.end(); ++it)
  {
    if (index % points_per_look == 0)
      poll_for_cancellation();
    if (!input.is_kept[index++])
      continue;
    const Vector n = vector_of(*it);
    const double largest = n.cwiseAbs().maxCoeff();
    Local_vector direction = Local_vector::Zero();
    if (n.allFinite() && largest > 0)
      direction = (n / largest).normalized().template cast<Local>();
    directions.push_back(direction);
  }
}

template <typename PointRange, typename NormalMap>
void read_normals(const PointRange& range, NormalMap normal_map, Input& input)
{
  read_directions(
    range, [&](const auto& key) { return as_vector(get(normal_map, key)); }, input, input.normals);
  // one of the two signs, so that neither the sign nor, among coincident points, the order of the
  // input matters
  const Local_vector zero = Local_vector::Zero();
  for_each_in_order(input.normals.size(), [&](std::size_t i) {
    Local_vector& normal = input.normals[i];
    if (std::lexicographical_compare(normal.data(), normal.data() + 3, zero.data(),
                                     zero.data() + 3))
      normal = -normal;
  });
}

/// \tparam NormalMap may be `bool`, for none, or an optional
template <typename PointRange, typename NormalMap>
void read_normals_if_given(const PointRange& range, const NormalMap& normal_map, Input& input)
{
  if constexpr (Is_optional<NormalMap>::value)
  {
    if (normal_map)
      read_normals(range, *normal_map, input);
  }
  else if constexpr (!std::is_same<NormalMap, bool>::value)
    read_normals(range, normal_map, input);
}

/// Reads `orientation_hint_map`, or the directions from the points to what `viewpoint_map` says.
template <typename PointRange, typename PointMap, typename NamedParameters>
void read_hints_if_given(const PointRange& range, PointMap point_map, const NamedParameters& np,
                         Input& input)
{
  if_given(np, internal_np::orientation_hint_map, [&](const auto& hint_map) {
    read_directions(
      range, [&](const auto& key) { return as_vector(get(hint_map, key)); }, input, input.hints);
  });
  if_given(np, internal_np::viewpoint_map, [&](const auto& viewpoint_map) {
    const auto half_way = [&](const auto& key) -> Vector { // the whole one may not be finite
      return 0.5 * as_vector(get(viewpoint_map, key)) - 0.5 * as_vector(get(point_map, key));
    };
    read_directions(range, half_way, input, input.hints);
  });
}

/// The finite points of the range, each with its place in it.
template <typename PointRange, typename PointMap>
Point_tree_3 tree_of_range(const PointRange& range, PointMap point_map, Memory_counter& memory)
{
  Buffer<Vector> points(&memory);
  Buffer<Index> indices(&memory);
  const std::size_t size = std::size_t(std::distance(range.begin(), range.end()));
  points.reserve(size);
  indices.reserve(size);
  Index index = 0;
  for (auto it = range.begin(); it != range.end(); ++it, ++index)
  {
    if (index % points_per_look == 0)
      poll_for_cancellation();
    const Vector point = as_vector(get(point_map, *it));
    if (!point.allFinite())
      continue;
    points.push_back(point);
    indices.push_back(index);
  }
  return Point_tree_3(std::move(points), std::move(indices));
}

/// The number of distinct finite points of the range, counted before any scaling can make two of
/// them one.
template <typename PointRange, typename PointMap>
std::size_t number_of_distinct_points(const PointRange& range, PointMap point_map,
                                      Memory_counter& memory)
{
  Buffer<Vector> points(&memory);
  points.reserve(std::size_t(std::distance(range.begin(), range.end())));
  std::size_t index = 0;
  for (auto it = range.begin(); it != range.end(); ++it)
  {
    if (index++ % points_per_look == 0)
      poll_for_cancellation();
    const Vector point = as_vector(get(point_map, *it));
    if (point.allFinite())
      points.push_back(point);
  }
  const auto comes_first = [](const Vector& a, const Vector& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::size_t number_of_comparisons = 0;
  std::sort(points.begin(), points.end(), watched_order(comes_first, number_of_comparisons));
  return std::size_t(std::unique(points.begin(), points.end()) - points.begin());
}

/// The bounding box of the input grown by `margin`, as far as numbers reach.
template <typename FT>
std::array<std::array<FT, 3>, 2> box_of_result(const Input& input, double margin)
{
  const double largest = double((std::numeric_limits<FT>::max)());
  std::array<std::array<FT, 3>, 2> box;
  for (int axis = 0; axis < 3; ++axis)
  {
    box[0][std::size_t(axis)] = FT((std::max)(input.low[axis] - margin, -largest));
    box[1][std::size_t(axis)] = FT((std::min)(input.high[axis] + margin, largest));
  }
  return box;
}

/// The result's positions in the number type of the caller: inside the bounding box grown by
/// `margin`, and no two equal if `separate`.
template <typename ConcurrencyTag, typename FT>
Buffer<std::array<FT, 3>> rounded_positions(const Buffer<Vector>& positions, const Input& input,
                                            double margin, bool separate)
{
  const std::array<std::array<FT, 3>, 2> box = box_of_result<FT>(input, margin);
  const std::array<FT, 3>& low = box[0];
  const std::array<FT, 3>& high = box[1];
  Buffer<std::array<FT, 3>> rounded(positions.get_allocator());
  rounded.reserve(positions.size());
  for_each_in_order(positions.size(), [&](std::size_t i) {
    std::array<FT, 3> r;
    for (std::size_t a = 0; a < 3; ++a)
      r[a] = FT(
        (std::min)((std::max)(positions[i][Eigen::Index(a)], double(low[a])), double(high[a])));
    rounded.push_back(r);
  });
  if (separate)
    separate_coincident_points<ConcurrencyTag>(low, high, FT(margin), rounded);
  return rounded;
}

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template Buffer<std::array<float, 3>> rounded_positions<Sequential_tag, float>(
  const Buffer<Vector>&, const Input&, double, bool);
extern template Buffer<std::array<double, 3>> rounded_positions<Sequential_tag, double>(
  const Buffer<Vector>&, const Input&, double, bool);
#ifdef CGAL_LINKED_WITH_TBB
extern template Buffer<std::array<float, 3>> rounded_positions<Parallel_tag, float>(
  const Buffer<Vector>&, const Input&, double, bool);
extern template Buffer<std::array<double, 3>> rounded_positions<Parallel_tag, double>(
  const Buffer<Vector>&, const Input&, double, bool);
#endif
#endif

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_RANGE_H
