// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SHARE_FINDER_H
#define CGAL_L0_RESAMPLING_INTERNAL_SHARE_FINDER_H

#include <CGAL/L0_resampling/internal/tiles/Point_finder.h>
#include <CGAL/L0_resampling/internal/tiles/Runs_of_cells.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
The first stages for a tile and its halo, where memory does not hold the whole cloud: what the tile
adds to the sums over all tiles; and, once these are known, what is to be known of each point, so
that samples start where they do in a call for the whole cloud.
*/
template <typename ConcurrencyTag, typename FT>
class Share_finder : public Point_finder<ConcurrencyTag, FT>
{
  using Base = Point_finder<ConcurrencyTag, FT>;
  using Base::found_of;
  using Base::m_areas;
  using Base::m_frame;
  using Base::m_input;

  const Room_of_tile& m_room;

  bool is_first_of_its_place(Index i) const
  {
    return i == 0 || m_input.points[i] != m_input.points[i - 1];
  }

  /// Calls `f(key, points, is_own)` for each run of cells, in their order.
  template <typename F>
  void for_each_run(const F& f) const
  {
    const Search_grid_3& grid = m_input.grid;
    for (std::size_t cell = 0; cell < grid.number_of_cells();)
    {
      const std::size_t first = cell;
      while (cell < grid.number_of_cells() && grid.key_of_run(cell) == grid.key_of_run(first))
        ++cell;
      f(grid.key_of_run(first),
        Search_grid_3::Range(grid.points_of_cell(first).first,
                             grid.points_of_cell(cell - 1).second),
        m_room.holds(m_frame.leave(grid.middle_of_run(first))));
    }
  }

public:
  using Base::number_of_points;

  Share_finder(const Facts_of_cloud& facts, const Room_of_tile& room, Buffer<Vector>& points,
               const Parameters& parameters, Any_solver<FT>& solver, Progress& progress,
               Report& report)
    : Base(facts, points, parameters, solver, progress, report), m_room(room)
  {}

  /// For the points as they are once they are sorted.
  Share_of_tile share(const Plan& plan)
  {
    Share_of_tile share;
    if (number_of_points() == 0) // all are outliers
      return share;
    m_areas = Base::areas_of_points(plan);
    share.area_per_unit = m_areas.area_per_unit;
    for_each_run([&](std::uint64_t key, const Search_grid_3::Range& points, bool is_own) {
      Sums_over_points sums;
      for (Index i = points.first; is_own && i < points.second; ++i)
      {
        const bool is_distinct = is_first_of_its_place(i);
        sums += {is_distinct ? m_areas.units[i] : 0, 1, is_distinct};
        share.units_of_all += m_areas.units[i];
      }
      share.runs.push_back({key, sums});
    });
    return share;
  }

  /// Finds the order of the points in the cloud, and the samples that start on them.
  /// After `share()`.
  void place_points(const Plan& plan, const Starts_of_runs& starts)
  {
    const std::uint64_t m = plan.number_of_samples, seed = plan.random_seed;
    const auto allocator = m_input.points.get_allocator();
    Sources sources{Buffer<Index>(allocator), Buffer<Index>(allocator)};
    Buffer<Index> distinct(allocator);
    auto start = starts.runs.begin();
    for_each_run([&](std::uint64_t key, const Search_grid_3::Range& points, bool is_own) {
      while (start != starts.runs.end() && start->key < key)
        ++start;
      const bool is_known = start != starts.runs.end() && start->key == key;
      distinct.clear();
      for (Index i = points.first; i < points.second; ++i)
      {
        Point_in_cloud& point = found_of(i);
        point.units = m_areas.units[i];
        point.is_own = is_own;
        if (!is_known)
          continue;
        point.index = Index(start->sums.points + (i - points.first));
        if (is_first_of_its_place(i))
          distinct.push_back(i);
      }
      if (!is_known)
        return;
      if (plan.starts_evenly)
        add_sources_by_area(distinct, m_areas.units, start->sums.units, starts.all.units, m, seed,
                            sources);
      else
        add_sources_by_points(distinct, start->sums.distinct, starts.all.distinct, m, seed,
                              sources);
    });
    this->count_samples(sources);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SHARE_FINDER_H
