// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_BASELINE_STEPS_H
#define CGAL_L0_RESAMPLING_BENCHMARK_BASELINE_STEPS_H

#include "method_program.h"

#include <cstddef>
#include <vector>

namespace L0_benchmark {

/// Neighbors for normals and their orientation, as in the examples of CGAL's manual: three rings.
constexpr unsigned number_of_normal_neighbors = 18;

/// Neighbors for the average spacing, as WLOP counts them for its default radius: one ring.
constexpr unsigned number_of_spacing_neighbors = 6;

/// What the user of a radius in spacings left out: the function's own default.
constexpr double default_radius = 0;

inline Json radius_to_json(double radius_in_spacings)
{
  return radius_in_spacings == default_radius ? Json("default") : Json(radius_in_spacings);
}

/// WLOP to `number_of_output_points` points, which replace those of `result`, without normals. CGAL
/// reorders `points`. `radius_in_spacings` is a multiple of the average spacing of `points`, or
/// `default_radius`: CGAL's, eight of them.
/// \throws std::invalid_argument for more points than `points` has, which CGAL reads out of range
template <typename ConcurrencyTag>
void wlop(std::vector<Point>& points, std::size_t number_of_output_points,
          double radius_in_spacings, bool require_uniform_sampling, Oriented_points& result);

template <typename ConcurrencyTag>
void estimate_normals(Oriented_points& points);

/// Points that CGAL cannot orient keep the sign they have: a benchmark that dropped them would
/// change the count.
void orient_normals(Oriented_points& points);

/// EAR's last step: points are added up to `number_of_output_points`, for which `result` has
/// reserved the room, so that CGAL may append to the range it reads.
/// \param sharpness_angle in degrees
template <typename ConcurrencyTag>
void upsample(std::size_t number_of_output_points, double sharpness_angle, double edge_sensitivity,
              Oriented_points& result);

/// What a method without normals gets: PCA normals oriented over a spanning tree. Timed apart, as
/// phases of their own.
void add_normals(const std::vector<Point>& points, Measurement& measurement,
                 Oriented_points& result);

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_BASELINE_STEPS_H
