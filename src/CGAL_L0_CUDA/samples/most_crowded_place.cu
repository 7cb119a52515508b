// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"
#include "search/Query.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// The number of points in a ball, and a place in the list: of more points, and then of what comes
/// first in the list, it is larger.
__device__ Wide as_number(unsigned number_of_points, unsigned place)
{
  return (Wide(number_of_points) << 32) | (0xffffffffu - place);
}

/// \param list the samples that the grid was built of
/// \param are_own whether each of all samples may be the center; null if all may
/// \param most in and out: the largest `as_number()`
__global__ void find_most_crowded(Cell_grid grid, Cell_blocks blocks, float radius,
                                  const unsigned* list, const unsigned char* are_own, Wide* most)
{
  const Query query(grid.size);
  const int4 center = grid.points[query.index];
  const float unit = grid.frame.unit();
  unsigned number = 0;
  for_each_candidate(grid, blocks, center, query.lane, radius, [&](unsigned, const int4& point) {
    const float3 d = difference(point, center, unit);
    number += dot(d, d) < radius * radius;
  });
  number = group_sum<lanes>(number) * blocks.centers[center.w].stride;
  const unsigned place = grid.order[query.index];
  if (query.writes && (!are_own || are_own[list[place]]))
    atomicMax(most, as_number(number, place));
}

} // namespace

Crowded_sample most_crowded_sample(const Execution_context& context, const Samples& samples,
                                   const unsigned char* are_listed, const double (&low)[3],
                                   const double (&high)[3], double radius)
{
  const Arena_scope arena_scope(context.arena), scratch_scope(context.scratch);
  unsigned* const list = context.arena.take<unsigned>(samples.size);
  const unsigned size = list_flagged(are_listed, samples.size, list, context.scratch,
                                     context.stream);
  if (size == 0)
    return {};
  const Cell_grid grid = build_grid({samples.positions, size, Frame(), true, list}, nullptr,
                                    Cell_frame::around(low, high, radius, radius), context.arena,
                                    context.scratch, context.stream);
  const Cell_blocks blocks = find_blocks(grid, grid, 1, maximum_number_of_candidates,
                                         context.scratch, context.stream);
  const Device_counter<Wide> most(context);
  find_most_crowded<<<blocks_for_queries(size), threads_per_block, 0, context.stream>>>(
    grid, blocks, float(radius), list, samples.are_own, most.address());
  check_launch("find_most_crowded");
  const Wide found = most.read();
  if (found == 0) // none may be the center
    return {};
  Crowded_sample result;
  result.number_of_samples = unsigned(found >> 32);
  const unsigned sample = context.scratch.read(list + (0xffffffffu - unsigned(found)),
                                               context.stream);
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(result.position, samples.positions + 3 * Wide(sample),
                                     sizeof(result.position), cudaMemcpyDeviceToHost,
                                     context.stream));
  CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(context.stream));
  return result;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
