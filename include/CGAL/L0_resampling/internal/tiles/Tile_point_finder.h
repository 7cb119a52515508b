// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TILE_POINT_FINDER_H
#define CGAL_L0_RESAMPLING_INTERNAL_TILE_POINT_FINDER_H

#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/internal/cloud/areas_of_points.h>
#include <CGAL/L0_resampling/internal/cloud/density_weights.h>
#include <CGAL/L0_resampling/internal/cloud/prepare_points.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/parallel_sort.h>
#include <CGAL/L0_resampling/internal/tiles/Own_blocks.h>
#include <CGAL/L0_resampling/internal/tiles/Point_finder.h>
#include <CGAL/L0_resampling/internal/tiles/Points_of_tile.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The first stages for a tile and its halo, where memory does not hold the whole cloud.
template <typename ConcurrencyTag, typename FT>
class Tile_point_finder : public Point_finder<ConcurrencyTag, FT>
{
  using Base = Point_finder<ConcurrencyTag, FT>;
  using Base::m_facts;
  using Base::m_frame;
  using Base::m_given_normals;
  using Base::m_hints;
  using Base::m_input;
  using Base::m_progress;
  using Base::m_report;

  Buffer<unsigned char> m_are_own; // of the points in their first order
  bool m_keeps_outliers = false;

  bool is_own(Index i) const { return m_are_own[m_input.indices[i]] != 0; }

  bool is_first_of_its_place(Index i) const
  {
    return i == 0 || m_input.points[i] != m_input.points[i - 1];
  }

public:
  using Base::number_of_points;

  /// \param are_own which of the points are in the blocks of the tile, and not of its halo
  /// \param scales of the points, used up; none if they are to be found, or all are 1
  Tile_point_finder(const Facts_of_cloud& facts, Buffer<unsigned char> are_own,
                    Buffer<Vector>& points, Buffer<float>&& scales, const Parameters& parameters,
                    Any_solver<FT>& solver, Progress& progress, Report& report)
    : Base(facts, points, parameters, solver, progress, report), m_are_own(std::move(are_own))
  {
    m_input.scales = std::move(scales);
  }

  /// Gives each run of cells that is in blocks of several tiles to the one that has its first point
  /// by coordinates. So each point is of one tile, and a run is counted once, as its tile finds it.
  /// For the points in their first order.
  void share_runs(const Plan& plan, const Own_blocks& own)
  {
    const Buffer<Vector>& points = m_input.points;
    const Cell_sizes sizes(plan.cell_size, m_input.scales);
    struct Entry
    {
      std::uint64_t run;
      Index point;
    };
    Buffer<Entry> entries = append_by_blocks<ConcurrencyTag, Entry>(
      points.size(), points_per_block, points.get_allocator(),
      [&](std::size_t begin, std::size_t end, Buffer<Entry>& of_block) {
        for (const Index i : points_near_border(plan, own, begin, end))
          of_block.push_back(
            {Search_grid_3::key_of_run(points[i], sizes.base, sizes.level_of(i)), i});
      });
    sort_by_key<ConcurrencyTag>(
      entries, [](const Entry& entry) { return entry.run; },
      [&](const Entry& a, const Entry& b) {
        const Vector &p = points[a.point], &q = points[b.point];
        return std::tie(p[0], p[1], p[2], a.point) < std::tie(q[0], q[1], q[2], b.point);
      });
    for (std::size_t k = 0, first = 0; k < entries.size(); ++k)
    {
      if (entries[k].run != entries[first].run)
        first = k;
      m_are_own[entries[k].point] = m_are_own[entries[first].point];
    }
  }

  /// But for a tile all of whose own points are outliers.
  void drop_outliers(const Plan& plan)
  {
    const Buffer<unsigned char> are_outliers = outliers_among<ConcurrencyTag>(
      m_input, plan.radius, plan.extent, Outlier_thresholds(plan.outlier_sensitivity), m_facts,
      m_progress);
    m_keeps_outliers = true;
    for_each_in_order(number_of_points(), [&](std::size_t i) {
      m_keeps_outliers = m_keeps_outliers && (!is_own(Index(i)) || are_outliers[i] != 0);
    });
    if (!m_keeps_outliers)
      m_report.number_of_outliers = drop_points(are_outliers, m_input, m_given_normals, m_hints);
  }

  /// For the points as they are once they are sorted.
  Points_of_tile find(const Plan& plan)
  {
    Points_of_tile found;
    found.disks.keeps_outliers = m_keeps_outliers;
    find_runs(plan, found);
    find_balls(plan, found);
    found.points = Base::take_points();
    for (std::size_t i = 0; i < found.points.size(); ++i)
      found.points[i].is_own = m_are_own[i];
    return found;
  }

private:
  static constexpr std::size_t points_per_block = 16384;

  /// Those of some points that may be in one run with others on the other side of the border.
  std::vector<Index> points_near_border(const Plan& plan, const Own_blocks& own, std::size_t begin,
                                        std::size_t end) const
  {
    const double roundings = 1 + 1e-6,
                 width = Search_grid_3::longest_run * plan.cell_size * roundings;
    const Source_box box = source_box_of(own.lattice, own.box);
    const Vector low = m_frame.point_in_frame(Vector(box.low.data())),
                 high = m_frame.point_in_frame(Vector(box.high.data()));
    const auto is_within = [&](const Vector& p, double margin) {
      return (p.array() >= low.array() - margin).all()
             && (p.array() <= high.array() + margin).all();
    };
    std::vector<Index> found;
    for (std::size_t i = begin; i < end; ++i)
    {
      const Vector& p = m_input.points[i];
      if (is_within(p, width) && !is_within(p, -width))
        found.push_back(Index(i));
    }
    return found;
  }

  void find_runs(const Plan& plan, Points_of_tile& found)
  {
    const Search_grid_3& grid = m_input.grid;
    Buffer<Index> neighbors(m_input.points.get_allocator());
    Buffer<Local> unwanted(m_input.points.get_allocator());
    sum_up_density<ConcurrencyTag>(grid, m_input.points, plan.filter_radius, plan.squared_bandwidth,
                                   m_facts, m_progress, neighbors, unwanted);
    found.order.assign(m_input.indices.begin(), m_input.indices.end());
    for_each_run(grid, [&](std::uint64_t key, const Search_grid_3::Range& points) {
      std::uint64_t sum = 0;
      for (Index i = points.first; i < points.second; ++i)
        sum += neighbors[i];
      found.runs.push_back({key, points.second, sum});
    });
    // a block around a cell beyond the halo is not whole
    found.disks.number_of_thinned_blocks = number_of_blocks_not_plain<ConcurrencyTag>(
      grid, cells_in_reach(plan.filter_radius, grid.cell_size()),
      [&](Index cell) { return is_own(grid.points_of_cell(cell).first); });
  }

  void find_balls(const Plan& plan, Points_of_tile& found)
  {
    const Search_grid_3& grid = m_input.grid;
    const Cell_sizes sizes(grid.cell_size(), grid.scales());
    const Buffer<Points_of_ball> balls = balls_of_points<ConcurrencyTag, Local>(
      grid, m_input.points, plan.area_radius(), Base::units_per_length(plan), m_progress);
    found.balls.assign(balls.begin(), balls.end());
    found.are_first.resize(number_of_points());
    found.are_distinct.resize(number_of_points());
    found.disks.units += block_sum<ConcurrencyTag>(
      number_of_points(), points_per_block, [&](std::size_t begin, std::size_t end) {
        std::uint64_t units = 0;
        for (std::size_t k = begin; k < end; ++k)
        {
          const Index i = Index(k);
          found.are_first[k] = 0;
          found.are_distinct[k] = is_first_of_its_place(i);
          if (is_own(i))
            units += units_of_disk(balls[i], sizes, i);
        }
        return units;
      });
    for_each_in_order(grid.number_of_cells(), [&](std::size_t cell) {
      found.are_first[grid.points_of_cell(cell).first] = 1;
    });
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TILE_POINT_FINDER_H
