// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_THIN_CROWDS_H
#define CGAL_L0_RESAMPLING_INTERNAL_THIN_CROWDS_H

#include <CGAL/L0_resampling/internal/kernels/crowded_subcells.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The points that stand for all points of a set, some of which are too close together to be
/// worked on one by one.
struct Representatives
{
  /// For each point, the index of the one that stands for it: a kept point stands for itself. Empty
  /// if all points are kept.
  Buffer<Index> of_points;

  bool are_all_points() const { return of_points.empty(); }
  bool is_kept(std::size_t i) const { return of_points[i] == Index(i); }

  /// Removes the values of the points that are not kept.
  template <typename T>
  void keep(Buffer<T>& values) const
  {
    if (are_all_points() || values.empty())
      return;
    std::size_t size = 0;
    for_each_in_order(of_points.size(), [&](std::size_t i) {
      if (is_kept(i))
        values[size++] = values[i];
    });
    values.resize(size);
  }

  /// How many points each kept point stands for.
  Buffer<Index> numbers_of_points() const
  {
    Buffer<Index> numbers = filled_buffer(of_points.size(), Index(0), of_points.get_allocator());
    for_each_in_order(of_points.size(), [&](std::size_t i) { ++numbers[of_points[i]]; });
    keep(numbers);
    return numbers;
  }
};

/// The cells of a grid of which a subcell, an eighth of a cell wide, holds more than `limit`
/// points. The outermost cells have no size, and never count.
class Crowded_cells
{
  using Counts = std::array<Index, subcells_of_cell>;

  const Search_grid_3& m_grid;
  const Buffer<Vector>& m_points;
  Index m_limit;

public:
  /// \param points sorted for `grid`
  Crowded_cells(const Search_grid_3& grid, const Buffer<Vector>& points, Index limit)
    : m_grid(grid), m_points(points), m_limit(limit)
  {}

  /// Calls `f(cell, range, counts)` for each such cell, with its points and the numbers of them in
  /// its subcells; at the same time for several cells.
  /// \returns the number of such cells
  template <typename ConcurrencyTag, typename F>
  std::size_t for_each(const F& f) const
  {
    const std::size_t cells_per_block = 256;
    return block_sum<ConcurrencyTag>(m_grid.number_of_cells(), cells_per_block,
                                     [&](std::size_t begin, std::size_t end) {
                                       Counts counts;
                                       std::size_t number_of_crowded_cells = 0;
                                       for (std::size_t cell = begin; cell < end; ++cell)
                                         if (is_crowded(cell, counts))
                                         {
                                           ++number_of_crowded_cells;
                                           f(cell, m_grid.points_of_cell(cell), counts);
                                         }
                                       return number_of_crowded_cells;
                                     });
  }

  template <typename ConcurrencyTag>
  bool are_there_any() const
  {
    return for_each<ConcurrencyTag>([](std::size_t, const Search_grid_3::Range&, const Counts&) {})
           > 0;
  }

  std::size_t subcell(Index i, std::size_t cell) const
  {
    return subcell_of(m_points[i].data(), m_grid.size_of_cell(cell));
  }

private:
  bool is_crowded(std::size_t cell, Counts& counts) const
  {
    const Search_grid_3::Range range = m_grid.points_of_cell(cell);
    if (range.second - range.first <= m_limit || m_grid.is_unbounded(cell))
      return false;
    counts.fill(0);
    bool is = false;
    for (Index i = range.first; i < range.second; ++i)
      is |= ++counts[subcell(i, cell)] > m_limit;
    return is;
  }
};

/*!
Thins a point set to at most `limit` points in each subcell of the grid, evenly in the order of the
points. So the work of all stages is bounded by the extent of the set in units of the cells, however
many points coincide or almost do, while sparse points beside such a crowd are kept.

\param points sorted for `grid`
*/
template <typename ConcurrencyTag>
Representatives thin_crowds(const Search_grid_3& grid, const Buffer<Vector>& points, Index limit)
{
  const Crowded_cells cells(grid, points, limit);
  Representatives result{Buffer<Index>(points.get_allocator())};
  if (!cells.are_there_any<ConcurrencyTag>())
    return result;
  result.of_points.reserve(points.size());
  for_each_in_order(points.size(), [&](std::size_t i) { result.of_points.push_back(Index(i)); });
  cells.for_each<ConcurrencyTag>(
    [&](std::size_t cell, const Search_grid_3::Range& range, const auto& counts) {
      std::array<Index, subcells_of_cell> ranks{}, last_kept;
      for (Index i = range.first; i < range.second; ++i)
      {
        const std::size_t s = cells.subcell(i, cell);
        if (is_kept_of_crowd(ranks[s]++, counts[s], limit))
          last_kept[s] = i;
        result.of_points[i] = last_kept[s];
      }
    });
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_THIN_CROWDS_H
