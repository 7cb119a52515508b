// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SEARCH_GRID_3_H
#define CGAL_L0_RESAMPLING_INTERNAL_SEARCH_GRID_3_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/parallel_sort.h>
#include <CGAL/L0_resampling/internal/kernels/levels_of_scales.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

using Vector = Eigen::Vector3d;

/// The scalar type of what happens within one ball, where relative coordinates make `float` enough.
using Local = float;
using Local_vector = Eigen::Matrix<Local, 3, 1>;

/// The coordinates of the vectors, xyz interleaved; null if there are none.
template <typename T>
const T* coordinates(const Buffer<Eigen::Matrix<T, 3, 1>>& vectors)
{
  return vectors.empty() ? nullptr : vectors.front().data();
}
template <typename T>
T* coordinates(Buffer<Eigen::Matrix<T, 3, 1>>& vectors)
{
  return vectors.empty() ? nullptr : vectors.front().data();
}

inline Scales_view view_of_scales(const Buffer<float>& scales)
{
  return {scales.empty() ? nullptr : scales.data()};
}

/// The scales of those points that a list names; none if all are 1.
inline Buffer<float> listed_scales(const Scales_view& scales, const Buffer<Index>& list)
{
  Buffer<float> listed(list.get_allocator());
  if (scales.values)
    for_each_in_order(list.size(), [&](std::size_t k) { listed.push_back(scales[list[k]]); });
  return listed;
}

/// How large the cell of a point is.
struct Cell_sizes
{
  double base; ///< of the cells of points of scale 1
  Scales_view scales;

  /// \param size of all cells
  Cell_sizes(double size) : base(size) {} // not explicit: most grids have cells of one size
  Cell_sizes(double size, const Scales_view& scales_of_points)
    : base(size), scales(scales_of_points)
  {}
  Cell_sizes(double size, const Buffer<float>& scales_of_points)
    : Cell_sizes(size, view_of_scales(scales_of_points))
  {}

  int level_of(std::size_t i) const
  {
    return scales.values ? level_of_scale(scales[i]) : level_of_one;
  }
};

/*!
Cubic cells over the whole space, of which only the occupied ones are stored. Points of one scale
have cells of one size; those of smaller or larger scales have cells of other levels, as
`level_of_scale()` says, so that a ball whose radius follows the scale of its center never reaches
across more than a few cells.

The points are kept by the caller, sorted as `sorted_order()` says: by level, by cell, x fastest,
and within a cell by coordinates. So a run of cells along x is a run of points, and the order does
not depend on the order of the input.
*/
class Search_grid_3
{
  // 20 bits an axis. Coordinates beyond +-2^19 cells share the outermost cell. That keeps neighbors
  // neighbors: clamping never moves two cells apart.
  static constexpr std::int64_t half_range = std::int64_t(1) << 19;
  static constexpr int axis_bits = 20;

  Cell_sizes m_sizes;
  Buffer<std::uint64_t> m_keys; // of the occupied cells, ascending
  Buffer<Index> m_begins;       // first point of each cell, and the number of points
  Buffer<Index>
    m_rows; // first cell of each row of cells that share y and z, and the number of cells
  std::vector<int> m_levels; // that have cells, ascending

public:
  /// A run of points, `[first, second)`.
  using Range = std::pair<Index, Index>;

  /// \param sizes with the scales in the order of the points
  /// \param points sorted as `sorted_order()` gives for the same sizes of cells
  template <typename ConcurrencyTag>
  Search_grid_3(ConcurrencyTag, const Buffer<Vector>& points, const Cell_sizes& sizes)
    : m_sizes(sizes), m_keys(points.get_allocator()), m_begins(points.get_allocator()),
      m_rows(points.get_allocator())
  {
    const std::size_t points_per_block = 16384;
    const auto key_of = [&](std::size_t i) {
      return cell_key(points[i], sizes.base, sizes.level_of(i));
    };
    m_begins = append_by_blocks<ConcurrencyTag, Index>(
      points.size(), points_per_block, points.get_allocator(),
      [&](std::size_t begin, std::size_t end, Buffer<Index>& begins) {
        std::uint64_t last = key_of(begin > 0 ? begin - 1 : 0);
        for (std::size_t i = begin; i < end; ++i)
        {
          const std::uint64_t key = key_of(i);
          if (i == 0 || key != last)
            begins.push_back(Index(i));
          last = key;
        }
      });
    m_keys.resize(m_begins.size());
    for_each_block<ConcurrencyTag>(m_keys.size(), points_per_block,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t cell = begin; cell < end; ++cell)
                                       m_keys[cell] = key_of(m_begins[cell]);
                                   });
    for_each_in_order(m_keys.size(), [&](std::size_t cell) {
      if (cell == 0 || row_of(m_keys[cell]) != row_of(m_keys[cell - 1]))
        m_rows.push_back(Index(cell));
      if (m_levels.empty() || m_levels.back() != level_of(m_keys[cell]))
        m_levels.push_back(level_of(m_keys[cell]));
    });
    m_begins.push_back(Index(points.size()));
    m_rows.push_back(Index(m_keys.size()));
  }
  Search_grid_3(const Buffer<Vector>& points, const Cell_sizes& sizes)
    : Search_grid_3(Sequential_tag(), points, sizes)
  {}

  /// Of the cells of points of scale 1.
  double cell_size() const { return m_sizes.base; }
  /// Of the points; the caller keeps them, as the points.
  const Scales_view& scales() const { return m_sizes.scales; }
  float scale(std::size_t i) const { return m_sizes.scales[i]; }
  double size_of_cell(std::size_t c) const { return size_of_level(level_of(m_keys[c])); }
  /// Whether all points are of scale 1, so that all balls and cells are of one size.
  bool has_one_scale() const { return !m_sizes.scales.values; }
  std::size_t number_of_points() const { return m_begins.back(); }
  std::size_t number_of_cells() const { return m_keys.size(); }
  std::size_t number_of_rows() const { return m_rows.size() - 1; }

  /// The cells of a row.
  Range row(std::size_t r) const { return {m_rows[r], m_rows[r + 1]}; }

  /// The place of a row across x, in y and z, counted from the outermost cells.
  std::pair<std::uint64_t, std::uint64_t> place_of_row(std::size_t r) const
  {
    const std::uint64_t key = m_keys[m_rows[r]];
    return {std::uint64_t(axis_of(key, 1)), std::uint64_t(axis_of(key, 2))};
  }

  /// The points of a cell.
  Range points_of_cell(std::size_t c) const { return {m_begins[c], m_begins[c + 1]}; }

  /// Calls `f(points)` for the points of each cell of a run of whole cells.
  template <typename F>
  void for_each_cell_of_range(const Range& points, const F& f) const
  {
    auto begin = std::lower_bound(m_begins.begin(), m_begins.end(), points.first);
    for (; *begin < points.second; ++begin)
      f(Range(*begin, *(begin + 1)));
  }

  /// The point of space that stands for a cell: local coordinates are taken from here.
  Vector cell_center(std::size_t c) const
  {
    const auto axis = [&](int a) { return double(axis_of(m_keys[c], a) - half_range) + 0.5; };
    return size_of_cell(c) * Vector(axis(0), axis(1), axis(2));
  }

  /// Which cells of a block count: all, or the one in the middle and those that come after it in
  /// the order of cells.
  enum class Block
  {
    WHOLE,
    AHEAD
  };

  /*!
  Walks along the rows of another grid of the same sizes of cells and finds, for one of its cells
  after the other, the points of this grid in the block of cells around it, and in the cells of the
  levels next to its own that the block meets.
  */
  class Block_cursor
  {
    struct Neighbor_row
    {
      Index first_cell, last_cell, end_cell;
      int level;
    }; // the cells in reach, and the end of the row

    const Search_grid_3& m_grid;
    std::int64_t m_reach;
    Block m_block;
    std::vector<Neighbor_row> m_rows;

  public:
    /// \param reach number of cells to each side
    /// \param block `AHEAD` only for the cells of `grid` itself, if it `has_one_scale()`
    Block_cursor(const Search_grid_3& grid, int reach, Block block = Block::WHOLE)
      : m_grid(grid), m_reach(reach), m_block(block)
    {}

    /// Goes to the row of the cell with this key.
    void enter_row(std::uint64_t key)
    {
      m_rows.clear();
      for (int level : m_grid.m_levels)
        if (std::abs(level - level_of(key)) <= levels_in_reach)
          add_rows(key, level);
    }

    /// Lists the runs of points around the cell, which has to come after the last one of its row.
    /// \returns the number of points listed
    std::size_t ranges_around(std::uint64_t key, std::vector<Range>& ranges)
    {
      ranges.clear();
      std::size_t count = 0;
      for (Neighbor_row& row : m_rows)
      {
        const bool is_own_row_ahead = m_block == Block::AHEAD && &row == &m_rows.front();
        const auto [low, high] = places_in_reach(key, 0, row.level);
        const std::int64_t first = is_own_row_ahead ? axis_of(key, 0) : low;
        while (row.first_cell < row.end_cell && axis_of(m_grid.m_keys[row.first_cell], 0) < first)
          ++row.first_cell;
        row.last_cell = (std::max)(row.last_cell, row.first_cell);
        while (row.last_cell < row.end_cell && axis_of(m_grid.m_keys[row.last_cell], 0) <= high)
          ++row.last_cell;
        if (row.first_cell == row.last_cell)
          continue;
        ranges.emplace_back(m_grid.m_begins[row.first_cell], m_grid.m_begins[row.last_cell]);
        count += ranges.back().second - ranges.back().first;
      }
      return count;
    }

  private:
    /// The first and the last place on an axis of the cells of a level that the block meets.
    std::pair<std::int64_t, std::int64_t> places_in_reach(std::uint64_t key, int axis,
                                                          int level) const
    {
      const std::int64_t place = axis_of(key, axis), last = 2 * half_range - 1;
      std::int64_t low = place - m_reach, high = place + m_reach;
      if (level != level_of(key))
      {
        const double ratio = std::exp2(0.5 * (level_of(key) - level)); // of the sizes of cells
        low = half_range + std::int64_t(std::floor(double(low - half_range) * ratio));
        high = half_range + std::int64_t(std::floor(double(high + 1 - half_range) * ratio));
        // an outermost cell collects all that lies beyond, at any level
        low = place == 0 ? 0 : low;
        high = place == last ? last : high;
      }
      return {(std::max)(low, std::int64_t(0)), (std::min)(high, last)};
    }

    /// The rows of a level in the block around a cell.
    void add_rows(std::uint64_t key, int level)
    {
      const auto [low_z, high_z] = places_in_reach(key, 2, level);
      const auto [low_y, high_y] = places_in_reach(key, 1, level);
      const std::int64_t first_z = m_block == Block::WHOLE ? low_z : axis_of(key, 2);
      for (std::int64_t z = first_z; z <= high_z; ++z)
      {
        const bool starts_with_own_row = m_block == Block::AHEAD && z == first_z;
        const std::int64_t first_y = starts_with_own_row ? axis_of(key, 1) : low_y;
        // the rows of one z follow each other, so that one search finds them all
        const auto begin = m_grid.m_rows.begin(), end = m_grid.m_rows.end() - 1;
        auto it = std::lower_bound(begin, end, row_key(level, first_y, z),
                                   [&](Index first_cell, std::uint64_t k) {
                                     return row_of(m_grid.m_keys[first_cell]) < k;
                                   });
        for (; it != end && row_of(m_grid.m_keys[*it]) <= row_key(level, high_y, z); ++it)
          m_rows.push_back({*it, *it, *(it + 1), level});
      }
    }
  };

  std::uint64_t key_of_cell(std::size_t c) const { return m_keys[c]; }

  /// Rows are cut into runs of at most four cells, whichever of them are occupied: of fewer where
  /// cells are larger, so that none is longer than this, in cells of scale 1.
  static constexpr double longest_run = 4 * 1.4142135623730951;
  /// Of the run of a cell: ascends with the order of the points.
  std::uint64_t key_of_run(std::size_t c) const { return run_of(m_keys[c]); }
  /// Of the run that a point is in.
  /// \param cell_size of points of scale 1
  static std::uint64_t key_of_run(const Vector& point, double cell_size, int level = level_of_one)
  {
    return run_of(cell_key(point, cell_size, level));
  }

  /// Whether the cell is an outermost one, which collects all that lies beyond.
  bool is_unbounded(std::size_t c) const
  {
    for (int axis = 0; axis < 3; ++axis)
      if (axis_of(m_keys[c], axis) == 0 || axis_of(m_keys[c], axis) == 2 * half_range - 1)
        return true;
    return false;
  }

  /// The order in which a grid of these sizes of cells wants its points.
  template <typename ConcurrencyTag>
  static Buffer<Index> sorted_order(const Buffer<Vector>& points, const Cell_sizes& sizes)
  {
    CGAL_precondition(sizes.base > 0);
    struct Entry
    {
      std::uint64_t key;
      Index index;
    };
    const std::size_t block_size = 4096;
    Buffer<Entry> entries(points.size(), points.get_allocator());
    const auto list_entries = [&](const auto& key_of) {
      for_each_block<ConcurrencyTag>(points.size(), block_size,
                                     [&](std::size_t begin, std::size_t end) {
                                       for (std::size_t i = begin; i < end; ++i)
                                         entries[i] = {key_of(i), Index(i)};
                                     });
    };
    if (sizes.scales.values)
      list_entries(
        [&](std::size_t i) { return cell_key(points[i], sizes.base, sizes.level_of(i)); });
    else
    {
      const Box box = block_sum<ConcurrencyTag>(points.size(), block_size,
                                                [&](std::size_t begin, std::size_t end) {
                                                  Box box_of_block;
                                                  for (std::size_t i = begin; i < end; ++i)
                                                    box_of_block += {points[i], points[i]};
                                                  return box_of_block;
                                                });
      const Short_keys short_key(cell_key(box.low, sizes.base, level_of_one),
                                 cell_key(box.high, sizes.base, level_of_one));
      list_entries([&](std::size_t i) { return short_key(points[i], sizes.base); });
    }
    sort_by_key<ConcurrencyTag>(
      entries, [](const Entry& e) { return e.key; },
      [&](const Entry& a, const Entry& b) {
        const Vector &p = points[a.index], &q = points[b.index];
        for (int axis = 0; axis < 3; ++axis)
          if (p[axis] != q[axis])
            return p[axis] < q[axis];
        return a.index < b.index;
      });
    Buffer<Index> order(points.size(), points.get_allocator());
    for_each_block<ConcurrencyTag>(points.size(), block_size,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       order[i] = entries[i].index;
                                   });
    return order;
  }

private:
  struct Box
  {
    Vector low = Vector::Constant((std::numeric_limits<double>::max)()), high = -low;

    Box& operator+=(const Box& other)
    {
      low = low.cwiseMin(other.low);
      high = high.cwiseMax(other.high);
      return *this;
    }
  };

  /// Keys in the order of `cell_key()`, of as few bits as the box of the cells needs, and of x
  /// within the cell after that as far as there is room: a radix sort of them leaves next to
  /// nothing to comparisons.
  class Short_keys
  {
    std::uint64_t m_lowest;
    int m_x_bits, m_y_bits, m_bits_within_cell;

  public:
    /// \param lowest, highest keys of the corners of the box
    Short_keys(std::uint64_t lowest, std::uint64_t highest)
      : m_lowest(lowest), m_x_bits(bits(highest - lowest, 0)), m_y_bits(bits(highest - lowest, 1)),
        m_bits_within_cell((std::min)(10, 64 - m_x_bits - m_y_bits - bits(highest - lowest, 2)))
    {}

    std::uint64_t operator()(const Vector& point, double cell_size) const
    {
      // on every axis, since no axis of a key is below that of the lowest
      const std::uint64_t difference = cell_key(point, cell_size, level_of_one) - m_lowest;
      std::uint64_t key = std::uint64_t(axis_of(difference, 2));
      key = (key << m_y_bits) | std::uint64_t(axis_of(difference, 1));
      key = (key << m_x_bits) | std::uint64_t(axis_of(difference, 0));
      const double x = clamped_to_cells(point[0] / cell_size);
      return (key << m_bits_within_cell)
             | std::uint64_t((x - std::floor(x)) * double(std::uint64_t(1) << m_bits_within_cell));
    }

  private:
    static int bits(std::uint64_t key, int axis)
    {
      int result = 0;
      while (axis_of(key, axis) >> result > 0)
        ++result;
      return result;
    }
  };

  static double clamped_to_cells(double x)
  {
    return (std::min)((std::max)(x, -double(half_range)), double(half_range - 1));
  }

  static std::uint64_t cell_key(const Vector& point, double base, int level)
  {
    const double cell_size = base * size_of_cells(level);
    std::uint64_t key = std::uint64_t(level);
    for (int axis = 2; axis >= 0; --axis)
    {
      const double cell = clamped_to_cells(std::floor(point[axis] / cell_size));
      key = (key << axis_bits) | std::uint64_t(std::int64_t(cell) + half_range);
    }
    return key;
  }

  static int level_of(std::uint64_t key) { return int(key >> (3 * axis_bits)); }

  /// The first cell that a run may have.
  static std::uint64_t run_of(std::uint64_t key)
  {
    const int octave = (level_of(key) - level_of_one) / 2;
    return key & ~((std::uint64_t(4) >> (std::clamp)(octave, 0, 2)) - 1);
  }

  double size_of_level(int level) const { return m_sizes.base * size_of_cells(level); }

  static std::int64_t axis_of(std::uint64_t key, int axis)
  {
    return std::int64_t((key >> (axis * axis_bits)) & ((std::uint64_t(1) << axis_bits) - 1));
  }

  static std::uint64_t row_of(std::uint64_t key) { return key >> axis_bits; }
  static std::uint64_t row_key(int level, std::int64_t y, std::int64_t z)
  {
    return (((std::uint64_t(level) << axis_bits) | std::uint64_t(z)) << axis_bits)
           | std::uint64_t(y);
  }
};

/// `values[order[i]]`, for each i.
template <typename ConcurrencyTag, typename T>
Buffer<T> values_in_order(const Buffer<Index>& order, const Buffer<T>& values)
{
  const std::size_t values_per_block = 4096;
  Buffer<T> sorted(order.size(), values.get_allocator());
  for_each_block<ConcurrencyTag>(order.size(), values_per_block,
                                 [&](std::size_t begin, std::size_t end) {
                                   for (std::size_t i = begin; i < end; ++i)
                                     sorted[i] = values[order[i]];
                                 });
  return sorted;
}

/// Puts `values[order[i]]` in place `i`, if there are values.
template <typename ConcurrencyTag = Sequential_tag, typename T>
void apply_order(const Buffer<Index>& order, Buffer<T>& values)
{
  if (values.empty())
    return;
  Buffer<T> sorted = values_in_order<ConcurrencyTag>(order, values);
  values.swap(sorted);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SEARCH_GRID_3_H
