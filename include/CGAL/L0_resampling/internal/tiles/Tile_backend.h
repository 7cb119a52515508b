// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H
#define CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H

#include <CGAL/L0_resampling/internal/driver/Cpu_backend.h>
#include <CGAL/L0_resampling/internal/tiles/Runs_of_cells.h>
#include <CGAL/L0_resampling/internal/tiles/Tiling.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The part of space that a tile keeps the samples of.
struct Room_of_tile
{
  Block_lattice lattice;
  Block_box room;

  /// \param place in the unit of the input
  bool holds(const Vector& place) const { return room.contains(lattice.block_of(place)); }
};

/// What is known of a point, where all points of the cloud were looked at together.
struct Point_in_cloud
{
  std::uint64_t units = 0;     ///< the area that it stands for; 0 if it is an outlier
  Index index = 0;             ///< in the order of the whole cloud
  Index number_of_samples = 0; ///< that start on it, or between it and another
};

/// What a tile has to know of the samples of the whole cloud: of each point that it reads; or, if
/// there are none, of each run of cells.
struct Starts_of_tile
{
  std::vector<Point_in_cloud> points; ///< in the order in which they are read
  std::vector<Run_of_cells> runs;     ///< with what comes before each
  Sums_over_points all;
};

/*!
The stages for a part of a cloud: facts of the whole are given, and what comes before the points of
each run in the order of the whole, or what is known of each point. So samples start where they do
in a call for all of it.
`run()` calls the stages as those of `Cpu_backend`.
*/
template <typename ConcurrencyTag, typename FT>
class Tile_backend : public Cpu_backend<ConcurrencyTag, FT>
{
  using Base = Cpu_backend<ConcurrencyTag, FT>;
  using Base::m_areas;
  using Base::m_facts;
  using Base::m_followers;
  using Base::m_frame;
  using Base::m_given_normals;
  using Base::m_hints;
  using Base::m_input;
  using Base::m_progress;
  using Base::m_report;
  using Base::m_samples;

  const Room_of_tile& m_room;
  const Starts_of_tile* m_starts = nullptr;
  Buffer<unsigned char> m_are_starts_own; // of the samples in their first order
  Buffer<unsigned char> m_are_own; // of the samples of the result: whether the tile keeps them
  Buffer<Index> m_trees;           // likewise: those of the orientation
  Buffer<float> m_confidences;     // likewise

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

  /// Thrown where no sample of the cloud starts.
  struct No_samples
  {};

  Tile_backend(const Facts_of_cloud& facts, const Room_of_tile& room, Buffer<Vector>& points,
               Buffer<Local_vector>& no_normals, Buffer<Local_vector>& hints,
               const Parameters& parameters, Any_solver<FT>& solver, Progress& progress,
               Report& report)
    : Base(points, no_normals, hints, parameters, solver, progress, report, facts), m_room(room),
      m_are_starts_own(points.get_allocator()), m_are_own(points.get_allocator()),
      m_trees(points.get_allocator()), m_confidences(points.get_allocator())
  {}

  /// Before the call is planned.
  void set_starts(const Starts_of_tile& starts)
  {
    m_starts = &starts;
    if (are_points_known())
      m_input.keep_indices();
  }

  void drop_outliers(const Plan& plan)
  {
    if (!are_points_known())
      return Base::drop_outliers(plan);
    Buffer<unsigned char> are_dropped(m_input.points.get_allocator());
    are_dropped.reserve(number_of_points());
    for_each_in_order(number_of_points(),
                      [&](std::size_t i) { are_dropped.push_back(known_point(i).units == 0); });
    m_report.number_of_outliers = drop_points(are_dropped, m_input, m_given_normals, m_hints);
  }

  void sort_points(const Plan& plan)
  {
    if (number_of_points() == 0) // all are outliers
      throw No_samples();
    Base::sort_points(plan);
  }

  /// What the tile adds to the whole; for the points as they are once they are prepared.
  Share_of_tile share(const Plan& plan)
  {
    m_areas = Base::areas_of_points(plan);
    Share_of_tile share;
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

  double total_area(const Plan& plan)
  {
    if (!are_points_known())
      return Base::total_area(plan);
    m_areas.area_per_unit = Areas::area_per_unit_of(plan.area_radius());
    m_areas.units.reserve(number_of_points());
    for_each_in_order(number_of_points(),
                      [&](std::size_t i) { m_areas.units.push_back(known_point(i).units); });
    return *m_facts.area;
  }

  void choose_samples(const Plan& plan)
  {
    const auto allocator = m_input.points.get_allocator();
    Sources sources{Buffer<Index>(allocator), Buffer<Index>(allocator)};
    Cloud_indices cloud_index{filled_buffer(m_input.points.size(), Index(0), allocator)};
    Buffer<unsigned char> are_points_own = filled_buffer(m_input.points.size(),
                                                         static_cast<unsigned char>(0), allocator);
    for_each_run([&](std::uint64_t, const Search_grid_3::Range& points, bool is_own) {
      std::fill(are_points_own.begin() + points.first, are_points_own.begin() + points.second,
                static_cast<unsigned char>(is_own));
    });
    if (are_points_known())
      add_known_sources(cloud_index, sources);
    else
      add_sources_of_runs(plan, cloud_index, sources);
    if (sources.on_points.empty())
      throw No_samples();

    Initial_samples initial = start_samples<ConcurrencyTag>(
      m_input.grid, m_input.points, m_input.normals, cloud_index, std::move(sources), plan.radius,
      plan.lone_radius, plan.random_seed, m_progress);
    Placed_samples placed = with_followers<ConcurrencyTag>(plan, m_input, m_areas, m_facts,
                                                           std::move(initial));
    for (const Index source : placed.start.sources)
      m_are_starts_own.push_back(are_points_own[source]);
    for (const Index source : placed.followers.sources)
      m_are_own.push_back(are_points_own[source]); // the others come before them at the end
    m_followers = take_samples(plan, m_input, cloud_index, std::move(placed), m_facts, m_hints,
                               m_samples);
    if (m_samples.start_indices.empty())
      for_each_in_order(m_samples.positions.size(),
                        [&](std::size_t i) { m_samples.start_indices.push_back(Index(i)); });
    release(m_areas.units);
  }

  void orient_normals(const Plan& plan)
  {
    const Orientation orientation = Base::orient_normals(plan);
    m_confidences = copy_of(orientation.confidences);
    m_trees.reserve(m_confidences.size());
    for_each_in_order(m_confidences.size(), [&](std::size_t i) {
      m_trees.push_back(orientation.trees.find(Index(i)).first);
    });
  }

  void append_followers()
  {
    const Buffer<unsigned char> of_followers = std::move(m_are_own);
    m_are_own = Buffer<unsigned char>(m_trees.get_allocator());
    m_are_own.reserve(m_samples.start_indices.size() + of_followers.size());
    for (const Index start : m_samples.start_indices)
      m_are_own.push_back(m_are_starts_own[start]);
    m_are_own.insert(m_are_own.end(), of_followers.begin(), of_followers.end());
    m_followers.append_values(m_samples.start_indices, m_trees);
    m_followers.append_values(m_samples.start_indices, m_confidences);
    Base::append_followers();
  }

  const Buffer<unsigned char>& are_own() const { return m_are_own; }
  const Buffer<Index>& trees() const { return m_trees; }
  const Buffer<float>& confidences() const { return m_confidences; }

private:
  bool are_points_known() const { return m_starts && !m_starts->points.empty(); }

  const Point_in_cloud& known_point(std::size_t i) const
  {
    return m_starts->points[m_input.indices[i]];
  }

  void add_known_sources(Cloud_indices& cloud_index, Sources& sources) const
  {
    for_each_in_order(number_of_points(), [&](std::size_t i) {
      const Point_in_cloud& point = known_point(i);
      cloud_index.of_points[i] = point.index;
      for (Index k = 0; k < point.number_of_samples; ++k)
        (k == 0 ? sources.on_points : sources.near_points).push_back(Index(i));
    });
  }

  void add_sources_of_runs(const Plan& plan, Cloud_indices& cloud_index, Sources& sources) const
  {
    const std::uint64_t m = plan.number_of_samples, seed = plan.random_seed;
    const Sums_over_points& all = m_starts->all;
    Buffer<Index> distinct(m_input.points.get_allocator());
    auto start = m_starts->runs.begin();
    for_each_run([&](std::uint64_t key, const Search_grid_3::Range& points, bool) {
      while (start != m_starts->runs.end() && start->key < key)
        ++start;
      if (start == m_starts->runs.end() || start->key != key)
        return;
      distinct.clear();
      for (Index i = points.first; i < points.second; ++i)
      {
        cloud_index.of_points[i] = Index(start->sums.points + (i - points.first));
        if (is_first_of_its_place(i))
          distinct.push_back(i);
      }
      if (plan.starts_evenly)
        add_sources_by_area(distinct, m_areas.units, start->sums.units, all.units, m, seed,
                            sources);
      else
        add_sources_by_points(distinct, start->sums.distinct, all.distinct, m, seed, sources);
    });
  }
};

/// The first stages for all points of a cloud, which keep the field of scales, and what they find
/// of each point.
template <typename ConcurrencyTag, typename FT>
class Fact_finder : public Cpu_backend<ConcurrencyTag, FT>
{
  using Base = Cpu_backend<ConcurrencyTag, FT>;
  using Base::m_areas;
  using Base::m_facts;
  using Base::m_input;

  std::vector<Point_in_cloud> m_points;

public:
  Fact_finder(Buffer<Vector>& points, Buffer<Local_vector>& no_normals,
              Buffer<Local_vector>& no_hints, const Parameters& parameters, Any_solver<FT>& solver,
              Progress& progress, Report& report)
    : Base(points, no_normals, no_hints, parameters, solver, progress, report, {}),
      m_points(points.size())
  {
    m_input.keep_indices();
  }

  Range_of_scales estimate_scale_field(double robust_diagonal, const Usual_scales& usual)
  {
    m_facts.field_of_scales = std::make_shared<const Scale_field>(
      Base::find_scale_field(robust_diagonal, usual));
    return Base::estimate_scale_field(robust_diagonal, usual);
  }

  void sort_points(const Plan& plan)
  {
    for (const Index i : m_input.indices) // without outliers
      m_points[i].units = 1;
    Base::sort_points(plan);
  }

  void choose_samples(const Plan& plan)
  {
    {
      const Buffer<std::uint64_t> no_areas(m_input.points.get_allocator());
      const Sources sources = sources_of_samples(distinct_points(m_input.points),
                                                 plan.starts_evenly ? m_areas.units : no_areas,
                                                 plan.number_of_samples, plan.random_seed,
                                                 m_facts.units_of_starts);
      for (const Buffer<Index>* list : {&sources.on_points, &sources.near_points})
        for (const Index source : *list)
          ++m_points[m_input.indices[source]].number_of_samples;
    }
    for_each_in_order(m_input.points.size(), [&](std::size_t i) {
      Point_in_cloud& point = m_points[m_input.indices[i]];
      point.units = m_areas.units[i];
      point.index = Index(i);
    });
    Base::choose_samples(plan);
  }

  /// Of all points, in their first order.
  std::vector<Point_in_cloud> take_points() { return std::move(m_points); }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H
