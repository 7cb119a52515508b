// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_FIND_NEAR_POINTS_H
#define CGAL_L0_RESAMPLING_FIND_NEAR_POINTS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Near_points.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/internal/search/nearest_input_points.h>
#include <CGAL/L0_resampling/named_parameters.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>

namespace CGAL {
namespace L0_resampling {

namespace internal {

template <typename ConcurrencyTag, typename FT, typename PointRange, typename PointMap>
Near_points find_near_points(const PointRange& points, PointMap point_map,
                             const Buffer<std::array<FT, 3>>& queries, std::size_t count,
                             Progress& progress, Memory_counter& memory)
{
  Near_points near_points;
  near_points.count = count;
  if (count == 0 || queries.empty())
    return near_points;
  progress.begin_stage("near points", 1, queries.size());
  const std::size_t size = std::size_t(std::distance(points.begin(), points.end()));
  const auto for_each = [&](const Point_function& f) { for_each_point(points, point_map, f); };
  const Point_tree_3 tree = tree_of_range<ConcurrencyTag>(size, Each_point(for_each), memory);
  nearest_input_points<ConcurrencyTag>(tree, queries, progress, near_points);
  progress.end_stage();
  return near_points;
}

} // namespace internal

/*!
\ingroup PkgL0ResamplingRef

finds the points near to those of a result, as `l0_resample_point_set()` does for the properties of
a `Point_set_3`: where distances are equal, those that come first. A point weighs
\f$ e^{-d^2/h^2} \f$, where \f$ h^2 \f$ is the mean of the squared distances of all that were found.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
\param points the input; those that are not finite are near to none
\param result the points of the result
\param count how many are found for each point of the result, or all if `points` has fewer
\param np `point_map` of `points`, `query_point_map` of `result`, both as `point_map` of
`l0_resample_point_set()`; `callback`; `maximum_memory`; and `resampling_report`, to which a stage
is added. Other names are not read, so that those of the call that gave the result can be passed.

\returns without points if the callback has returned `false`

\pre `points` has a point that is finite
*/
template <typename ConcurrencyTag, typename PointRange, typename QueryRange,
          typename NamedParameters = parameters::Default_named_parameters>
Near_points find_near_points(const PointRange& points, const QueryRange& result, std::size_t count,
                             const NamedParameters& np = parameters::default_values())
{
  using internal::as_vector;
  internal::Buffer<std::array<double, 3>> queries;
  queries.reserve(std::size_t(std::distance(result.begin(), result.end())));
  const auto add = [&](const auto& point) {
    const auto v = as_vector(point);
    queries.push_back({v[0], v[1], v[2]});
  };
  for (const auto& element : result)
    if constexpr (parameters::is_default_parameter<NamedParameters,
                                                   internal_np::query_point_t>::value)
      add(element);
    else
      add(get(parameters::get_parameter(np, internal_np::query_point_map), element));
  const internal::Given_parameters given(np);
  internal::Memory_counter memory(
    given.maximum_memory.value_or((std::numeric_limits<std::size_t>::max)()));
  Report own_report;
  internal::Progress progress(given.callback, own_report, memory);
  Near_points near_points;
  try
  {
    near_points = internal::find_near_points<ConcurrencyTag>(
      points, internal::point_map_of(points, np), queries, count, progress, memory);
  }
  catch (const internal::Interrupted&)
  {
    progress.rethrow_exception_of_callback();
    return near_points;
  }
  internal::if_given(np, internal_np::resampling_report, [&](Report* report) {
    if (!report)
      return;
    report->stages.insert(report->stages.end(), own_report.stages.begin(), own_report.stages.end());
    report->peak_bytes = (std::max)(report->peak_bytes, own_report.peak_bytes);
  });
  return near_points;
}

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_FIND_NEAR_POINTS_H
