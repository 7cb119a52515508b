// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DENSITY_WEIGHTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_DENSITY_WEIGHTS_H

#include <CGAL/L0_resampling/internal/ball_queries.h>
#include <CGAL/L0_resampling/internal/weights.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// \f$ v_j \f$ of Eq. (5) for each input point. The sum leaves out the point itself, which the "1 +" of Eq. (5) counts.
/// \param points sorted for `grid`
/// \param weights out: one number a point, at least 1
/// \returns \f$ \eta_Q \f$, the mean number of neighbors
template <typename ConcurrencyTag, typename T>
double compute_input_density_weights(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                                     double squared_bandwidth, Progress& progress, Buffer<T>& weights)
{
  const T squared_radius = T(radius * radius);
  Buffer<Index> counts(points.size(), 0, points.get_allocator());
  const auto make_visitor = [&]() {
    return [&](Search_grid_3::Range queries, const Local_points<T>& candidates, const Vector& origin) {
      using L = Lanes<T>;
      for (Index i = queries.first; i < queries.second; ++i)
      {
        const Eigen::Matrix<T, 3, 1> center = (points[i] - origin).template cast<T>();
        L count, sum;
        candidates.for_each_run_in_ball(center, squared_radius, [&](std::size_t, const L& squared_distance) {
          count += where_less(squared_distance, squared_radius, L(T(1)));
          sum += where_less(squared_distance, squared_radius, gaussian_weight(squared_distance, T(squared_bandwidth)));
        });
        // thinning may have left the point itself out
        const T self = count.sum() > 0 ? T(1) : T(0);
        counts[i] = Index(count.sum() - self) * candidates.stride;
        weights[i] = (std::max)(T(0), sum.sum() - self) * T(candidates.stride);
      }
    };
  };
  for_each_cell<T, ConcurrencyTag>(grid, points, grid, points, cells_in_reach(radius, grid.cell_size()), progress,
                                   make_visitor);

  double total = 0;
  for (Index count : counts)
    total += count;
  const double mean_number_of_input_neighbors = total / double(points.size());
  if (mean_number_of_input_neighbors > 0)
    for (T& weight : weights)
      weight = T(1 + weight / mean_number_of_input_neighbors);
  else
    weights.assign(weights.size(), T(1));
  return mean_number_of_input_neighbors;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DENSITY_WEIGHTS_H
