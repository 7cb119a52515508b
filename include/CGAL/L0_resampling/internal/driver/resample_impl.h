// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_IMPL_H

#include <CGAL/L0_resampling/internal/driver/Cpu_backend.h>
#include <CGAL/L0_resampling/internal/driver/resample.h>
#include <CGAL/L0_resampling/internal/driver/run.h>

#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

template <typename ConcurrencyTag, typename FT>
Oriented_points<FT> resample(Buffer<Vector>& points, Buffer<Local_vector>& given_normals,
                             Buffer<Local_vector>& hints, const Parameters& parameters,
                             Any_solver<FT>& solver, Progress& progress, Report& report,
                             Facts_of_cloud& facts, Buffer<float> noise_ratios)
{
  Cpu_backend<ConcurrencyTag, FT> backend(points, given_normals, hints, parameters, solver,
                                          progress, report, facts);
  backend.take_noise_ratios(std::move(noise_ratios));
  run(plan_call(parameters, backend), backend);
  facts = backend.facts();
  return backend.take_result();
}

template <typename ConcurrencyTag>
void report_plan(Buffer<Vector>& points, const Parameters& parameters, Progress& progress,
                 Report& report, Buffer<float> noise_ratios)
{
  Cpu_points<ConcurrencyTag> all(points, progress, report);
  all.take_noise_ratios(std::move(noise_ratios));
  plan_call(parameters, all);
  progress.end_stage();
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_IMPL_H
