// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cloud/connected_parts.cuh"

#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/kernels/outlier_tests.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void make_parts(unsigned number_of_cells, unsigned* parents)
{
  const Wide cell = thread_index();
  if (cell < number_of_cells)
    parents[cell] = unsigned(cell);
}

/// The lowest cell of the part, as far as parts are joined. Shortens the way: a parent that another
/// thread has put there meanwhile is an ancestor too.
__device__ unsigned find_root(unsigned* parents, unsigned cell)
{
  for (unsigned parent = __ldcg(parents + cell); parent != cell;)
  {
    const unsigned next = __ldcg(parents + parent);
    if (next != parent)
      __stcg(parents + cell, next);
    cell = parent;
    parent = next;
  }
  return cell;
}

/// Hooks the higher root to the lower, so that no circle closes, and the roots in the end do not
/// depend on who was first.
__device__ void join_parts(unsigned* parents, unsigned a, unsigned b)
{
  while (true)
  {
    a = find_root(parents, a);
    b = find_root(parents, b);
    if (a == b)
      return;
    const unsigned high = max(a, b), low = min(a, b);
    if (atomicCAS(parents + high, high, low) == high)
      return;
  }
}

// Of the nine rows of cells around a cell: four whose cells all come before it, and its own.
constexpr int number_of_rows_before = 5;

/// Joins each cell with those before it that it touches.
__global__ void join_touching_cells(Cell_grid grid, unsigned* parents)
{
  const Wide t = thread_index(), cell = t / number_of_rows_before;
  if (cell >= grid.number_of_cells)
    return;
  const uint2 range = range_of_row(grid, grid.frame.cell_of_key(grid.keys[cell]), 1,
                                   int(t % number_of_rows_before));
  if (range.x == range.y)
    return;
  const unsigned last = unsigned(grid.points[range.y - 1].w);
  for (unsigned other = unsigned(grid.points[range.x].w); other <= last && other < cell; ++other)
    join_parts(parents, unsigned(cell), other);
}

/// The same where cells are of several levels, with all cells at the ends of the runs around.
__global__ void join_touching_levels(Cell_grid grid, Cell_blocks blocks, unsigned* parents)
{
  const Wide cell = thread_index();
  if (cell >= grid.number_of_cells)
    return;
  const uint2* const ranges = blocks.ranges_of(unsigned(cell));
  for (int row = 0, rows = blocks.number_of_ranges(unsigned(cell)); row < rows; ++row)
    for (const unsigned point : {ranges[row].x, ranges[row].y - 1})
      join_parts(parents, unsigned(cell), unsigned(grid.points[point].w));
}

/// \param sizes of each root: the points of its part
__global__ void count_points_of_parts(Cell_grid grid, unsigned* parents, unsigned* sizes)
{
  const Wide cell = thread_index();
  const bool is_cell = cell < grid.number_of_cells;
  const unsigned root = is_cell ? find_root(parents, unsigned(cell)) : grid.number_of_cells;
  const unsigned peers = __match_any_sync(0xffffffffu, root);
  const unsigned size = peer_sum(peers, is_cell ? grid.begins[cell + 1] - grid.begins[cell] : 0u);
  if (is_cell && is_leader_of(peers))
    atomicAdd(sizes + root, size);
}

/// \param grid of the points in the list
__global__ void keep_points_of_large_parts(Cell_grid grid, unsigned* parents, const unsigned* sizes,
                                           const unsigned* median, double share_of_part,
                                           const unsigned* list, unsigned char* is_kept)
{
  const Wide i = thread_index();
  if (i < grid.size)
    is_kept[list[grid.order[i]]] =
      !is_part_small(double(sizes[find_root(parents, unsigned(grid.points[i].w))]), share_of_part,
                     double(*median));
}

} // namespace

void keep_large_parts(const Execution_context& context, const Positions& points,
                      const unsigned* list, const Cell_frame& frame, const unsigned* median,
                      double share_of_part, unsigned char* is_kept)
{
  const cudaStream_t stream = context.stream;
  const Arena_scope arena_scope(context.arena), scratch_scope(context.scratch);
  const Cell_grid grid = build_grid(points, nullptr, frame, context.arena, context.scratch, stream);
  const unsigned cells = grid.number_of_cells, blocks_for_cells = blocks_for(cells);
  unsigned *const parents = context.scratch.take<unsigned>(cells), *const sizes =
                                                                     context.scratch.take<unsigned>(
                                                                       cells);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(sizes, 0, cells * sizeof(unsigned), stream));
  make_parts<<<blocks_for_cells, threads_per_block, 0, stream>>>(cells, parents);
  check_launch("make_parts");
  if (grid.frame.has_levels)
  {
    const Cell_blocks blocks = find_blocks(grid, grid, 1, maximum_number_of_candidates,
                                           context.scratch, stream);
    join_touching_levels<<<blocks_for_cells, threads_per_block, 0, stream>>>(grid, blocks, parents);
    check_launch("join_touching_levels");
  }
  else
  {
    join_touching_cells<<<blocks_for(Wide(cells) * number_of_rows_before), threads_per_block, 0,
                          stream>>>(grid, parents);
    check_launch("join_touching_cells");
  }
  count_points_of_parts<<<blocks_for_cells, threads_per_block, 0, stream>>>(grid, parents, sizes);
  check_launch("count_points_of_parts");
  keep_points_of_large_parts<<<blocks_for(points.size), threads_per_block, 0, stream>>>(
    grid, parents, sizes, median, share_of_part, list, is_kept);
  check_launch("keep_points_of_large_parts");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
