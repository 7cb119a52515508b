// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SHARE_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SHARE_POINTS_H

#include <CGAL/L0_resampling/internal/kernels/disk_of_sample.h>
#include <CGAL/L0_resampling/internal/normals/Local_normals.h>
#include <CGAL/L0_resampling/internal/samples/Gathered_values.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Samples as disks, sorted for the grid of the samples.
struct Sample_disks
{
  const Search_grid_3& grid;
  const Buffer<Vector>& positions;
  const Buffer<Local_vector>& normals; ///< unit length
  const Buffer<Disk_kernel<Local>>& kernels;
};

/*!
Shares the points among the samples around them by likelihood, the first half of a step of
expectation maximization (Dempster, Laird and Rubin 1977) of a mixture of disks: sample k has the
share \f$ r_{jk} = w_{jk} / (w_0 + \sum_i w_{ji}) \f$ of point j, \f$ w_{jk} \f$ as `Disk_kernel`
says and \f$ w_0 \f$ the density of outliers.

\param point_grid with cells of the sizes of those of the samples
\param reach of the disks, in cells
\returns one disk a sample
*/
template <typename ConcurrencyTag>
Buffer<Disk> share_points(const Search_grid_3& point_grid, const Buffer<Vector>& points,
                          const Sample_disks& samples, int reach, Progress& progress)
{
  using L = Lanes<Local>;
  using Local_vector = Eigen::Matrix<Local, 3, 1>;

  // of each point: the sum of the densities of the disks there
  Buffer<Local> densities = filled_buffer(points.size(), Local(share_of_outliers),
                                          points.get_allocator());
  const auto make_visitor_of_points = [&]() {
    return [&, normals = Local_normals<Local>(), kernels = Gathered_values<Local, 4>()](
             Search_grid_3::Range queries, Local_points<Local>& candidates,
             const Vector& origin) mutable {
      if (candidates.indices.empty())
        return;
      normals.gather(candidates, samples.normals);
      Local largest = 0;
      kernels.gather(candidates, [&](Index k, Local(&own)[4]) {
        const Disk_kernel<Local>& kernel = samples.kernels[k];
        own[0] = kernel.per_squared_height;
        own[1] = kernel.per_squared_extent;
        own[2] = kernel.density * Local(candidates.stride);
        own[3] = kernel.squared_reach;
        largest = (std::max)(largest, kernel.squared_reach);
      });
      for (Index j = queries.first; j < queries.second; ++j)
      {
        const Local_vector center = (points[j] - origin).cast<Local>();
        L sum;
        candidates.for_each_run_in_ball(
          center, largest, [&](std::size_t k, const L& squared_distance) {
            const L dx = L::load(&candidates.x[k]) - center[0],
                    dy = L::load(&candidates.y[k]) - center[1],
                    dz = L::load(&candidates.z[k]) - center[2],
                    height = dx * L::load(&normals.x[k]) + dy * L::load(&normals.y[k])
                             + dz * L::load(&normals.z[k]);
            const Disk_kernel<L> kernel = {kernels.load(0, k), kernels.load(1, k),
                                           kernels.load(2, k), kernels.load(3, k)};
            sum += kernel(squared_distance, height);
          });
        densities[j] += sum.sum();
      }
    };
  };
  for_each_cell<Local, ConcurrencyTag>(point_grid, points, samples.grid, samples.positions, reach,
                                       progress, make_visitor_of_points);

  Buffer<Disk> disks(samples.positions.size(), points.get_allocator());
  const auto make_visitor_of_samples = [&]() {
    return [&, inverse_densities = Gathered_values<Local, 1>()](Search_grid_3::Range queries,
                                                                Local_points<Local>& candidates,
                                                                const Vector& origin) mutable {
      inverse_densities.gather(candidates,
                               [&](Index j, Local(&own)[1]) { own[0] = 1 / densities[j]; });
      for (Index i = queries.first; i < queries.second; ++i)
      {
        const Local_vector center = (samples.positions[i] - origin).cast<Local>(),
                           normal = samples.normals[i];
        const Disk_kernel<Local>& own = samples.kernels[i];
        const Disk_kernel<L> kernel = {L(own.per_squared_height), L(own.per_squared_extent),
                                       L(own.density), L(own.squared_reach)};
        Shares_of_disk<L> sums;
        candidates.for_each_run_in_ball(
          center, own.squared_reach, [&](std::size_t k, const L& squared_distance) {
            const L height = (L::load(&candidates.x[k]) - center[0]) * normal[0]
                             + (L::load(&candidates.y[k]) - center[1]) * normal[1]
                             + (L::load(&candidates.z[k]) - center[2]) * normal[2];
            sums.add(kernel(squared_distance, height) * inverse_densities.load(0, k), height);
          });
        disks[i] = Disk(Shares_of_disk<Local>{sums.shares.sum(), sums.squared_shares.sum(),
                                              sums.heights.sum(), sums.squared_heights.sum(),
                                              sums.fourth_powers.sum()});
      }
    };
  };
  for_each_cell<Local, ConcurrencyTag>(samples.grid, samples.positions, point_grid, points, reach,
                                       progress, make_visitor_of_samples);
  return disks;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SHARE_POINTS_H
