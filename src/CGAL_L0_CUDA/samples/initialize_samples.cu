// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/choose_sources.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/kernels/Start_near_source.h>
#include <CGAL/L0_resampling/internal/kernels/exact_ball.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

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
                                 Index_subset distinct, int axis, unsigned* least)
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
unsigned* least_hints(const Execution_context& context, const float* hints, const Cell_grid& grid,
                      const Index_subset& distinct)
{
  const std::size_t count = 3 * std::size_t(distinct.size);
  unsigned* const least = context.scratch.take<unsigned>(count);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(least, 0xff, count * sizeof(unsigned), context.stream));
  for (int axis = 0; axis < 3; ++axis)
  {
    find_least_hints<<<blocks_for(grid.size), threads_per_block, 0, context.stream>>>(
      hints, grid.order, grid.size, distinct, axis, least);
    check_launch("find_least_hints");
  }
  return least;
}

// Where they are then

/// What distinct points hand on to the samples that start on them.
struct Source_attributes
{
  const float4* normals; // of the points of the grid
  const Wide* areas;     // of the cells of the grid
  double area_per_unit, points_per_sample, maximum_spreading_radius;
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
                               const Source_attributes& attributes, const Cell_grid& grid,
                               unsigned source, Wide number, bool is_support_point)
{
  samples.positions[3 * i] = position.x;
  samples.positions[3 * i + 1] = position.y;
  samples.positions[3 * i + 2] = position.z;
  samples.normals[i] = unit_normal(attributes.normals[source]);
  samples.fit[i] = make_float4(0, 0, 0, 1);
  if (samples.scales)
    samples.scales[i] = grid.scale(source);
  if (samples.are_support_points)
    samples.are_support_points[i] = is_support_point;
  if (samples.spreading_radii)
    samples.spreading_radii[i] = spreading_radius_of(double(attributes.areas[grid.points[source].w])
                                                       * attributes.area_per_unit
                                                       * attributes.points_per_sample,
                                                     attributes.maximum_spreading_radius);
  if (samples.hints)
  {
    const unsigned* const hint = attributes.hints + 3 * number;
    samples.hints[i] = make_float4(number_of_ascending_bits(hint[0]),
                                   number_of_ascending_bits(hint[1]),
                                   number_of_ascending_bits(hint[2]), 0);
  }
  if (samples.are_own)
    samples.are_own[i] = static_cast<unsigned char>(attributes.known(source).is_own);
}

/// Each new sample, as `move_near_sources()` on the CPU.
/// \param sources numbers of distinct points
/// \param isolated_radius of the ball around a source that is alone
__global__ void place_near_points(Positions positions, Cell_grid grid, Cell_blocks blocks,
                                  Index_subset distinct, Index_subset sources, float radius,
                                  double isolated_radius, Wide seed, Source_attributes attributes,
                                  Samples samples)
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
  const Start_near_source near_source(seed, attributes.known.cloud_index(source), e - first);
  const int4 center = grid.points[source];
  const float4* const normals = attributes.normals;
  const float3 normal = xyz(normals[source]);
  radius *= grid.scale(source);
  const float unit = grid.frame.unit(), squared_radius = radius * radius;

  Wide best = 0;
  unsigned partner = source;
  for_each_candidate(grid, blocks, center, query.lane, radius, [&](unsigned j, const int4& point) {
    const float3 d = difference(point, center, unit);
    const float squared_distance = dot(d, d);
    if (squared_distance >= squared_radius)
      return;
    const float3 other = xyz(normals[j]);
    const Wide rank = near_source.rank(attributes.known.cloud_index(j), dot(normal, other),
                                       dot(d, other), squared_distance);
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
                                                       isolated_radius * grid.scale(source));
    way = {offset.x, offset.y, offset.z};
  }
  start_on_point(samples, e, start + way, attributes, grid, source, number, false);
}

/// \param first of the samples that start so
__global__ void place_on_points(Positions positions, Cell_grid grid, Index_subset distinct,
                                Index_subset sources, unsigned first, Source_attributes attributes,
                                Support_subset support_points, Samples samples)
{
  const Wide k = thread_index();
  if (k >= sources.size)
    return;
  const unsigned number = sources[k], source = distinct[number];
  start_on_point(samples, first + k, positions(grid.order[source]), attributes, grid, source,
                 number, support_points.takes(attributes.known.cloud_index(source)));
}

} // namespace

void initialize_samples(const Execution_context& context, const Positions& positions,
                        const Cell_grid& grid, const Sources_of_samples& points, double radius,
                        double isolated_radius, double spacing, std::size_t seed,
                        const Samples& samples)
{
  const cudaStream_t stream = context.stream;
  const Arena_scope scope(context.scratch);
  const Index_subset distinct = distinct_points(context, grid);
  const Areas* const areas = points.areas;
  const Known_starts* const known = points.known;
  const Known_points known_points = {known ? known->points : nullptr, positions.list, grid.order};
  const Sources sources = known ? known_sources(context, known_points, grid, distinct, samples.size)
                                : chosen_sources(context, grid, distinct,
                                                 areas && points.spreads_evenly ? areas : nullptr,
                                                 samples.size, seed);
  const Source_attributes attributes = {
    points.normals,
    areas ? areas->of_cells : nullptr,
    areas ? areas->area_per_unit : 0,
    known ? double(known->number_of_points) / double(known->number_of_samples)
          : double(grid.size) / double(samples.size),
    points.maximum_spreading_radius,
    samples.hints ? least_hints(context, points.hints, grid, distinct) : nullptr,
    known_points};

  const unsigned number_of_new = sources.near_points.size;
  if (number_of_new > 0)
  {
    const Arena_scope blocks_scope(context.arena);
    const Cell_blocks blocks = find_blocks(grid, grid, cells_in_reach(radius, grid.frame.cell_size),
                                           maximum_number_of_candidates, context.arena, stream);
    place_near_points<<<blocks_for_queries(number_of_new), threads_per_block, 0, stream>>>(
      positions, grid, blocks, distinct, sources.near_points, float(radius), isolated_radius, seed,
      attributes, samples);
    check_launch("place_near_points");
  }
  const Support_subset support_points(seed, radius, spacing,
                                      known ? known->number_of_samples : samples.size,
                                      known ? known->number_of_places : distinct.size);
  place_on_points<<<blocks_for(sources.on_points.size), threads_per_block, 0, stream>>>(
    positions, grid, distinct, sources.on_points, number_of_new, attributes, support_points,
    samples);
  check_launch("place_on_points");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
