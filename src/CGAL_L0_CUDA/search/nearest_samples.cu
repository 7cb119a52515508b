// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/nearest_samples.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

constexpr unsigned warps_per_block = 4;
constexpr unsigned cache_size = 256; // candidates of a query that shared memory holds

/// A squared distance, and behind it the index: the bits of floats that are not negative ascend, so
/// that the nearest comes first.
__device__ Wide rank_of(float squared_distance, unsigned index)
{
  return Wide(__float_as_uint(squared_distance)) << 32 | index;
}

/// Calls `f(is_inside, squared_distance, j)` in all threads of the warp at once, for the points of
/// the block around a cell, but for those of rows that the ball does not reach. The points of the
/// rows are dealt out one after the other, as there may be fewer in a row than threads in a warp.
template <typename F>
__device__ void for_each_in_ball(const Cell_grid& grid, const Cell_blocks& blocks, int4 center,
                                 unsigned self, float squared_radius, const F& f)
{
  const unsigned lane = threadIdx.x % 32, all = 0xffffffffu;
  const Block_center block = blocks.centers[center.w];
  const unsigned shift = unsigned(__ffs(int(block.stride))) - 1;
  const float unit = grid.frame.unit(), cell_size = float(grid.frame.cell_size);
  const Offset_in_row offset(block, center, unit);
  const uint2* const ranges = blocks.ranges
                              + Wide(unsigned(center.w)) * unsigned(blocks.number_of_rows);
  for (int first_row = 0; first_row < blocks.number_of_rows; first_row += 32)
  {
    uint2 range = {0, 0};
    const int row = first_row + int(lane);
    if (row < blocks.number_of_rows
        && (!block.is_inside
            || offset.squared_reach(squared_radius, cell_size, blocks.reach, row) > 0))
      range = ranges[row];
    unsigned first = range.x;
    if (block.stride > 1 && range.x < range.y) // a power of two
      first += (phase_of_row(ranges, row) - range.x) & (block.stride - 1);
    const unsigned count = range.x < range.y && first < range.y
                             ? ((range.y - 1 - first) >> shift) + 1
                             : 0;
    unsigned end = count; // how many points this row and those before it have
    for (unsigned offset = 1; offset < 32; offset *= 2)
    {
      const unsigned before = __shfl_up_sync(all, end, offset);
      end += lane >= offset ? before : 0;
    }
    const unsigned begin =
      first
      - ((end - count)
         << shift); // where the row would begin if it had the points of those before, too
    const unsigned total = __shfl_sync(all, end, 31);
    for (unsigned t = lane; t < total + lane; t += 32)
    {
      unsigned r = 0; // rows that end before the point
      for (unsigned step = 16; step > 0; step /= 2)
        r += __shfl_sync(all, end, r + step - 1) <= t ? step : 0;
      const unsigned j = __shfl_sync(all, begin, r) + (t << shift); // modulo 2^32
      float squared_distance = squared_radius;
      if (t < total && j != self)
      {
        const float3 d = difference(grid.points[j], center, unit);
        squared_distance = dot(d, d);
      }
      f(squared_distance < squared_radius, squared_distance, j);
    }
  }
}

/// One warp for each sample that is open: it stays so if its ball holds fewer than k others.
/// \param places of the samples in the grid
__global__ void find_nearest(Cell_grid grid, Cell_blocks blocks, const unsigned* places,
                             const unsigned* open, unsigned number_of_open, float squared_radius,
                             bool take_what_is_there, unsigned k, unsigned* nearest,
                             unsigned char* is_open)
{
  __shared__ Wide caches[warps_per_block][cache_size];
  Wide* const cache = caches[threadIdx.x / 32];
  const Wide q = warp_index();
  if (q >= number_of_open) // whole warps leave
    return;
  const unsigned lane = threadIdx.x % 32;
  const unsigned sample = open ? open[q] : unsigned(q);
  const unsigned self = places[sample];
  const int4 center = grid.points[self];
  unsigned* const result = nearest + Wide(sample) * k;

  unsigned count = 0;
  for_each_in_ball(grid, blocks, center, self, squared_radius,
                   [&](bool is_inside, float squared_distance, unsigned j) {
                     const unsigned found = __ballot_sync(0xffffffffu, is_inside);
                     const unsigned place = count + unsigned(__popc(found & ((1u << lane) - 1)));
                     if (is_inside && place < cache_size)
                       cache[place] = rank_of(squared_distance, grid.order[j]);
                     count += unsigned(__popc(found));
                   });
  __syncwarp();
  if (count < k && !take_what_is_there)
    return;
  if (lane == 0)
    is_open[sample] = 0;

  if (count <= cache_size)
  {
    for (unsigned c = lane; c < count; c += 32)
    {
      const Wide own = cache[c];
      unsigned rank = 0;
      for (unsigned other = 0; other < count; ++other)
        rank += cache[other] < own;
      if (rank < k)
        result[rank] = unsigned(own);
    }
    return;
  }

  // Too many to rank: the k-th smallest squared distance, bit by bit, as the bits of floats that
  // are not negative ascend.
  unsigned low = 0, high = __float_as_uint(squared_radius);
  while (low < high)
  {
    const unsigned middle = low + (high - low) / 2;
    unsigned number_below = 0;
    for_each_in_ball(grid, blocks, center, self, squared_radius,
                     [&](bool is_inside, float squared_distance, unsigned) {
                       number_below += unsigned(__popc(__ballot_sync(
                         0xffffffffu, is_inside && __float_as_uint(squared_distance) <= middle)));
                     });
    if (number_below >= k)
      high = middle;
    else
      low = middle + 1;
  }
  const float limit = __uint_as_float(low);
  unsigned size = 0;
  for (const bool is_tie : {false, true})
    for_each_in_ball(grid, blocks, center, self, squared_radius,
                     [&](bool is_inside, float squared_distance, unsigned j) {
                       const bool is_taken = is_inside
                                             && (is_tie ? squared_distance == limit
                                                        : squared_distance < limit);
                       const unsigned found = __ballot_sync(0xffffffffu, is_taken);
                       const unsigned place = size + unsigned(__popc(found & ((1u << lane) - 1)));
                       if (is_taken && place < k)
                         result[place] = grid.order[j];
                       size += unsigned(__popc(found));
                     });
}

constexpr unsigned threads_of_query = 256;

/// So few samples have a block of threads each, which looks into the cells without help: preparing
/// blocks of candidates around all cells would take longer.
constexpr unsigned maximum_number_of_single_queries = 2048;

constexpr int maximum_reach = 8;

/// Adds up over a block of threads.
__device__ unsigned sum_over_block(unsigned value)
{
  __shared__ unsigned sum;
  __syncthreads(); // the last sum has been read
  if (threadIdx.x == 0)
    sum = 0;
  __syncthreads();
  value = group_sum<32>(value);
  if (threadIdx.x % 32 == 0)
    atomicAdd(&sum, value);
  __syncthreads();
  return sum;
}

/// One block for each sample that is open, as `find_nearest()`. A sample stays open, too, where the
/// cells to look into reach the outermost ones, whose points may be further away than fixed-point
/// numbers tell, unless what is there has to do.
__global__ void __launch_bounds__(threads_of_query)
  find_nearest_of_few(Cell_grid grid, int reach, const unsigned* places, const unsigned* open,
                      float squared_radius, bool take_what_is_there, unsigned k, unsigned* nearest,
                      unsigned char* is_open)
{
  constexpr unsigned maximum_number_of_rows = (2 * maximum_reach + 1) * (2 * maximum_reach + 1);
  __shared__ uint2 ranges[maximum_number_of_rows];
  __shared__ unsigned number_of_ranges, number_of_candidates;
  __shared__ Wide candidates[maximum_number_of_candidates + 1]; // `rank_of()`
  const unsigned sample = open ? open[blockIdx.x] : blockIdx.x;
  const unsigned self = places[sample];
  const int4 center = grid.points[self];
  const uint3 cell = grid.frame.cell_of_key(grid.keys[center.w]);
  const auto is_inside = [&](unsigned place, unsigned size) {
    return place > unsigned(reach) && place + unsigned(reach) + 1 < size;
  };
  const bool is_block_inside = is_inside(cell.x, grid.frame.count[0])
                               && is_inside(cell.y, grid.frame.count[1])
                               && is_inside(cell.z, grid.frame.count[2]);
  if (!is_block_inside && !take_what_is_there)
    return;

  if (threadIdx.x == 0)
    number_of_ranges = number_of_candidates = 0;
  __syncthreads();
  unsigned size = 0;
  for (int row = int(threadIdx.x); row < (2 * reach + 1) * (2 * reach + 1);
       row += int(threads_of_query))
  {
    const uint2 range = range_of_row(grid, cell, reach, row);
    if (range.x < range.y)
      ranges[atomicAdd(&number_of_ranges, 1u)] = range;
    size += range.y - range.x;
  }
  size = sum_over_block(size);
  unsigned stride = 1; // as in `Block_center`
  while (size / stride > maximum_number_of_candidates)
    stride *= 2;
  const float unit = grid.frame.unit();
  const unsigned lane = threadIdx.x % 32;
  for (unsigned r = threadIdx.x / 32; r < number_of_ranges; r += threads_of_query / 32)
  {
    Wide first = ranges[r].x;
    if (stride > 1) // as `phase_of_row()`; the rows are in no order
    {
      unsigned number_before = 0;
      for (unsigned other = lane; other < number_of_ranges; other += 32)
        if (ranges[other].x < ranges[r].x)
          number_before += ranges[other].y - ranges[other].x;
      first += (0u - group_sum<32>(number_before)) & (stride - 1);
    }
    for (Wide j = first + lane * Wide(stride); j < ranges[r].y; j += 32 * Wide(stride))
    {
      const float3 d = difference(grid.points[j], center, unit);
      const float squared_distance = dot(d, d);
      if (j != self && squared_distance < squared_radius)
        candidates[atomicAdd(&number_of_candidates, 1u)] = rank_of(squared_distance, grid.order[j]);
    }
  }
  __syncthreads();
  const unsigned count = number_of_candidates;
  if (count < k && !take_what_is_there)
    return;
  if (threadIdx.x == 0)
    is_open[sample] = 0;

  // So small a ball that it is quick to rank what it holds.
  const unsigned few = 2 * k + 64;
  unsigned low = 0, high = __float_as_uint(squared_radius), number_inside = count;
  unsigned middle = __float_as_uint(squared_radius
                                    * fminf(1, float(few) / 2 / float(max(count, 1u))));
  while (number_inside > few && low < high)
  {
    unsigned own_number = 0;
    for (unsigned c = threadIdx.x; c < count; c += threads_of_query)
      own_number += unsigned(candidates[c] >> 32) <= middle;
    const unsigned number = sum_over_block(own_number);
    if (number >= k)
    {
      high = middle;
      number_inside = number;
    }
    else
      low = middle + 1;
    middle = low + (high - low) / 2;
  }
  for (unsigned c = threadIdx.x; c < count; c += threads_of_query)
  {
    const Wide own = candidates[c];
    if (unsigned(own >> 32) > high)
      continue;
    unsigned rank = 0;
    for (unsigned other = 0; other < count; ++other)
      rank += candidates[other] < own;
    if (rank < k)
      nearest[Wide(sample) * k + rank] = unsigned(own);
  }
}

__global__ void invert_order(const unsigned* order, unsigned size, unsigned* places)
{
  const Wide i = thread_index();
  if (i < size)
    places[order[i]] = unsigned(i);
}

} // namespace

unsigned* find_nearest_samples(const Execution_context& context, const double (&low)[3],
                               const double (&high)[3], unsigned k, double spacing_guess,
                               const Samples& samples)
{
  const int number_of_doublings = 10;
  const unsigned m = samples.size;
  const cudaStream_t stream = context.stream;
  unsigned* const nearest = context.arena.take<unsigned>(Wide(m) * k);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(nearest, 0xff, Wide(m) * k * sizeof(unsigned), stream));

  const Arena_scope scope(context.scratch);
  unsigned char* const is_open = context.scratch.take<unsigned char>(m);
  unsigned* const open = context.scratch.take<unsigned>(m);
  unsigned* const places = context.scratch.take<unsigned>(m);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(is_open, 1, m, stream));
  unsigned number_of_open = m;
  for (int base = 0; base <= number_of_doublings && number_of_open > 0; base += 2)
  {
    // A grid serves balls as large as a cell, of twice that size, and larger ones if few samples
    // are left.
    const double cell_size = std::ldexp(spacing_guess, base);
    const Arena_scope grid_scope(context.arena);
    const Positions positions = {samples.positions, m, Frame(), true};
    const Cell_grid grid = build_grid(
      positions, nullptr, Cell_frame::around(low, high, cell_size, maximum_reach * cell_size),
      context.arena, context.scratch, stream);
    invert_order<<<blocks_for(m), threads_per_block, 0, stream>>>(grid.order, m, places);
    check_launch("invert_order");
    for (int doubling = base; doubling <= number_of_doublings && number_of_open > 0; ++doubling)
    {
      const int reach = 1 << (doubling - base);
      const bool are_few = number_of_open <= maximum_number_of_single_queries;
      if (reach > (are_few ? maximum_reach : 2))
        break;
      const double radius = reach * cell_size;
      const float squared_radius = float(radius * radius);
      const bool is_last = doubling == number_of_doublings;
      const unsigned* const open_or_all = number_of_open < m ? open : nullptr;
      if (are_few)
      {
        find_nearest_of_few<<<number_of_open, threads_of_query, 0, stream>>>(
          grid, reach, places, open_or_all, squared_radius, is_last, k, nearest, is_open);
        check_launch("find_nearest_of_few");
      }
      else
      {
        const Arena_scope blocks_scope(context.arena);
        const Cell_blocks blocks = find_blocks(grid, grid, reach, maximum_number_of_candidates,
                                               context.arena, stream);
        const unsigned thread_blocks = (number_of_open + warps_per_block - 1) / warps_per_block;
        find_nearest<<<thread_blocks, 32 * warps_per_block, 0, stream>>>(
          grid, blocks, places, open_or_all, number_of_open, squared_radius, is_last, k, nearest,
          is_open);
        check_launch("find_nearest");
      }
      number_of_open = list_flagged(is_open, m, open, context.scratch, stream);
    }
  }
  return nearest;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
