// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/cloud/near_pairs.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/kernels/Bilateral_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Sum_of_vectors.h>
#include <CGAL/L0_resampling/internal/normals/update_normals.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The normal that has the direction of a sum. The point itself has weight 1 in the sum, if the
/// block was not thinned, so that the sum is short only where nothing agrees: then the normal stays
/// as it is.
template <typename T>
Eigen::Matrix<T, 3, 1> direction_of_sum(const Eigen::Vector3d& sum,
                                        const Eigen::Matrix<T, 3, 1>& normal)
{
  const double length = sum.norm();
  return length > minimum_length_of_mean_normal
           ? Eigen::Matrix<T, 3, 1>((sum / length).template cast<T>())
           : normal;
}

/// Eq. (1) for one point: the mean of the normals in its ball by position and by similarity to its
/// own, each turned to the side of its own first.
template <typename T>
Eigen::Matrix<T, 3, 1> filtered_normal(const Eigen::Matrix<T, 3, 1>& center,
                                       const Eigen::Matrix<T, 3, 1>& normal,
                                       Local_points<T>& candidates, const Local_normals<T>& normals,
                                       const Normal_filter<T>& filter)
{
  using L = Lanes<T>;
  const T own_x = normal[0], own_y = normal[1], own_z = normal[2];
  const Bilateral_kernel<T> kernel = filter.kernel();
  Sum_of_vectors<L> sum; // of Eq. (1), of which only the direction counts
  candidates.for_each_run_in_ball(
    center, kernel.squared_radius, [&](std::size_t k, const L& squared_distance) {
      const L nx = L::load(&normals.x[k]), ny = L::load(&normals.y[k]), nz = L::load(&normals.z[k]);
      sum.add(nx, ny, nz,
              signed_weight(squared_distance, nx * own_x + ny * own_y + nz * own_z, kernel));
    });
  return direction_of_sum({sum.x.sum(), sum.y.sum(), sum.z.sum()}, normal);
}

/// Eq. (1) for all points, each pair once.
/// \pre `has_plain_blocks_only()`
template <typename ConcurrencyTag, typename T>
void filter_normals_by_pairs(const Search_grid_3& grid, const Buffer<Vector>& points,
                             const Tiles_of_rows& tiles, int reach, const Normal_filter<T>& filter,
                             Progress& progress, Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  using L = Lanes<T>;
  using Local_vector = Eigen::Matrix<T, 3, 1>;
  Buffer<Local_vector> sums = copy_of(normals); // the point itself has weight 1
  const auto make_visitor = [&]() {
    return [&, n = Local_normals<T>(), s = Local_normals<T>()](
             Search_grid_3::Range queries, Local_points<T>& candidates, const Vector&) mutable {
      n.gather(candidates, normals);
      for (Aligned_vector<T>* values : {&s.x, &s.y, &s.z})
        values->assign(candidates.padded_size(), T(0));
      // in registers, which the compiler cannot know to be safe while there are sums to write to
      const Bilateral_kernel<T> kernel = filter.kernel();
      const T *const n_x = n.x.data(), *const n_y = n.y.data(), *const n_z = n.z.data();
      T *const s_x = s.x.data(), *const s_y = s.y.data(), *const s_z = s.z.data();
      for (std::size_t i = 0; i < queries.second - queries.first; ++i)
      {
        const Local_vector center = candidates.take(
          i); // neither a neighbor of itself nor one of those that follow
        const T own_x = n_x[i], own_y = n_y[i], own_z = n_z[i];
        Sum_of_vectors<L> sum; // of Eq. (1), of which only the direction counts
        candidates.for_each_run_in_ball(
          center, kernel.squared_radius, [&](std::size_t k, const L& squared_distance) {
            const L nx = L::load(n_x + k), ny = L::load(n_y + k), nz = L::load(n_z + k);
            const L weight = signed_weight(squared_distance, nx * own_x + ny * own_y + nz * own_z,
                                           kernel);
            sum.add(nx, ny, nz, weight);
            (L::load(s_x + k) + weight * own_x).store(s_x + k);
            (L::load(s_y + k) + weight * own_y).store(s_y + k);
            (L::load(s_z + k) + weight * own_z).store(s_z + k);
          });
        s_x[i] += sum.x.sum();
        s_y[i] += sum.y.sum();
        s_z[i] += sum.z.sum();
      }
      for (std::size_t k = 0; k < candidates.indices.size(); ++k)
        sums[candidates.indices[k]] += Local_vector(s.x[k], s.y[k], s.z[k]);
    };
  };
  for_each_cell_and_those_ahead<T, ConcurrencyTag>(grid, points, tiles, reach, progress,
                                                   make_visitor);
  for_each_block<ConcurrencyTag>(normals.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      normals[i] = direction_of_sum<T>(sums[i].template cast<double>(), normals[i]);
  });
}

/// Bilateral filtering of unoriented normals, Eq. (1) and (2), once over all points.
/// \param points sorted for `grid`
/// \param filter at scale 1
/// \param facts whether blocks are plain: given, or found here
/// \param normals in and out, one unit vector a point
template <typename ConcurrencyTag, typename T>
void filter_normals(const Search_grid_3& grid, const Buffer<Vector>& points,
                    const Normal_filter<T>& filter, Facts_of_cloud& facts, Progress& progress,
                    Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  using Local_vector = Eigen::Matrix<T, 3, 1>;
  const int reach = cells_in_reach(filter.radius, grid.cell_size());
  if (all_blocks_complete<ConcurrencyTag>(grid, filter.radius, facts))
    filter_normals_by_pairs<ConcurrencyTag>(grid, points, Tiles_of_rows(grid, reach), reach, filter,
                                            progress, normals);
  else // points that thinning leaves out of one ball are not those that it leaves out of another
    update_normals<ConcurrencyTag>(
      grid, points, filter.radius, progress, normals,
      [&](const Local_vector& center, float scale, const Local_vector& normal,
          Local_points<T>& candidates, const Local_normals<T>& candidate_normals) {
        return filtered_normal(center, normal, candidates, candidate_normals,
                               filter.scaled(T(scale)));
      });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FILTER_NORMALS_H
