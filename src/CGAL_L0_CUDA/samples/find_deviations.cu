// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/gathered.cuh"
#include "samples/stages_of_refinement.cuh"
#include "search/Query.cuh"

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void fill_deviations(Deviations all, Samples samples)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  samples.position_deviations[i] = all.position;
  samples.normal_deviations[i] = all.normal;
}

/// \param normals in the order of the grid
__global__ void find_deviations_of_samples(Cell_grid grid, Cell_blocks blocks,
                                           const float4* normals, Lengths_of_refinement lengths,
                                           const Variances_of_fit* variances, Samples samples)
{
  const Query query(grid.size);
  const unsigned i = grid.order[query.index];
  const int4 center = grid.points[query.index];
  const float unit = grid.frame.unit();
  const float4 normal = normals[query.index];
  const Ball_of_normals ball(lengths_at(lengths, samples, i));
  Angles_around<float> around;
  for_each_candidate(grid, blocks, center, query.lane, sqrtf(ball.squared_radius),
                     [&](unsigned k, const int4& place) {
                       const float3 d = difference(place, center, unit);
                       const float4 other = normals[k];
                       around.add(ball, dot(d, d),
                                  squared_difference_of_normals(normal.x, normal.y, normal.z,
                                                                other.x, other.y, other.z));
                     });
  around = {group_sum<lanes>(around.weight), group_sum<lanes>(around.squared_angles)};
  if (!query.writes)
    return;
  const Deviations deviations = deviations_of_sample(variances[i], around);
  const unsigned start = samples.start_indices[i];
  samples.position_deviations[start] = deviations.position;
  samples.normal_deviations[start] = deviations.normal;
}

} // namespace

void begin_deviations(const Execution_context& context, const Lengths_of_refinement& lengths,
                      const Samples& samples)
{
  const Deviations all = {float(lengths.noise_of_disk()),
                          float(std::sqrt(squared_angle_of_any_normal))};
  fill_deviations<<<blocks_for(samples.size), threads_per_block, 0, context.stream>>>(all, samples);
  check_launch("fill_deviations");
}

void find_deviations(const Execution_context& context, const Cell_frame& frame,
                     const Lengths_of_refinement& lengths, const Variances_of_fit* variances,
                     const Samples& samples)
{
  const cudaStream_t stream = context.stream;
  Device_arena &arena = context.arena, &scratch = context.scratch;
  const Arena_scope scope(arena);
  const Cell_grid grid = build_grid(samples.in_frame(), nullptr, frame, arena, scratch, stream);
  const Cell_blocks blocks = find_blocks(
    grid, grid, cells_in_reach(Ball_of_normals::maximum_radius(lengths), frame.cell_size),
    maximum_number_of_candidates, arena, stream);
  const float4* const normals = gathered(arena, stream, grid.order, grid.size, samples.normals);
  find_deviations_of_samples<<<blocks_for_queries(grid.size), threads_per_block, 0, stream>>>(
    grid, blocks, normals, lengths, variances, samples);
  check_launch("find_deviations_of_samples");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
