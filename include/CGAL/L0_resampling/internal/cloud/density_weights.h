// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DENSITY_WEIGHTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_DENSITY_WEIGHTS_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/cloud/near_pairs.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Density_in_ball.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the others in the ball of each point add up to: how many they are, and the sum of their
/// weights of Eq. (2).
template <typename ConcurrencyTag, typename T>
void sum_weights_in_balls(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                          T squared_bandwidth, Progress& progress, Buffer<Index>& counts,
                          Buffer<T>& sums)
{
  using L = Lanes<T>;
  const auto make_visitor = [&]() {
    return [&](Search_grid_3::Range queries, Local_points<T>& candidates, const Vector& origin) {
      for (Index i = queries.first; i < queries.second; ++i)
      {
        const Eigen::Matrix<T, 3, 1> center = (points[i] - origin).template cast<T>();
        const T squared_radius = T(square(radius * grid.scale(i))),
                own_squared_bandwidth = squared_bandwidth * T(grid.scale(i)) * T(grid.scale(i));
        Density_in_ball<L> lanes;
        candidates.for_each_run_in_ball(
          center, squared_radius, [&](std::size_t, const L& squared_distance) {
            lanes += Density_in_ball<L>::of_point(squared_distance, squared_radius,
                                                  own_squared_bandwidth);
          });
        const Density_in_ball<T> all = {lanes.count.sum(), lanes.sum.sum()},
                                 others = all.of_others();
        counts[i] = Index(others.count) * candidates.stride;
        sums[i] = others.sum * T(candidates.stride);
      }
    };
  };
  for_each_cell<T, ConcurrencyTag>(
    grid, points, grid, points, cells_in_reach(radius, grid.cell_size()), progress, make_visitor);
}

/// As `sum_weights_in_balls()`, each pair once.
/// \pre `has_plain_blocks_only()`
template <typename ConcurrencyTag, typename T>
void sum_weights_by_pairs(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                          T squared_bandwidth, Progress& progress, Buffer<Index>& counts,
                          Buffer<T>& sums)
{
  using L = Lanes<T>;
  const T squared_radius = T(radius * radius);
  const int reach = cells_in_reach(radius, grid.cell_size());
  const auto make_visitor = [&]() {
    return [&, local_counts = Aligned_vector<T>(), local_sums = Aligned_vector<T>()](
             Search_grid_3::Range queries, Local_points<T>& candidates, const Vector&) mutable {
      local_counts.assign(candidates.padded_size(), T(0));
      local_sums.assign(candidates.padded_size(), T(0));
      for (std::size_t i = 0; i < queries.second - queries.first; ++i)
      {
        Density_in_ball<L> lanes;
        candidates.for_each_run_in_ball(
          candidates.take(i), squared_radius, [&](std::size_t k, const L& squared_distance) {
            const Density_in_ball<L> of_pair =
              Density_in_ball<L>::of_point(squared_distance, squared_radius, squared_bandwidth);
            lanes += of_pair;
            (L::load(&local_counts[k]) + of_pair.count).store(&local_counts[k]);
            (L::load(&local_sums[k]) + of_pair.sum).store(&local_sums[k]);
          });
        local_counts[i] += lanes.count.sum();
        local_sums[i] += lanes.sum.sum();
      }
      for (std::size_t k = 0; k < candidates.indices.size(); ++k)
      {
        counts[candidates.indices[k]] += Index(local_counts[k]);
        sums[candidates.indices[k]] += local_sums[k];
      }
    };
  };
  for_each_cell_and_those_ahead<T, ConcurrencyTag>(grid, points, Tiles_of_rows(grid, reach), reach,
                                                   progress, make_visitor);
}

/// The number of others in the ball of each input point, and the sum of Eq. (5) over them.
/// \param points sorted for `grid`
/// \param radius, squared_bandwidth at scale 1
/// \param facts whether blocks are plain: given, or found here
/// \param counts, sums out: one number a point
template <typename ConcurrencyTag, typename T>
void sum_up_density(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                    double squared_bandwidth, Facts_of_cloud& facts, Progress& progress,
                    Buffer<Index>& counts, Buffer<T>& sums)
{
  fill_buffer(points.size(), Index(0), counts);
  fill_buffer(points.size(), T(0), sums);
  if (all_blocks_complete<ConcurrencyTag>(grid, radius, facts))
    sum_weights_by_pairs<ConcurrencyTag>(grid, points, radius, T(squared_bandwidth), progress,
                                         counts, sums);
  else
    sum_weights_in_balls<ConcurrencyTag>(grid, points, radius, T(squared_bandwidth), progress,
                                         counts, sums);
}

/// \f$ v_j \f$ of Eq. (5) for each input point. The sum leaves out the point itself, which the "1
/// +" of Eq. (5) counts. Parameters are those of `sum_up_density()`.
/// \param facts also the mean number of neighbors: given, or found here
/// \param weights out: one number a point, at least 1
/// \returns the number of points whose balls hold fewer than `minimum_number_of_points_of_plane`
template <typename ConcurrencyTag, typename T>
std::size_t compute_input_density_weights(const Search_grid_3& grid, const Buffer<Vector>& points,
                                          double radius, double squared_bandwidth,
                                          Facts_of_cloud& facts, Progress& progress,
                                          Buffer<T>& weights)
{
  Buffer<Index> counts(points.get_allocator());
  sum_up_density<ConcurrencyTag>(grid, points, radius, squared_bandwidth, facts, progress, counts,
                                 weights);
  double total = 0;
  std::size_t number_of_sparse_balls = 0;
  for (Index count : counts)
  {
    total += count;
    number_of_sparse_balls += count + 1 < minimum_number_of_points_of_plane;
  }
  const double mean_number_of_neighbors =
    known_or_found(facts.mean_number_of_neighbors, [&]() { return total / double(points.size()); });
  for_each_in_order(weights.size(), [&](std::size_t i) {
    weights[i] = T(density_weight(weights[i], mean_number_of_neighbors));
  });
  return number_of_sparse_balls;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DENSITY_WEIGHTS_H
