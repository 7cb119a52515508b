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

/// \param half_counts of the balls of half the radius
__global__ void share_balls(Cell_grid grid, Cell_blocks blocks, double radius,
                            double units_per_length, unsigned* counts, unsigned* half_counts)
{
  const Query query(grid.size);
  const int4 center = grid.points[query.index];
  // as on the CPU
  const double own_radius = radius * size_of_cells(grid.frame.level_of_key(grid.keys[center.w]));
  const Exact_ball ball(own_radius, units_per_length), half_ball = ball.half();
  Counts_in_balls found;
  for_each_candidate(
    grid, blocks, center, query.lane, float(own_radius), [&](unsigned, const int4& other) {
      const auto difference = [](int a, int b) { return int(unsigned(a) - unsigned(b)); };
      const int x = difference(other.x, center.x), y = difference(other.y, center.y),
                z = difference(other.z, center.z);
      found.in_ball += ball.holds(x, y, z);
      found.in_half_ball += half_ball.holds(x, y, z);
    });
  found.sum_up(query, blocks.centers[center.w].stride, counts, half_counts);
}

/// One warp for each cell: the sum of the areas of its points, as if all were of a surface.
__global__ void sum_up_cells(Cell_grid grid, const unsigned* counts, Wide* units_of_cells,
                             Wide* total_units)
{
  const Wide cell = thread_index() / 32;
  if (cell >= grid.number_of_cells) // whole warps leave
    return;
  const int level = grid.frame.level_of_key(grid.keys[cell]);
  const Wide fewest = grid.scales ? fewest_points_of_disk : 1;
  Wide sum = 0;
  for (Wide i = grid.begins[cell] + threadIdx.x % 32; i < grid.begins[cell + 1]; i += 32)
    sum += area_units_of_point(counts[i], level, fewest);
  sum = group_sum<32>(sum);
  if (threadIdx.x % 32 != 0)
    return;
  units_of_cells[cell] = sum;
  atomicAdd(total_units, sum);
}

/// One warp for each cell: what each of its points stands for.
/// \param spacing of the samples
/// \param units_of_cells in and out
__global__ void share_cells(Cell_grid grid, const unsigned* counts, const unsigned* half_counts,
                            double radius, double spacing, Wide* units_of_cells, Wide* total_units)
{
  const Wide cell = thread_index() / 32;
  if (cell >= grid.number_of_cells) // whole warps leave
    return;
  const unsigned begin = grid.begins[cell], end = grid.begins[cell + 1];
  Growth_of_balls growth;
  for (Wide i = begin + threadIdx.x % 32; i < end; i += 32)
  {
    growth.in_balls += counts[i] > 0 ? counts[i] - 1 : 0;
    growth.in_half_balls += half_counts[i] > 0 ? half_counts[i] - 1 : 0;
  }
  growth.in_balls = group_sum<32>(growth.in_balls);
  growth.in_half_balls = group_sum<32>(growth.in_half_balls);
  if (threadIdx.x % 32 != 0)
    return;
  const double size = size_of_cells(grid.frame.level_of_key(grid.keys[cell]));
  const Wide count = end - begin,
             sum = grid.scales ? growth.units_of_all(units_of_cells[cell],
                                                     part_of_strip(spacing / (radius * size)))
                               : units_of_cells[cell];
  const Wide share = area_units_in_cell(sum > count ? sum : count, count);
  units_of_cells[cell] = share;
  atomicAdd(total_units, share * count);
}

} // namespace

Areas areas_of_points(const Workplace& workplace, const Cell_grid& grid, double radius,
                      unsigned number_of_samples)
{
  const double pi = 3.141592653589793;
  const cudaStream_t stream = workplace.stream;
  Wide* const units_of_cells = workplace.arena.take<Wide>(grid.number_of_cells);
  const Arena_scope scope(workplace.scratch);
  const Cell_blocks blocks = find_blocks(grid, grid, cells_in_reach(radius, grid.frame.cell_size),
                                         maximum_number_of_candidates, workplace.scratch, stream);
  unsigned *const counts = workplace.scratch.take<unsigned>(grid.size),
                  *const half_counts = workplace.scratch.take<unsigned>(grid.size);
  const Device_counter<Wide> first_total(workplace), total_units(workplace);
  share_balls<<<blocks_for_queries(grid.size), threads_per_block, 0, stream>>>(
    grid, blocks, radius, grid.frame.units_per_length, counts, half_counts);
  check_launch("share_balls");
  const unsigned warps = blocks_for(32ull * grid.number_of_cells);
  sum_up_cells<<<warps, threads_per_block, 0, stream>>>(grid, counts, units_of_cells,
                                                        first_total.address());
  check_launch("sum_up_cells");
  const double area_per_unit = pi * radius * radius / double(area_units_of_ball);
  const double spacing = std::sqrt(double(first_total.read()) * area_per_unit
                                   / double(number_of_samples));
  share_cells<<<warps, threads_per_block, 0, stream>>>(grid, counts, half_counts, radius, spacing,
                                                       units_of_cells, total_units.address());
  check_launch("share_cells");
  return {units_of_cells, area_per_unit, double(total_units.read()) * area_per_unit};
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
