// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEAR_PAIRS_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEAR_PAIRS_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// Sums over the points in a ball whose summands are as good for one point of a pair as for the
// other: looking at each pair once, from the cell that comes first, halves the work.

/// Whether sums over the balls of this radius may go over pairs: given, or found here.
template <typename ConcurrencyTag>
bool all_blocks_complete(const Search_grid_3& grid, double radius, Facts_of_cloud& facts)
{
  return known_or_found(facts.has_plain_blocks, [&]() {
    return has_plain_blocks_only<ConcurrencyTag>(grid, cells_in_reach(radius, grid.cell_size()));
  });
}

/*!
The rows of a grid in tiles, and the tiles in four colors: cells of different tiles of one color,
and the cells ahead of them within `reach`, have no point in common. So tiles of one color can add
to what belongs to their points at the same time, and what a point gets is added up in an order that
depends on the grid alone.
*/
class Tiles_of_rows
{
  std::vector<Index> m_rows;               // by color, tile and place
  std::vector<std::size_t> m_tile_begins;  // in m_rows, and its size
  std::vector<std::size_t> m_color_begins; // in m_tile_begins, of four colors, and its size

public:
  Tiles_of_rows(const Search_grid_3& grid, int reach)
  {
    // A tile is 2 reach rows wide in y and z. What lies ahead of it ends before the tile after the
    // next one begins.
    struct Entry
    {
      std::uint64_t color, z, y;
      Index row;
    };
    std::vector<Entry> entries;
    entries.reserve(grid.number_of_rows());
    for (std::size_t r = 0; r < grid.number_of_rows(); ++r)
    {
      const std::pair<std::uint64_t, std::uint64_t> place = grid.place_of_row(r);
      const std::uint64_t y = place.first / std::uint64_t(2 * reach),
                          z = place.second / std::uint64_t(2 * reach);
      entries.push_back({2 * (z % 2) + y % 2, z, y, Index(r)});
    }
    const auto tile = [](const Entry& e) { return std::make_tuple(e.color, e.z, e.y); };
    std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
      return std::make_pair(tile(a), a.row) < std::make_pair(tile(b), b.row);
    });

    m_color_begins.assign(number_of_colors + 1, 0);
    for (std::size_t k = 0; k < entries.size(); ++k)
    {
      if (k == 0 || tile(entries[k]) != tile(entries[k - 1]))
      {
        m_tile_begins.push_back(k);
        ++m_color_begins[entries[k].color + 1];
      }
      m_rows.push_back(entries[k].row);
    }
    m_tile_begins.push_back(entries.size());
    std::partial_sum(m_color_begins.begin(), m_color_begins.end(), m_color_begins.begin());
  }

  static constexpr std::size_t number_of_colors = 4;

  /// Calls `f(begin, end)` for the rows `[begin, end)` of each tile of a color, for all of them at
  /// the same time.
  template <typename ConcurrencyTag, typename F>
  void for_each_tile(std::size_t color, const F& f) const
  {
    const std::size_t first = m_color_begins[color];
    for_each_block<ConcurrencyTag>(m_color_begins[color + 1] - first, 1,
                                   [&](std::size_t tile, std::size_t) {
                                     f(m_rows.data() + m_tile_begins[first + tile],
                                       m_rows.data() + m_tile_begins[first + tile + 1]);
                                   });
  }
};

/*!
Calls `visitor(queries, candidates, origin)` for each occupied cell, as `for_each_cell()` does, with
those candidates only that come at or after the points of the cell: the points of the cell
themselves, which stand first, and those in the cells ahead of it. The visitor may change
`candidates`, and may add to what belongs to queries and candidates.

\pre `has_plain_blocks_only()`
*/
template <typename T, typename ConcurrencyTag, typename Make_visitor>
void for_each_cell_and_those_ahead(const Search_grid_3& grid, const Buffer<Vector>& points,
                                   const Tiles_of_rows& tiles, int reach, Progress& progress,
                                   const Make_visitor& make_visitor)
{
  const auto visit_tile = [&](const Index* begin, const Index* end) {
    auto visitor = make_visitor();
    Search_grid_3::Block_cursor cursor(grid, reach, Search_grid_3::Block::AHEAD);
    Local_points<T> candidates;
    std::vector<Search_grid_3::Range> ranges;
    for (const Index* r = begin; r != end; ++r)
      for_each_cell_of_row(grid, *r, cursor, ranges,
                           [&](Index cell, const auto& found, std::size_t count) {
                             const Search_grid_3::Range queries = grid.points_of_cell(cell);
                             const Vector origin = grid.cell_center(cell);
                             candidates.gather(found, count, points, origin);
                             visitor(queries, candidates, origin);
                             progress.advance(queries.second - queries.first);
                           });
  };
  for (std::size_t color = 0; color < Tiles_of_rows::number_of_colors; ++color)
    tiles.template for_each_tile<ConcurrencyTag>(color, visit_tile);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEAR_PAIRS_H
