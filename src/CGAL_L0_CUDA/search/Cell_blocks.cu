// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/Cell_grid.cuh"

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// One thread for each row of cells of each block.
__global__ void find_ranges(Cell_grid queries, Cell_grid grid, int reach, Cell_blocks blocks)
{
  const unsigned long long t = thread_index();
  const unsigned long long cell = t / unsigned(blocks.number_of_rows);
  if (cell >= queries.number_of_cells)
    return;
  blocks.ranges[t] = range_of_row(grid, queries.frame.cell_of_key(queries.keys[cell]), reach,
                                  int(t % unsigned(blocks.number_of_rows)));
}

/// A row of cells of one level in the block around a cell.
struct Found_row
{
  uint2 range; // of points, `[x, y)`
  Row_place place;
};

/// Calls `f(row)` in all threads of a warp at once, for the rows of cells around a cell of another
/// grid of the same sizes of cells, those of its own level and of the levels next to it, as
/// `Search_grid_3::Block_cursor`: each thread with another row, in their order; with an empty one
/// where there is none.
template <typename F>
__device__ void for_each_rows_around(const Cell_frame& of_queries, Key key, const Cell_grid& grid,
                                     int reach, const F& f)
{
  const Cell_frame& frame = grid.frame;
  const int own_level = of_queries.level_of_key(key);
  const uint3 cell = of_queries.cell_of_key(key);
  const unsigned place[3] = {cell.x, cell.y, cell.z}, lane = threadIdx.x % 32;
  for (int level = max(own_level - levels_in_reach, 0);
       level <= min(own_level + levels_in_reach, number_of_levels - 1); ++level)
  {
    if (!(grid.levels >> level & 1))
      continue;
    unsigned low[3], high[3];
    bool is_empty = false, is_inside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double absolute = of_queries.first_of_level(own_level, axis) + place[axis];
      double first = absolute - reach, last = absolute + reach;
      if (level != own_level)
      {
        const double ratio = exp2(0.5 * (own_level - level));
        first = floor(first * ratio);
        last = floor((last + 1) * ratio);
        first = absolute <= -Cell_frame::half_range ? -Cell_frame::half_range : first;
        last = absolute >= Cell_frame::half_range - 1 ? Cell_frame::half_range - 1 : last;
      }
      const double begin = frame.first_of_level(level, axis),
                   count = frame.count_of_level(level, axis);
      is_empty |= last < begin || first >= begin + count;
      low[axis] = unsigned(fmax(first - begin, 0.));
      high[axis] = unsigned(fmin(fmax(last - begin, 0.), count - 1));
      is_inside &= low[axis] > 0 && high[axis] < count - 1;
    }
    if (is_empty)
      continue;
    const double size = frame.size_of_level(level);
    const unsigned width = high[1] - low[1] + 1, number_of_rows = width * (high[2] - low[2] + 1);
    for (unsigned first_row = 0; first_row < number_of_rows; first_row += 32)
    {
      const unsigned row = first_row + lane;
      Found_row found = {};
      if (row < number_of_rows)
      {
        const unsigned y = low[1] + row % width, z = low[2] + row / width;
        const Key last = frame.key_of_cell(level, high[0], y, z);
        const unsigned begin = lower_bound(grid.keys, grid.number_of_cells,
                                           frame.key_of_cell(level, low[0], y, z));
        unsigned end = begin;
        while (end < grid.number_of_cells && grid.keys[end] <= last)
          ++end;
        const int3 fixed = frame.fixed_point({0, (frame.first_of_level(level, 1) + y) * size,
                                              (frame.first_of_level(level, 2) + z) * size});
        if (begin < end)
          found = {{grid.begins[begin], grid.begins[end]},
                   {fixed.y, fixed.z, is_inside ? float(size) : 0}};
      }
      f(found);
    }
  }
}

/// One warp for each cell of the queries.
__global__ void count_ranges(Cell_grid queries, Cell_grid grid, int reach,
                             unsigned long long* counts)
{
  const unsigned long long c = warp_index();
  if (c >= queries.number_of_cells)
    return;
  unsigned long long count = 0;
  for_each_rows_around(queries.frame, queries.keys[c], grid, reach, [&](const Found_row& row) {
    count += unsigned(__popc(__ballot_sync(0xffffffffu, row.range.x < row.range.y)));
  });
  if (threadIdx.x % 32 == 0)
    counts[c] = count;
}

/// The same, into the blocks.
__global__ void list_ranges(Cell_grid queries, Cell_grid grid, int reach, Cell_blocks blocks)
{
  const unsigned long long c = warp_index();
  if (c >= queries.number_of_cells)
    return;
  unsigned long long begin = blocks.begins[c];
  for_each_rows_around(queries.frame, queries.keys[c], grid, reach, [&](const Found_row& row) {
    const bool is_listed = row.range.x < row.range.y;
    const unsigned listed = __ballot_sync(0xffffffffu, is_listed),
                   before = listed & ((1u << threadIdx.x % 32) - 1);
    if (is_listed)
    {
      blocks.ranges[begin + unsigned(__popc(before))] = row.range;
      blocks.places[begin + unsigned(__popc(before))] = row.place;
    }
    begin += unsigned(__popc(listed));
  });
}

/// One warp a cell.
__global__ void find_centers(Cell_grid queries, unsigned limit, Cell_blocks blocks)
{
  const unsigned long long c = warp_index();
  if (c >= queries.number_of_cells) // whole warps leave
    return;
  const uint2* const ranges = blocks.ranges_of(unsigned(c));
  const int number_of_ranges = blocks.number_of_ranges(unsigned(c)), lane = int(threadIdx.x % 32);
  unsigned long long count = 0;
  for (int row = lane; row < number_of_ranges; row += 32)
    count += ranges[row].y - ranges[row].x;
  count = group_sum<32>(count);
  if (lane != 0)
    return;
  Block_center center;
  center.stride = 1;
  while (count / center.stride > limit)
    center.stride *= 2;

  const Cell_frame& frame = queries.frame;
  const uint3 cell = frame.cell_of_key(queries.keys[c]);
  const double3 begin = {0, (frame.first[1] + cell.y) * frame.cell_size,
                         (frame.first[2] + cell.z) * frame.cell_size};
  const int3 fixed = frame.fixed_point(begin);
  center.begin_y = fixed.y;
  center.begin_z = fixed.z;
  const unsigned reach = unsigned(blocks.reach);
  const auto is_inside = [reach](unsigned place, unsigned size) {
    return place > reach && place + reach + 1 < size;
  };
  center.is_inside = is_inside(cell.x, frame.count[0]) && is_inside(cell.y, frame.count[1])
                     && is_inside(cell.z, frame.count[2]);
  blocks.centers[c] = center;
}

} // namespace

int cells_in_reach(double radius, double cell_size) { return int(std::ceil(radius / cell_size)); }

Cell_blocks find_blocks(const Cell_grid& query_grid, const Cell_grid& grid, int reach,
                        unsigned maximum_number_of_candidates, Device_arena& arena,
                        cudaStream_t stream)
{
  Cell_blocks blocks;
  blocks.reach = reach;
  blocks.number_of_rows = (2 * reach + 1) * (2 * reach + 1);
  const unsigned cells = query_grid.number_of_cells;
  if (grid.frame.has_levels)
  {
    blocks.begins = arena.take<unsigned long long>(std::size_t(cells) + 1);
    CGAL_L0_CUDA_CHECK(
      cudaMemsetAsync(blocks.begins + cells, 0, sizeof(unsigned long long), stream));
    const unsigned number_of_blocks = blocks_for(32ull * cells);
    count_ranges<<<number_of_blocks, threads_per_block, 0, stream>>>(query_grid, grid, reach,
                                                                     blocks.begins);
    check_launch("count_ranges");
    sum_up(blocks.begins, cells, blocks.begins, arena, stream);
    const std::size_t count = arena.read(blocks.begins + cells, stream);
    blocks.ranges = arena.take<uint2>(count);
    blocks.places = arena.take<Row_place>(count);
    list_ranges<<<number_of_blocks, threads_per_block, 0, stream>>>(query_grid, grid, reach,
                                                                    blocks);
    check_launch("list_ranges");
  }
  else
  {
    const std::size_t count = std::size_t(cells) * std::size_t(blocks.number_of_rows);
    blocks.ranges = arena.take<uint2>(count);
    find_ranges<<<blocks_for(count), threads_per_block, 0, stream>>>(query_grid, grid, reach,
                                                                     blocks);
    check_launch("find_ranges");
  }
  blocks.centers = arena.take<Block_center>(cells);
  find_centers<<<blocks_for(32ull * cells), threads_per_block, 0, stream>>>(
    query_grid, maximum_number_of_candidates, blocks);
  check_launch("find_centers");
  return blocks;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
