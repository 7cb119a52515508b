// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearest_samples.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

using Wide = unsigned long long;

constexpr unsigned warps_per_block = 4;
constexpr unsigned cache_size = 256; // candidates of a query that shared memory holds

struct Candidate
{
  float squared_distance;
  unsigned index;

  __device__ bool operator<(const Candidate& b) const
  {
    return squared_distance < b.squared_distance || (squared_distance == b.squared_distance && index < b.index);
  }
};

/// Calls `f(is_inside, candidate)` in all threads of the warp at once, for the points of the block around a cell.
template <typename F>
__device__ void for_each_in_ball(const Cell_grid& grid, const Cell_blocks& blocks, int4 center, unsigned self,
                                 float squared_radius, const F& f)
{
  const unsigned lane = threadIdx.x % 32, stride = blocks.centers[center.w].stride;
  const float unit = grid.frame.unit();
  for (int row = 0; row < blocks.number_of_rows; ++row)
  {
    const uint2 range = blocks.ranges[Wide(unsigned(center.w)) * unsigned(blocks.number_of_rows) + unsigned(row)];
    const Wide first = (Wide(range.x) + stride - 1) & ~Wide(stride - 1);
    for (Wide begin = first; begin < range.y; begin += 32 * stride)
    {
      const Wide j = begin + lane * stride;
      Candidate candidate = {squared_radius, 0};
      if (j < range.y && j != self)
      {
        const float3 d = difference(grid.points[j], center, unit);
        candidate = {dot(d, d), grid.order[j]};
      }
      f(candidate.squared_distance < squared_radius, candidate);
    }
  }
}

/// One warp for each sample that is open: it stays so if its ball holds fewer than k others.
/// \param places of the samples in the grid
__global__ void find_nearest(Cell_grid grid, Cell_blocks blocks, const unsigned* places, const unsigned* open,
                             unsigned number_of_open, float squared_radius, bool take_what_is_there, unsigned k,
                             unsigned* nearest, unsigned char* is_open)
{
  __shared__ Candidate caches[warps_per_block][cache_size];
  Candidate* const cache = caches[threadIdx.x / 32];
  const Wide q = thread_index() / 32;
  if (q >= number_of_open) // whole warps leave
    return;
  const unsigned lane = threadIdx.x % 32;
  const unsigned sample = open ? open[q] : unsigned(q);
  const unsigned self = places[sample];
  const int4 center = grid.points[self];
  unsigned* const result = nearest + Wide(sample) * k;

  unsigned count = 0;
  for_each_in_ball(grid, blocks, center, self, squared_radius, [&](bool is_inside, const Candidate& candidate) {
    const unsigned found = __ballot_sync(0xffffffffu, is_inside);
    const unsigned place = count + unsigned(__popc(found & ((1u << lane) - 1)));
    if (is_inside && place < cache_size)
      cache[place] = candidate;
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
      const Candidate candidate = cache[c];
      unsigned rank = 0;
      for (unsigned other = 0; other < count; ++other)
        rank += cache[other] < candidate;
      if (rank < k)
        result[rank] = candidate.index;
    }
    return;
  }

  // Too many to rank: the k-th smallest squared distance, bit by bit, as the bits of floats that are not negative ascend.
  unsigned low = 0, high = __float_as_uint(squared_radius);
  while (low < high)
  {
    const unsigned middle = low + (high - low) / 2;
    unsigned number_below = 0;
    for_each_in_ball(grid, blocks, center, self, squared_radius, [&](bool is_inside, const Candidate& candidate) {
      number_below += unsigned(
        __popc(__ballot_sync(0xffffffffu, is_inside && __float_as_uint(candidate.squared_distance) <= middle)));
    });
    if (number_below >= k)
      high = middle;
    else
      low = middle + 1;
  }
  const float limit = __uint_as_float(low);
  unsigned size = 0;
  for (const bool is_tie : {false, true})
    for_each_in_ball(grid, blocks, center, self, squared_radius, [&](bool is_inside, const Candidate& candidate) {
      const bool is_taken = is_inside
                            && (is_tie ? candidate.squared_distance == limit : candidate.squared_distance < limit);
      const unsigned found = __ballot_sync(0xffffffffu, is_taken);
      const unsigned place = size + unsigned(__popc(found & ((1u << lane) - 1)));
      if (is_taken && place < k)
        result[place] = candidate.index;
      size += unsigned(__popc(found));
    });
}

__global__ void invert_order(const unsigned* order, unsigned size, unsigned* places)
{
  const Wide i = thread_index();
  if (i < size)
    places[order[i]] = unsigned(i);
}

} // namespace

unsigned* find_nearest_samples(const Workplace& workplace, const double (&low)[3], const double (&high)[3], unsigned k,
                               double spacing_guess, const Samples& samples)
{
  const int number_of_doublings = 10;
  const unsigned m = samples.size;
  const cudaStream_t stream = workplace.stream;
  unsigned* const nearest = workplace.arena.take<unsigned>(Wide(m) * k);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(nearest, 0xff, Wide(m) * k * sizeof(unsigned), stream));

  const Arena_scope scope(workplace.scratch);
  unsigned char* const is_open = workplace.scratch.take<unsigned char>(m);
  unsigned* const open = workplace.scratch.take<unsigned>(m);
  unsigned* const places = workplace.scratch.take<unsigned>(m);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(is_open, 1, m, stream));
  unsigned number_of_open = m;
  for (int doubling = 0; doubling <= number_of_doublings && number_of_open > 0; doubling += 2)
  {
    // A grid serves two balls: one as large as a cell, and one of twice that size.
    const double radius = std::ldexp(spacing_guess, doubling);
    const Arena_scope grid_scope(workplace.arena);
    const Positions positions = {samples.positions, m, Frame(), true};
    const Cell_grid grid = build_grid(positions, nullptr, Cell_frame::around(low, high, radius, 2 * radius),
                                      workplace.arena, workplace.scratch, stream);
    invert_order<<<blocks_for(m), threads_per_block, 0, stream>>>(grid.order, m, places);
    check_launch("invert_order");
    for (int reach = 1; reach <= 2 && doubling + reach - 1 <= number_of_doublings && number_of_open > 0; ++reach)
    {
      const Cell_blocks blocks = find_blocks(grid, grid, reach, maximum_number_of_candidates, workplace.arena, stream);
      const float squared_radius = float(radius * reach * radius * reach);
      const unsigned thread_blocks = (number_of_open + warps_per_block - 1) / warps_per_block;
      find_nearest<<<thread_blocks, 32 * warps_per_block, 0, stream>>>(
        grid, blocks, places, number_of_open < m ? open : nullptr, number_of_open, squared_radius,
        doubling + reach - 1 == number_of_doublings, k, nearest, is_open);
      check_launch("find_nearest");
      number_of_open = list_flagged(is_open, m, open, workplace.scratch, stream);
    }
  }
  return nearest;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
