// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FACT_FINDER_H
#define CGAL_L0_RESAMPLING_INTERNAL_FACT_FINDER_H

#include <CGAL/L0_resampling/internal/tiles/Point_finder.h>

#include <cstddef>
#include <utility>

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
  using Base::m_input;

  void count_samples(const Sources& sources)
  {
    for (const Buffer<Index>* list : {&sources.on_points, &sources.near_points})
      for (const Index source : *list)
        ++found_of(source).number_of_samples;
  }

public:
  Fact_finder(Buffer<Vector>& points, const Parameters& parameters, Any_solver<FT>& solver,
              Progress& progress, Report& report)
    : Base({}, points, parameters, solver, progress, report)
  {}

  void choose_samples(const Plan& plan)
  {
    Sources sources = Base::choose_sources(plan);
    count_samples(sources);
    for_each_in_order(m_input.points.size(), [&](std::size_t i) {
      Point_in_cloud& point = found_of(Index(i));
      point.units = m_areas.units[i];
      point.index = Index(i);
    });
    Base::start_samples(plan, std::move(sources));
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FACT_FINDER_H
