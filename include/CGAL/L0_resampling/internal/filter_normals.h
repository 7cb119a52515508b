// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H

#include <CGAL/L0_resampling/internal/Local_normals.h>
#include <CGAL/L0_resampling/internal/ball_queries.h>
#include <CGAL/L0_resampling/internal/weights.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What Eq. (1) and (2) need beside the points.
template <typename T>
struct Normal_filter
{
  double radius;             ///< \f$ r_q \f$
  T squared_bandwidth;       ///< \f$ \sigma_q^2 \f$
  T normal_bandwidth;        ///< \f$ (1 - \cos\sigma_n)^2 \f$
};

/// Eq. (1) for one point: the mean of the normals in its ball by position and by similarity to its own, each turned to
/// the side of its own first. Scaling to unit length makes the division of Eq. (1) needless.
template <typename T>
Eigen::Matrix<T, 3, 1> filtered_normal(const Eigen::Matrix<T, 3, 1>& center, const Eigen::Matrix<T, 3, 1>& normal,
                                       const Local_points<T>& candidates, const Local_normals<T>& normals,
                                       const Normal_filter<T>& filter)
{
  using L = Lanes<T>;
  const T squared_radius = T(filter.radius * filter.radius);
  L x, y, z;
  for (std::size_t k = 0; k < candidates.padded_size(); k += L::size)
  {
    const L squared_distance = candidates.squared_distances(k, center);
    // Candidates that follow each other are neighbors along x: half of the time all are outside.
    if (!any_less(squared_distance, squared_radius))
      continue;
    const L nx = L::load(&normals.x[k]), ny = L::load(&normals.y[k]), nz = L::load(&normals.z[k]);
    const L cosine = nx * normal[0] + ny * normal[1] + nz * normal[2];
    const L similarity = bilateral_weight(squared_distance, filter.squared_bandwidth, cosine, filter.normal_bandwidth);
    const L weight = where_less(squared_distance, squared_radius, with_sign_of(cosine, similarity));
    x += weight * nx;
    y += weight * ny;
    z += weight * nz;
  }
  // The point itself has weight 1, if the block was not thinned, so that the mean is short only where nothing agrees.
  const Eigen::Vector3d mean(x.sum(), y.sum(), z.sum());
  const double length = mean.norm();
  return length > 1e-3 ? Eigen::Matrix<T, 3, 1>((mean / length).template cast<T>()) : normal;
}

/// Bilateral filtering of unoriented normals, Eq. (1) and (2), `number_of_iterations` times over all points. Each round reads
/// only the normals of the last one.
/// \param points sorted for `grid`
/// \param normals in and out, one unit vector a point
template <typename ConcurrencyTag, typename T>
void filter_normals(const Search_grid_3& grid, const Buffer<Vector>& points, const Normal_filter<T>& filter,
                    std::size_t number_of_iterations, Progress& progress, Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  Buffer<Eigen::Matrix<T, 3, 1>> filtered(normals);
  const auto make_visitor = [&]() {
    return [&, local_normals = Local_normals<T>()](Search_grid_3::Range queries, const Local_points<T>& candidates,
                                                   const Vector& origin) mutable {
      local_normals.gather(candidates, normals);
      for (Index i = queries.first; i < queries.second; ++i)
        filtered[i] = filtered_normal<T>((points[i] - origin).template cast<T>(), normals[i], candidates, local_normals, filter);
    };
  };
  for (std::size_t iteration = 0; iteration < number_of_iterations; ++iteration)
  {
    for_each_cell<T, ConcurrencyTag>(grid, points, grid, points, cells_in_reach(filter.radius, grid.cell_size()), progress,
                                     make_visitor);
    normals.swap(filtered);
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H
