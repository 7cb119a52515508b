// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/stages_of_refinement.cuh"
#include "kernels/Plane_fit.cuh"
#include "search/Query.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// \param order where each sample of the grid stands; null if each in its own place
__global__ void __launch_bounds__(threads_per_block, 2)
  fit(Cell_grid sample_grid, const unsigned* order, Cell_blocks blocks, Cell_grid grid, Disks disks,
      Lengths_of_refinement lengths, int scale_of_fit, Samples samples, const float* variances,
      Surface_of_disks* predictions, Surfaces_of_scale* all_surfaces)
{
  __shared__ Sums_of_block<Moments_of_disks<float>> sums;
  const auto radius_at = [&](unsigned i) {
    return radius_of_fit(scale_of_fit) * lengths_at(lengths, samples, i).unit;
  };
  {
    const Query query(samples.size);
    const int4 center = sample_grid.points[query.index];
    const unsigned i = order ? order[query.index] : query.index;
    const double radius = radius_at(i);
    const float4 normal = samples.normals[i];
    const Tangent_frame frame({normal.x, normal.y, normal.z});
    const float3 u = to_float(frame.u), v = to_float(frame.v), w = to_float(frame.normal);
    const Surface_of_disks prediction = predictions[i];
    Disk own;
    own.variance = variances[i];
    const Weight_in_fit<float> weight_of(radius, lengths_at(lengths, samples, i).deviation(own));
    const float unit = grid.frame.unit(), per_radius = float(1 / radius);
    Moments_of_disks<float> moments;
    for_each_candidate(
      grid, blocks, center, query.lane, float(radius), [&](unsigned k, const int4& place) {
        const float3 d = difference(place, center, unit);
        const float4 other = disks.normals[k];
        const float3 n = xyz(other), foot = d + other.w * n;
        const Seen_disk<float> disk = {dot(foot, u), dot(foot, v), dot(foot, w), dot(n, u),
                                       dot(n, v),    dot(n, w),    dot(d, d)};
        moments.add(disk.u * per_radius, disk.v * per_radius, disk.h * per_radius,
                    weight_of(disk, prediction), disks.informations[k]);
      });
    sums.set(query,
             Moments_of_disks<float>(moments, [](float sum) { return group_sum<lanes>(sum); }));
  }
  __syncthreads();
  const Single_query query(samples.size);
  if (!query.exists)
    return;
  const unsigned i = order ? order[query.index] : query.index;
  const double radius = radius_at(i), squared_noise = square(lengths.noise_of_disk());
  const Moments_of_disks<float>& moments = sums.of_query();
  const Surfaces_of_scale surfaces = {moments.surface<3>(radius, squared_noise),
                                      moments.surface<6>(radius, squared_noise)};
  all_surfaces[i] = surfaces;
  predictions[i] = surfaces.prediction(scale_of_fit, predictions[i]);
}

} // namespace

void fit_disks(const Execution_context& context, const Lengths_of_refinement& lengths,
               const Cell_grid& sample_grid, bool is_in_order, const Cell_grid& disk_grid,
               const Disks& disks, int scale, const Samples& samples, const float* variances,
               Surface_of_disks* predictions, Surfaces_of_scale* surfaces)
{
  const Arena_scope scope(context.scratch);
  const int reach = cells_in_reach(radius_of_fit(scale) * lengths.unit, disk_grid.frame.cell_size);
  const Cell_blocks blocks = find_blocks(
    sample_grid, disk_grid, reach, maximum_number_of_candidates, context.scratch, context.stream);
  fit<<<blocks_for_queries(samples.size), threads_per_block, 0, context.stream>>>(
    sample_grid, is_in_order ? nullptr : sample_grid.order, blocks, disk_grid, disks, lengths,
    scale, samples, variances, predictions, surfaces);
  check_launch("fit");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
