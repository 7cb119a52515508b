// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DISK_FINDER_H
#define CGAL_L0_RESAMPLING_INTERNAL_DISK_FINDER_H

#include <CGAL/L0_resampling/internal/tiles/Point_finder.h>
#include <CGAL/L0_resampling/internal/tiles/facts_of_tile.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The first stages for a tile and its halo, as far as areas are relative to the whole cloud.
template <typename ConcurrencyTag, typename FT>
class Disk_finder : public Point_finder<ConcurrencyTag, FT>
{
  using Base = Point_finder<ConcurrencyTag, FT>;
  using Base::m_input;
  using Base::m_progress;

public:
  using Base::Base;

  /// \param are_own which of the points are the tile's, in their first order
  Disks_of_tile count(const Plan& plan, const Buffer<unsigned char>& are_own)
  {
    Disks_of_tile found;
    const Search_grid_3& grid = m_input.grid;
    const auto is_own = [&](std::size_t sorted) { return are_own[m_input.indices[sorted]] != 0; };
    const Cell_sizes sizes(grid.cell_size(), grid.scales());
    const Buffer<Points_of_ball> balls = balls_of_points<ConcurrencyTag, Local>(
      grid, m_input.points, plan.area_radius(), Base::units_per_length(plan), m_progress);
    for_each_in_order(m_input.points.size(), [&](std::size_t i) {
      if (!is_own(i))
        return;
      ++found.number_of_points_left;
      found.units += units_of_disk(balls[i], sizes, i);
    });
    // a block around a cell beyond the halo is not whole
    found.number_of_others = number_of_blocks_not_plain<ConcurrencyTag>(
      grid, cells_in_reach(plan.filter_radius, grid.cell_size()),
      [&](Index cell) { return is_own(grid.points_of_cell(cell).first); });
    return found;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DISK_FINDER_H
