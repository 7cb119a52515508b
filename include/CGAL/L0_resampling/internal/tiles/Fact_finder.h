// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FACT_FINDER_H
#define CGAL_L0_RESAMPLING_INTERNAL_FACT_FINDER_H

#include <CGAL/L0_resampling/internal/tiles/Point_finder.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The first stages for all points of a cloud.
template <typename ConcurrencyTag, typename FT>
class Fact_finder : public Point_finder<ConcurrencyTag, FT>
{
  using Base = Point_finder<ConcurrencyTag, FT>;
  using Base::found_of;
  using Base::m_areas;
  using Base::m_facts;
  using Base::m_input;

public:
  Fact_finder(Buffer<Vector>& points, const Parameters& parameters, Any_solver<FT>& solver,
              Progress& progress, Report& report)
    : Base({}, points, parameters, solver, progress, report)
  {}

  void choose_samples(const Plan& plan)
  {
    {
      const Buffer<std::uint64_t> no_areas(m_input.points.get_allocator());
      this->count_samples(sources_of_samples(
        distinct_points(m_input.points), plan.starts_evenly ? m_areas.units : no_areas,
        plan.number_of_samples, plan.random_seed, m_facts.units_of_starts));
    }
    for_each_in_order(m_input.points.size(), [&](std::size_t i) {
      Point_in_cloud& point = found_of(Index(i));
      point.units = m_areas.units[i];
      point.index = Index(i);
    });
    Base::choose_samples(plan);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FACT_FINDER_H
