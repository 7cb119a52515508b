// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_RANGE_H
#define CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_RANGE_H

#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/precedes.h>
#include <CGAL/L0_resampling/internal/core/select_nth.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/kernels/side_of_normal.h>
#include <CGAL/L0_resampling/internal/search/nearest_input_points.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

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

inline std::size_t number_of_blocks(std::size_t n)
{
  return n / points_per_look + std::size_t(n % points_per_look != 0);
}

template <typename Iterator>
constexpr bool has_random_access =
  std::is_convertible<typename std::iterator_traits<Iterator>::iterator_category,
                      std::random_access_iterator_tag>::value;

/// Calls `f(it, begin, end)` for the blocks of `points_per_look` places of a range from `first` to
/// `last`, with the iterator at `begin`, which `f` increments to `end`, unless nothing behind
/// counts any more. With `Parallel_tag` the calls run at the same time if the iterators have random
/// access, else one after the other.
/// \param it at `first`, where a block begins; out: at `last`
template <typename ConcurrencyTag, typename Iterator, typename F>
void for_each_block_of_range(Iterator& it, std::size_t first, std::size_t last, const F& f)
{
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
  if constexpr (is_parallel && has_random_access<Iterator>)
  {
    using Difference = typename std::iterator_traits<Iterator>::difference_type;
    const auto call = [&](std::size_t begin, std::size_t end) {
      Iterator at_begin = it + Difference(begin);
      f(at_begin, first + begin, first + end);
    };
    for_each_block<ConcurrencyTag>(last - first, points_per_look, call);
    it += Difference(last - first);
  }
  else
  {
    const auto call = [&](std::size_t begin, std::size_t end) {
      f(it, first + begin, first + end);
    };
    for_each_block<Sequential_tag>(last - first, points_per_look, call);
  }
}

/// Anything with three coordinates.
template <typename Coordinates>
Vector as_vector(const Coordinates& p)
{
  return Vector(double(p.x()), double(p.y()), double(p.z()));
}

/// The caller's points in double precision, and their bounding box.
struct Input
{
  std::size_t size_of_range = 0;
  Buffer<Vector> points;
  Buffer<Local_vector> normals; // empty, or unit vectors, zero where the caller's is of no use
  Buffer<Local_vector> hints; // likewise, of the side that normals shall point to, or to viewpoints
  double noise = 0;           // the median of the points, if theirs are given
  Buffer<float> noise_ratios; // of each point, to it; empty if none are given
  Buffer<unsigned char> is_kept; // one for each point of the range; none if all are kept
  std::vector<std::size_t> places_of_blocks; // of the range, among `points`; none if all are kept
  Vector low = Vector::Zero(), high = Vector::Zero();

  explicit Input(Memory_counter* memory = nullptr)
    : points(memory), normals(memory), hints(memory), noise_ratios(memory), is_kept(memory)
  {}

  bool keeps(std::size_t index) const { return is_kept.empty() || is_kept[index]; }

  /// The place among `points` of the first point that is kept of a block, or of those behind it.
  /// \param begin of the block, or the size of the range
  std::size_t place_of_block(std::size_t begin) const
  {
    return places_of_blocks.empty() ? begin : places_of_blocks[number_of_blocks(begin)];
  }
};

/// Which points of the range some of the points are that were read of it.
/// \param points ascending
inline Buffer<Index> places_in_range(Buffer<Index> points, const Input& input)
{
  if (input.is_kept.empty())
    return points;
  std::size_t number_before = 0, place = 0;
  for (Index& point : points)
  {
    for (; !input.is_kept[place] || number_before < point; ++place)
      number_before += input.is_kept[place];
    point = Index(place);
  }
  return points;
}

/// \throws std::invalid_argument for a point of the caller that is not finite
[[noreturn]] inline void refuse_non_finite_point(std::size_t index, const Vector& point,
                                                 const char* function = resampling_function)
{
  throw std::invalid_argument(std::string(function) + ": point " + std::to_string(index)
                              + " has a coordinate that is not finite (" + std::to_string(point[0])
                              + ", " + std::to_string(point[1]) + ", " + std::to_string(point[2])
                              + "); drop_non_finite(true) leaves such points out");
}

/// Finds the points of the range that are finite, which are those that are kept.
template <typename ConcurrencyTag, typename PointRange, typename PointMap>
void find_finite_points(const PointRange& range, PointMap point_map, Input& input)
{
  input.is_kept.resize(input.size_of_range);
  input.places_of_blocks.assign(number_of_blocks(input.size_of_range) + 1, 0);
  const auto find_in_block = [&](auto& it, std::size_t begin, std::size_t end) {
    std::size_t number = 0;
    for (std::size_t i = begin; i < end; ++i, ++it)
    {
      const bool is_finite = as_vector(get(point_map, *it)).allFinite();
      input.is_kept[i] = is_finite;
      number += is_finite;
    }
    input.places_of_blocks[number_of_blocks(end)] = number;
  };
  auto it = range.begin();
  for_each_block_of_range<ConcurrencyTag>(it, 0, input.size_of_range, find_in_block);
  std::partial_sum(input.places_of_blocks.begin(), input.places_of_blocks.end(),
                   input.places_of_blocks.begin());
}

/// What is found in one block of a range.
struct Block_of_points
{
  Vector low = Vector::Constant(std::numeric_limits<double>::infinity()), high = -low;
};

/// What is found in a range.
struct Found_points
{
  std::vector<Block_of_points> blocks;
  /// What is behind the first point that is not finite need not be read: the call refuses it.
  std::atomic<std::size_t> first_non_finite{(std::numeric_limits<std::size_t>::max)()};

  void note_non_finite(std::size_t place)
  {
    std::size_t first = first_non_finite;
    while (place < first && !first_non_finite.compare_exchange_weak(first, place))
      ;
  }
};

/// Reads the points of a range of which is known which are kept.
/// \param read_blocks called with the begin and the end of whole blocks of the range, in its order
/// \throws std::invalid_argument for the first non-finite point
inline void read_points_by_blocks(
  const Function_view<std::size_t, std::size_t, Found_points&>& read_blocks, Report& report,
  Input& input, const char* function)
{
  const std::size_t size = input.size_of_range;
  Found_points found;
  found.blocks.resize(number_of_blocks(size));
  // The first block alone: a map that throws does so before there is memory for all points, and a
  // point that is not finite is refused.
  std::size_t begin = 0;
  for (const std::size_t end : {(std::min)(size, points_per_look), size})
  {
    input.points.reserve(input.place_of_block(end));
    input.points.resize(input.place_of_block(end));
    read_blocks(begin, end, found);
    if (found.first_non_finite < input.points.size())
      refuse_non_finite_point(found.first_non_finite, input.points[found.first_non_finite],
                              function);
    begin = end;
  }

  Block_of_points all;
  for (const Block_of_points& block : found.blocks)
  {
    all.low = all.low.cwiseMin(block.low);
    all.high = all.high.cwiseMax(block.high);
  }
  if (!input.points.empty())
  {
    input.low = all.low;
    input.high = all.high;
  }
  report.number_of_input_points = input.points.size();
  report.number_of_dropped_points = size - input.points.size();
}

/// Reads the points of the range, without the non-finite ones if they are to be dropped.
/// \throws std::invalid_argument for the first non-finite point if they are not
template <typename ConcurrencyTag, typename PointRange, typename PointMap>
void read_points(const PointRange& range, PointMap point_map, bool drop_non_finite, Report& report,
                 Input& input, const char* function = resampling_function)
{
  input.size_of_range = std::size_t(std::distance(range.begin(), range.end()));
  if (drop_non_finite)
    find_finite_points<ConcurrencyTag>(range, point_map, input);
  auto block_begin = range.begin();
  const auto read_blocks = [&](std::size_t first, std::size_t last, Found_points& found) {
    const auto read_block = [&](auto& it, std::size_t begin, std::size_t end) {
      Block_of_points block;
      std::size_t place = input.place_of_block(begin);
      if (place > found.first_non_finite)
        return;
      for (std::size_t i = begin; i < end; ++i, ++it)
      {
        if (!input.keeps(i))
          continue;
        const Vector point = as_vector(get(point_map, *it));
        if (!point.allFinite())
        {
          found.note_non_finite(place);
          input.points[place] = point;
          return;
        }
        block.low = block.low.cwiseMin(point);
        block.high = block.high.cwiseMax(point);
        input.points[place++] = point;
      }
      found.blocks[begin / points_per_look] = block;
    };
    for_each_block_of_range<ConcurrencyTag>(block_begin, first, last, read_block);
  };
  read_points_by_blocks(Function_view<std::size_t, std::size_t, Found_points&>(read_blocks), report,
                        input, function);
}

/// Calls `f(element, place)` for each point that is kept, with its element of the range and its
/// place among the points, by the threads of `for_each_block_of_range()`.
template <typename ConcurrencyTag, typename Range, typename F>
void for_each_kept_point(Range& range, const Input& input, const F& f)
{
  const auto call_for_block = [&](auto& it, std::size_t begin, std::size_t end) {
    std::size_t place = input.place_of_block(begin);
    for (std::size_t i = begin; i < end; ++i, ++it)
      if (input.keeps(i))
        f(*it, place++);
  };
  auto it = range.begin();
  for_each_block_of_range<ConcurrencyTag>(it, 0, input.size_of_range, call_for_block);
}

/// To unit length, or zero if it is zero or not finite.
inline Local_vector direction_of(const Vector& n)
{
  const double largest = n.cwiseAbs().maxCoeff();
  Local_vector direction = Local_vector::Zero();
  if (n.allFinite() && largest > 0)
    direction = (n / largest).normalized().template cast<Local>();
  return direction;
}

/// One of the two signs, so that neither the sign nor, among coincident points, the order of the
/// input matters.
inline Local_vector without_sign(const Local_vector& normal)
{
  // No branch here either, behind a division and a root.
  return Local(1 - 2 * int(is_negative(normal[0], normal[1], normal[2]))) * normal;
}

/// Reads a vector for each point that is kept.
/// \param vector_of called with an element of the range
template <typename ConcurrencyTag, typename PointRange, typename VectorOf>
void read_vectors(const PointRange& range, const VectorOf& vector_of, const Input& input,
                  Buffer<Local_vector>& vectors)
{
  vectors.resize(input.points.size());
  for_each_kept_point<ConcurrencyTag>(range, input, [&](const auto& key, std::size_t place) {
    vectors[place] = vector_of(key);
  });
}

template <typename ConcurrencyTag, typename PointRange, typename NormalMap>
void read_normals(const PointRange& range, NormalMap normal_map, Input& input)
{
  const auto normal_of = [&](const auto& key) {
    return without_sign(direction_of(as_vector(get(normal_map, key))));
  };
  read_vectors<ConcurrencyTag>(range, normal_of, input, input.normals);
}

/// \tparam NormalMap may be `bool`, for none, or an optional
template <typename ConcurrencyTag, typename PointRange, typename NormalMap>
void read_normals_if_given(const PointRange& range, const NormalMap& normal_map, Input& input)
{
  if constexpr (Is_optional<NormalMap>::value)
  {
    if (normal_map)
      read_normals<ConcurrencyTag>(range, *normal_map, input);
  }
  else if constexpr (!std::is_same<NormalMap, bool>::value)
    read_normals<ConcurrencyTag>(range, normal_map, input);
}

/// Of the noises of the points takes the median, and the ratio of each to it. Those that are no
/// number above zero are unknown, and the median stands for them. Beyond a factor of a thousand no
/// place of a cloud differs.
inline void take_noises(const Buffer<double>& noises, Input& input)
{
  const auto is_known = [](double given) { return given > 0 && std::isfinite(given); };
  Buffer<double> known(noises.get_allocator());
  std::copy_if(noises.begin(), noises.end(), std::back_inserter(known), is_known);
  if (known.empty())
    return;
  input.noise = median_of(std::move(known));
  input.noise_ratios.reserve(noises.size());
  const double maximum_ratio = 1000;
  for_each_in_order(noises.size(), [&](std::size_t i) {
    const double ratio = is_known(noises[i]) ? noises[i] / input.noise : 1;
    input.noise_ratios.push_back(
      float((std::min)((std::max)(ratio, 1 / maximum_ratio), maximum_ratio)));
  });
}

/// Reads `orientation_hint_map`, or the directions from the points to what `viewpoint_map` says.
template <typename ConcurrencyTag, typename PointRange, typename PointMap, typename NamedParameters>
void read_hints_if_given(const PointRange& range, PointMap point_map, const NamedParameters& np,
                         Input& input)
{
  if_given(np, internal_np::orientation_hint_map, [&](const auto& hint_map) {
    read_vectors<ConcurrencyTag>(
      range, [&](const auto& key) { return direction_of(as_vector(get(hint_map, key))); }, input,
      input.hints);
  });
  if_given(np, internal_np::viewpoint_map, [&](const auto& viewpoint_map) {
    const auto to_viewpoint = [&](const auto& key) { // half of it: the whole may not be finite
      return direction_of(0.5 * as_vector(get(viewpoint_map, key))
                          - 0.5 * as_vector(get(point_map, key)));
    };
    read_vectors<ConcurrencyTag>(range, to_viewpoint, input, input.hints);
  });
}

/// Reads `point_noise_map`.
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
void read_noises_if_given(const PointRange& range, const NamedParameters& np, Input& input)
{
  if_given(np, internal_np::point_noise_map, [&](const auto& noise_map) {
    Buffer<double> noises(input.points.size(), input.points.get_allocator());
    for_each_kept_point<ConcurrencyTag>(range, input, [&](const auto& key, std::size_t place) {
      noises[place] = double(get(noise_map, key));
    });
    take_noises(noises, input);
  });
}

/// Of the place of a point in the range, and the point.
using Point_function = Function_view<std::size_t, const Vector&>;

/// `for_each_point()` of a range and its point map, for functions that do not depend on their
/// types.
using Each_point = Function_view<const Point_function&>;

/// Calls `f` for each point of the range, in its order.
template <typename PointRange, typename PointMap>
void for_each_point(const PointRange& range, PointMap point_map, const Point_function& f)
{
  std::size_t index = 0;
  for (auto it = range.begin(); it != range.end(); ++it, ++index)
  {
    if (index % points_per_look == 0)
      poll_for_cancellation();
    f(index, as_vector(get(point_map, *it)));
  }
}

/// The finite points of a range of that size, each with its place in it.
template <typename ConcurrencyTag>
Point_tree_3 tree_of_range(std::size_t size, const Each_point& for_each, Memory_counter& memory)
{
  Buffer<Vector> points(&memory);
  Buffer<Index> indices(&memory);
  points.reserve(size);
  indices.reserve(size);
  for_each(Point_function([&](std::size_t index, const Vector& point) {
    if (!point.allFinite())
      return;
    points.push_back(point);
    indices.push_back(Index(index));
  }));
  return Point_tree_3(ConcurrencyTag(), std::move(points), std::move(indices));
}

/// The number of distinct finite points of a range of that size, counted before any scaling can
/// make two of them one.
inline std::size_t number_of_distinct_points(std::size_t size, const Each_point& for_each,
                                             Memory_counter& memory)
{
  Buffer<Vector> points(&memory);
  points.reserve(size);
  for_each(Point_function([&](std::size_t, const Vector& point) {
    if (point.allFinite())
      points.push_back(point);
  }));
  std::size_t number_of_comparisons = 0;
  std::sort(points.begin(), points.end(), watched_order(precedes<double>, number_of_comparisons));
  return std::size_t(std::unique(points.begin(), points.end()) - points.begin());
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_POINTS_OF_RANGE_H
