// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "baseline_steps.h"

#include <CGAL/compute_average_spacing.h>
#include <CGAL/edge_aware_upsample_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <iterator>
#include <stdexcept>

namespace L0_benchmark {

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

void orient_normals(Oriented_points& points)
{
  CGAL::mst_orient_normals(points, number_of_normal_neighbors, point_and_normal_maps());
}

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

void add_normals(const std::vector<Point>& points, Measurement& measurement,
                 Oriented_points& result)
{
  result.clear();
  for (const Point& point : points)
    result.emplace_back(point, CGAL::NULL_VECTOR);
  measurement.phase("estimate normals", [&] { estimate_normals<CGAL::Sequential_tag>(result); });
  measurement.phase("orient normals", [&] { orient_normals(result); });
}

#define L0_BENCHMARK_STEPS_OF_TAG(Tag)                                                             \
  template void wlop<Tag>(std::vector<Point>&, std::size_t, double, bool, Oriented_points&);       \
  template void estimate_normals<Tag>(Oriented_points&);                                           \
  template void upsample<Tag>(std::size_t, double, double, Oriented_points&);

L0_BENCHMARK_STEPS_OF_TAG(CGAL::Sequential_tag)
L0_BENCHMARK_STEPS_OF_TAG(CGAL::Parallel_tag)

} // namespace L0_benchmark
