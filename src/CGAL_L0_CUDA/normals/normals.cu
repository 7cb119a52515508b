// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cloud/plane_fits.cuh"
#include "driver/stages.cuh"
#include "kernels/Plane_fit.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Bilateral_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Density_in_ball.h>
#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Sum_of_vectors.h>
#include <CGAL/L0_resampling/internal/kernels/local_surface.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__device__ Fitted_plane fit_plane(int4 center, const Cell_grid& grid, const Cell_blocks& blocks,
                                  unsigned lane, float radius)
{
  const float unit = grid.frame.unit(), squared_radius = radius * radius;
  Plane_moments<float> moments;
  for_each_candidate(grid, blocks, center, lane, radius, [&](unsigned, const int4& point) {
    const float3 d = difference(point, center, unit);
    if (dot(d, d) < squared_radius)
      moments.add(d.x, d.y, d.z, 1);
  });
  return plane_through(sum_of_group<lanes>(moments), squared_radius);
}

/// \param is_in_strip out; null if nobody asks
__global__ void fit_planes(Cell_grid grid, Cell_blocks blocks, float radius, float4* normals,
                           unsigned char* is_degenerate, unsigned char* is_in_strip)
{
  const Query query(grid.size);
  const int4 center = grid.points[query.index];
  const Fitted_plane fit = fit_plane(center, grid, blocks, query.lane,
                                     radius * grid.scale(query.index));
  if (!query.writes)
    return;
  normals[query.index] = with_w(to_float(fit.normal), 0);
  is_degenerate[query.index] = !fit.spans_plane;
  if (is_in_strip)
    is_in_strip[query.index] = fit.spans_plane && fit.share < 1;
}

/// \param blocks that reach twice the radius
/// \param is_on_line out: of the points in strips
__global__ void look_beyond_strips(Cell_grid grid, Cell_blocks blocks, float radius,
                                   const unsigned* strips, unsigned number_of_strips,
                                   float4* normals, unsigned char* is_on_line)
{
  const Query query(number_of_strips);
  const unsigned i = strips[query.index];
  const int4 center = grid.points[i];
  const float own_radius = radius * grid.scale(i);
  const Fitted_plane own = fit_plane(center, grid, blocks, query.lane, own_radius),
                     wide = fit_plane(center, grid, blocks, query.lane, 2 * own_radius);
  if (!query.writes)
    return;
  normals[i] = with_w(to_float(normal_beyond_strip(own, wide)), 0);
  is_on_line[i] = lies_on_line(own, wide);
}

/// \param open points without a plane so far, in the order of the fine grid
/// \param places of the points of the fine grid in the coarse one
__global__ void refit_planes(Cell_grid coarse_grid, Cell_blocks blocks, const unsigned* places,
                             float radius, const unsigned* open, unsigned number_of_open,
                             float4* normals, unsigned char* is_degenerate)
{
  const Query query(number_of_open);
  const unsigned i = open[query.index];
  const int4 center = coarse_grid.points[places[i]];
  const Fitted_plane fit = fit_plane(center, coarse_grid, blocks, query.lane,
                                     radius * coarse_grid.scale(places[i]));
  if (!query.writes)
    return;
  normals[i] = with_w(to_float(fit.normal), 0);
  is_degenerate[i] = !fit.spans_plane;
}

__global__ void invert_order(const unsigned* order, unsigned size, unsigned* places)
{
  const unsigned long long i = thread_index();
  if (i < size)
    places[order[i]] = unsigned(i);
}

/// places[i] becomes the place of the i-th point of another order
__global__ void compose(const unsigned* places, const unsigned* order, unsigned size,
                        unsigned* composed)
{
  const unsigned long long i = thread_index();
  if (i < size)
    composed[i] = places[order[i]];
}

__global__ void gather_given_normals(const float* given, const unsigned* order, unsigned size,
                                     float4* normals)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  const float* const n = given + 3 * (unsigned long long)(order[i]);
  if (n[0] != 0 || n[1] != 0 || n[2] != 0)
    normals[i] = make_float4(n[0], n[1], n[2], 0);
}

__global__ void take_listed_vectors(const float* vectors, const unsigned* list, unsigned size,
                                    float* taken)
{
  const unsigned long long i = thread_index();
  if (i < size)
    for (int axis = 0; axis < 3; ++axis)
      taken[3 * i + unsigned(axis)] = vectors[3 * (unsigned long long)(list[i]) + unsigned(axis)];
}

__global__ void count_zeros(const float* vectors, unsigned size, unsigned* count)
{
  const unsigned long long i = thread_index();
  if (i < size && vectors[3 * i] == 0 && vectors[3 * i + 1] == 0 && vectors[3 * i + 2] == 0)
    atomicAdd(count, 1u);
}

/// Adds up integers over a block of threads, so that the order of the additions does not matter.
__device__ void add_over_block(unsigned long long value, unsigned long long* total)
{
  __shared__ unsigned long long of_block;
  if (threadIdx.x == 0)
    of_block = 0;
  __syncthreads();
  if (value > 0)
    atomicAdd(&of_block, value);
  __syncthreads();
  if (threadIdx.x == 0 && of_block > 0)
    atomicAdd(total, of_block);
}

/// The sum of Eq. (5) over a ball, for all threads of a block at once; the counts add up.
/// \param stride of the candidates
__device__ float sum_of_others(const Density_in_ball<float>& of_thread, bool writes,
                               unsigned stride, Ball_counts* counts)
{
  const Density_in_ball<float> all = {group_sum<lanes>(of_thread.count),
                                      group_sum<lanes>(of_thread.sum)},
                               others = all.of_others();
  const unsigned long long number = (unsigned long long)(others.count) * stride;
  add_over_block(writes ? number : 0, &counts->neighbors);
  add_over_block(writes && number + 1 < minimum_number_of_points_of_plane ? 1 : 0, &counts->sparse);
  return others.sum * float(stride);
}

/// Eq. (1): the mean of the normals in the ball, each turned to the side of the point's own first.
/// With `with_density`, the sum of Eq. (5), too, goes to the fourth number of the normal.
/// \param squared_radius, squared_bandwidth `in_squared_units()`
template <bool with_density>
__global__ void filter_normals_kernel(Cell_grid grid, Cell_blocks blocks, float radius,
                                      float squared_radius, float squared_bandwidth,
                                      float normal_bandwidth, const float4* normals,
                                      float4* filtered, Ball_counts* counts)
{
  const Query query(grid.size);
  const int4 center = grid.points[query.index];
  const float3 normal = xyz(normals[query.index]);
  const float scale = grid.scale(query.index), squared_scale = scale * scale;
  radius *= scale;
  const Bilateral_kernel<float> kernel = {squared_radius * squared_scale,
                                          squared_bandwidth * squared_scale, normal_bandwidth};
  Sum_of_vectors<float> sum;
  Density_in_ball<float> density;
  for_each_candidate(grid, blocks, center, query.lane, radius, [&](unsigned j, const int4& point) {
    const float3 d = difference(point, center, 1);
    const float squared_distance = dot(d, d);
    const float3 other = xyz(normals[j]);
    sum.add(other.x, other.y, other.z, signed_weight(squared_distance, dot(normal, other), kernel));
    if constexpr (with_density)
      density += Density_in_ball<float>::of_point(squared_distance, kernel.squared_radius,
                                                  kernel.squared_bandwidth);
  });
  const float3 sum_of_all = group_sum<lanes>(float3{sum.x, sum.y, sum.z});
  float of_density = 0;
  if constexpr (with_density)
    of_density = sum_of_others(density, query.writes, blocks.centers[center.w].stride, counts);
  if (!query.writes)
    return;
  const double3 mean = to_double(sum_of_all);
  const double length = sqrt(dot(mean, mean));
  filtered[query.index] = with_w(
    length > minimum_length_of_mean_normal ? to_float((1 / length) * mean) : normal, of_density);
}

/// As `refitted_normal()` on the CPU.
__global__ void refit_normals_kernel(Cell_grid grid, Cell_blocks blocks,
                                     Fit_kernel<float> kernel_of_one, const float4* normals,
                                     float4* refitted)
{
  const Query query(grid.size);
  const int4 center = grid.points[query.index];
  const float3 normal = xyz(normals[query.index]);
  const Fit_kernel<float> kernel = kernel_of_one.scaled(grid.scale(query.index));
  const float unit = grid.frame.unit();
  Plane_moments<float> moments;
  for_each_candidate(
    grid, blocks, center, query.lane, kernel.radius, [&](unsigned j, const int4& place) {
      const float3 d = difference(place, center, unit);
      const Seen_point<float> point = seen_point(d, xyz(normals[j]), normal);
      moments.add(d.x, d.y, d.z, weight_in_ball(dot(d, d), point.cosine, point.height, kernel));
    });
  const Plane_moments<double> all = sum_of_group<lanes>(moments);
  if (!query.writes)
    return;
  const Triple result = lean_to_plane(all, {normal.x, normal.y, normal.z});
  refitted[query.index] = with_w(to_float(result), 0);
}

/// The sum of Eq. (5) without the point itself, to the fourth number of its normal; the balls are
/// counted.
/// \param squared_radius, squared_bandwidth `in_squared_units()`
__global__ void sum_up_density(Cell_grid grid, Cell_blocks blocks, float radius,
                               float squared_radius, float squared_bandwidth, float4* normals,
                               Ball_counts* counts)
{
  const Query query(grid.size);
  const int4 center = grid.points[query.index];
  const float scale = grid.scale(query.index), squared_scale = scale * scale;
  radius *= scale;
  squared_radius *= squared_scale;
  squared_bandwidth *= squared_scale;
  Density_in_ball<float> density;
  for_each_candidate(grid, blocks, center, query.lane, radius, [&](unsigned, const int4& point) {
    const float3 d = difference(point, center, 1);
    const float squared_distance = dot(d, d);
    density += Density_in_ball<float>::of_point(squared_distance, squared_radius,
                                                squared_bandwidth);
  });
  const float sum = sum_of_others(density, query.writes, blocks.centers[center.w].stride, counts);
  if (query.writes)
    normals[query.index].w = sum;
}

/// \param counts null where density shall not count
/// \param known_mean number of neighbors; 0 for that of the counts
__global__ void invert_density(unsigned size, const Ball_counts* counts, double known_mean,
                               float4* normals)
{
  const unsigned long long i = thread_index();
  const float mean_number_of_neighbors =
    counts ? float(known_mean > 0 ? known_mean : double(counts->neighbors) / double(size)) : 0;
  if (i < size)
    normals[i].w = 1 / density_weight(normals[i].w, mean_number_of_neighbors);
}

__global__ void sum_listed(const unsigned* numbers, const unsigned* list, unsigned size,
                           unsigned long long* sum)
{
  const unsigned long long i = thread_index();
  if (i < size)
    atomicAdd(sum, (unsigned long long)(numbers[list[i]]));
}

/// A squared length in units of the fixed-point numbers, so that a kernel need not multiply all
/// differences by the unit. That is a power of two: the results are the same.
float in_squared_units(const Cell_grid& grid, float squared_length)
{
  return squared_length / (grid.frame.unit() * grid.frame.unit());
}

/// How many points of the input some points stand for.
/// \param numbers_of_points of each; null if each is one
std::size_t number_in_input(const Execution_context& context, const unsigned* numbers_of_points,
                            const unsigned* list, unsigned size)
{
  if (!numbers_of_points || size == 0)
    return size;
  const Device_counter<unsigned long long> sum(context);
  sum_listed<<<blocks_for(size), threads_per_block, 0, context.stream>>>(numbers_of_points, list,
                                                                         size, sum.address());
  check_launch("sum_listed");
  return sum.read();
}

/// \param is_in_strip becomes whether the point is on a line
/// \param strips room for as many numbers as there are points
void refit_strips(const Execution_context& context, const Cell_grid& grid, double radius,
                  unsigned char* is_in_strip, unsigned* strips, float4* normals)
{
  const unsigned number_of_strips = list_flagged(is_in_strip, grid.size, strips, context.scratch,
                                                 context.stream);
  if (number_of_strips == 0)
    return;
  const Arena_scope scope(context.scratch);
  const Cell_blocks blocks =
    find_blocks(grid, grid, cells_in_reach(2 * radius, grid.frame.cell_size),
                maximum_number_of_candidates, context.scratch, context.stream);
  look_beyond_strips<<<blocks_for_queries(number_of_strips), threads_per_block, 0,
                       context.stream>>>(grid, blocks, float(radius), strips, number_of_strips,
                                         normals, is_in_strip);
  check_launch("look_beyond_strips");
}

} // namespace

std::size_t estimate_pca_normals(const Execution_context& context, const Positions& positions,
                                 const Cell_grid& grid, const Cell_blocks& blocks, double radius,
                                 bool looks_beyond_strips, const unsigned* numbers_of_points,
                                 float4* normals)
{
  // For so few points, and as long as there are not too many cells to look into, a coarser grid of
  // all points would cost more. Further away, as on the CPU, blocks are thinned that have so many
  // points that a few of them tell the plane.
  const unsigned maximum_number_of_single_queries = 10000;
  const unsigned n = grid.size;
  const cudaStream_t stream = context.stream;
  const Arena_scope scope(context.scratch);
  unsigned char* const is_degenerate = context.scratch.take<unsigned char>(n);
  unsigned char* const is_in_strip = looks_beyond_strips ? context.scratch.take<unsigned char>(n)
                                                         : nullptr;
  fit_planes<<<blocks_for_queries(n), threads_per_block, 0, stream>>>(
    grid, blocks, float(radius), normals, is_degenerate, is_in_strip);
  check_launch("fit_planes");

  unsigned* const open = context.scratch.take<unsigned>(n);
  std::size_t number_of_degenerate = 0;
  if (looks_beyond_strips)
  {
    refit_strips(context, grid, radius, is_in_strip, open, normals);
    const unsigned number_on_lines = list_flagged(is_in_strip, n, open, context.scratch, stream);
    number_of_degenerate = number_in_input(context, numbers_of_points, open, number_on_lines);
  }

  // Few points in a healthy cloud, which meet coarser and coarser grids.
  unsigned number_of_open = list_flagged(is_degenerate, n, open, context.scratch, stream);
  if (number_of_open == 0)
    return number_of_degenerate;
  number_of_degenerate += number_in_input(context, numbers_of_points, open, number_of_open);

  unsigned* const places = context.scratch.take<unsigned>(n);
  unsigned* const coarse_places = context.scratch.take<unsigned>(n);
  for (int doubling = 1; doubling <= number_of_radius_doublings && number_of_open > 0;
       ++doubling, number_of_open = list_flagged(is_degenerate, n, open, context.scratch, stream))
  {
    const double coarse_radius = std::ldexp(radius, doubling);
    if (number_of_open <= maximum_number_of_single_queries && !grid.scales
        && cells_in_reach(coarse_radius, grid.frame.cell_size) <= farthest_reach_of_refits)
    {
      refit_planes_of(context, grid, open, number_of_open, coarse_radius, normals, is_degenerate);
      continue;
    }
    const Arena_scope coarse_scope(context.arena);
    double low[3], high[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = grid.frame.low[axis];
      high[axis] = grid.frame.high[axis];
    }
    const Cell_grid coarse_grid =
      build_grid(positions, nullptr,
                 Cell_frame::around(low, high, coarse_radius, coarse_radius, grid.frame.has_levels),
                 context.arena, context.scratch, stream);
    const Cell_blocks coarse_blocks =
      find_blocks(coarse_grid, coarse_grid, 1, maximum_number_of_candidates, context.arena, stream);
    invert_order<<<blocks_for(n), threads_per_block, 0, stream>>>(coarse_grid.order, n, places);
    check_launch("invert_order");
    compose<<<blocks_for(n), threads_per_block, 0, stream>>>(places, grid.order, n, coarse_places);
    check_launch("compose");
    refit_planes<<<blocks_for_queries(number_of_open), threads_per_block, 0, stream>>>(
      coarse_grid, coarse_blocks, coarse_places, float(coarse_radius), open, number_of_open,
      normals, is_degenerate);
    check_launch("refit_planes");
  }
  return number_of_degenerate;
}

void take_listed(const Execution_context& context, const float* vectors, const unsigned* list,
                 unsigned size, float* taken)
{
  take_listed_vectors<<<blocks_for(size), threads_per_block, 0, context.stream>>>(vectors, list,
                                                                                  size, taken);
  check_launch("take_listed_vectors");
}

bool has_zero(const Execution_context& context, const float* vectors, unsigned size)
{
  const Arena_scope scope(context.scratch);
  const Device_counter<unsigned> counter(context);
  count_zeros<<<blocks_for(size), threads_per_block, 0, context.stream>>>(vectors, size,
                                                                          counter.address());
  check_launch("count_zeros");
  return counter.read() > 0;
}

void take_given_normals(const Execution_context& context, const Cell_grid& grid,
                        const float* given_normals, float4* normals)
{
  gather_given_normals<<<blocks_for(grid.size), threads_per_block, 0, context.stream>>>(
    given_normals, grid.order, grid.size, normals);
  check_launch("gather_given_normals");
}

void filter_normals(const Execution_context& context, const Cell_grid& grid,
                    const Cell_blocks& blocks, double radius, float squared_bandwidth,
                    float normal_bandwidth, const float4* normals, float4* filtered,
                    Ball_counts* counts)
{
  const auto kernel = counts ? filter_normals_kernel<true> : filter_normals_kernel<false>;
  kernel<<<blocks_for_queries(grid.size), threads_per_block, 0, context.stream>>>(
    grid, blocks, float(radius), in_squared_units(grid, float(radius) * float(radius)),
    in_squared_units(grid, squared_bandwidth), normal_bandwidth, normals, filtered, counts);
  check_launch("filter_normals_kernel");
}

void refit_normals(const Execution_context& context, const Cell_grid& grid,
                   const Cell_blocks& blocks, const Fit_kernel<double>& kernel,
                   const float4* normals, float4* refitted)
{
  refit_normals_kernel<<<blocks_for_queries(grid.size), threads_per_block, 0, context.stream>>>(
    grid, blocks, kernel.as<float>(), normals, refitted);
  check_launch("refit_normals_kernel");
}

void sum_up_input_density(const Execution_context& context, const Cell_grid& grid,
                          const Cell_blocks& blocks, double radius, float squared_bandwidth,
                          float4* normals, Ball_counts* counts)
{
  sum_up_density<<<blocks_for_queries(grid.size), threads_per_block, 0, context.stream>>>(
    grid, blocks, float(radius), in_squared_units(grid, float(radius) * float(radius)),
    in_squared_units(grid, squared_bandwidth), normals, counts);
  check_launch("sum_up_density");
}

void invert_input_density(const Execution_context& context, unsigned size,
                          const Ball_counts* counts, double known_mean, float4* normals)
{
  invert_density<<<blocks_for(size), threads_per_block, 0, context.stream>>>(size, counts,
                                                                             known_mean, normals);
  check_launch("invert_density");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
