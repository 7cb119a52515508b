// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/choose_sources.cuh"

#include <CGAL/L0_resampling/internal/core/random_bits.h>
#include <CGAL/L0_resampling/internal/kernels/exact_ball.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

// Samples shared out by points

/// One of each run of nearly equal length, as `pick_one_of_each_run()` on the CPU.
__global__ void pick_one_of_each_run(unsigned number_of_distinct, unsigned number_of_samples,
                                     Wide seed, unsigned* picked)
{
  const Wide k = thread_index();
  if (k >= number_of_samples)
    return;
  const Wide begin = k * number_of_distinct / number_of_samples,
             end = (k + 1) * number_of_distinct / number_of_samples;
  picked[k] = unsigned(begin + random_bits(seed, k) % (end - begin));
}

__global__ void spread_evenly(unsigned number_of_distinct, unsigned number_of_new,
                              unsigned* sources)
{
  const Wide e = thread_index();
  if (e < number_of_new)
    sources[e] = unsigned(e * number_of_distinct / number_of_new);
}

/// As `sources_by_points()` on the CPU.
Sources sources_by_points(const Execution_context& context, unsigned number_of_distinct, unsigned m,
                          Wide seed)
{
  Sources sources = {{nullptr, m}, {nullptr, 0}};
  unsigned* const list = context.scratch.take<unsigned>(m);
  if (m <= number_of_distinct)
  {
    pick_one_of_each_run<<<blocks_for(m), threads_per_block, 0, context.stream>>>(
      number_of_distinct, m, seed, list);
    check_launch("pick_one_of_each_run");
    sources.on_points.list = list;
    return sources;
  }
  sources.on_points.size = number_of_distinct;
  sources.near_points = {list, m - number_of_distinct};
  spread_evenly<<<blocks_for(sources.near_points.size), threads_per_block, 0, context.stream>>>(
    number_of_distinct, sources.near_points.size, list);
  check_launch("spread_evenly");
  return sources;
}

// Samples shared out by area

__global__ void take_areas(Cell_grid grid, Index_subset distinct, Areas areas, Wide* units)
{
  const Wide k = thread_index();
  if (k < distinct.size)
    units[k] = areas.of_cells[grid.points[distinct[k]].w];
}

/// The point in whose area the threshold of each sample lies; the last takes what rounding leaves.
/// \param sums of the areas before each point, and of all
__global__ void find_thresholds(const Wide* sums, unsigned number_of_distinct,
                                unsigned number_of_samples, Wide seed, unsigned* sources)
{
  const Wide k = thread_index();
  if (k >= number_of_samples)
    return;
  const Wide threshold = area_threshold(k, number_of_samples, seed, sums[number_of_distinct]);
  unsigned first = 0, size = number_of_distinct - 1;
  while (size > 0)
  {
    const unsigned half = size / 2;
    if (sums[first + half + 1] <= threshold)
    {
      first += half + 1;
      size -= half + 1;
    }
    else
      size = half;
  }
  sources[k] = first;
}

__global__ void mark_first_of_points(const unsigned* sources, unsigned number_of_samples,
                                     unsigned* is_first)
{
  const Wide k = thread_index();
  if (k < number_of_samples)
    is_first[k] = k == 0 || sources[k] != sources[k - 1];
}

/// \param places how many samples before each are the first of their points
__global__ void part_first_from_others(const unsigned* sources, const unsigned* places,
                                       unsigned number_of_samples, unsigned* first,
                                       unsigned* others)
{
  const Wide k = thread_index();
  if (k >= number_of_samples)
    return;
  const unsigned place = places[k];
  if (places[k + 1] > place)
    first[place] = sources[k];
  else
    others[k - place] = sources[k];
}

/// As `sources_by_area()` on the CPU.
Sources sources_by_area(const Execution_context& context, const Cell_grid& grid,
                        const Index_subset& distinct, const Areas& areas, unsigned m, Wide seed)
{
  const cudaStream_t stream = context.stream;
  unsigned *const first = context.scratch.take<unsigned>(m), *const others =
                                                               context.scratch.take<unsigned>(m);
  const Arena_scope scope(context.scratch);
  unsigned *const sources = context.scratch.take<unsigned>(m), *const places =
                                                                 context.scratch.take<unsigned>(
                                                                   Wide(m) + 1);
  Wide* const sums = context.scratch.take<Wide>(Wide(distinct.size) + 1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(sums + distinct.size, 0, sizeof(Wide), stream));
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(places + m, 0, sizeof(unsigned), stream));
  take_areas<<<blocks_for(distinct.size), threads_per_block, 0, stream>>>(grid, distinct, areas,
                                                                          sums);
  check_launch("take_areas");
  sum_up(sums, distinct.size, sums, context.scratch, stream);
  find_thresholds<<<blocks_for(m), threads_per_block, 0, stream>>>(sums, distinct.size, m, seed,
                                                                   sources);
  check_launch("find_thresholds");
  mark_first_of_points<<<blocks_for(m), threads_per_block, 0, stream>>>(sources, m, places);
  check_launch("mark_first_of_points");
  sum_up(places, m, places, context.scratch, stream);
  part_first_from_others<<<blocks_for(m), threads_per_block, 0, stream>>>(sources, places, m, first,
                                                                          others);
  check_launch("part_first_from_others");
  const unsigned number_of_first = context.scratch.read(places + m, stream);
  return {{first, number_of_first}, {others, m - number_of_first}};
}

// Samples whose starts are known

/// \param has_start out, of each distinct point: whether a sample starts on it
/// \param numbers_of_near out: how many start near it
__global__ void find_known_starts(Known_points known, Index_subset distinct,
                                  unsigned number_of_points, unsigned char* has_start,
                                  unsigned* numbers_of_near)
{
  const Wide d = thread_index();
  if (d >= distinct.size)
    return;
  const unsigned end = d + 1 < distinct.size ? distinct[d + 1] : number_of_points;
  unsigned number = 0; // one of the points at a place has all
  for (unsigned i = distinct[d]; i < end; ++i)
    number += known(i).number_of_samples;
  has_start[d] = number > 0;
  numbers_of_near[d] = number > 0 ? number - 1 : 0;
}

/// \param offsets how many samples start near all distinct points before
__global__ void list_near_starts(const unsigned* offsets, unsigned number_of_distinct,
                                 unsigned number_of_samples, unsigned* sources)
{
  const Wide e = thread_index();
  if (e < number_of_samples)
    sources[e] = last_not_above(offsets, number_of_distinct, e);
}

// Counted

__global__ void add_starts(Index_subset sources, Index_subset distinct, unsigned* numbers)
{
  const Wide k = thread_index();
  if (k < sources.size)
    atomicAdd(&numbers[distinct[sources[k]]], 1u);
}

} // namespace

Index_subset distinct_points(const Execution_context& context, const Cell_grid& grid)
{
  Index_subset distinct = {nullptr, grid.number_of_distinct};
  if (grid.number_of_distinct < grid.size)
  {
    unsigned* const list = context.scratch.take<unsigned>(grid.size);
    list_flagged(grid.is_first, grid.size, list, context.scratch, context.stream);
    distinct.list = list;
  }
  return distinct;
}

Sources chosen_sources(const Execution_context& context, const Cell_grid& grid,
                       const Index_subset& distinct, const Areas* areas, unsigned number_of_samples,
                       Wide seed)
{
  return areas ? sources_by_area(context, grid, distinct, *areas, number_of_samples, seed)
               : sources_by_points(context, distinct.size, number_of_samples, seed);
}

Sources known_sources(const Execution_context& context, const Known_points& known,
                      const Cell_grid& grid, const Index_subset& distinct, unsigned m)
{
  const cudaStream_t stream = context.stream;
  unsigned *const on_points = context.scratch.take<unsigned>(distinct.size),
                  *const near_points = context.scratch.take<unsigned>(m);
  const Arena_scope scope(context.scratch);
  unsigned char* const has_start = context.scratch.take<unsigned char>(distinct.size);
  unsigned* const offsets = context.scratch.take<unsigned>(Wide(distinct.size) + 1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(offsets + distinct.size, 0, sizeof(unsigned), stream));
  find_known_starts<<<blocks_for(distinct.size), threads_per_block, 0, stream>>>(
    known, distinct, grid.size, has_start, offsets);
  check_launch("find_known_starts");
  const unsigned number_on_points = list_flagged(has_start, distinct.size, on_points,
                                                 context.scratch, stream);
  sum_up(offsets, distinct.size, offsets, context.scratch, stream);
  const unsigned number_near_points = context.scratch.read(offsets + distinct.size, stream);
  if (Wide(number_on_points) + number_near_points != m)
    throw Failure(Status::DEVICE_FAILED, "points on which samples start were left out");
  list_near_starts<<<blocks_for((std::max)(number_near_points, 1u)), threads_per_block, 0,
                     stream>>>(offsets, distinct.size, number_near_points, near_points);
  check_launch("list_near_starts");
  return {{on_points, number_on_points}, {near_points, number_near_points}};
}

void count_starts(const Execution_context& context, const Cell_grid& grid, const Areas* areas,
                  unsigned number_of_samples, std::size_t seed, unsigned* numbers)
{
  const Arena_scope scope(context.scratch);
  const Index_subset distinct = distinct_points(context, grid);
  const Sources sources = chosen_sources(context, grid, distinct, areas, number_of_samples, seed);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(numbers, 0, grid.size * sizeof(unsigned), context.stream));
  for (const Index_subset& of_kind : {sources.on_points, sources.near_points})
    if (of_kind.size > 0)
    {
      add_starts<<<blocks_for(of_kind.size), threads_per_block, 0, context.stream>>>(
        of_kind, distinct, numbers);
      check_launch("add_starts");
    }
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
