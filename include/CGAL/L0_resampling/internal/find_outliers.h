// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIND_OUTLIERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIND_OUTLIERS_H

#include <CGAL/L0_resampling/internal/Parameters.h>
#include <CGAL/L0_resampling/internal/ball_queries.h>
#include <CGAL/L0_resampling/internal/select_nth.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The number of points in the ball of each point, itself included.
/// \param points sorted for `grid`, whose cells are no smaller than `radius`
template <typename T, typename ConcurrencyTag>
Buffer<double> count_points_in_balls(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                                     Progress& progress)
{
  const T squared_radius = T(radius * radius);
  Buffer<double> counts = filled_buffer(points.size(), 0., points.get_allocator());
  for_each_cell<T, ConcurrencyTag>(grid, points, grid, points, 1, progress, [&]() {
    return [&](Search_grid_3::Range queries, const Local_points<T>& candidates, const Vector& origin) {
      using L = Lanes<T>;
      for (Index i = queries.first; i < queries.second; ++i)
      {
        L count;
        candidates.for_each_run_in_ball((points[i] - origin).template cast<T>(), squared_radius,
                                        [&](std::size_t, const L& squared_distance) {
                                          count += where_less(squared_distance, squared_radius, L(T(1)));
                                        });
        counts[i] = double(count.sum()) * double(candidates.stride);
      }
    };
  });
  return counts;
}

/// The mean of the values of the points in the block of cells around the cell of each point.
template <typename ConcurrencyTag>
Buffer<double> means_around(const Search_grid_3& grid, const Buffer<double>& values, Progress& progress)
{
  Buffer<double> sums(1, 0., values.get_allocator()), means = filled_buffer(values.size(), 0., values.get_allocator());
  sums.reserve(values.size() + 1);
  for_each_in_order(values.size(), [&](std::size_t i) { sums.push_back(sums.back() + values[i]); });
  for_each_cell_block<ConcurrencyTag>(grid, grid, 1, progress, [&]() {
    return [&](Index cell, const std::vector<Search_grid_3::Range>& ranges, std::size_t count) {
      double sum = 0;
      for (const Search_grid_3::Range& range : ranges)
        sum += sums[range.second] - sums[range.first];
      const Search_grid_3::Range own = grid.points_of_cell(cell);
      std::fill(means.begin() + own.first, means.begin() + own.second, sum / double(count));
    };
  });
  return means;
}

/// The number of points of the connected part that each point is in, where cells that touch are connected.
template <typename ConcurrencyTag>
Buffer<Index> sizes_of_parts(const Buffer<Vector>& unsorted_points, double cell_size, Progress& progress)
{
  const Counting_allocator<Index> allocator = unsorted_points.get_allocator();
  const std::size_t n = unsorted_points.size();
  const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(unsorted_points, cell_size);
  Buffer<Vector> points = copy_of(unsorted_points);
  apply_order(order, points);
  const Search_grid_3 grid(points, cell_size);
  Buffer<Index> ranks = filled_buffer(n, Index(0), allocator), parents = filled_buffer(n, Index(0), allocator),
                sizes = filled_buffer(n, Index(0), allocator), sizes_of_points = filled_buffer(n, Index(0), allocator);
  boost::disjoint_sets<Index*, Index*> parts(ranks.data(), parents.data());
  for_each_in_order(n, [&](std::size_t i) { parts.make_set(Index(i)); });
  for_each_cell_block<Sequential_tag>(grid, grid, 1, progress, [&]() {
    return [&](Index cell, const std::vector<Search_grid_3::Range>& ranges, std::size_t) {
      const Search_grid_3::Range own = grid.points_of_cell(cell);
      for (Index i = own.first + 1; i < own.second; ++i)
        parts.union_set(own.first, i);
      for (const Search_grid_3::Range& range : ranges)
      {
        // the cells of a run, three at most, touch their neighbors in it
        parts.union_set(own.first, range.first);
        parts.union_set(own.first, range.second - 1);
      }
    };
  });
  for_each_in_order(n, [&](std::size_t i) { ++sizes[parts.find_set(Index(i))]; });
  for_each_in_order(n, [&](std::size_t i) { sizes_of_points[order[i]] = sizes[parts.find_set(Index(i))]; });
  return sizes_of_points;
}

/*!
Finds the points that lie off the cloud: those whose ball holds far fewer points than the balls around them do, or than the median ball of the cloud; and, among the
others, those of parts that hang together and have fewer points than half a median ball, such as clusters of outliers. The first
comparison is with the surroundings so that a sparse region of a surface stays. If that would be all points, there are none.

\param radius of the ball, \f$ r_p \f$
\returns whether each point is an outlier
*/
template <typename T, typename ConcurrencyTag>
Buffer<unsigned char> find_outliers(const Buffer<Vector>& unsorted_points, double radius, Progress& progress)
{
  const auto allocator = unsorted_points.get_allocator();
  const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(unsorted_points, radius);
  Buffer<Vector> points = copy_of(unsorted_points);
  apply_order(order, points);
  const Search_grid_3 grid(points, radius);

  const Buffer<double> counts = count_points_in_balls<T, ConcurrencyTag>(grid, points, radius, progress);
  const Buffer<double> surroundings = means_around<ConcurrencyTag>(grid, counts, progress);
  Buffer<double> sorted_counts = copy_of(counts);
  const auto middle = sorted_counts.begin() + std::ptrdiff_t(sorted_counts.size() / 2);
  select_nth(sorted_counts.begin(), middle, sorted_counts.end());
  const double median = *middle;

  Buffer<Index> rest(allocator);
  Buffer<Vector> rest_points(allocator);
  rest.reserve(points.size());
  rest_points.reserve(points.size());
  for_each_in_order(points.size(), [&](std::size_t i) {
    if (counts[i] >= (std::max)(outlier_share_of_surroundings * surroundings[i], outlier_share_of_median * median))
    {
      rest.push_back(order[i]);
      rest_points.push_back(points[i]);
    }
  });
  const Buffer<Index> sizes = sizes_of_parts<ConcurrencyTag>(rest_points, gap_of_parts * radius, progress);

  Buffer<unsigned char> is_outlier(points.size(), 1, allocator);
  bool is_any_left = false;
  for_each_in_order(rest.size(), [&](std::size_t k) {
    if (sizes[k] >= median / 2)
    {
      is_outlier[rest[k]] = 0;
      is_any_left = true;
    }
  });
  if (!is_any_left)
    is_outlier.assign(points.size(), 0);
  return is_outlier;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIND_OUTLIERS_H
