// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_BASELINE_STEPS_H
#define CGAL_L0_RESAMPLING_BENCHMARK_BASELINE_STEPS_H

#include "method_program.h"

#include <CGAL/compute_average_spacing.h>
#include <CGAL/edge_aware_upsample_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <iterator>
#include <stdexcept>

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
          double radius_in_spacings, bool require_uniform_sampling, Oriented_points& result)
{
  if (number_of_output_points > points.size())
    throw std::invalid_argument("WLOP makes no more points than it is given");
  // WLOP floors the product of share and size: half a point more makes the count exact
  const double percentage = 100. * (double(number_of_output_points) + 0.5) / double(points.size());
  const double radius =
    radius_in_spacings == default_radius
      ? -1
      : radius_in_spacings
          * CGAL::compute_average_spacing<ConcurrencyTag>(points, number_of_spacing_neighbors);

  result.clear();
  const auto append = [&result](const Point& point) {
    result.emplace_back(point, CGAL::NULL_VECTOR);
  };
  CGAL::wlop_simplify_and_regularize_point_set<ConcurrencyTag>(
    points, boost::make_function_output_iterator(append),
    CGAL::parameters::select_percentage(percentage)
      .neighbor_radius(radius)
      .require_uniform_sampling(require_uniform_sampling));
}

template <typename ConcurrencyTag>
void estimate_normals(Oriented_points& points)
{
  CGAL::pca_estimate_normals<ConcurrencyTag>(points, number_of_normal_neighbors,
                                             point_and_normal_maps());
}

/// Points that CGAL cannot orient keep the sign they have: a benchmark that dropped them would
/// change the count.
inline void orient_normals(Oriented_points& points)
{
  CGAL::mst_orient_normals(points, number_of_normal_neighbors, point_and_normal_maps());
}

/// EAR's last step: points are added up to `number_of_output_points`, for which `result` has
/// reserved the room, so that CGAL may append to the range it reads.
/// \param sharpness_angle in degrees
template <typename ConcurrencyTag>
void upsample(std::size_t number_of_output_points, double sharpness_angle, double edge_sensitivity,
              Oriented_points& result)
{
  CGAL::edge_aware_upsample_point_set<ConcurrencyTag>(result, std::back_inserter(result),
                                                      point_and_normal_maps()
                                                        .sharpness_angle(sharpness_angle)
                                                        .edge_sensitivity(edge_sensitivity)
                                                        .number_of_output_points(
                                                          number_of_output_points));
}

/// What a method without normals gets: PCA normals oriented over a spanning tree. Timed apart, as
/// phases of their own.
inline void add_normals(const std::vector<Point>& points, Measurement& measurement,
                        Oriented_points& result)
{
  result.clear();
  for (const Point& point : points)
    result.emplace_back(point, CGAL::NULL_VECTOR);
  measurement.phase("estimate normals", [&] { estimate_normals<CGAL::Sequential_tag>(result); });
  measurement.phase("orient normals", [&] { orient_normals(result); });
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_BASELINE_STEPS_H
