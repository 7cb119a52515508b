// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_ESTIMATE_SCALES_H
#define CGAL_L0_ESTIMATE_SCALES_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/internal/interface/resample_on_cpu.h>
#include <CGAL/L0_resampling/named_parameters.h>
#include <CGAL/L0_resampling/tags.h>

#include <cstddef>
#include <iterator>
#include <new>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgL0ResamplingRef

finds the scales that `l0_resample_point_set()` would work at, without resampling: for users who
choose a radius or a weight.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
\param points as for `l0_resample_point_set()`
\param np as for `l0_resample_point_set()`; of the maps, `point_map` and `point_noise_map` are read,
and nothing is written

\returns a report with the numbers of points, the radii, and with the default method the spacing and
the noise of the points

\throws std::invalid_argument, std::bad_alloc as `l0_resample_point_set()` before its first stage
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
L0_resampling::Report l0_estimate_scales(const PointRange& points,
                                         const NamedParameters& np = parameters::default_values())
{
  static_assert(!std::is_same<ConcurrencyTag, CUDA_tag>::value,
                "Scales are estimated on the CPU: use Parallel_if_available_tag.");
  using namespace L0_resampling::internal;
  L0_resampling::Block_chebyshev_solver_traits<Local, ConcurrencyTag> default_solver;
  auto&& chosen_solver = choose_solver(np, default_solver);
  using FT = typename std::decay_t<decltype(unwrapped(chosen_solver))>::FT;
  const Given_parameters given(np);
  const std::size_t size = std::size_t(std::distance(points.begin(), points.end()));
  Parameters checked = checked_parameters(given, size);
  if (minimum_memory<FT>(size, checked) > checked.maximum_memory)
    throw std::bad_alloc();
  L0_resampling::Report report;
  Memory_counter memory(checked.maximum_memory);
  Input input(&memory);
  Progress progress(given.callback, report, memory);
  try
  {
    read_points<ConcurrencyTag>(points, point_map_of(points, np),
                                given.drop_non_finite.value_or(false), report, input);
    read_noises_if_given<ConcurrencyTag>(points, np, input);
    if (input.noise > 0)
      checked.noise = input.noise;
    if (!input.points.empty())
      report_plan<ConcurrencyTag>(input.points, checked, progress, report,
                                  std::move(input.noise_ratios));
  }
  catch (const Interrupted&)
  {
    progress.rethrow_exception_of_callback();
    report.outcome = L0_resampling::Outcome::CANCELLED;
  }
  return report;
}

} // namespace CGAL

#endif // CGAL_L0_ESTIMATE_SCALES_H
