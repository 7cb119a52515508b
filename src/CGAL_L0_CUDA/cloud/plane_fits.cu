// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cloud/plane_fits.cuh"
#include "kernels/Plane_fit.cuh"
#include "search/representatives.cuh"

#include <CGAL/L0_resampling/internal/kernels/crowded_subcells.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

constexpr unsigned threads_per_query = 512;

/// Sums over a block of `threads_per_query` threads, for its first thread.
template <typename T, int count>
__device__ void sum_over_block(T (&values)[count])
{
  __shared__ T shared[threads_per_query / 32][count];
  for (int c = 0; c < count; ++c)
    values[c] = group_sum<32>(values[c]);
  __syncthreads();
  if (threadIdx.x % 32 == 0)
    for (int c = 0; c < count; ++c)
      shared[threadIdx.x / 32][c] = values[c];
  __syncthreads();
  if (threadIdx.x == 0)
    for (unsigned w = 1; w < threads_per_query / 32; ++w)
      for (int c = 0; c < count; ++c)
        values[c] += shared[w][c];
}

/// The points around a query, for a block of threads: queries are few, so that each has to be
/// short. A thread finds a row of cells, and a warp looks at its points.
class Surroundings
{
  const Cell_grid& m_grid;
  int4 m_center;
  uint3 m_cell;
  int m_reach;
  Wide m_stride; // of too many points, every `m_stride`-th is used

public:
  __device__ Surroundings(const Cell_grid& grid, unsigned query, int reach)
    : m_grid(grid), m_center(grid.points[query]),
      m_cell(grid.frame.cell_of_key(grid.keys[m_center.w])), m_reach(reach)
  {
    Wide count[1] = {0};
    for (int row = int(threadIdx.x); row < number_of_rows(); row += int(threads_per_query))
    {
      const uint2 range = range_of_row(m_grid, m_cell, m_reach, row);
      count[0] += range.y - range.x;
    }
    sum_over_block(count);
    __shared__ Wide stride;
    if (threadIdx.x == 0)
    {
      stride = 1;
      while (count[0] / stride > maximum_number_of_candidates)
        stride *= 2;
    }
    __syncthreads();
    m_stride = stride;
  }

  __device__ unsigned stride() const { return unsigned(m_stride); }

  /// Calls `f(d)` for the points of the thread in the ball, with the way to them. For all threads
  /// of the block.
  template <typename F>
  __device__ void for_each_in_ball(float radius, const F& f) const
  {
    __shared__ uint2 ranges[threads_per_query];
    const float unit = m_grid.frame.unit();
    const int warp = int(threadIdx.x / 32), number_of_warps = int(threads_per_query / 32);
    const Wide lane = threadIdx.x % 32;
    Wide number_before = 0; // of the points in the rows before
    for (int first_row = 0; first_row < number_of_rows(); first_row += int(threads_per_query))
    {
      const int row = first_row + int(threadIdx.x), rest = number_of_rows() - first_row;
      if (row < number_of_rows())
        ranges[threadIdx.x] = range_of_row(m_grid, m_cell, m_reach, row);
      __syncthreads();
      for (int r = warp; r < min(rest, int(threads_per_query)); r += number_of_warps)
      {
        Wide first = ranges[r].x;
        if (m_stride > 1) // as `phase_of_row()`
          first += (0 - (number_before + number_of_points(ranges, r))) & (m_stride - 1);
        for (Wide j = first + lane * m_stride; j < ranges[r].y; j += 32 * m_stride)
        {
          const float3 d = difference(m_grid.points[j], m_center, unit);
          if (dot(d, d) < radius * radius)
            f(d);
        }
      }
      if (m_stride > 1)
        number_before += number_of_points(ranges, min(rest, int(threads_per_query)));
      __syncthreads();
    }
  }

  /// In the first thread; the others return nothing of use.
  /// \param number_of_points out: in the ball
  __device__ Fitted_plane fit_plane(float radius, unsigned& number_of_points) const
  {
    Plane_moments<float> m;
    for_each_in_ball(radius, [&](float3 d) { m.add(d.x, d.y, d.z, 1); });
    float sums[] = {m.sum, m.x, m.y, m.z, m.xx, m.xy, m.xz, m.yy, m.yz, m.zz};
    sum_over_block(sums);
    if (threadIdx.x != 0)
      return Fitted_plane();
    number_of_points = unsigned(sums[0]);
    return plane_through({sums[0], sums[1], sums[2], sums[3], sums[4], sums[5], sums[6], sums[7],
                          sums[8], sums[9]},
                         radius * radius);
  }

private:
  __device__ int number_of_rows() const { return (2 * m_reach + 1) * (2 * m_reach + 1); }

  /// In the first rows. For all threads of a warp at once.
  __device__ static Wide number_of_points(const uint2* rows, int count)
  {
    Wide number = 0;
    for (int r = int(threadIdx.x % 32); r < count; r += 32)
      number += rows[r].y - rows[r].x;
    return group_sum<32>(number);
  }
};

/// One block of threads for each point of the list.
__global__ void __launch_bounds__(threads_per_query)
  fit_planes_around(Cell_grid grid, const unsigned* list, int reach, float radius, float4* normals,
                    unsigned char* is_degenerate)
{
  const unsigned i = list[blockIdx.x];
  unsigned number_of_points;
  const Fitted_plane fit = Surroundings(grid, i, reach).fit_plane(radius, number_of_points);
  if (threadIdx.x != 0)
    return;
  normals[i] = with_w(to_float(fit.normal), 0);
  is_degenerate[i] = !fit.spans_plane;
}

__global__ void take_points(const int4* points, const unsigned* list, unsigned size, int4* taken)
{
  const Wide i = thread_index();
  if (i < size)
    taken[i] = points[list[i]];
}

/// Makes places in the whole array places in the list.
__global__ void count_listed_before(const unsigned* list, unsigned size, unsigned* places,
                                    unsigned number_of_places)
{
  const Wide k = thread_index();
  if (k >= number_of_places)
    return;
  const unsigned place = places[k];
  unsigned first = 0;
  for (unsigned rest = size; rest > 0;)
  {
    const unsigned half = rest / 2;
    const bool is_before = list[first + half] < place;
    first = is_before ? first + half + 1 : first;
    rest = is_before ? rest - half - 1 : half;
  }
  places[k] = first;
}

/// Leaves one of the points at each place, in memory of the scratch arena.
void keep_one_of_equal_points(const Execution_context& context, Cell_grid& grid)
{
  const unsigned size = grid.number_of_distinct, number_of_places = grid.number_of_cells + 1;
  if (size == grid.size)
    return;
  unsigned* const list = context.scratch.take<unsigned>(grid.size);
  list_flagged(grid.is_first, grid.size, list, context.scratch, context.stream);
  int4* const points = context.scratch.take<int4>(size);
  take_points<<<blocks_for(size), threads_per_block, 0, context.stream>>>(grid.points, list, size,
                                                                          points);
  check_launch("take_points");
  count_listed_before<<<blocks_for(number_of_places), threads_per_block, 0, context.stream>>>(
    list, size, grid.begins, number_of_places);
  check_launch("count_listed_before");
  grid.points = points;
  grid.size = size;
  grid.forget_order();
}

/// One block of threads for each query; every `stride_of_queries`-th point is one.
__global__ void __launch_bounds__(threads_per_query)
  look_at_balls(Cell_grid grid, unsigned stride_of_queries, int reach, float radius,
                Ball_of_points* balls)
{
  const Surroundings surroundings(grid, blockIdx.x * stride_of_queries, reach);
  unsigned number_of_points;
  const Fitted_plane fit = surroundings.fit_plane(radius, number_of_points);
  __shared__ float normal[3];
  if (threadIdx.x == 0)
  {
    normal[0] = float(fit.normal.x);
    normal[1] = float(fit.normal.y);
    normal[2] = float(fit.normal.z);
  }
  __syncthreads();
  Height_moments<float> heights;
  surroundings.for_each_in_ball(radius, [&](float3 d) {
    heights.add(dot(d, float3{normal[0], normal[1], normal[2]}), 1);
  });
  float sums[4] = {heights.first, heights.second, heights.third, heights.fourth};
  sum_over_block(sums);
  if (threadIdx.x != 0)
    return;
  balls[blockIdx.x] = ball_of_points(number_of_points, surroundings.stride(), fit.variance,
                                     {sums[0], sums[1], sums[2], sums[3]});
}

} // namespace

void refit_planes_of(const Execution_context& context, const Cell_grid& grid, const unsigned* open,
                     unsigned number_of_open, double radius, float4* normals,
                     unsigned char* is_degenerate)
{
  fit_planes_around<<<number_of_open, threads_per_query, 0, context.stream>>>(
    grid, open, cells_in_reach(radius, grid.frame.cell_size), float(radius), normals,
    is_degenerate);
  check_launch("fit_planes_around");
}

Scales estimate_scales(const Execution_context& context, const Positions& positions,
                       const double (&low)[3], const double (&high)[3], double initial_radius)
{
  const double cell_size = cell_size_of_scales * initial_radius;
  const Arena_scope arena_scope(context.arena), scratch_scope(context.scratch);
  const Cell_frame frame = Cell_frame::around(low, high, cell_size,
                                              maximum_reach_of_balls * cell_size);
  const auto grid_of = [&](const Positions& points) {
    return build_grid(points, nullptr, frame, context.arena, context.scratch, context.stream);
  };
  Cell_grid grid = grid_of(positions);
  const Representatives found = representatives_of_crowds(context, positions, grid,
                                                          maximum_number_of_points_of_subcell);
  if (!found.are_all_points())
  {
    unsigned* const list = context.scratch.take<unsigned>(found.number_of_kept);
    list_kept(context, positions, grid, found.kept, found.number_of_kept, list);
    Positions standing = positions;
    standing.list = list;
    standing.size = found.number_of_kept;
    grid = grid_of(standing);
  }
  keep_one_of_equal_points(context, grid);
  const unsigned minimum_stride = (std::max)(grid.size / unsigned(number_of_balls), 1u);
  const auto size_of = [&](unsigned stride) { return (grid.size + stride - 1) / stride; };
  Ball_of_points* const device_balls = context.scratch.take<Ball_of_points>(
    size_of(minimum_stride));
  return scales_of_growing_balls(cell_size, [&](int reach, double radius) {
    const unsigned stride = minimum_stride * unsigned(stride_at_reach(reach)),
                   size = size_of(stride);
    std::vector<Ball_of_points> balls(size);
    look_at_balls<<<size, threads_per_query, 0, context.stream>>>(grid, stride, reach,
                                                                  float(radius), device_balls);
    check_launch("look_at_balls");
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(balls.data(), device_balls, size * sizeof(Ball_of_points),
                                       cudaMemcpyDeviceToHost, context.stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(context.stream));
    return balls;
  });
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
