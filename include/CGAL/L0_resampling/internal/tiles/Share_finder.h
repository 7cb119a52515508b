// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SHARE_FINDER_H
#define CGAL_L0_RESAMPLING_INTERNAL_SHARE_FINDER_H

#include <CGAL/L0_resampling/internal/cloud/density_weights.h>
#include <CGAL/L0_resampling/internal/tiles/Own_blocks.h>
#include <CGAL/L0_resampling/internal/tiles/Point_finder.h>
#include <CGAL/L0_resampling/internal/tiles/Points_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Runs_of_cells.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The first stages for a tile and its halo, where memory does not hold the whole cloud: what the
/// tile adds to the sums over all tiles, and what is known then of each point.
template <typename ConcurrencyTag, typename FT>
class Share_finder : public Point_finder<ConcurrencyTag, FT>
{
  using Base = Point_finder<ConcurrencyTag, FT>;
  using Base::found_of;
  using Base::m_areas;
  using Base::m_facts;
  using Base::m_input;
  using Base::m_progress;

  const Buffer<unsigned char>& m_are_own; // of the points in their first order

  bool is_own(Index i) const { return m_are_own[m_input.indices[i]] != 0; }

  bool is_first_of_its_place(Index i) const
  {
    return i == 0 || m_input.points[i] != m_input.points[i - 1];
  }

public:
  using Base::number_of_points;

  /// \param are_own which of the points are the tile's, and not of its halo
  Share_finder(const Facts_of_cloud& facts, const Buffer<unsigned char>& are_own,
               Buffer<Vector>& points, const Parameters& parameters, Any_solver<FT>& solver,
               Progress& progress, Report& report)
    : Base(facts, points, parameters, solver, progress, report), m_are_own(are_own)
  {}

  /// For the points as they are once they are sorted.
  /// \param points_of_tile out
  Share_of_tile share(const Plan& plan, Points_of_tile& points_of_tile)
  {
    Share_of_tile share;
    if (number_of_points() > 0)
    {
      m_areas = Base::areas_of_points(plan);
      share.area_per_unit = m_areas.area_per_unit;
      Buffer<Index> neighbors(m_input.points.get_allocator());
      Buffer<Local> unwanted(m_input.points.get_allocator());
      sum_up_density<ConcurrencyTag>(m_input.grid, m_input.points, plan.filter_radius,
                                     plan.squared_bandwidth, m_facts, m_progress, neighbors,
                                     unwanted);
      points_of_tile.order.reserve(number_of_points());
      points_of_tile.are_distinct.reserve(number_of_points());
      for_each_run(m_input.grid, [&](std::uint64_t key, const Search_grid_3::Range& points) {
        Sums_over_points sums;
        bool has_own = false;
        for (Index i = points.first; i < points.second; ++i)
        {
          const bool is_distinct = is_first_of_its_place(i);
          has_own = has_own || is_own(i);
          sums += {is_distinct ? m_areas.units[i] : 0, 1, is_distinct, m_areas.units[i],
                   neighbors[i]};
          points_of_tile.order.push_back(m_input.indices[i]);
          points_of_tile.are_distinct.push_back(is_distinct);
          found_of(i).units = m_areas.units[i];
        }
        points_of_tile.runs.push_back({key, points.second});
        share.runs.push_back({key, has_own ? sums : Sums_over_points()});
      });
    }
    points_of_tile.points = Base::take_points();
    for (std::size_t i = 0; i < points_of_tile.points.size(); ++i)
      points_of_tile.points[i].is_own = m_are_own[i];
    return share;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SHARE_FINDER_H
