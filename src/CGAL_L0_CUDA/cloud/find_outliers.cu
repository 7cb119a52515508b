// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cloud/connected_parts.cuh"
#include "driver/stages.cuh"
#include "search/Morton_places.cuh"
#include "search/Query.cuh"
#include "search/Warp.cuh"
#include "search/representatives.cuh"

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/kernels/crowded_subcells.h>
#include <CGAL/L0_resampling/internal/kernels/outlier_tests.h>

#include <optional>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// What the lanes of a query counted in its ball, and in the one of half the radius.
struct Counts_in_balls
{
  unsigned in_ball = 0, in_half_ball = 0;

  /// \param stride of the block: every so many of its points were looked at
  /// \param counts, half_counts one a query
  __device__ void sum_up(const Query& query, unsigned stride, unsigned* counts,
                         unsigned* half_counts)
  {
    in_ball = group_sum<lanes>(in_ball) * stride;
    in_half_ball = group_sum<lanes>(in_half_ball) * stride;
    if (!query.writes)
      return;
    counts[query.index] = in_ball;
    half_counts[query.index] = in_half_ball;
  }
};

/// Of the points in the ball of each query, itself included, and in the one of half the radius.
/// \param wide_counts out: the same numbers
__global__ void count_points_in_balls(Cell_grid queries, Cell_grid grid, Cell_blocks blocks,
                                      double radius, unsigned* counts, unsigned* half_counts,
                                      Wide* wide_counts)
{
  const Query query(queries.size);
  const int4 center = queries.points[query.index];
  const double own_radius = radius * queries.scale(query.index);
  const float unit = grid.frame.unit(), squared_radius = float(own_radius * own_radius),
              squared_half_radius = squared_radius / 4;
  Counts_in_balls found;
  for_each_candidate(grid, blocks, center, query.lane, float(own_radius),
                     [&](unsigned, const int4& point) {
                       const float3 d = difference(point, center, unit);
                       const float squared_distance = dot(d, d);
                       found.in_ball += squared_distance < squared_radius;
                       found.in_half_ball += squared_distance < squared_half_radius;
                     });
  found.sum_up(query, blocks.centers[center.w].stride, counts, half_counts);
  if (query.writes)
    wide_counts[query.index] = found.in_ball;
}

/// The sum over the points of the block of cells around a cell.
/// \param sums over all points before each point
__device__ Wide sum_around(const Cell_blocks& blocks, Wide cell, const Wide* sums)
{
  Wide sum = 0;
  const uint2* const ranges = blocks.ranges_of(unsigned(cell));
  for (int row = 0, rows = blocks.number_of_ranges(unsigned(cell)); row < rows; ++row)
  {
    const uint2 range = ranges[row];
    sum += sums[range.y] - sums[range.x];
  }
  return sum;
}

/// For each cell, how many points the mean ball in the block of cells around holds.
/// \param sums of the counts of all points before each point
__global__ void find_means_around(Cell_blocks blocks, unsigned number_of_cells, const Wide* sums,
                                  double* means)
{
  const Wide cell = thread_index();
  if (cell >= number_of_cells)
    return;
  Wide count = 0;
  const uint2* const ranges = blocks.ranges_of(unsigned(cell));
  for (int row = 0, rows = blocks.number_of_ranges(unsigned(cell)); row < rows; ++row)
  {
    const uint2 range = ranges[row];
    count += range.y - range.x;
  }
  means[cell] = double(sum_around(blocks, cell, sums)) / double(count);
}

/// \param numbers which entries of the list
__global__ void follow_list(const unsigned* list, const unsigned* numbers, unsigned size,
                            unsigned* entries)
{
  const Wide i = thread_index();
  if (i < size)
    entries[i] = list[numbers[i]];
}

/// \param representatives which of the judged points stands for each
__global__ void copy_verdicts(const unsigned char* is_judged_kept, const unsigned* representatives,
                              unsigned size, unsigned char* is_kept)
{
  const Wide i = thread_index();
  if (i < size)
    is_kept[i] = is_judged_kept[representatives[i]];
}

/// Which points may be kept, which are sparse, and which may tell a sheet. Arrays on the device,
/// one number a position, but for the last two.
struct Dense_points
{
  unsigned char *is_kept, *is_sparse, *may_tell;
  unsigned* half_counts;
  unsigned* median;             // of the counts of all balls
  unsigned* is_any_sparse_kept; // 0 before
};

__global__ void keep_dense(Cell_grid grid, const unsigned* counts, const unsigned* half_counts,
                           const double* means_around, Outlier_thresholds thresholds,
                           Dense_points result)
{
  const Wide i = thread_index();
  if (i >= grid.size)
    return;
  const unsigned position = grid.order[i];
  const double count = double(counts[i]), mean_around = means_around[grid.points[i].w],
               median = double(*result.median);
  const bool is_kept = count >= minimum_count_of_ball(thresholds, mean_around, median);
  const bool is_one_of_sparse = is_sparse(count, mean_around, median);
  result.is_kept[position] = is_kept;
  result.is_sparse[position] = is_one_of_sparse;
  result.may_tell[position] = may_tell_sheet(count, mean_around, median);
  result.half_counts[position] = half_counts[i];
  if (is_kept && is_one_of_sparse)
    *result.is_any_sparse_kept = 1;
}

/// The others in the two balls of each sparse point: one less than nothing, where only one of so
/// many points is looked at, and not the point itself. Sums of these numbers are right once they
/// are read with their sign.
/// \param list the positions that the grid of the sparse points was built of
/// \param half_counts of the positions, in the balls of a fourth of the radius of `counts`
/// \param inner, outer out
__global__ void count_others(Cell_grid sparse, const unsigned* list, const unsigned* half_counts,
                             const unsigned* counts, Wide* inner, Wide* outer)
{
  const Wide i = thread_index();
  if (i >= sparse.size)
    return;
  inner[i] = Wide(half_counts[list[sparse.order[i]]]) - 1;
  outer[i] = Wide(counts[i]) - 1;
}

/// \param inner_sums, outer_sums over all points before each point
__global__ void find_filled_cells(Cell_blocks blocks, unsigned number_of_cells,
                                  const Wide* inner_sums, const Wide* outer_sums,
                                  double minimum_ratio, unsigned char* is_filled)
{
  const Wide cell = thread_index();
  if (cell < number_of_cells)
    is_filled[cell] = is_space_filled(
      double(static_cast<long long>(sum_around(blocks, cell, outer_sums))),
      double(static_cast<long long>(sum_around(blocks, cell, inner_sums))), minimum_ratio);
}

__global__ void drop_points_of_filled_cells(Cell_grid sparse, const unsigned* list,
                                            const unsigned char* is_filled, unsigned char* is_kept)
{
  const Wide i = thread_index();
  if (i < sparse.size && is_filled[sparse.points[i].w])
    is_kept[list[sparse.order[i]]] = 0;
}

/// Keeps the points that lie in a sheet of sparse ones, a warp a point that may tell one.
/// \param places of these points
/// \param list which of the positions they are
__global__ void keep_points_in_sheets(Positions positions, Morton_points places,
                                      const unsigned* list, unsigned size, double radius,
                                      unsigned char* is_kept)
{
  const Wide k = warp_index();
  if (k >= size || is_kept[list[k]])
    return;
  const unsigned point = list[k];
  const double3 p = positions(point);
  const double xyz[3] = {p.x, p.y, p.z};
  const bool is_in_sheet = lies_in_sheet(Warp(), places, places.lower_bound(places.cells.code(xyz)),
                                         reach_of_sparse_sheet(radius, positions.scale(point)));
  if (is_in_sheet && Warp().lane() == 0)
    is_kept[point] = 1;
}

/// Some of the positions.
/// \param list which of them; which of the points they are in the end
Positions listed(const Execution_context& context, const Positions& positions, const unsigned* list,
                 unsigned size)
{
  Positions result = positions;
  result.size = size;
  result.list = list;
  if (positions.list)
  {
    unsigned* const points = context.scratch.take<unsigned>(size);
    follow_list<<<blocks_for(size), threads_per_block, 0, context.stream>>>(positions.list, list,
                                                                            size, points);
    check_launch("follow_list");
    result.list = points;
  }
  return result;
}

/// Keeps the points with enough others around.
/// \param grid of the points
/// \param result out
void find_dense_points(const Execution_context& context, const Cell_grid& grid, double radius,
                       const Outlier_thresholds& thresholds, const Dense_points& result)
{
  const unsigned n = grid.size;
  const cudaStream_t stream = context.stream;
  const Arena_scope arena_scope(context.arena), scratch_scope(context.scratch);
  const Cell_blocks blocks = find_blocks(grid, grid, 1, maximum_number_of_candidates, context.arena,
                                         stream);
  unsigned *const counts = context.arena.take<unsigned>(n), *const half_counts =
                                                              context.arena.take<unsigned>(n);
  Wide* const sums = context.scratch.take<Wide>(Wide(n) + 1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(sums + n, 0, sizeof(Wide), stream));
  count_points_in_balls<<<blocks_for_queries(n), threads_per_block, 0, stream>>>(
    grid, grid, blocks, radius, counts, half_counts, sums);
  check_launch("count_points_in_balls");
  sum_up(sums, n, sums, context.scratch, stream);
  {
    const Arena_scope sort_scope(context.scratch);
    unsigned *const values = context.scratch.take<unsigned>(n), *const other =
                                                                  context.scratch.take<unsigned>(n);
    CGAL_L0_CUDA_CHECK(
      cudaMemcpyAsync(values, counts, n * sizeof(unsigned), cudaMemcpyDeviceToDevice, stream));
    const unsigned* const sorted = sort_values(values, other, n, context.scratch, stream);
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(result.median, sorted + n / 2, sizeof(unsigned),
                                       cudaMemcpyDeviceToDevice, stream));
  }
  double* const means = context.scratch.take<double>(grid.number_of_cells);
  find_means_around<<<blocks_for(grid.number_of_cells), threads_per_block, 0, stream>>>(
    blocks, grid.number_of_cells, sums, means);
  check_launch("find_means_around");
  keep_dense<<<blocks_for(n), threads_per_block, 0, stream>>>(grid, counts, half_counts, means,
                                                              thresholds, result);
  check_launch("keep_dense");
}

/// Of the sparse points, drops those that fill space, as `fill_space()` on the CPU.
void drop_points_that_fill_space(const Execution_context& context, const Positions& positions,
                                 const double (&low)[3], const double (&high)[3], double radius,
                                 double minimum_ratio, const Dense_points& points)
{
  const cudaStream_t stream = context.stream;
  const double large_radius = 2 * radius;
  const Arena_scope arena_scope(context.arena), scratch_scope(context.scratch);
  unsigned* const list = context.arena.take<unsigned>(positions.size);
  const unsigned number_of_sparse = list_flagged(points.is_sparse, positions.size, list,
                                                 context.scratch, stream);
  const Positions sparse_positions = listed(context, positions, list, number_of_sparse);
  const Cell_frame frame = Cell_frame::around(low, high, large_radius, large_radius,
                                              positions.scales);
  const Cell_grid grid = build_grid(positions, nullptr, frame, context.arena, context.scratch,
                                    stream);
  const Cell_grid sparse = build_grid(sparse_positions, nullptr, frame, context.arena,
                                      context.scratch, stream);

  const unsigned n = sparse.size;
  Wide *const inner = context.scratch.take<Wide>(Wide(n) + 1), *const outer =
                                                                 context.scratch.take<Wide>(Wide(n)
                                                                                            + 1);
  {
    const Cell_blocks blocks = find_blocks(sparse, grid, 1, maximum_number_of_candidates,
                                           context.arena, stream);
    unsigned *const counts = context.scratch.take<unsigned>(n), *const unused =
                                                                  context.scratch.take<unsigned>(n);
    count_points_in_balls<<<blocks_for_queries(n), threads_per_block, 0, stream>>>(
      sparse, grid, blocks, large_radius, counts, unused, outer);
    check_launch("count_points_in_balls");
    count_others<<<blocks_for(n), threads_per_block, 0, stream>>>(sparse, list, points.half_counts,
                                                                  counts, inner, outer);
    check_launch("count_others");
  }
  for (Wide* const sums : {inner, outer})
  {
    CGAL_L0_CUDA_CHECK(cudaMemsetAsync(sums + n, 0, sizeof(Wide), stream));
    sum_up(sums, n, sums, context.scratch, stream);
  }
  const Cell_blocks blocks = find_blocks(sparse, sparse, 1, maximum_number_of_candidates,
                                         context.arena, stream);
  unsigned char* const is_filled = context.scratch.take<unsigned char>(sparse.number_of_cells);
  find_filled_cells<<<blocks_for(sparse.number_of_cells), threads_per_block, 0, stream>>>(
    blocks, sparse.number_of_cells, inner, outer, minimum_ratio, is_filled);
  check_launch("find_filled_cells");
  drop_points_of_filled_cells<<<blocks_for(n), threads_per_block, 0, stream>>>(
    sparse, list, is_filled, points.is_kept);
  check_launch("drop_points_of_filled_cells");
}

/// Keeps the points that lie in a sheet of sparse ones, as `keep_sparse_sheets()` on the CPU.
void keep_sparse_sheets(const Execution_context& context, const Positions& positions, double extent,
                        double radius, const Dense_points& points)
{
  const Arena_scope scope(context.scratch);
  unsigned* const list = context.scratch.take<unsigned>(positions.size);
  const unsigned size = list_flagged(points.may_tell, positions.size, list, context.scratch,
                                     context.stream);
  if (size == 0)
    return;
  const Morton_points places = places_of(context, listed(context, positions, list, size),
                                         cells_of_places(extent));
  keep_points_in_sheets<<<blocks_for(Wide(size) * Warp::number_of_threads), threads_per_block, 0,
                          context.stream>>>(positions, places, list, size, radius, points.is_kept);
  check_launch("keep_points_in_sheets");
}

/// Of the points that are kept, keeps those whose part of the cloud has a share of as many points
/// as the median ball.
void keep_large_parts_of_rest(const Execution_context& context, const Positions& positions,
                              const Cell_frame& frame, double share_of_part,
                              const Dense_points& points)
{
  const Arena_scope arena_scope(context.arena), scratch_scope(context.scratch);
  unsigned* const list = context.arena.take<unsigned>(positions.size);
  const unsigned number_of_kept = list_flagged(points.is_kept, positions.size, list,
                                               context.scratch, context.stream);
  if (number_of_kept > 0)
    keep_large_parts(context, listed(context, positions, list, number_of_kept), list, frame,
                     points.median, share_of_part, points.is_kept);
}

} // namespace

unsigned find_outliers(const Execution_context& context, const Positions& positions,
                       const double (&low)[3], const double (&high)[3], double radius,
                       double extent, const Outlier_thresholds& thresholds, unsigned* kept)
{
  const unsigned n = positions.size;
  const Arena_scope scope(context.scratch);
  Device_arena& scratch = context.scratch;
  std::optional<Arena_scope> grid_scope(std::in_place, context.arena);
  const Cell_frame frame = Cell_frame::around(low, high, radius, radius, positions.scales);
  Cell_grid grid = build_grid(positions, nullptr, frame, context.arena, scratch, context.stream);
  // those that stand for a crowd are judged, and the others share their lot
  Positions judged = positions;
  unsigned* representatives = nullptr;
  const Representatives found = representatives_of_crowds(context, positions, grid,
                                                          maximum_number_of_points_of_subcell);
  if (!found.are_all_points())
  {
    unsigned* const list = scratch.take<unsigned>(found.number_of_kept);
    representatives = scratch.take<unsigned>(n);
    list_kept(context, positions, grid, found.kept, found.number_of_kept, list);
    find_places_of_points(context, grid, found, representatives);
    judged.list = list;
    judged.size = found.number_of_kept;
    grid_scope.reset();
    grid_scope.emplace(context.arena);
    grid = build_grid(judged, nullptr, frame, context.arena, scratch, context.stream);
  }
  const Device_counter<unsigned> is_any_sparse_kept(context);
  const Dense_points points = {scratch.take<unsigned char>(judged.size),
                               scratch.take<unsigned char>(judged.size),
                               scratch.take<unsigned char>(judged.size),
                               scratch.take<unsigned>(judged.size),
                               scratch.take<unsigned>(1),
                               is_any_sparse_kept.address()};
  find_dense_points(context, grid, radius, thresholds, points);
  grid_scope.reset();
  if (is_any_sparse_kept.read())
    drop_points_that_fill_space(context, judged, low, high, radius, thresholds.volume_filling_ratio,
                                points);
  keep_large_parts_of_rest(context, judged, frame, thresholds.share_of_part, points);
  keep_sparse_sheets(context, judged, extent, radius, points);
  const unsigned char* is_kept = points.is_kept;
  if (representatives)
  {
    unsigned char* const shared = scratch.take<unsigned char>(n);
    copy_verdicts<<<blocks_for(n), threads_per_block, 0, context.stream>>>(
      points.is_kept, representatives, n, shared);
    check_launch("copy_verdicts");
    is_kept = shared;
  }
  const unsigned number_of_kept = list_flagged(is_kept, n, kept, scratch, context.stream);
  return number_of_kept > 0 ? n - number_of_kept : 0;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
