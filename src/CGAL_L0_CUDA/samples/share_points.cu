// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/stages_of_refinement.cuh"
#include "search/Query.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void find_kernels(Samples samples, Lengths_of_refinement lengths, double widening,
                             Disk_kernel<float>* kernels)
{
  const Wide k = thread_index();
  if (k < samples.size)
    kernels[k] = lengths_at(lengths, samples, unsigned(k)).widened(widening).kernel_of_disk();
}

/// How far the disks of the block around each cell of points reach at most. One warp a cell.
__global__ void find_reaches(Cell_blocks blocks, unsigned number_of_cells,
                             const Disk_kernel<float>* kernels, float* reaches)
{
  const Wide cell = warp_index();
  if (cell >= number_of_cells)
    return;
  const uint2* const ranges = blocks.ranges_of(unsigned(cell));
  const unsigned lane = threadIdx.x % 32;
  float largest = 0;
  for (int row = 0, rows = blocks.number_of_ranges(unsigned(cell)); row < rows; ++row)
    for (unsigned k = ranges[row].x + lane; k < ranges[row].y; k += 32)
      largest = fmaxf(largest, kernels[k].squared_reach);
  largest = group_maximum<32>(largest);
  if (lane == 0)
    reaches[cell] = sqrtf(largest);
}

/// Of each point: the sum of the densities of the disks there.
/// \param reaches of the disks around each cell
/// \param inverse_densities out
__global__ void sum_up_densities(Cell_grid points, Cell_blocks blocks, Cell_grid sample_grid,
                                 const float4* normals, const Disk_kernel<float>* kernels,
                                 const float* reaches, float* inverse_densities)
{
  const Query query(points.size);
  const int4 center = points.points[query.index];
  const float unit = points.frame.unit();
  float sum = 0;
  for_each_candidate(sample_grid, blocks, center, query.lane, reaches[center.w],
                     [&](unsigned k, const int4& place) {
                       const float3 d = difference(place, center, unit);
                       sum += kernels[k](dot(d, d), dot(d, xyz(normals[k])));
                     });
  // of a thinned block each sample stands for as many
  const float density = group_sum<lanes>(sum) * float(blocks.centers[center.w].stride);
  if (query.writes)
    inverse_densities[query.index] = 1 / (float(share_of_outliers) + density);
}

__global__ void sum_up_shares(Cell_grid sample_grid, Cell_blocks blocks, Cell_grid points,
                              const float* inverse_densities, const Disk_kernel<float>* kernels,
                              Lengths_of_refinement lengths, Samples samples,
                              Shares_of_samples shares)
{
  const Query query(samples.size);
  const unsigned i = query.index;
  const int4 center = sample_grid.points[i];
  const float unit = points.frame.unit();
  const float3 normal = xyz(samples.normals[i]);
  const Disk_kernel<float> kernel = kernels[i];
  const float reach = sqrtf(kernel.squared_reach);
  Shares_of_disk<float> sums;
  for_each_candidate(points, blocks, center, query.lane, reach, [&](unsigned j, const int4& place) {
    const float3 d = difference(place, center, unit);
    const float height = dot(d, normal);
    sums.add(kernel(dot(d, d), height) * inverse_densities[j], height);
  });
  const Disk disk(
    Shares_of_disk<float>{group_sum<lanes>(sums.shares), group_sum<lanes>(sums.squared_shares),
                          group_sum<lanes>(sums.heights), group_sum<lanes>(sums.squared_heights),
                          group_sum<lanes>(sums.fourth_powers)});
  if (!query.writes)
    return;
  samples.normals[i] = with_w(normal, disk.height);
  shares.informations[i] =
    lengths_at(lengths, samples, i).information(disk, lengths.noise_of_disk());
  shares.variances[i] = disk.variance;
  if (shares.scatters)
    shares.scatters[i] = {disk.weight, fmaxf(disk.squared_height - disk.height * disk.height, 0),
                          disk.squared_height, disk.fourth_power};
}

} // namespace

void share_points(const Execution_context& context, const Lengths_of_refinement& lengths,
                  double widening, const Cell_grid& point_grid, const Cell_grid& sample_grid,
                  const Samples& samples, const Shares_of_samples& shares)
{
  const cudaStream_t stream = context.stream;
  const int reach = cells_in_reach(lengths.widened(widening).reach_of_disk(),
                                   sample_grid.frame.cell_size);
  const Arena_scope arena_scope(context.arena);
  float* const inverse_densities = context.arena.take<float>(point_grid.size);
  Disk_kernel<float>* const kernels = context.arena.take<Disk_kernel<float>>(samples.size);
  find_kernels<<<blocks_for(samples.size), threads_per_block, 0, stream>>>(samples, lengths,
                                                                           widening, kernels);
  check_launch("find_kernels");
  {
    const Arena_scope scope(context.scratch);
    const unsigned cells = point_grid.number_of_cells;
    const Cell_blocks blocks = find_blocks(point_grid, sample_grid, reach,
                                           maximum_number_of_candidates, context.scratch, stream);
    float* const reaches = context.scratch.take<float>(cells);
    find_reaches<<<blocks_for(32ull * cells), threads_per_block, 0, stream>>>(blocks, cells,
                                                                              kernels, reaches);
    check_launch("find_reaches");
    sum_up_densities<<<blocks_for_queries(point_grid.size), threads_per_block, 0, stream>>>(
      point_grid, blocks, sample_grid, samples.normals, kernels, reaches, inverse_densities);
    check_launch("sum_up_densities");
  }
  const Arena_scope scope(context.scratch);
  const Cell_blocks blocks = find_blocks(sample_grid, point_grid, reach,
                                         maximum_number_of_candidates, context.scratch, stream);
  sum_up_shares<<<blocks_for_queries(samples.size), threads_per_block, 0, stream>>>(
    sample_grid, blocks, point_grid, inverse_densities, kernels, lengths, samples, shares);
  check_launch("sum_up_shares");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
