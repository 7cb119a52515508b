// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FEATURES_OF_RESULT_H
#define CGAL_L0_RESAMPLING_INTERNAL_FEATURES_OF_RESULT_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/creases/find_creases.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>
#include <CGAL/L0_resampling/internal/samples/estimate_feature_confidences.h>
#include <CGAL/L0_resampling/tags.h>
#ifndef CGAL_L0_LINKED_WITH_COMPILED
#include <CGAL/L0_resampling/internal/creases/find_creases_impl.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The creases of a result of the device, found by all threads of the host, and points put on them.
inline Placed_creases find_creases(double spacing, Buffer<Vector>& positions,
                                   std::vector<float>& result_normals)
{
  Buffer<Local_vector> normals;
  for (std::size_t i = 0; i < positions.size(); ++i)
    normals.emplace_back(Eigen::Map<const Local_vector>(&result_normals[3 * i]));
  Report unwanted_report;
  Memory_counter memory;
  Progress progress(nullptr, unwanted_report, memory);
  Placed_creases found = find_creases<Parallel_if_available_tag>(spacing, progress, positions,
                                                                 normals);
  for (std::size_t i = 0; i < positions.size(); ++i)
    std::copy_n(normals[i].data(), 3, &result_normals[3 * i]);
  return found;
}

/// The confidences of a result of the device, computed by all threads of the host.
inline void estimate_feature_confidences(const Buffer<Vector>& result,
                                         const std::vector<float>& result_normals,
                                         double sharpness_angle, Buffer<float>& confidences)
{
  Buffer<Vector> positions(result);
  Working_frame frame;
  frame.enter<Parallel_if_available_tag>(positions);
  double spacing = robust_diagonal<Parallel_if_available_tag>(positions)
                   / std::sqrt(double(positions.size()));
  spacing = sensible_radius(spacing, box_diagonal(positions));
  frame.set_unit<Parallel_if_available_tag>(spacing, positions);
  Buffer<Local_vector> normals;
  for (std::size_t i = 0; i < positions.size(); ++i)
    normals.emplace_back(result_normals[3 * i], result_normals[3 * i + 1],
                         result_normals[3 * i + 2]);
  Report unwanted_report;
  Memory_counter memory;
  Progress progress(nullptr, unwanted_report, memory);
  estimate_feature_confidences<Parallel_if_available_tag>(
    positions, normals, 1, normal_bandwidth(fit_angle_factor * sharpness_angle), progress,
    confidences);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FEATURES_OF_RESULT_H
