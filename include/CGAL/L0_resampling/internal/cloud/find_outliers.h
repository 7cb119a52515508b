// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIND_OUTLIERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIND_OUTLIERS_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/select_nth.h>
#include <CGAL/L0_resampling/internal/kernels/outlier_tests.h>
#include <CGAL/L0_resampling/internal/search/Morton_places.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>
#include <CGAL/L0_resampling/internal/search/thin_crowds.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The number of points in the ball of each query, itself included, and in the one of half the
/// radius.
struct Counts_in_balls
{
  Buffer<double> in_ball, in_half_ball;
};

/// \param queries sorted for `query_grid`
/// \param points sorted for `grid`; neither has cells smaller than `radius` times the scale
template <typename T, typename ConcurrencyTag>
Counts_in_balls count_points_in_balls(const Search_grid_3& query_grid,
                                      const Buffer<Vector>& queries, const Search_grid_3& grid,
                                      const Buffer<Vector>& points, double radius,
                                      Progress& progress)
{
  Counts_in_balls counts{filled_buffer(queries.size(), 0., queries.get_allocator()),
                         filled_buffer(queries.size(), 0., queries.get_allocator())};
  for_each_cell<T, ConcurrencyTag>(query_grid, queries, grid, points, 1, progress, [&]() {
    return [&](Search_grid_3::Range range, Local_points<T>& candidates, const Vector& origin) {
      using L = Lanes<T>;
      for (Index i = range.first; i < range.second; ++i)
      {
        const T squared_radius = T(square(radius * query_grid.scale(i))),
                squared_half_radius = squared_radius / 4;
        L in_ball, in_half_ball;
        candidates.for_each_run_in_ball(
          (queries[i] - origin).template cast<T>(), squared_radius,
          [&](std::size_t, const L& squared_distance) {
            in_ball += where_less(squared_distance, squared_radius, L(T(1)));
            in_half_ball += where_less(squared_distance, squared_half_radius, L(T(1)));
          });
        counts.in_ball[i] = double(in_ball.sum()) * double(candidates.stride);
        counts.in_half_ball[i] = double(in_half_ball.sum()) * double(candidates.stride);
      }
    };
  });
  return counts;
}

/// Sums of values of points, over ranges of the points.
class Range_sums
{
  Buffer<double> m_sums; // of the values before each point

public:
  explicit Range_sums(const Buffer<double>& values) : m_sums(1, 0., values.get_allocator())
  {
    m_sums.reserve(values.size() + 1);
    for_each_in_order(values.size(),
                      [&](std::size_t i) { m_sums.push_back(m_sums.back() + values[i]); });
  }

  double operator()(const std::vector<Search_grid_3::Range>& ranges) const
  {
    double sum = 0;
    for (const Search_grid_3::Range& range : ranges)
      sum += m_sums[range.second] - m_sums[range.first];
    return sum;
  }
};

/// The mean of the values of the points in the block of cells around the cell of each point.
template <typename ConcurrencyTag>
Buffer<double> means_around(const Search_grid_3& grid, const Buffer<double>& values,
                            Progress& progress)
{
  const Range_sums sums(values);
  Buffer<double> means = filled_buffer(values.size(), 0., values.get_allocator());
  for_each_cell_block<ConcurrencyTag>(grid, grid, 1, progress, [&]() {
    return [&](Index cell, const std::vector<Search_grid_3::Range>& ranges, std::size_t count) {
      const Search_grid_3::Range own = grid.points_of_cell(cell);
      std::fill(means.begin() + own.first, means.begin() + own.second,
                sums(ranges) / double(count));
    };
  });
  return means;
}

/*!
Whether sparse points fill space, as a crowd of outliers does, rather than lie in a sheet, as the
sparse end of a scan: by how the numbers of points grow from their balls of r_p/2 to those of 2 r_p,
in sum over the sparse points in the block of cells of 2 r_p around each. A point alone has too few
others to tell.

\param scales of the points; none if all are 1
\param sparse which of the points are sparse
\param counts_in_half_balls of the sparse points
\param radius \f$ r_p \f$, at scale 1
\param minimum_ratio from where on points fill space
*/
template <typename T, typename ConcurrencyTag>
Buffer<unsigned char> fill_space(const Buffer<Vector>& unsorted_points, const Scales_view& scales,
                                 const Buffer<Index>& sparse,
                                 const Buffer<double>& counts_in_half_balls, double radius,
                                 double minimum_ratio, Progress& progress)
{
  const double cell_size = 2 * radius;
  const Buffer<Vector> unsorted_sparse_points = values_in_order<ConcurrencyTag>(sparse,
                                                                                unsorted_points);
  const Sorted_queries all(ConcurrencyTag(), unsorted_points, Cell_sizes(cell_size, scales));
  const Sorted_queries sparse_points(ConcurrencyTag(), unsorted_sparse_points,
                                     Cell_sizes(cell_size, listed_scales(scales, sparse)));

  // the point itself is none of the others
  const auto others = [](Buffer<double> counts) {
    for (double& count : counts)
      --count;
    return counts;
  };
  Buffer<double> inner_counts = copy_of(counts_in_half_balls);
  apply_order(sparse_points.order, inner_counts);
  const Range_sums inner_sums(others(std::move(inner_counts)));
  const Range_sums outer_sums(
    others(count_points_in_balls<T, ConcurrencyTag>(sparse_points.grid, sparse_points.points,
                                                    all.grid, all.points, cell_size, progress)
             .in_ball));
  Buffer<unsigned char> result = filled_buffer(sparse.size(), static_cast<unsigned char>(0),
                                               unsorted_points.get_allocator());
  for_each_cell_block<Sequential_tag>(sparse_points.grid, sparse_points.grid, 1, progress, [&]() {
    return [&](Index cell, const std::vector<Search_grid_3::Range>& ranges, std::size_t) {
      const bool fills = is_space_filled(outer_sums(ranges), inner_sums(ranges), minimum_ratio);
      const Search_grid_3::Range own = sparse_points.grid.points_of_cell(cell);
      for (Index i = own.first; i < own.second; ++i)
        result[sparse_points.order[i]] = fills;
    };
  });
  return result;
}

/// Keeps the outliers that lie in a sheet of sparse points.
/// \param tellers which of the points `may_tell_sheet()`
/// \param extent of the whole cloud, outliers left out
/// \param radius \f$ r_p \f$, at scale 1
/// \param scales of the points; none if all are 1
template <typename ConcurrencyTag>
void keep_sparse_sheets(const Buffer<Vector>& points, const Scales_view& scales,
                        const Buffer<Index>& tellers, double extent, double radius,
                        Progress& progress, Buffer<unsigned char>& is_outlier)
{
  const std::size_t points_per_block = 64;
  if (std::none_of(tellers.begin(), tellers.end(), [&](Index i) { return is_outlier[i] != 0; }))
    return;
  const Morton_places places = places_of<ConcurrencyTag>(
    values_in_order<ConcurrencyTag>(tellers, points), cells_of_places(extent));
  const Morton_points view = places.view();
  for_each_block<ConcurrencyTag>(
    tellers.size(), points_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
      {
        const Index i = tellers[k];
        if (is_outlier[i])
          is_outlier[i] = !lies_in_sheet(One_thread(), view,
                                         view.lower_bound(view.cells.code(points[i].data())),
                                         reach_of_sparse_sheet(radius, scales[i]));
      }
      progress.advance(0);
    });
}

/// The number of points of the connected part that each cell is in, where cells that touch are
/// connected.
inline Buffer<Index> sizes_of_parts(const Search_grid_3& grid,
                                    const Counting_allocator<Index>& allocator, Progress& progress)
{
  const std::size_t number_of_cells = grid.number_of_cells();
  Buffer<Index> cell_of_points(grid.number_of_points(), allocator),
    ranks = filled_buffer(number_of_cells, Index(0), allocator),
    parents = filled_buffer(number_of_cells, Index(0), allocator),
    sizes = filled_buffer(number_of_cells, Index(0), allocator);
  boost::disjoint_sets<Index*, Index*> parts(ranks.data(), parents.data());
  for_each_in_order(number_of_cells, [&](std::size_t cell) {
    parts.make_set(Index(cell));
    const Search_grid_3::Range own = grid.points_of_cell(cell);
    std::fill(cell_of_points.begin() + own.first, cell_of_points.begin() + own.second, Index(cell));
  });
  for_each_cell_block<Sequential_tag>(grid, grid, 1, progress, [&]() {
    return [&](Index cell, const std::vector<Search_grid_3::Range>& ranges, std::size_t) {
      for (const Search_grid_3::Range& range : ranges)
      {
        // the cells of a run, three at most, touch their neighbors in it
        parts.union_set(cell, cell_of_points[range.first]);
        parts.union_set(cell, cell_of_points[range.second - 1]);
      }
    };
  });
  for_each_in_order(number_of_cells, [&](std::size_t cell) {
    const Search_grid_3::Range own = grid.points_of_cell(cell);
    sizes[parts.find_set(Index(cell))] += own.second - own.first;
  });
  Buffer<Index> sizes_of_cells(number_of_cells, allocator);
  for_each_in_order(number_of_cells, [&](std::size_t cell) {
    sizes_of_cells[cell] = sizes[parts.find_set(Index(cell))];
  });
  return sizes_of_cells;
}

/*!
Finds the points that lie off the cloud: those whose ball holds far fewer points than the balls
around them do, or than the median ball of the cloud; sparse ones that fill space; and, among the
others, those of connected components that have fewer points than half a median ball, such as
clusters of outliers. The first comparison is with the surroundings so that a sparse region of a
surface stays, and so do sparse points that lie in a sheet of their like. Which points are sparse
does not depend on the thresholds: the sums over them, and so who of them is an outlier, would
change with it. If that would be all points of a cloud, there are none; of a part of a cloud, all
may be.

\param sorted the points, in cells of the radius; none once they have been read
\param radius of the ball, \f$ r_p \f$, at scale 1
\param extent of the whole cloud, outliers left out
\param scales of the points; none if all are 1
\param known_median how many points the median ball of the whole cloud holds: given, or found here
\returns whether each point is an outlier
*/
template <typename T, typename ConcurrencyTag>
Buffer<unsigned char> find_outliers_among(const Buffer<Vector>& unsorted_points,
                                          std::optional<Sorted_queries>& sorted, double radius,
                                          double extent, const Outlier_thresholds& thresholds,
                                          const Scales_view& scales,
                                          std::optional<double>& known_median, Progress& progress)
{
  const auto allocator = unsorted_points.get_allocator();
  const std::size_t n = unsorted_points.size(), points_per_block = 4096;
  const bool is_part = known_median.has_value();
  Buffer<unsigned char> is_outlier(n, 1, allocator);
  Buffer<Index> sparse(allocator), tellers(allocator);
  Buffer<double> counts_in_half_balls(allocator);
  double median;
  bool is_any_sparse_kept = false;
  {
    const Search_grid_3& grid = sorted->grid;
    const Counts_in_balls counts = count_points_in_balls<T, ConcurrencyTag>(
      grid, sorted->points, grid, sorted->points, radius, progress);
    const Buffer<double> surroundings = means_around<ConcurrencyTag>(grid, counts.in_ball,
                                                                     progress);
    if (!known_median)
      known_median = median_of(copy_of(counts.in_ball));
    median = *known_median;
    for_each_in_order(n, [&](std::size_t i) {
      const double count = counts.in_ball[i];
      const bool is_kept = count >= minimum_count_of_ball(thresholds, surroundings[i], median);
      is_outlier[sorted->order[i]] = !is_kept;
      if (may_tell_sheet(count, surroundings[i], median))
        tellers.push_back(sorted->order[i]);
      if (is_sparse(count, surroundings[i], median))
      {
        sparse.push_back(sorted->order[i]);
        counts_in_half_balls.push_back(counts.in_half_ball[i]);
        is_any_sparse_kept = is_any_sparse_kept || is_kept;
      }
    });
  }
  Buffer<Index> rest = std::move(sorted->order);
  sorted.reset();
  if (is_any_sparse_kept)
  {
    const Buffer<unsigned char> fills =
      fill_space<T, ConcurrencyTag>(unsorted_points, scales, sparse, counts_in_half_balls, radius,
                                    thresholds.volume_filling_ratio, progress);
    for_each_in_order(sparse.size(), [&](std::size_t k) {
      is_outlier[sparse[k]] = is_outlier[sparse[k]] || fills[k];
    });
  }

  keep_by_blocks<ConcurrencyTag>(
    points_per_block,
    [&](Index i) { return is_outlier[i] ? std::nullopt : std::optional<Index>(i); }, rest);
  const Sorted_queries sorted_rest(ConcurrencyTag(), unsorted_points, Cell_sizes(radius, scales),
                                   std::move(rest)); // which are sorted as all points were
  const Buffer<Index> sizes = sizes_of_parts(sorted_rest.grid, allocator, progress);
  for_each_in_order(sizes.size(), [&](std::size_t cell) {
    const bool is_small = is_part_small(sizes[cell], thresholds.share_of_part, median);
    const Search_grid_3::Range own = sorted_rest.grid.points_of_cell(cell);
    for (Index k = own.first; k < own.second; ++k)
      is_outlier[sorted_rest.order[k]] = is_small;
  });
  keep_sparse_sheets<ConcurrencyTag>(unsorted_points, scales, tellers, extent, radius, progress,
                                     is_outlier);
  if (!is_part && std::all_of(is_outlier.begin(), is_outlier.end(), [](unsigned char is) {
        return is != 0;
      }))
    is_outlier.assign(n, 0);
  return is_outlier;
}

/// The points that stand for all of a set, as `thin_crowds()` says: a crowd would otherwise be all
/// that the median ball and the surroundings of a point are made of.
class Representatives_of_cloud
{
  Buffer<Index> m_list;            // of them; none if all stand for themselves
  Buffer<Index> m_representatives; // which of all points stands for each; likewise
  Buffer<Vector> m_points;         // likewise: where they are
  Buffer<float> m_scales;          // likewise; also none if all are 1
  const Buffer<Vector>& m_all_points;
  Scales_view m_all_scales;
  std::optional<Sorted_queries> m_sorted;

public:
  /// \param points, scales outlive this object
  /// \param radius of the balls, at scale 1
  template <typename ConcurrencyTag>
  Representatives_of_cloud(ConcurrencyTag tag, const Buffer<Vector>& points, double radius,
                           const Scales_view& scales)
    : m_list(points.get_allocator()), m_representatives(points.get_allocator()),
      m_points(points.get_allocator()), m_scales(points.get_allocator()), m_all_points(points),
      m_all_scales(scales)
  {
    const std::size_t n = points.size();
    m_sorted.emplace(tag, points, Cell_sizes(radius, scales));
    {
      const Representatives found = thin_crowds<ConcurrencyTag>(
        m_sorted->grid, m_sorted->points, maximum_number_of_points_of_subcell);
      if (found.are_all_points())
        return;
      m_representatives = filled_buffer(n, Index(0), points.get_allocator());
      for_each_in_order(n, [&](std::size_t i) {
        if (found.is_kept(i))
          m_list.push_back(m_sorted->order[i]);
        m_representatives[m_sorted->order[i]] = m_sorted->order[found.of_points[i]];
      });
    }
    m_sorted.reset();
    m_points = values_in_order<ConcurrencyTag>(m_list, points);
    m_scales = listed_scales(scales, m_list);
    m_sorted.emplace(tag, m_points, Cell_sizes(radius, m_scales));
  }

  bool are_all_points() const { return m_list.empty(); }
  const Buffer<Vector>& points() const { return are_all_points() ? m_all_points : m_points; }
  Scales_view scales() const { return are_all_points() ? m_all_scales : view_of_scales(m_scales); }
  /// Those points in cells of the radius; may be taken away.
  std::optional<Sorted_queries>& sorted() { return m_sorted; }
  /// Which of all points the k-th of them is.
  Index operator[](std::size_t k) const { return are_all_points() ? Index(k) : m_list[k]; }

  /// For all points what is known of those that stand for them.
  Buffer<unsigned char> of_all(Buffer<unsigned char> values) const
  {
    if (are_all_points())
      return values;
    Buffer<unsigned char> result = filled_buffer(m_all_points.size(), static_cast<unsigned char>(0),
                                                 m_all_points.get_allocator());
    for_each_in_order(m_list.size(), [&](std::size_t k) { result[m_list[k]] = values[k]; });
    for_each_in_order(m_all_points.size(),
                      [&](std::size_t i) { result[i] = result[m_representatives[i]]; });
    return result;
  }
};

/// The same for points of which any number may be at one place: those that stand for others are
/// judged, and the others share their lot.
template <typename T, typename ConcurrencyTag>
Buffer<unsigned char> find_outliers(const Buffer<Vector>& points, double radius, double extent,
                                    const Outlier_thresholds& thresholds, const Scales_view& scales,
                                    std::optional<double>& known_median, Progress& progress)
{
  Representatives_of_cloud standing(ConcurrencyTag(), points, radius, scales);
  return standing.of_all(
    find_outliers_among<T, ConcurrencyTag>(standing.points(), standing.sorted(), radius, extent,
                                           thresholds, standing.scales(), known_median, progress));
}

/// Calls `f(i, number)` for each of the points that `find_outliers()` judges, with the number of
/// points in its ball.
template <typename T, typename ConcurrencyTag, typename F>
void for_each_number_of_neighbors(const Buffer<Vector>& points, double radius,
                                  const Scales_view& scales, Progress& progress, const F& f)
{
  Representatives_of_cloud standing(ConcurrencyTag(), points, radius, scales);
  const Sorted_queries& sorted = *standing.sorted();
  const Counts_in_balls counts = count_points_in_balls<T, ConcurrencyTag>(
    sorted.grid, sorted.points, sorted.grid, sorted.points, radius, progress);
  for_each_in_order(sorted.order.size(),
                    [&](std::size_t k) { f(standing[sorted.order[k]], counts.in_ball[k]); });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIND_OUTLIERS_H
