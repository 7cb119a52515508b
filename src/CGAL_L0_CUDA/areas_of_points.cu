// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Query.cuh"
#include "stages.cuh"

#include <CGAL/L0_resampling/internal/exact_ball.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void share_balls(Cell_grid grid, Cell_blocks blocks, float radius, Exact_ball ball,
                            unsigned* units)
{
  const Query query(grid.size);
  const int4 center = grid.points[query.index];
  unsigned count = 0;
  for_each_candidate(grid, blocks, center, query.lane, radius, [&](unsigned, const int4& other) {
    const auto difference = [](int a, int b) { return int(unsigned(a) - unsigned(b)); };
    count += ball.holds(difference(other.x, center.x), difference(other.y, center.y),
                        difference(other.z, center.z));
  });
  count = group_sum<lanes>(count) * blocks.centers[center.w].stride;
  if (query.writes)
    units[query.index] = unsigned(area_units_of_point(count));
}

/// One warp for each cell.
__global__ void share_cells(Cell_grid grid, const unsigned* units, Wide* units_of_cells,
                            Wide* total_units)
{
  const Wide cell = thread_index() / 32;
  if (cell >= grid.number_of_cells) // whole warps leave
    return;
  const unsigned begin = grid.begins[cell], end = grid.begins[cell + 1];
  Wide sum = 0;
  for (Wide i = begin + threadIdx.x % 32; i < end; i += 32)
    sum += units[i];
  sum = group_sum<32>(sum);
  if (threadIdx.x % 32 != 0)
    return;
  const Wide share = area_units_in_cell(sum, end - begin);
  units_of_cells[cell] = share;
  atomicAdd(total_units, share * (end - begin));
}

} // namespace

Areas areas_of_points(const Workplace& workplace, const Cell_grid& grid, double radius)
{
  const double pi = 3.141592653589793;
  Wide* const units_of_cells = workplace.arena.take<Wide>(grid.number_of_cells);
  const Arena_scope scope(workplace.scratch);
  const Cell_blocks blocks = find_blocks(grid, grid, cells_in_reach(radius, grid.frame.cell_size),
                                         maximum_number_of_candidates, workplace.scratch,
                                         workplace.stream);
  unsigned* const units = workplace.scratch.take<unsigned>(grid.size);
  const Device_counter<Wide> total_units(workplace);
  share_balls<<<blocks_for_queries(grid.size), threads_per_block, 0, workplace.stream>>>(
    grid, blocks, float(radius), Exact_ball(radius, grid.frame.units_per_length), units);
  check_launch("share_balls");
  share_cells<<<blocks_for(32ull * grid.number_of_cells), threads_per_block, 0, workplace.stream>>>(
    grid, units, units_of_cells, total_units.address());
  check_launch("share_cells");
  const double area_per_unit = pi * radius * radius / double(area_units_of_ball);
  return {units_of_cells, area_per_unit, double(total_units.read()) * area_per_unit};
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
