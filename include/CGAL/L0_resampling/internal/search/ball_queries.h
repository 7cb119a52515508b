// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_BALL_QUERIES_H
#define CGAL_L0_RESAMPLING_INTERNAL_BALL_QUERIES_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/core/lanes.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Cells to each side that a ball of this radius around any point of a cell can touch.
inline int cells_in_reach(double radius, double cell_size)
{
  return int(std::ceil(radius / cell_size));
}

/*!
The points of a block of cells, as arrays of coordinates relative to the block, ready for vector
instructions.

A ball holds few points of a cloud that is everywhere; relative coordinates of type `float` resolve
it as well as `double` does, and twice as many fit in a register. The arrays are padded to full
lanes with points so far away that no ball holds them.

A block of more than `maximum_number_of_candidates` points is thinned to every s-th of them, s a
power of two: this bounds the neighbors of a point, and the time, where a million points share a
cell. The points of the block are counted in its own order, from its first one on, so that the
choice does not depend on the rest of the cloud.
*/
template <typename T>
class Local_points
{
public:
  Aligned_vector<T> x, y, z;
  std::vector<Index> indices; ///< of the points, without the padding
  Index stride = 1;           ///< s: every s-th point was taken

  /// \param count the number of points in the ranges
  void gather(const std::vector<Search_grid_3::Range>& ranges, std::size_t count,
              const Buffer<Vector>& points, const Vector& origin)
  {
    stride = 1;
    while (count / stride > maximum_number_of_candidates)
      stride *= 2;

    const std::size_t lanes = Lanes<T>::size, maximum_size = count / stride + 1 + lanes;
    indices.resize(maximum_size);
    m_runs_of_indices.clear();
    std::size_t size = 0;
    Index number_before = 0; // of the points of the block in the ranges before
    for (const Search_grid_3::Range& range : ranges)
    {
      // the stride is a power of two
      const Index number = range.second - range.first, skipped = (0 - number_before) & (stride - 1);
      number_before += number;
      if (skipped >= number)
        continue;
      const Index first = range.first + skipped;
      const std::size_t run = (number - skipped - 1) / stride + 1;
      m_runs_of_indices.push_back({first, size, size + run});
      for (std::size_t k = 0; k < run; ++k)
        indices[size + k] = first + Index(k) * stride;
      size += run;
    }
    for (Aligned_vector<T>* coordinates : {&x, &y, &z})
      coordinates->resize(maximum_size);
    gather_coordinates(coordinates(points), origin.data(), x, y, z);
    const std::size_t padded_size = (size + lanes - 1) / lanes * lanes;
    for (Aligned_vector<T>* coordinates : {&x, &y, &z})
    {
      coordinates->resize(padded_size);
      std::fill(coordinates->begin() + std::ptrdiff_t(size), coordinates->end(), far_away);
    }
    indices.resize(size);
    // an outermost cell may hold points at any distance, whose squares would not be finite
    for (Aligned_vector<T>* coordinates : {&x, &y, &z})
      for (std::size_t k = 0; k < padded_size; k += lanes)
        at_most(at_least(Lanes<T>::load(&(*coordinates)[k]), -far_away), far_away)
          .store(&(*coordinates)[k]);
  }

  /// Gathers coordinates of the points, or of vectors that belong to them, relative to `origin`.
  /// \param vectors xyz interleaved, one for each point of the cloud
  /// \param to_x, to_y, to_z have room for all points
  template <typename U>
  void gather_coordinates(const U* vectors, const U* origin, Aligned_vector<T>& to_x,
                          Aligned_vector<T>& to_y, Aligned_vector<T>& to_z) const
  {
    const U x0 = origin[0], y0 = origin[1], z0 = origin[2];
    const auto gather_run = [&](const Run& run, auto step) {
      const U* const from = vectors + 3 * std::size_t(run.first);
      T *const tx = to_x.data() + run.begin, *const ty = to_y.data() + run.begin,
               *const tz = to_z.data() + run.begin;
      for (std::size_t k = 0, size = run.end - run.begin; k < size; ++k)
      {
        tx[k] = T(from[3 * step * k] - x0);
        ty[k] = T(from[3 * step * k + 1] - y0);
        tz[k] = T(from[3 * step * k + 2] - z0);
      }
    };
    for (const Run& run : m_runs_of_indices)
      if (stride == 1)
        gather_run(
          run, std::integral_constant<
                 std::size_t, 1>()); // known to the compiler, which then uses vector instructions
      else
        gather_run(run, std::size_t(stride));
  }

  /// Moves a point out of reach of every ball.
  /// \returns where it was
  Eigen::Matrix<T, 3, 1> take(std::size_t k)
  {
    Eigen::Matrix<T, 3, 1> place(x[k], y[k], z[k]);
    x[k] = far_away;
    return place;
  }

  /// Number of points, padding included: a multiple of the number of lanes.
  std::size_t padded_size() const { return x.size(); }

  /// Calls `f(k, squared_distances)` for each run of as many points as there are lanes, from the
  /// k-th on, of which one is in the ball. Points that follow each other are neighbors, so that
  /// half of the runs have none. Which half, no processor foresees: listing the others before
  /// calling `f` costs less than a branch that is guessed wrong half of the time. Not to be called
  /// from `f`: the list is of the object.
  template <typename F>
  void for_each_run_in_ball(const Eigen::Matrix<T, 3, 1>& center, T squared_radius, const F& f)
  {
    constexpr std::size_t lanes = Lanes<T>::size;
    m_runs.resize(padded_size() / lanes + 1);
    m_squared_distances.resize(padded_size() + lanes);
    Index* const runs = m_runs.data();
    T* const distances = m_squared_distances.data();
    std::size_t count = 0;
    for (std::size_t k = 0, size = padded_size(); k < size; k += lanes)
    {
      const Lanes<T> squared_distance = squared_distances(k, center);
      runs[count] = Index(k);
      squared_distance.store(distances + count * lanes);
      count += any_less(squared_distance, squared_radius);
    }
    for (std::size_t r = 0; r < count; ++r)
      f(std::size_t(runs[r]), Lanes<T>::load(distances + r * lanes));
  }

  /// From `center` to the points from the k-th on, as many as there are lanes.
  Lanes<T> squared_distances(std::size_t k, const Eigen::Matrix<T, 3, 1>& center) const
  {
    const Lanes<T> dx = Lanes<T>::load(&x[k]) - center[0];
    const Lanes<T> dy = Lanes<T>::load(&y[k]) - center[1];
    const Lanes<T> dz = Lanes<T>::load(&z[k]) - center[2];
    return dx * dx + dy * dy + dz * dz;
  }

private:
  struct Run
  {
    Index first;
    std::size_t begin, end;
  }; // the indices in these places ascend from the first by the stride
  std::vector<Run> m_runs_of_indices;

  // working memory of `for_each_run_in_ball()`
  std::vector<Index> m_runs;
  Aligned_vector<T> m_squared_distances;

  static constexpr T far_away = T(1e12); // its square is finite in `float`
};

/// Queries in any order, sorted into the cells of a grid, so that those near each other share their
/// candidates.
class Sorted_queries
{
public:
  Buffer<Index> order; ///< which query stands where
  const Buffer<Vector> points;
  const Buffer<float> scales; ///< none if all are 1
  const Search_grid_3 grid;

  /// \param sizes of cells, with the scales of the unsorted points
  template <typename ConcurrencyTag>
  Sorted_queries(ConcurrencyTag tag, const Buffer<Vector>& unsorted_points, const Cell_sizes& sizes)
    : Sorted_queries(tag, unsorted_points, sizes,
                     Search_grid_3::sorted_order<ConcurrencyTag>(unsorted_points, sizes))
  {}

  /// \param known_order which of the points to take, and where each stands
  template <typename ConcurrencyTag>
  Sorted_queries(ConcurrencyTag tag, const Buffer<Vector>& unsorted_points, const Cell_sizes& sizes,
                 Buffer<Index> known_order)
    : order(std::move(known_order)),
      points(values_in_order<ConcurrencyTag>(order, unsorted_points)),
      scales(listed_scales(sizes.scales, order)), grid(tag, points, Cell_sizes(sizes.base, scales))
  {}
};

/// Calls `visitor(cell, ranges, count)` for each occupied cell of a row, with the runs of points
/// that the cursor finds around it, and their number. Runs ascend.
template <typename Visitor>
void for_each_cell_of_row(const Search_grid_3& grid, std::size_t row,
                          Search_grid_3::Block_cursor& cursor,
                          std::vector<Search_grid_3::Range>& ranges, const Visitor& visitor)
{
  const Search_grid_3::Range cells = grid.row(row);
  cursor.enter_row(grid.key_of_cell(cells.first));
  for (Index cell = cells.first; cell < cells.second; ++cell)
  {
    const std::size_t count = cursor.ranges_around(grid.key_of_cell(cell), ranges);
    visitor(cell, ranges, count);
  }
}

/// Rows whose cells are visited one after the other.
constexpr std::size_t rows_per_block = 4;

using Cell_function = Function_view<Index, const std::vector<Search_grid_3::Range>&, std::size_t>;

/// `for_each_cell_block()` for the rows `[begin, end)` of `query_grid`.
inline void visit_cells_of_rows(const Search_grid_3& query_grid, std::size_t begin, std::size_t end,
                                const Search_grid_3& point_grid, int reach, Progress& progress,
                                const Cell_function& visitor)
{
  Search_grid_3::Block_cursor cursor(point_grid, reach);
  std::vector<Search_grid_3::Range> ranges;
  for (std::size_t r = begin; r < end; ++r)
    for_each_cell_of_row(query_grid, r, cursor, ranges,
                         [&](Index cell, const auto& found, std::size_t count) {
                           visitor(cell, found, count);
                           const Search_grid_3::Range queries = query_grid.points_of_cell(cell);
                           progress.advance(queries.second - queries.first);
                         });
}

/*!
Calls `visitor(cell, ranges, count)` for each occupied cell of `query_grid`, with the runs of points
of `point_grid` that lie within `reach` cells of it, and their number. Runs ascend.

`make_visitor` is called once in a while to make a visitor with arrays of its own, so that visitors
can run at the same time.
*/
template <typename ConcurrencyTag, typename Make_visitor>
void for_each_cell_block(const Search_grid_3& query_grid, const Search_grid_3& point_grid,
                         int reach, Progress& progress, const Make_visitor& make_visitor)
{
  for_each_block<ConcurrencyTag>(
    query_grid.number_of_rows(), rows_per_block, [&](std::size_t begin, std::size_t end) {
      auto visitor = make_visitor();
      const auto visit = [&](Index cell, const std::vector<Search_grid_3::Range>& ranges,
                             std::size_t count) { visitor(cell, ranges, count); };
      visit_cells_of_rows(query_grid, begin, end, point_grid, reach, progress,
                          Cell_function(visit));
    });
}

/// Of how many cells `Local_points` does not take all points of the block around them as they are:
/// the block is thinned, or the cell is an outermost one, whose points may be anywhere.
/// \param counts called with a cell: whether it counts
template <typename ConcurrencyTag, typename Counts>
std::size_t number_of_blocks_not_plain(const Search_grid_3& grid, int reach, const Counts& counts)
{
  return block_sum<ConcurrencyTag>(
    grid.number_of_rows(), rows_per_block, [&](std::size_t begin, std::size_t end) {
      Search_grid_3::Block_cursor cursor(grid, reach);
      std::vector<Search_grid_3::Range> ranges;
      std::size_t number = 0;
      for (std::size_t r = begin; r < end; ++r)
        for_each_cell_of_row(
          grid, r, cursor, ranges, [&](Index cell, const auto&, std::size_t count) {
            number += counts(cell)
                      && (grid.is_unbounded(cell) || count > maximum_number_of_candidates);
          });
      return number;
    });
}

/// Whether all balls are of one size, and all blocks of cells are plain.
template <typename ConcurrencyTag>
bool has_plain_blocks_only(const Search_grid_3& grid, int reach)
{
  return grid.has_one_scale() && number_of_blocks_not_plain<ConcurrencyTag>(grid, reach, [](Index) {
                                   return true;
                                 }) == 0;
}

template <typename T>
using Candidates_function =
  Function_view<const Search_grid_3::Range&, Local_points<T>&, const Vector&>;

/// `for_each_cell()` for one cell.
/// \param candidates working memory
template <typename T>
void visit_candidates(const Search_grid_3& query_grid, const Buffer<Vector>& query_points,
                      const Buffer<Vector>& points, Index cell,
                      const std::vector<Search_grid_3::Range>& ranges, std::size_t count,
                      Local_points<T>& candidates, const Candidates_function<T>& visitor)
{
  const Search_grid_3::Range queries = query_grid.points_of_cell(cell);
  if (!query_grid.is_unbounded(cell))
  {
    const Vector origin = query_grid.cell_center(cell);
    candidates.gather(ranges, count, points, origin);
    visitor(queries, candidates, origin);
    return;
  }
  // no single origin is near to all points of such a cell
  for (Index i = queries.first; i < queries.second; ++i)
  {
    candidates.gather(ranges, count, points, query_points[i]);
    visitor(Search_grid_3::Range(i, i + 1), candidates, query_points[i]);
  }
}

/// As `for_each_cell_block()`, but calls `visitor(queries, candidates, origin)`: `queries` is the
/// run of query points of the cell, and `candidates` holds the points around them relative to
/// `origin`.
template <typename T, typename ConcurrencyTag, typename Make_visitor>
void for_each_cell(const Search_grid_3& query_grid, const Buffer<Vector>& query_points,
                   const Search_grid_3& point_grid, const Buffer<Vector>& points, int reach,
                   Progress& progress, const Make_visitor& make_visitor)
{
  for_each_cell_block<ConcurrencyTag>(query_grid, point_grid, reach, progress, [&]() {
    return
      [&, visitor = make_visitor(), candidates = Local_points<T>()](
        Index cell, const std::vector<Search_grid_3::Range>& ranges, std::size_t count) mutable {
        const auto visit = [&](const Search_grid_3::Range& queries, Local_points<T>& around,
                               const Vector& origin) { visitor(queries, around, origin); };
        visit_candidates(query_grid, query_points, points, cell, ranges, count, candidates,
                         Candidates_function<T>(visit));
      };
  });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_BALL_QUERIES_H
