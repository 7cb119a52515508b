// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_POINT_FINDER_H
#define CGAL_L0_RESAMPLING_INTERNAL_POINT_FINDER_H

#include <CGAL/L0_resampling/internal/driver/Cpu_backend.h>
#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The first stages on the CPU, which keep what they find of each point.
template <typename ConcurrencyTag, typename FT>
class Point_finder : public Cpu_backend<ConcurrencyTag, FT>
{
  using Base = Cpu_backend<ConcurrencyTag, FT>;

  Buffer<Local_vector> m_no_normals, m_no_hints;
  std::vector<Point_in_cloud> m_points; // in their first order

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

  Range_of_scales estimate_scale_field(double robust_diagonal, const Usual_scales& usual)
  {
    const Range_of_scales range = Base::estimate_scale_field(robust_diagonal, usual);
    for_each_in_order(m_input.scales.size(),
                      [&](std::size_t i) { found_of(Index(i)).scale = m_input.scales[i]; });
    return range;
  }

  void sort_points(const Plan& plan)
  {
    for_each_in_order(number_of_points(), [&](std::size_t i) {
      found_of(Index(i)).units = 1; // no outlier
    });
    if (number_of_points() > 0)
      Base::sort_points(plan);
  }

  /// Of all points, in their first order.
  std::vector<Point_in_cloud> take_points() { return std::move(m_points); }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_POINT_FINDER_H
