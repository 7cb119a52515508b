// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_POINT_FINDER_H
#define CGAL_L0_RESAMPLING_INTERNAL_POINT_FINDER_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/driver/Cpu_backend.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The first stages on the CPU, which keep what they find of each point.
template <typename ConcurrencyTag, typename FT>
class Point_finder : public Cpu_backend<ConcurrencyTag, FT>
{
  using Base = Cpu_backend<ConcurrencyTag, FT>;

  Buffer<Local_vector> m_no_normals, m_no_hints;
  Buffer<Point_in_cloud> m_points; // in their first order

  /// Calls `f(point, i)` for each of the first `n` points in their order now; for several at once.
  template <typename F>
  void for_each_found(std::size_t n, const F& f)
  {
    const std::size_t points_per_block = 16384;
    for_each_block<ConcurrencyTag>(n, points_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        f(found_of(Index(i)), i);
    });
  }

protected:
  using Base::m_areas;
  using Base::m_input;

  Point_in_cloud& found_of(Index sorted) { return m_points[m_input.indices[sorted]]; }

public:
  using Base::number_of_points;

  Point_finder(const Facts_of_cloud& facts, Buffer<Vector>& points, const Parameters& parameters,
               Any_solver<FT>& solver, Progress& progress, Report& report)
    : Base(points, m_no_normals, m_no_hints, parameters, solver, progress, report, facts),
      m_no_normals(points.get_allocator()), m_no_hints(points.get_allocator()),
      m_points(points.size())
  {
    m_input.keep_indices();
  }

  Range_of_scales estimate_scale_field(double robust_diagonal, const Reference_scales& usual)
  {
    const Range_of_scales range = Base::estimate_scale_field(robust_diagonal, usual);
    for_each_found(m_input.scales.size(),
                   [&](Point_in_cloud& point, std::size_t i) { point.scale = m_input.scales[i]; });
    return range;
  }

  void sort_points(const Plan& plan)
  {
    for_each_found(number_of_points(), [](Point_in_cloud& point, std::size_t) {
      point.units = 1; // no outlier
    });
    if (number_of_points() > 0)
      Base::sort_points(plan);
  }

  /// Of all points, in their first order.
  Buffer<Point_in_cloud> take_points() { return std::move(m_points); }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_POINT_FINDER_H
