// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DEVICE_SESSION_H
#define CGAL_L0_RESAMPLING_INTERNAL_DEVICE_SESSION_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/device/cuda_answer.h>
#include <CGAL/L0_resampling/internal/device/cuda_interface.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace L0_resampling {
namespace internal {

struct Destroy_session
{
  void operator()(cuda::Session* session) const noexcept { cuda::destroy(session); }
};

using Device_session = std::unique_ptr<cuda::Session, Destroy_session>;

/// On the device that is current.
/// \throws Device_error if it cannot be used
inline Device_session new_device_session()
{
  cuda::Session* session = nullptr;
  const cuda::Answer answer = cuda::create(session);
  Device_session result(session);
  throw_if_failed(answer);
  return result;
}

/// What the device did, as the report that users know.
inline void fill_report(const cuda::Call_report& call, Report& report)
{
  report.number_of_outliers = call.number_of_outliers;
  report.number_of_distinct_points = call.number_of_distinct_points;
  report.number_of_degenerate_neighborhoods = call.number_of_degenerate_neighborhoods;
  report.number_of_lonely_samples = call.number_of_lonely_samples;
  report.number_of_unexplained_samples = call.number_of_unexplained_samples;
  report.number_of_unexplained_samples_there = call.number_of_unexplained_samples_there;
  std::copy_n(call.unexplained_center, 3, report.unexplained_center.begin());
  report.unexplained_radius = call.unexplained_radius;
  report.number_of_self_neighbor_pairs = call.number_of_self_neighbor_pairs;
  report.neighbor_radius = call.neighbor_radius;
  report.least_neighbor_radius = call.least_neighbor_radius;
  report.median_neighbor_radius = call.median_neighbor_radius;
  report.largest_neighbor_radius = call.largest_neighbor_radius;
  report.normal_filter_radius = call.normal_filter_radius;
  report.estimated_spacing = call.estimated_spacing;
  report.estimated_noise = call.estimated_noise;
  report.sample_spacing = call.sample_spacing;
  report.oriented_share = call.oriented_share;
  report.right_side_share = call.right_side_share;
  report.hinted_share = call.hinted_share;
  report.extent_share = call.extent_share;
  report.peak_bytes = call.peak_bytes;
  for (std::size_t i = 0; i < call.number_of_stages; ++i)
    report.stages.push_back(
      {call.stages[i].name, call.stages[i].seconds, call.stages[i].peak_bytes});
  for (std::size_t i = 0; i < call.number_of_iterations; ++i)
  {
    const cuda::Iteration& iteration = call.iterations[i];
    report.iterations.push_back(
      {iteration.penalty,
       iteration.regularized,
       iteration.fit_energy,
       iteration.regularization_energy,
       iteration.normal_energy,
       iteration.sparsity_energy,
       iteration.active_pair_share,
       {iteration.solver_iterations, iteration.relative_residual, iteration.converged}});
    report.converged = report.converged && iteration.converged;
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DEVICE_SESSION_H
