// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"
#include "kernels/Plane_fit.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Quadric_moments.h>
#include <CGAL/L0_resampling/internal/kernels/project_to_local_quadric.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// \param listed the support points, in the order before that of their grid
__global__ void gather_normals_of_support_points(Cell_grid grid, const unsigned* listed,
                                                 const float4* normals, float4* of_support_points)
{
  const unsigned long long k = thread_index();
  if (k < grid.size)
    of_support_points[k] = normals[listed[grid.order[k]]];
}

/// \param grid of the support points
/// \param normals of the support points, and the variances of their fits
__global__ void __launch_bounds__(threads_per_block, 3)
  settle(Cell_grid sample_grid, Cell_blocks blocks, Cell_grid grid, const float4* normals,
         Fit_kernel<float> kernel_of_one, Samples samples)
{
  struct Sums
  {
    Quadric_moments<float> moments;
    float variance;
  };
  __shared__ Sums_of_block<Sums> sums;
  const auto frame_of = [](float4 normal) { return Tangent_frame({normal.x, normal.y, normal.z}); };
  {
    const Query query(samples.size);
    const int4 center = sample_grid.points[query.index];
    const Wide i = sample_grid.order[query.index];
    const Fit_kernel<float> kernel = kernel_of_one.scaled(samples.scale(i));
    const Tangent_frame frame = frame_of(samples.normals[i]);
    const float3 u = to_float(frame.u), v = to_float(frame.v), w = to_float(frame.normal);
    const float unit = grid.frame.unit(), per_radius = 1 / kernel.radius;
    Sums own = {};
    for_each_candidate(
      grid, blocks, center, query.lane, kernel.radius, [&](unsigned k, const int4& place) {
        const float3 d = difference(place, center, unit);
        const float4 other = normals[k];
        const Seen_point<float> point = seen_point(d, xyz(other), w);
        const float weight = weight_in_ball(dot(d, d), point.cosine, point.height, kernel);
        own.moments.add(dot(d, u) * per_radius, dot(d, v) * per_radius,
                        point.own_height * per_radius, weight);
        own.variance += weight * other.w;
      });
    const auto sum_of_lanes = [](float sum) { return group_sum<lanes>(sum); };
    sums.set(query,
             {Quadric_moments<float>(own.moments, sum_of_lanes), sum_of_lanes(own.variance)});
  }
  __syncthreads();
  const Single_query query(samples.size);
  if (!query.exists)
    return;
  const Wide i = sample_grid.order[query.index];
  const float4 normal = samples.normals[i];
  const float radius = kernel_of_one.radius * samples.scale(i);
  const Sums& all = sums.of_query();
  const Projected_sample settled = project_to_local_quadric(
    Quadric_moments<double>(all.moments, [](float sum) { return double(sum); }),
    all.variance / square(radius), frame_of(normal), radius);
  samples.positions[3 * i] += settled.height * normal.x;
  samples.positions[3 * i + 1] += settled.height * normal.y;
  samples.positions[3 * i + 2] += settled.height * normal.z;
  samples.normals[i] = with_w(to_float(settled.normal), 0);
}

} // namespace

void project_to_local_quadrics(const Execution_context& context, const Cell_frame& frame,
                               const Fit_kernel<double>& kernel, const Samples& samples)
{
  const Arena_scope scope(context.scratch);
  unsigned* const listed = context.scratch.take<unsigned>(samples.size);
  const unsigned number_of_support_points = list_flagged(samples.are_support_points, samples.size,
                                                         listed, context.scratch, context.stream);
  if (number_of_support_points == 0)
    return;
  const Arena_scope arena_scope(context.arena);
  const auto grid_of = [&](const unsigned* list, unsigned size) {
    return build_grid({samples.positions, size, Frame(), true, list, samples.scales}, nullptr,
                      frame, context.arena, context.scratch, context.stream);
  };
  const Cell_grid support_points = grid_of(listed, number_of_support_points),
                  all = grid_of(nullptr, samples.size);
  float4* const normals = context.arena.take<float4>(number_of_support_points);
  gather_normals_of_support_points<<<blocks_for(number_of_support_points), threads_per_block, 0,
                                     context.stream>>>(support_points, listed, samples.normals,
                                                       normals);
  check_launch("gather_normals_of_support_points");
  const Cell_blocks blocks =
    find_blocks(all, support_points, cells_in_reach(kernel.radius, frame.cell_size),
                maximum_number_of_candidates, context.arena, context.stream);
  settle<<<blocks_for_queries(samples.size), threads_per_block, 0, context.stream>>>(
    all, blocks, support_points, normals, kernel.as<float>(), samples);
  check_launch("settle");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
