// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H
#define CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/driver/Cpu_backend.h>
#include <CGAL/L0_resampling/internal/kernels/side_of_normal.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The stages for a part of a cloud: facts of the whole are given, and what is known of each point.
/// So samples start where they do in a call for all of it.
/// `run()` calls the stages as those of `Cpu_backend`.
template <typename ConcurrencyTag, typename FT>
class Tile_backend : public Cpu_backend<ConcurrencyTag, FT>
{
  using Base = Cpu_backend<ConcurrencyTag, FT>;
  using Base::m_areas;
  using Base::m_facts;
  using Base::m_followers;
  using Base::m_given_normals;
  using Base::m_hints;
  using Base::m_input;
  using Base::m_progress;
  using Base::m_report;
  using Base::m_samples;

  const Buffer<Point_in_cloud>& m_points; // in their first order
  const bool m_finds_sides;
  Buffer<unsigned char> m_are_starts_own; // of the samples in their first order
  Buffer<unsigned char> m_are_own;  // of the samples of the result: whether the tile keeps them
  Buffer<Index> m_trees;            // likewise: those of the orientation
  Buffer<float> m_confidences;      // likewise
  Buffer<Tile_sample> m_unoriented; // if sides are found later: each tree, which is a sample
  Buffer<unsigned char> m_are_trees_own;

  static constexpr std::size_t points_per_block = 16384;

  const Point_in_cloud& known_of(std::size_t sorted) const
  {
    return m_points[m_input.indices[sorted]];
  }

  /// Makes `values` what `f` says of what is known of each point, in the order that these have now.
  template <typename T, typename F>
  void list_known(const F& f, Buffer<T>& values) const
  {
    resize_to_overwrite(number_of_points(), values);
    for_each_block<ConcurrencyTag>(values.size(), points_per_block,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       values[i] = f(known_of(i));
                                   });
  }

  /// Each point so many times as `f` says of what is known of it.
  template <typename F>
  Buffer<Index> repeated(const F& f) const
  {
    return append_by_blocks<ConcurrencyTag, Index>(
      number_of_points(), points_per_block, m_input.points.get_allocator(),
      [&](std::size_t begin, std::size_t end, Buffer<Index>& points) {
        for (std::size_t i = begin; i < end; ++i)
          points.insert(points.end(), f(known_of(i)), Index(i));
      });
  }

public:
  using Base::number_of_points;

  /// \param known of each of the points, not all outliers
  Tile_backend(const Facts_of_cloud& facts, const Buffer<Point_in_cloud>& known, bool finds_sides,
               Buffer<Vector>& points, Buffer<Local_vector>& no_normals,
               Buffer<Local_vector>& no_hints, const Parameters& parameters, Any_solver<FT>& solver,
               Progress& progress, Report& report)
    : Base(points, no_normals, no_hints, parameters, solver, progress, report, facts),
      m_points(known), m_finds_sides(finds_sides), m_are_starts_own(points.get_allocator()),
      m_are_own(points.get_allocator()), m_trees(points.get_allocator()),
      m_confidences(points.get_allocator())
  {
    m_input.keep_indices();
  }

  Range_of_scales estimate_scale_field(double, const Reference_scales&)
  {
    const auto has_scale = [](const Point_in_cloud& point) { return point.scale != 1; };
    const std::optional<Range_of_scales>& known = m_facts.range_of_scales;
    if (known ? !known->is_one() : std::any_of(m_points.begin(), m_points.end(), has_scale))
      list_known([](const Point_in_cloud& point) { return point.scale; }, m_input.scales);
    return known ? *known : range_of(m_input.scales);
  }

  void drop_outliers(const Plan&)
  {
    Buffer<unsigned char> are_dropped(m_input.points.get_allocator());
    list_known([](const Point_in_cloud& point) { return point.units == 0; }, are_dropped);
    m_report.number_of_outliers = drop_points(are_dropped, m_input, m_given_normals, m_hints);
  }

  /// Reports of the points of the tile alone.
  void estimate_pca_normals(const Plan& plan)
  {
    Buffer<Index> numbers_of_own = copy_of(m_input.numbers_of_points);
    if (numbers_of_own.empty())
      fill_buffer(number_of_points(), Index(1), numbers_of_own);
    for_each_in_order(number_of_points(),
                      [&](std::size_t i) { numbers_of_own[i] *= known_of(i).is_own; });
    Base::estimate_pca_normals(plan, numbers_of_own);
  }

  double total_area(const Plan& plan)
  {
    m_areas.area_per_unit = Areas::area_per_unit_of(plan.area_radius());
    list_known([](const Point_in_cloud& point) { return point.units; }, m_areas.units);
    return *m_facts.area;
  }

  void choose_samples(const Plan& plan)
  {
    const auto allocator = m_input.points.get_allocator();
    Sources sources{
      repeated([](const Point_in_cloud& point) { return (std::min)(point.number_of_samples, 1u); }),
      repeated(
        [](const Point_in_cloud& point) { return (std::max)(point.number_of_samples, 1u) - 1u; })};
    Cloud_indices cloud_index{Buffer<Index>(allocator)};
    list_known([](const Point_in_cloud& point) { return point.index; }, cloud_index.of_points);
    Initial_samples initial = start_samples<ConcurrencyTag>(
      m_input.grid, m_input.points, m_input.normals, cloud_index, std::move(sources), plan.radius,
      plan.isolated_radius, plan.random_seed, m_progress);
    Placed_samples placed = with_followers<ConcurrencyTag>(plan, m_input, m_areas, m_facts,
                                                           std::move(initial));
    const auto is_own = [&](Index source) {
      return static_cast<unsigned char>(known_of(source).is_own);
    };
    for (const Index source : placed.start.sources)
      m_are_starts_own.push_back(is_own(source));
    for (const Index source : placed.followers.sources)
      m_are_own.push_back(is_own(source)); // the others come before them at the end
    m_followers = take_samples(plan, m_input, cloud_index, std::move(placed), m_facts, m_hints,
                               m_samples);
    if (m_samples.start_indices.empty())
      for_each_in_order(m_samples.positions.size(),
                        [&](std::size_t i) { m_samples.start_indices.push_back(Index(i)); });
    release(m_areas.units);
  }

  /// Reports of the samples of the tile alone.
  void fit_compatible_points(const Plan& plan, bool is_last)
  {
    Base::fit_compatible_points(plan, is_last, [this](std::size_t i) {
      return m_are_starts_own[m_samples.start_indices[i]] != 0;
    });
  }

  void orient_normals(const Plan& plan)
  {
    if (!m_finds_sides)
    {
      keep_unoriented(plan);
      return;
    }
    const Orientation orientation = Base::orient_normals(plan);
    m_confidences = copy_of(orientation.confidences);
    m_trees.reserve(m_confidences.size());
    for_each_in_order(m_confidences.size(), [&](std::size_t i) {
      m_trees.push_back(orientation.trees.find(Index(i)).first);
    });
  }

  void end_refinement()
  {
    Base::end_refinement();
    for_each_in_order(m_trees.size(), [&](std::size_t i) {
      if (m_samples.sides[i] == Side_after_refinement::OUTWARDS)
        m_trees[i] = tree_of_known_sides;
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

  /// Of the tile, once it was run.
  Samples_of_tile<FT> take_found()
  {
    return {Base::take_result(),      std::move(m_are_own),    std::move(m_trees),
            std::move(m_confidences), std::move(m_unoriented), std::move(m_are_trees_own)};
  }

private:
  /// Notes what sides follow from. The samples are in the order that they have in a call for the
  /// whole cloud.
  void keep_unoriented(const Plan& plan)
  {
    Base::sort_by_places(plan);
    const std::size_t m = m_samples.positions.size();
    m_trees.resize(m);
    m_unoriented.resize(m);
    m_are_trees_own.resize(m);
    for_each_block<ConcurrencyTag>(m, points_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vector& p = m_samples.positions[i];
        const auto& n = m_samples.normals[i];
        m_trees[i] = Index(i);
        m_unoriented[i] = {{p[0], p[1], p[2]}, {float(n[0]), float(n[1]), float(n[2])}, 0};
        m_are_trees_own[i] = m_are_starts_own[m_samples.start_indices[i]];
      }
    });
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H
