// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_OWN_BLOCKS_H
#define CGAL_L0_RESAMPLING_INTERNAL_OWN_BLOCKS_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>
#include <CGAL/L0_resampling/internal/tiles/Tiling.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Those of a tile, and not those around it that are only looked at.
struct Own_blocks
{
  Block_lattice lattice;
  Block_box box;

  /// \param place in the unit of the input
  bool hold(const Vector& place) const { return box.contains(lattice.block_of(place)); }

  /// Which of the points are in them.
  template <typename ConcurrencyTag>
  Buffer<unsigned char> flags_of(const Buffer<Vector>& points) const
  {
    Buffer<unsigned char> flags(points.size(), points.get_allocator());
    const std::size_t points_per_block = 16384;
    for_each_block<ConcurrencyTag>(points.size(), points_per_block,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       flags[i] = hold(points[i]);
                                   });
    return flags;
  }
};

/// Calls `f(key, points)` for each run of cells, in their order, with
/// `Search_grid_3::key_of_run()`.
template <typename F>
void for_each_run(const Search_grid_3& grid, const F& f)
{
  for (std::size_t cell = 0; cell < grid.number_of_cells();)
  {
    const std::size_t first = cell;
    while (cell < grid.number_of_cells() && grid.key_of_run(cell) == grid.key_of_run(first))
      ++cell;
    f(grid.key_of_run(first),
      Search_grid_3::Range(grid.points_of_cell(first).first, grid.points_of_cell(cell - 1).second));
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_OWN_BLOCKS_H
