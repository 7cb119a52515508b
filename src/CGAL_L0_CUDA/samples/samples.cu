// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/kernels/Fit_of_neighbors.h>

#include <type_traits>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void collapse(Cell_grid sample_grid, Cell_blocks blocks, Cell_grid grid,
                         const float4* normals, float radius, Samples samples,
                         const unsigned* numbers_of_samples, Sample_counts* counts)
{
  const Query query(samples.size);
  const int4 center = sample_grid.points[query.index];
  const float unit = grid.frame.unit(), squared_radius = radius * radius;
  Fit_of_neighbors<float> own;
  for_each_candidate(grid, blocks, center, query.lane, radius, [&](unsigned j, const int4& point) {
    const float3 d = difference(point, center, unit);
    own.add(d.x, d.y, d.z, dot(d, d), squared_radius, normals[j].w);
  });
  const float weight_sum = group_sum<lanes>(own.weight);
  const float3 sum = group_sum<lanes>(float3{own.places.x, own.places.y, own.places.z});
  if (!query.writes)
    return;
  const unsigned i = sample_grid.order[query.index];
  const bool is_lonely = !(weight_sum > 0);
  samples.fit[i] = is_lonely ? make_float4(0, 0, 0, 1) : with_w((1 / weight_sum) * sum, weight_sum);
  if (is_lonely)
    atomicAdd(&counts->lonely, numbers_of_samples ? numbers_of_samples[i] : 1u);
}

__global__ void reorder_samples(const unsigned* order, Samples from, Samples to)
{
  const Wide i = thread_index();
  if (i >= to.size)
    return;
  const Wide k = order[i];
  for (int axis = 0; axis < 3; ++axis)
    to.positions[3 * i + axis] = from.positions[3 * k + axis];
  to.normals[i] = from.normals[k];
  if (to.fit)
    to.fit[i] = from.fit[k];
  if (to.outward)
    to.outward[i] = from.outward[k];
  if (to.are_support_points)
    to.are_support_points[i] = from.are_support_points[k];
  if (to.scales)
    to.scales[i] = from.scales[k];
  if (to.spreading_radii)
    to.spreading_radii[i] = from.spreading_radii[k];
  if (to.hints)
    to.hints[i] = from.hints[k];
  if (to.start_indices)
    to.start_indices[i] = from.start_indices[k];
  if (to.noises)
    to.noises[i] = from.noises[k];
  if (to.noise_ratios)
    to.noise_ratios[i] = from.noise_ratios[k];
  if (to.sides)
    to.sides[i] = from.sides[k];
  if (to.are_own)
    to.are_own[i] = from.are_own[k];
}

/// Calls `f(k, is_neighbor, found)` in all threads of a group at once: whether the sample k of the
/// thread is a self neighbor, and a bit for each thread whose is; k ascends. Where blocks are
/// thinned, a pair counts if the ranks in their cells are equal modulo the strides of both.
template <typename F>
__device__ void for_each_self_neighbor(const Cell_grid& grid, const Cell_blocks& blocks,
                                       const Range_of_pairs& range_of, unsigned i, unsigned lane,
                                       const F& f)
{
  const int4 center = grid.points[i];
  const unsigned cell = unsigned(center.w), stride = blocks.centers[cell].stride;
  // in its cell, modulo the stride; only read where a block is thinned
  const auto rank = [&](unsigned sample, unsigned of_cell, unsigned modulus) {
    return modulus == 1 ? 0 : (sample - grid.begins[of_cell]) & (modulus - 1);
  };
  const float unit = grid.frame.unit();
  const unsigned group_shift = threadIdx.x % 32 / lanes * lanes, group_mask = ((1u << lanes) - 1)
                                                                              << group_shift;
  const float own_limit = range_of.limit(i);
  const uint2* const ranges = blocks.ranges_of(cell);
  for (int row = 0, rows = blocks.number_of_ranges(cell); row < rows; ++row)
  {
    const uint2 range = ranges[row];
    // of a thinned block cell by cell, in each those of the rank of this sample
    for (unsigned first = range.x, end = range.y; first < range.y; first = end)
    {
      if (stride > 1)
        end = grid.begins[grid.points[first].w + 1];
      for (unsigned begin = first + rank(i, cell, stride); begin < end; begin += lanes * stride)
      {
        const unsigned k = begin + lane * stride;
        bool is_neighbor = k < end && k != i;
        if (is_neighbor)
        {
          const int4 other = grid.points[k];
          const float3 d = difference(center, other, unit);
          const unsigned other_stride = blocks.centers[other.w].stride;
          is_neighbor = dot(d, d) < range_of.squared(own_limit, range_of.limit(k))
                        && rank(k, unsigned(other.w), other_stride) == rank(i, cell, other_stride);
        }
        const unsigned found = (__ballot_sync(group_mask, is_neighbor) & group_mask) >> group_shift;
        f(k, is_neighbor, found);
      }
    }
  }
}

__global__ void count_self_neighbors(Cell_grid grid, Cell_blocks blocks, Range_of_pairs range_of,
                                     unsigned* counts, Wide* total_count)
{
  const Query query(grid.size);
  unsigned count = 0;
  for_each_self_neighbor(grid, blocks, range_of, query.index, query.lane,
                         [&](unsigned, bool, unsigned found) { count += unsigned(__popc(found)); });
  if (query.writes)
    counts[query.index] = count;

  __shared__ Wide block_count;
  if (threadIdx.x == 0)
    block_count = 0;
  __syncthreads();
  if (query.writes)
    atomicAdd(&block_count, Wide(count));
  __syncthreads();
  if (threadIdx.x == 0)
    atomicAdd(total_count, block_count);
}

__global__ void list_self_neighbors(Cell_grid grid, Cell_blocks blocks, Range_of_pairs range_of,
                                    const unsigned* offsets, unsigned* indices)
{
  const Wide q = thread_index() / lanes;
  if (q >= grid.size) // whole groups leave
    return;
  const unsigned lane = threadIdx.x % lanes;
  unsigned next = offsets[q];
  for_each_self_neighbor(grid, blocks, range_of, unsigned(q), lane,
                         [&](unsigned k, bool is_neighbor, unsigned found) {
                           if (is_neighbor)
                             indices[next + unsigned(__popc(found & ((1u << lane) - 1)))] = k;
                           next += unsigned(__popc(found));
                         });
}

__global__ void note_rows(const unsigned* offsets, unsigned size, int4* points)
{
  const Wide i = thread_index();
  if (i < size)
    points[i].w = int(offsets[i]);
}

__global__ void take_result(Frame frame, Samples samples, float* normals)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const double3 n = to_double(xyz(samples.normals[i]));
  const double3 unit = (1 / sqrt(dot(n, n))) * n;
  for (int axis = 0; axis < 3; ++axis)
    samples.positions[3 * i + axis] = frame.leave(samples.positions[3 * i + axis], axis);
  normals[3 * i] = float(unit.x);
  normals[3 * i + 1] = float(unit.y);
  normals[3 * i + 2] = float(unit.z);
}

} // namespace

Samples take_samples(Device_arena& arena, unsigned size, const Kinds_of_sample_data& kinds)
{
  Samples samples;
  samples.size = size;
  samples.positions = arena.take<double>(3 * std::size_t(size));
  samples.normals = arena.take<float4>(size);
  samples.fit = arena.take<float4>(size);
  samples.outward = kinds.of_default_method ? arena.take<Short_vector>(size) : nullptr;
  samples.are_support_points = kinds.of_default_method ? arena.take<unsigned char>(size) : nullptr;
  samples.scales = kinds.scales ? arena.take<float>(size) : nullptr;
  samples.spreading_radii = kinds.spreading_radii ? arena.take<float>(size) : nullptr;
  samples.hints = kinds.hints ? arena.take<float4>(size) : nullptr;
  samples.side_confidences = arena.take<float>(size);
  samples.noises = kinds.noises ? arena.take<float>(size) : nullptr;
  samples.position_deviations = kinds.deviations ? arena.take<float>(size) : nullptr;
  samples.normal_deviations = kinds.deviations ? arena.take<float>(size) : nullptr;
  samples.are_own = kinds.of_tile ? arena.take<unsigned char>(size) : nullptr;
  samples.trees = kinds.of_tile ? arena.take<unsigned>(size) : nullptr;
  return samples;
}

void reorder(const Execution_context& context, const unsigned* order, const Samples& samples)
{
  Samples all = samples;
  keep_listed(context, order, all.size, all);
}

void keep_listed(const Execution_context& context, const unsigned* list, unsigned size,
                 Samples& samples)
{
  const Arena_scope scope(context.scratch);
  const std::size_t m = samples.size;
  Samples before = samples;
  const auto copy = [&](auto*& array, std::size_t count) {
    const auto* const from = array;
    if (!from)
      return;
    array = context.scratch.take<std::decay_t<decltype(*array)>>(count);
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(array, from, count * sizeof(*array),
                                       cudaMemcpyDeviceToDevice, context.stream));
  };
  copy(before.positions, 3 * m);
  copy(before.normals, m);
  copy(before.fit, m);
  copy(before.outward, m);
  copy(before.are_support_points, m);
  copy(before.scales, m);
  copy(before.spreading_radii, m);
  copy(before.hints, m);
  copy(before.start_indices, m);
  copy(before.noises, m);
  copy(before.noise_ratios, m);
  copy(before.sides, m);
  copy(before.are_own, m);
  samples.size = size;
  reorder_samples<<<blocks_for(size), threads_per_block, 0, context.stream>>>(list, before,
                                                                              samples);
  check_launch("reorder_samples");
}

void sort_by_places(const Execution_context& context, const double (&low)[3],
                    const double (&high)[3], double cell_size, const Samples& samples,
                    unsigned* order)
{
  const Arena_scope arena_scope(context.arena);
  const Cell_grid grid = build_grid({samples.positions, samples.size, Frame(), true}, nullptr,
                                    Cell_frame::around(low, high, cell_size, cell_size, false),
                                    context.arena, context.scratch, context.stream);
  reorder(context, grid.order, samples);
  if (order)
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(order, grid.order, grid.size * sizeof(*order),
                                       cudaMemcpyDeviceToDevice, context.stream));
}

void collapse_fit_term(const Execution_context& context, const Cell_grid& sample_grid,
                       const Cell_blocks& blocks, const Cell_grid& grid, const float4* normals,
                       double radius, const Samples& samples, const unsigned* numbers_of_samples,
                       Sample_counts* counts)
{
  collapse<<<blocks_for_queries(samples.size), threads_per_block, 0, context.stream>>>(
    sample_grid, blocks, grid, normals, float(radius), samples, numbers_of_samples, counts);
  check_launch("collapse");
}

Neighbor_lists find_self_neighbors(const Execution_context& context, const Cell_grid& grid,
                                   const Range_of_pairs& range_of)
{
  const cudaStream_t stream = context.stream;
  const unsigned m = grid.size, thread_blocks = blocks_for_queries(m);
  Neighbor_lists lists;
  const Arena_scope scope(context.scratch);
  const Cell_blocks blocks = find_blocks(grid, grid, 1, maximum_number_of_self_candidates,
                                         context.scratch, stream);
  unsigned* const offsets = context.scratch.take<unsigned>(std::size_t(m) + 1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(offsets + m, 0, sizeof(unsigned), stream));
  const Device_counter<Wide> total_count(context);
  count_self_neighbors<<<thread_blocks, threads_per_block, 0, stream>>>(
    grid, blocks, range_of, offsets, total_count.address());
  check_launch("count_self_neighbors");
  sum_up(offsets, m, offsets, context.scratch, stream);
  lists.number_of_pairs = total_count.read();
  if (lists.number_of_pairs > 0xffffffffu)
    throw Failure(Status::OUT_OF_MEMORY, "more than 2^32 - 1 pairs of self neighbors");

  lists.indices = context.arena.take<unsigned>(lists.number_of_pairs);
  list_self_neighbors<<<thread_blocks, threads_per_block, 0, stream>>>(grid, blocks, range_of,
                                                                       offsets, lists.indices);
  check_launch("list_self_neighbors");
  note_rows<<<blocks_for(m), threads_per_block, 0, stream>>>(offsets, m, grid.points);
  check_launch("note_rows");
  return lists;
}

void leave_frame(const Execution_context& context, const Frame& frame, const Samples& samples)
{
  take_result<<<blocks_for(samples.size), threads_per_block, 0, context.stream>>>(
    frame, samples, reinterpret_cast<float*>(samples.fit));
  check_launch("take_result");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
