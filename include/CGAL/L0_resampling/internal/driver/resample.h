// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/driver/Oriented_points.h>
#include <CGAL/L0_resampling/internal/energy/Any_solver.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Resamples on the CPU.
/// \param points, given_normals, hints as for `Cpu_backend`
/// \param parameters checked; radii in the unit of the input
/// \param facts of the cloud that the points are a part of, as far as they are known; out: all
/// \param noise_ratios of the noise of each point to that of the parameters; none if all are 1
template <typename ConcurrencyTag, typename FT>
Oriented_points<FT> resample(Buffer<Vector>& points, Buffer<Local_vector>& given_normals,
                             Buffer<Local_vector>& hints, const Parameters& parameters,
                             Any_solver<FT>& solver, Progress& progress, Report& report,
                             Facts_of_cloud& facts, Buffer<float> noise_ratios = Buffer<float>());

/// Fills the report as far as `resample()` would before its first stage works on the points: the
/// radii, and the spacing and noise of methods that estimate them.
/// \param points as for `Cpu_points`
/// \param noise_ratios as for `resample()`
template <typename ConcurrencyTag>
void report_plan(Buffer<Vector>& points, const Parameters& parameters, Progress& progress,
                 Report& report, Buffer<float> noise_ratios = Buffer<float>());

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H
