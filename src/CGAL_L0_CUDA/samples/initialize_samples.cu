// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/core/random_bits.h>
#include <CGAL/L0_resampling/internal/kernels/Start_near_source.h>
#include <CGAL/L0_resampling/internal/kernels/exact_ball.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// Some of the numbers from 0 on, ascending; `list` is null where they are the first `size`.
struct Some
{
  const unsigned* list;
  unsigned size;

  __device__ unsigned operator[](Wide k) const { return list ? list[k] : unsigned(k); }
};

/// Where samples start, by the numbers of distinct points: on a point, or between it and another.
struct Sources
{
  Some on_points, near_points;
};

/// Of ascending numbers, the place of the last that is not above `value`; the first is not.
__device__ unsigned last_not_above(const unsigned* numbers, unsigned size, Wide value)
{
  unsigned first = 0;
  for (unsigned rest = size - 1; rest > 0;)
  {
    const unsigned half = (rest + 1) / 2;
    if (numbers[first + half] <= value)
    {
      first += half;
      rest -= half;
    }
    else
      rest = half - 1;
  }
  return first;
}

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
Sources sources_by_points(const Workplace& workplace, unsigned number_of_distinct, unsigned m,
                          Wide seed)
{
  Sources sources = {{nullptr, m}, {nullptr, 0}};
  unsigned* const list = workplace.scratch.take<unsigned>(m);
  if (m <= number_of_distinct)
  {
    pick_one_of_each_run<<<blocks_for(m), threads_per_block, 0, workplace.stream>>>(
      number_of_distinct, m, seed, list);
    check_launch("pick_one_of_each_run");
    sources.on_points.list = list;
    return sources;
  }
  sources.on_points.size = number_of_distinct;
  sources.near_points = {list, m - number_of_distinct};
  spread_evenly<<<blocks_for(sources.near_points.size), threads_per_block, 0, workplace.stream>>>(
    number_of_distinct, sources.near_points.size, list);
  check_launch("spread_evenly");
  return sources;
}

// Samples shared out by area

__global__ void take_areas(Cell_grid grid, Some distinct, Areas areas, Wide* units)
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
Sources sources_by_area(const Workplace& workplace, const Cell_grid& grid, const Some& distinct,
                        const Areas& areas, unsigned m, Wide seed)
{
  const cudaStream_t stream = workplace.stream;
  unsigned *const first = workplace.scratch.take<unsigned>(m), *const others =
                                                                 workplace.scratch.take<unsigned>(
                                                                   m);
  const Arena_scope scope(workplace.scratch);
  unsigned *const sources = workplace.scratch.take<unsigned>(m), *const places =
                                                                   workplace.scratch.take<unsigned>(
                                                                     Wide(m) + 1);
  Wide* const sums = workplace.scratch.take<Wide>(Wide(distinct.size) + 1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(sums + distinct.size, 0, sizeof(Wide), stream));
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(places + m, 0, sizeof(unsigned), stream));
  take_areas<<<blocks_for(distinct.size), threads_per_block, 0, stream>>>(grid, distinct, areas,
                                                                          sums);
  check_launch("take_areas");
  sum_up(sums, distinct.size, sums, workplace.scratch, stream);
  find_thresholds<<<blocks_for(m), threads_per_block, 0, stream>>>(sums, distinct.size, m, seed,
                                                                   sources);
  check_launch("find_thresholds");
  mark_first_of_points<<<blocks_for(m), threads_per_block, 0, stream>>>(sources, m, places);
  check_launch("mark_first_of_points");
  sum_up(places, m, places, workplace.scratch, stream);
  part_first_from_others<<<blocks_for(m), threads_per_block, 0, stream>>>(sources, places, m, first,
                                                                          others);
  check_launch("part_first_from_others");
  const unsigned number_of_first = workplace.scratch.read(places + m, stream);
  return {{first, number_of_first}, {others, m - number_of_first}};
}

// Samples whose starts are known

/// What is known of the points of a grid.
struct Known_points
{
  const Point_in_cloud* points; // of the session; null if nothing is known
  const unsigned *list,         // which of these were sorted; null for all
    *order;                     // where each stood before

  __device__ const Point_in_cloud& operator()(unsigned i) const
  {
    return points[list ? list[order[i]] : order[i]];
  }

  /// The number of a point in the order of the whole cloud.
  __device__ unsigned cloud_index(unsigned i) const { return points ? (*this)(i).index : i; }
};

__global__ void add_starts(Some sources, Some distinct, unsigned* numbers)
{
  const Wide k = thread_index();
  if (k < sources.size)
    atomicAdd(&numbers[distinct[sources[k]]], 1u);
}

/// \param has_start out, of each distinct point: whether a sample starts on it
/// \param numbers_of_near out: how many start near it
__global__ void find_known_starts(Known_points known, Some distinct, unsigned number_of_points,
                                  unsigned char* has_start, unsigned* numbers_of_near)
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

Sources known_sources(const Workplace& workplace, const Known_points& known, const Cell_grid& grid,
                      const Some& distinct, unsigned m)
{
  const cudaStream_t stream = workplace.stream;
  unsigned *const on_points = workplace.scratch.take<unsigned>(distinct.size),
                  *const near_points = workplace.scratch.take<unsigned>(m);
  const Arena_scope scope(workplace.scratch);
  unsigned char* const has_start = workplace.scratch.take<unsigned char>(distinct.size);
  unsigned* const offsets = workplace.scratch.take<unsigned>(Wide(distinct.size) + 1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(offsets + distinct.size, 0, sizeof(unsigned), stream));
  find_known_starts<<<blocks_for(distinct.size), threads_per_block, 0, stream>>>(
    known, distinct, grid.size, has_start, offsets);
  check_launch("find_known_starts");
  const unsigned number_on_points = list_flagged(has_start, distinct.size, on_points,
                                                 workplace.scratch, stream);
  sum_up(offsets, distinct.size, offsets, workplace.scratch, stream);
  const unsigned number_near_points = workplace.scratch.read(offsets + distinct.size, stream);
  if (Wide(number_on_points) + number_near_points != m)
    throw Failure(Status::DEVICE_FAILED, "points on which samples start were left out");
  list_near_starts<<<blocks_for((std::max)(number_near_points, 1u)), threads_per_block, 0,
                     stream>>>(offsets, distinct.size, number_near_points, near_points);
  check_launch("list_near_starts");
  return {{on_points, number_on_points}, {near_points, number_near_points}};
}

// Hints, one for each distinct point

/// Bits that ascend with the number.
__device__ unsigned ascending_bits(float value)
{
  const unsigned bits = value == 0 ? 0 : __float_as_uint(value), sign = 1u << 31;
  return bits & sign ? ~bits : bits | sign;
}

__device__ float number_of_ascending_bits(unsigned bits)
{
  const unsigned sign = 1u << 31;
  return __uint_as_float(bits & sign ? bits & ~sign : ~bits);
}

/// One axis of the hint of each distinct point, that of the first in lexicographic order of those
/// of its points: other than a choice by the order of the input, it is the same for any order.
/// \param least of each distinct point, xyz interleaved; those of the axes before are known
__global__ void find_least_hints(const float* hints, const unsigned* order, unsigned size,
                                 Some distinct, int axis, unsigned* least)
{
  const Wide j = thread_index();
  if (j >= size)
    return;
  // of the last distinct point that is not behind this point
  const Wide number = distinct.list ? last_not_above(distinct.list, distinct.size, j) : j;
  const float* const hint = hints + 3 * Wide(order[j]);
  for (int before = 0; before < axis; ++before)
    if (ascending_bits(hint[before]) != least[3 * number + unsigned(before)])
      return;
  atomicMin(&least[3 * number + unsigned(axis)], ascending_bits(hint[axis]));
}

/// From the scratch arena.
unsigned* least_hints(const Workplace& workplace, const float* hints, const Cell_grid& grid,
                      const Some& distinct)
{
  const std::size_t count = 3 * std::size_t(distinct.size);
  unsigned* const least = workplace.scratch.take<unsigned>(count);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(least, 0xff, count * sizeof(unsigned), workplace.stream));
  for (int axis = 0; axis < 3; ++axis)
  {
    find_least_hints<<<blocks_for(grid.size), threads_per_block, 0, workplace.stream>>>(
      hints, grid.order, grid.size, distinct, axis, least);
    check_launch("find_least_hints");
  }
  return least;
}

// Where they are then

/// What distinct points hand on to the samples that start on them.
struct Heritage
{
  const float4* normals; // of the points of the grid
  const Wide* areas;     // of the cells of the grid
  double area_per_unit, points_per_sample, largest_spreading_radius;
  const unsigned* hints; // of the distinct points
  Known_points known;
};

__device__ float4 unit_normal(float4 n)
{
  const double3 wide = to_double(xyz(n));
  return with_w(to_float((1 / sqrt(dot(wide, wide))) * wide), 0);
}

/// \param source the point in the grid, whose number among the distinct ones is `number`
__device__ void start_on_point(const Samples& samples, Wide i, double3 position,
                               const Heritage& heritage, const Cell_grid& grid, unsigned source,
                               Wide number, bool is_support_point)
{
  samples.positions[3 * i] = position.x;
  samples.positions[3 * i + 1] = position.y;
  samples.positions[3 * i + 2] = position.z;
  samples.normals[i] = unit_normal(heritage.normals[source]);
  samples.fit[i] = make_float4(0, 0, 0, 1);
  if (samples.scales)
    samples.scales[i] = grid.scale(source);
  if (samples.are_support_points)
    samples.are_support_points[i] = is_support_point;
  if (samples.spreading_radii)
    samples.spreading_radii[i] = spreading_radius_of(double(heritage.areas[grid.points[source].w])
                                                       * heritage.area_per_unit
                                                       * heritage.points_per_sample,
                                                     heritage.largest_spreading_radius);
  if (samples.hints)
  {
    const unsigned* const hint = heritage.hints + 3 * number;
    samples.hints[i] = make_float4(number_of_ascending_bits(hint[0]),
                                   number_of_ascending_bits(hint[1]),
                                   number_of_ascending_bits(hint[2]), 0);
  }
  if (samples.are_own)
    samples.are_own[i] = static_cast<unsigned char>(heritage.known(source).is_own);
}

/// Each new sample, as `move_near_sources()` on the CPU.
/// \param sources numbers of distinct points
/// \param lone_radius of the ball around a source that is alone
__global__ void place_near_points(Positions positions, Cell_grid grid, Cell_blocks blocks,
                                  Some distinct, Some sources, float radius, double lone_radius,
                                  Wide seed, Heritage heritage, Samples samples)
{
  const Query query(sources.size);
  const Wide e = query.index;
  const Wide number = sources[e];
  const unsigned source = distinct[number];
  Wide first = 0; // of the samples of this source
  for (Wide size = e; size > 0;)
  {
    const Wide half = size / 2;
    const bool is_before = sources[first + half] < number;
    first = is_before ? first + half + 1 : first;
    size = is_before ? size - half - 1 : half;
  }
  const Start_near_source near_source(seed, heritage.known.cloud_index(source), e - first);
  const int4 center = grid.points[source];
  const float4* const normals = heritage.normals;
  const float3 normal = xyz(normals[source]);
  radius *= grid.scale(source);
  const float unit = grid.frame.unit(), squared_radius = radius * radius;

  Wide best = 0;
  unsigned partner = source;
  for_each_candidate(grid, blocks, center, query.lane, radius, [&](unsigned j, const int4& point) {
    const float3 d = difference(point, center, unit);
    if (dot(d, d) >= squared_radius)
      return;
    const bool is_similar = fabsf(dot(normal, xyz(normals[j]))) > float(cosine_of_similar_normals);
    const Wide rank = near_source.rank(heritage.known.cloud_index(j), is_similar);
    if (rank <= best)
      return;
    const double3 p = positions(grid.order[j]), q = positions(grid.order[source]);
    if (p.x == q.x && p.y == q.y && p.z == q.z)
      return;
    best = rank;
    partner = j;
  });
  for (int offset = lanes / 2; offset > 0; offset /= 2)
  {
    const Wide other_best = __shfl_xor_sync(0xffffffffu, best, offset);
    const unsigned other_partner = __shfl_xor_sync(0xffffffffu, partner, offset);
    if (other_best > best || (other_best == best && other_partner < partner))
    {
      best = other_best;
      partner = other_partner;
    }
  }
  if (!query.writes)
    return;
  const double3 start = positions(grid.order[source]);
  double3 way;
  if (best > 0)
    way = near_source.share_of_way() * (positions(grid.order[partner]) - start);
  else
  {
    const Triple offset = near_source.offset_from_lone({normal.x, normal.y, normal.z},
                                                       lone_radius * grid.scale(source));
    way = {offset.x, offset.y, offset.z};
  }
  start_on_point(samples, e, start + way, heritage, grid, source, number, false);
}

/// \param first of the samples that start so
__global__ void place_on_points(Positions positions, Cell_grid grid, Some distinct, Some sources,
                                unsigned first, Heritage heritage, Support_subset support_points,
                                Samples samples)
{
  const Wide k = thread_index();
  if (k >= sources.size)
    return;
  const unsigned number = sources[k], source = distinct[number];
  start_on_point(samples, first + k, positions(grid.order[source]), heritage, grid, source, number,
                 support_points.takes(heritage.known.cloud_index(source)));
}

/// The first of the points at each place, from the scratch arena.
Some distinct_points(const Workplace& workplace, const Cell_grid& grid)
{
  Some distinct = {nullptr, grid.number_of_distinct};
  if (grid.number_of_distinct < grid.size)
  {
    unsigned* const list = workplace.scratch.take<unsigned>(grid.size);
    list_flagged(grid.is_first, grid.size, list, workplace.scratch, workplace.stream);
    distinct.list = list;
  }
  return distinct;
}

/// \param areas null if samples spread as the points do
Sources chosen_sources(const Workplace& workplace, const Cell_grid& grid, const Some& distinct,
                       const Areas* areas, unsigned number_of_samples, Wide seed)
{
  return areas ? sources_by_area(workplace, grid, distinct, *areas, number_of_samples, seed)
               : sources_by_points(workplace, distinct.size, number_of_samples, seed);
}

} // namespace

unsigned count_starts(const Workplace& workplace, const Cell_grid& grid, const Areas* areas,
                      unsigned number_of_samples, std::size_t seed, unsigned* numbers)
{
  const Arena_scope scope(workplace.scratch);
  const Some distinct = distinct_points(workplace, grid);
  const Sources sources = chosen_sources(workplace, grid, distinct, areas, number_of_samples, seed);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(numbers, 0, grid.size * sizeof(unsigned), workplace.stream));
  for (const Some& of_kind : {sources.on_points, sources.near_points})
    if (of_kind.size > 0)
    {
      add_starts<<<blocks_for(of_kind.size), threads_per_block, 0, workplace.stream>>>(
        of_kind, distinct, numbers);
      check_launch("add_starts");
    }
  return sources.on_points.size;
}

void initialize_samples(const Workplace& workplace, const Positions& positions,
                        const Cell_grid& grid, const Sources_of_samples& points, double radius,
                        double lone_radius, double spacing, std::size_t seed,
                        const Samples& samples)
{
  const cudaStream_t stream = workplace.stream;
  const Arena_scope scope(workplace.scratch);
  const Some distinct = distinct_points(workplace, grid);
  const Areas* const areas = points.areas;
  const Known_starts* const known = points.known;
  const Known_points known_points = {known ? known->points : nullptr, positions.list, grid.order};
  const Sources sources = known
                            ? known_sources(workplace, known_points, grid, distinct, samples.size)
                            : chosen_sources(workplace, grid, distinct,
                                             areas && points.spreads_evenly ? areas : nullptr,
                                             samples.size, seed);
  const Heritage heritage = {
    points.normals,
    areas ? areas->of_cells : nullptr,
    areas ? areas->area_per_unit : 0,
    known ? double(known->number_of_points) / double(known->number_of_samples)
          : double(grid.size) / double(samples.size),
    points.largest_spreading_radius,
    samples.hints ? least_hints(workplace, points.hints, grid, distinct) : nullptr,
    known_points};

  const unsigned number_of_new = sources.near_points.size;
  if (number_of_new > 0)
  {
    const Arena_scope blocks_scope(workplace.arena);
    const Cell_blocks blocks = find_blocks(grid, grid, cells_in_reach(radius, grid.frame.cell_size),
                                           maximum_number_of_candidates, workplace.arena, stream);
    place_near_points<<<blocks_for_queries(number_of_new), threads_per_block, 0, stream>>>(
      positions, grid, blocks, distinct, sources.near_points, float(radius), lone_radius, seed,
      heritage, samples);
    check_launch("place_near_points");
  }
  const Support_subset support_points(
    seed, radius, spacing, known ? known->number_of_starts : samples.size,
    known ? known->number_of_point_starts : sources.on_points.size);
  place_on_points<<<blocks_for(sources.on_points.size), threads_per_block, 0, stream>>>(
    positions, grid, distinct, sources.on_points, number_of_new, heritage, support_points, samples);
  check_launch("place_on_points");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
