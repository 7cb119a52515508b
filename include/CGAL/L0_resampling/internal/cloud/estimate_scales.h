// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H

#include <CGAL/L0_resampling/internal/cloud/estimate_plane.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/kernels/scales_of_balls.h>
#include <CGAL/L0_resampling/internal/search/thin_crowds.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Of the candidates in the ball around `center`, over the plane through it.
template <typename T>
Height_moments<double> moments_over_plane(const Eigen::Matrix<T, 3, 1>& center,
                                          const Eigen::Matrix<T, 3, 1>& normal,
                                          const Local_points<T>& candidates, T squared_radius)
{
  using L = Lanes<T>;
  Height_moments<L> lanes;
  candidates.for_each_run_in_ball(
    center, squared_radius, [&](std::size_t k, const L& squared_distance) {
      const L height = (L::load(&candidates.x[k]) - center[0]) * normal[0]
                       + (L::load(&candidates.y[k]) - center[1]) * normal[1]
                       + (L::load(&candidates.z[k]) - center[2]) * normal[2];
      lanes.add(height, where_less(squared_distance, squared_radius, L(T(1))));
    });
  return sum_of_lanes(lanes);
}

/// The scales of a point set, by `scales_of_growing_balls()` around `queries`.
/// \param queries some of the points, in units of the initial radius as the points are
/// \param points sorted for `grid`, all different
template <typename ConcurrencyTag, typename T>
Scales scales_around(const Buffer<Vector>& queries, const Search_grid_3& grid,
                     const Buffer<Vector>& points, Progress& progress)
{
  const double cell_size = grid.cell_size();
  const Search_grid_3 query_grid(queries, cell_size);
  std::vector<Ball_of_points> balls(queries.size());
  return scales_of_growing_balls(cell_size, [&](int reach, double radius) {
    for_each_cell<T, ConcurrencyTag>(query_grid, queries, grid, points, reach, progress, [&]() {
      return
        [&](Search_grid_3::Range range, const Local_points<T>& candidates, const Vector& origin) {
          for (Index i = range.first; i < range.second; ++i)
          {
            const Eigen::Matrix<T, 3, 1> center = (queries[i] - origin).template cast<T>();
            const Plane_of_ball fit = fit_plane<T>(center, candidates, T(radius * radius));
            balls[i] = ball_of_points(
              double(fit.number_of_points), double(candidates.stride), fit.variance,
              moments_over_plane(center, fit.normal_as<T>(), candidates, T(radius * radius)));
          }
        };
    });
    return balls;
  });
}

/*!
The scales of a point set. Of points at one place one counts, and of those that all but coincide a
few, however many there are: they tell nothing of a plane, and balls would shrink to a few places.

\param initial_radius a length; the largest ball is 8 times as large. The paper's r_p is a good one
\param is_core called with a point in the unit of `initial_radius`: whether all points that are
near to it are there, so that balls may be laid around it. Holds for one of them at least
\returns spacing and noise in units of `initial_radius`
*/
template <typename ConcurrencyTag, typename T, typename IsCore>
Scales estimate_scales(const Buffer<Vector>& unsorted_points, double initial_radius,
                       const IsCore& is_core, Progress& progress)
{
  const double cell_size = cell_size_of_scales;
  Buffer<Vector> points = copy_of(unsorted_points);
  Working_frame::divide<ConcurrencyTag>(initial_radius, points);
  apply_order<ConcurrencyTag>(Search_grid_3::sorted_order<ConcurrencyTag>(points, cell_size),
                              points);
  std::optional<Search_grid_3> grid(std::in_place, points, cell_size);
  thin_crowds<ConcurrencyTag>(*grid, points, most_points_of_subcell).keep(points);
  points.resize(std::size_t(std::unique(points.begin(), points.end()) - points.begin()));
  if (points.size() < grid->number_of_points())
    grid.emplace(points, cell_size);
  std::size_t number_in_core = 0;
  for_each_in_order(points.size(), [&](std::size_t i) { number_in_core += is_core(points[i]); });
  const std::size_t stride = (std::max)(number_in_core / number_of_balls, std::size_t(1));
  Buffer<Vector> queries(points.get_allocator());
  std::size_t place = 0; // among the points of the core
  for_each_in_order(points.size(), [&](std::size_t i) {
    if (is_core(points[i]) && place++ % stride == 0)
      queries.push_back(points[i]);
  });
  return scales_around<ConcurrencyTag, T>(queries, *grid, points, progress);
}

/// The scales of a point set, all of which is there.
template <typename ConcurrencyTag, typename T>
Scales estimate_scales(const Buffer<Vector>& points, double initial_radius, Progress& progress)
{
  return estimate_scales<ConcurrencyTag, T>(
    points, initial_radius, [](const Vector&) { return true; }, progress);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H
