// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/kernels/exact_ball.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// \param counts, spreads out: of the points of each ball
__global__ void look_around(Cell_grid grid, Cell_blocks blocks, double radius,
                            double units_per_length, unsigned* counts, Spread_in_ball* spreads)
{
  const Query query(grid.size);
  const int4 center = grid.points[query.index];
  // as on the CPU
  const double own_radius = radius * size_of_cells(grid.frame.level_of_key(grid.keys[center.w]));
  const Exact_ball ball(own_radius, units_per_length);
  Plane_moments<std::int64_t> moments;
  for_each_candidate(
    grid, blocks, center, query.lane, float(own_radius), [&](unsigned, const int4& other) {
      const auto difference = [](int a, int b) { return int(unsigned(a) - unsigned(b)); };
      const int x = difference(other.x, center.x), y = difference(other.y, center.y),
                z = difference(other.z, center.z);
      if (ball.holds(x, y, z))
        ball.add(x, y, z, moments);
    });
  const auto sum_of_lanes = [](std::int64_t value) { return group_sum<lanes>(value); };
  const auto sums = moments.transformed<std::int64_t>(sum_of_lanes);
  if (!query.writes)
    return;
  const auto to_number = [](std::int64_t sum) { return double(sum); };
  counts[query.index] = unsigned(sums.sum) * blocks.centers[center.w].stride;
  spreads[query.index] = Spread_in_ball(sums.transformed<double>(to_number),
                                        ball.radius_of_moments());
}

/// One thread for each point: what all of them stand for if each disk is covered.
__global__ void sum_up_disks(Cell_grid grid, const unsigned* counts, Wide* total_units)
{
  const Wide i = thread_index();
  const Wide units = i < grid.size ? area_units_of_point(
                       counts[i], grid.frame.level_of_key(grid.keys[grid.points[i].w]), 1)
                                   : 0;
  const Wide sum = group_sum<32>(units);
  if (threadIdx.x % 32 == 0)
    atomicAdd(total_units, sum);
}

/// One warp for each cell: what each of its points stands for.
/// \param spacing of the samples
/// \param units_of_cells out
__global__ void share_cells(Cell_grid grid, const unsigned* counts, const Spread_in_ball* spreads,
                            double radius, double spacing, Wide* units_of_cells, Wide* total_units)
{
  const Wide cell = warp_index();
  if (cell >= grid.number_of_cells) // whole warps leave
    return;
  const unsigned begin = grid.begins[cell], end = grid.begins[cell + 1];
  const int level = grid.frame.level_of_key(grid.keys[cell]);
  const double spacing_per_radius = spacing / (radius * size_of_cells(level));
  Wide sum = 0;
  for (Wide i = begin + threadIdx.x % 32; i < end; i += 32)
    sum += area_units_of_point(counts[i], level, spreads[i].share_of_disk(spacing_per_radius));
  sum = group_sum<32>(sum);
  if (threadIdx.x % 32 != 0)
    return;
  const Wide count = end - begin, share = area_units_in_cell(sum, count);
  units_of_cells[cell] = share;
  atomicAdd(total_units, share * count);
}

} // namespace

double area_per_unit_of(double radius)
{
  const double pi = 3.141592653589793;
  return pi * radius * radius / double(area_units_of_disk);
}

Areas areas_of_points(const Execution_context& context, const Cell_grid& grid, double radius,
                      unsigned number_of_samples)
{
  const cudaStream_t stream = context.stream;
  Wide* const units_of_cells = context.arena.take<Wide>(grid.number_of_cells);
  const Arena_scope scope(context.scratch);
  const Cell_blocks blocks = find_blocks(grid, grid, cells_in_reach(radius, grid.frame.cell_size),
                                         maximum_number_of_candidates, context.scratch, stream);
  unsigned* const counts = context.scratch.take<unsigned>(grid.size);
  Spread_in_ball* const spreads = context.scratch.take<Spread_in_ball>(grid.size);
  const Device_counter<Wide> units_of_disks(context), total_units(context);
  look_around<<<blocks_for_queries(grid.size), threads_per_block, 0, stream>>>(
    grid, blocks, radius, grid.frame.units_per_length, counts, spreads);
  check_launch("look_around");
  sum_up_disks<<<blocks_for(grid.size), threads_per_block, 0, stream>>>(grid, counts,
                                                                        units_of_disks.address());
  check_launch("sum_up_disks");
  const double area_per_unit = area_per_unit_of(radius);
  const double spacing = std::sqrt(double(units_of_disks.read()) * area_per_unit
                                   / double(number_of_samples));
  share_cells<<<blocks_for(32ull * grid.number_of_cells), threads_per_block, 0, stream>>>(
    grid, counts, spreads, radius, spacing, units_of_cells, total_units.address());
  check_launch("share_cells");
  return {units_of_cells, area_per_unit, double(total_units.read()) * area_per_unit};
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
