// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H

#include <CGAL/L0_resampling/internal/update_normals.h>
#include <CGAL/L0_resampling/internal/weights.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Eq. (1) for one point: the mean of the normals in its ball by position and by similarity to its own, each turned to
/// the side of its own first. Scaling to unit length makes the division of Eq. (1) needless.
template <typename T>
Eigen::Matrix<T, 3, 1> filtered_normal(const Eigen::Matrix<T, 3, 1>& center, const Eigen::Matrix<T, 3, 1>& normal,
                                       const Local_points<T>& candidates, const Local_normals<T>& normals,
                                       const Normal_filter<T>& filter)
{
  using L = Lanes<T>;
  const T squared_radius = T(filter.radius * filter.radius);
  const T squared_bandwidth = filter.squared_bandwidth, normal_bandwidth = filter.normal_bandwidth;
  const T own_x = normal[0], own_y = normal[1], own_z = normal[2];
  L x, y, z;
  candidates.for_each_run_in_ball(center, squared_radius, [&](std::size_t k, const L& squared_distance) {
    const L nx = L::load(&normals.x[k]), ny = L::load(&normals.y[k]), nz = L::load(&normals.z[k]);
    const L cosine = nx * own_x + ny * own_y + nz * own_z;
    const L similarity = bilateral_weight(squared_distance, squared_bandwidth, cosine, normal_bandwidth);
    const L weight = where_less(squared_distance, squared_radius, with_sign_of(cosine, similarity));
    x += weight * nx;
    y += weight * ny;
    z += weight * nz;
  });
  // The point itself has weight 1, if the block was not thinned, so that the mean is short only where nothing agrees.
  const Eigen::Vector3d mean(x.sum(), y.sum(), z.sum());
  const double length = mean.norm();
  return length > 1e-3 ? Eigen::Matrix<T, 3, 1>((mean / length).template cast<T>()) : normal;
}

/// Bilateral filtering of unoriented normals, Eq. (1) and (2), `number_of_iterations` times over all points.
/// \param points sorted for `grid`
/// \param normals in and out, one unit vector a point
template <typename ConcurrencyTag, typename T>
void filter_normals(const Search_grid_3& grid, const Buffer<Vector>& points, const Normal_filter<T>& filter,
                    std::size_t number_of_iterations, Progress& progress, Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  for (std::size_t iteration = 0; iteration < number_of_iterations; ++iteration)
    update_normals<ConcurrencyTag>(grid, points, filter.radius, progress, normals,
                                   [&](const Eigen::Matrix<T, 3, 1>& center, const Eigen::Matrix<T, 3, 1>& normal,
                                       const Local_points<T>& candidates, const Local_normals<T>& candidate_normals) {
                                     return filtered_normal(center, normal, candidates, candidate_normals, filter);
                                   });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H
