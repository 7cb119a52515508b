// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"
#include "kernels/Plane_fit.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Border_of_ball.h>
#include <CGAL/L0_resampling/internal/kernels/Compatible_points.h>
#include <CGAL/L0_resampling/internal/kernels/push_of_pair.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// The points around a sample, for the lanes that share it.
struct Surroundings
{
  const Query& query;
  const int4& center;
  const Cell_grid& grid;
  const Cell_blocks& blocks;
  const float4* normals;
  const Fit_kernel<float>& kernel;

  /// \param visit called with the place of each point relative to the sample, its normal, and its
  /// scale in the ball, and before the normal the square of the distance
  template <typename Visit>
  __device__ void for_each(const Visit& visit) const
  {
    const float unit = grid.frame.unit();
    for_each_candidate(grid, blocks, center, query.lane, kernel.radius,
                       [&](unsigned j, const int4& point) {
                         const float3 d = difference(point, center, unit);
                         const float4 other = normals[j];
                         const float squared_distance = dot(d, d);
                         visit(d, squared_distance, xyz(other),
                               share_in_ball(squared_distance, kernel.squared_radius()) * other.w);
                       });
  }

  /// \param own_kernel that of the ball, but for the height of the sheet
  __device__ Compatible_points<double> sum_compatible_points(
    const float3& normal, const Fit_kernel<float>& own_kernel) const
  {
    Compatible_points<float> sums;
    for_each([&](const float3& d, float squared_distance, const float3& other, float scale) {
      sums.add(d.x, d.y, d.z, squared_distance, other.x, other.y, other.z, scale, normal.x,
               normal.y, normal.z, own_kernel);
    });
    return sums.transformed<double>([](float sum) { return group_sum<lanes>(sum); });
  }

  __device__ float3 normal_of_most(const float3& own, double weight_of_own) const
  {
    Plane_moments<float> moments;
    for_each([&](const float3&, float squared_distance, const float3& other, float scale) {
      moments.add(other.x, other.y, other.z,
                  scale * gaussian_weight(squared_distance, kernel.squared_bandwidth));
    });
    Plane_moments<double> all = sum_of_group<lanes>(moments);
    all.add(own.x, own.y, own.z, weight_of_own);
    return to_float(all.main_direction());
  }
};

/// The fit of the default method, as `fit_compatible_points()` on the CPU, which says why.
__global__ void fit_samples(Cell_grid sample_grid, const unsigned* order, Cell_blocks blocks,
                            Cell_grid grid, const float4* normals, Fit_kernel<float> kernel_of_one,
                            Border_of_ball border, Samples samples, Outcomes_of_fit outcomes)
{
  const Query query(samples.size);
  const int4 center = sample_grid.points[query.index];
  const unsigned i = order ? order[query.index] : query.index;
  const float scale = samples.scale(i);
  const Fit_kernel<float> kernel = kernel_of_one.scaled(scale);
  const Surroundings surroundings = {query, center, grid, blocks, normals, kernel};
  float3 normal = xyz(samples.normals[i]);
  Compatible_points<double> sums = surroundings.sum_compatible_points(normal, kernel);
  const Unsupported_sample support(sums.weight(), sums.all, kernel.squared_sheet_height,
                                   kernel.squared_radius());
  const double sheet_height = squared_height_of_second_look(support, sums,
                                                            kernel.squared_sheet_height);
  const bool has_more_noise = is_unexplained(support, sums, kernel.squared_sheet_height);
  float noise = samples.noises ? float(noise_of_fit(sums, kernel)) : 0;
  // the lanes of a warp add up together
  if (__any_sync(0xffffffffu, support.is_unsupported))
  {
    const float3 normal_of_most = surroundings.normal_of_most(normal, support.weight_of_own_normal);
    if (support.is_unsupported)
      normal = normal_of_most;
  }
  if (__any_sync(0xffffffffu, sheet_height != kernel.squared_sheet_height))
  {
    Fit_kernel<float> own_kernel = kernel;
    own_kernel.squared_sheet_height = float(sheet_height);
    sums = surroundings.sum_compatible_points(normal, own_kernel);
    if (samples.noises && support.is_unsupported)
      noise = float(noise_of_fit(sums, own_kernel));
  }
  if (!query.writes)
    return;
  Sample_counts* const counts = samples.is_own(i) ? outcomes.counts : nullptr;
  if (counts && has_more_noise)
    atomicAdd(&counts->unexplained, 1u);
  if (outcomes.are_unexplained)
    outcomes.are_unexplained[i] = has_more_noise;

  const Fit_of_sample fit(sums, {normal.x, normal.y, normal.z}, border, scale);
  samples.outward[i] = Short_vector::of(to_float(fit.outward));
  if (samples.noises)
    samples.noises[i] = noise;
  if (!fit.has_points)
  {
    // the sample is drawn to where it was last fitted, and keeps its normal
    samples.fit[i].w = 1;
    samples.normals[i].w = 0;
    if (counts)
      atomicAdd(&counts->lonely, 1u);
    return;
  }
  samples.fit[i] = with_w(to_float(fit.to_centroid), float(sums.weight()));
  samples.normals[i] = with_w(fit.has_new_normal ? to_float(fit.normal) : xyz(samples.normals[i]),
                              float(fit.variance));
}

/// `Repulsion` in `float`.
struct Push
{
  Range_of_pairs range; // of the neighbors
  float squared_bandwidth, strength, maximum_step;
  float spreading_radius; // of an even set
  double spacing;         // of that
  double radius;          // of the fit, at scale 1
};

/// One step of `repel_tangentially()` on the CPU.
__global__ void repel(Cell_frame frame, Neighbor_lists neighbors, Push push_rule,
                      const int4* places, const int4* points, Samples samples, int4* moved_points)
{
  const Query query(samples.size);
  const unsigned i = query.index;
  const float unit = frame.unit();
  const int4 center = points[i], place = places[i];
  const float* const radii = push_rule.range.spreading_radii;
  const float own_limit = push_rule.range.limit(i);
  float3 push = {0, 0, 0};
  const uint2 row = neighbors.row(places, samples.size, i);
  for (Wide e = Wide(row.x) + query.lane; e < row.y; e += lanes)
  {
    const unsigned k = neighbors.indices[e];
    const float3 d = difference(center, points[k], unit),
                 former_d = difference(place, places[k], unit);
    float squared_distance = dot(d, d);
    if (radii)
      squared_distance *= squared_stretch_of_pair(push_rule.spreading_radius, radii[i] + radii[k]);
    const float share = share_in_ball(dot(former_d, former_d),
                                      Range_of_pairs::squared(own_limit, push_rule.range.limit(k)));
    push += strength_of_push(push_rule.strength, share, squared_distance,
                             push_rule.squared_bandwidth)
            * d;
  }
  push = group_sum<lanes>(push);
  if (!query.writes)
    return;
  const float3 normal = xyz(samples.normals[i]), outward = samples.outward[i].vector();
  push -= dot(normal, push) * normal;
  push -= fmaxf(dot(outward, push), 0) * outward;
  const float length = sqrtf(dot(push, push));
  const float maximum_step =
    radii || samples.scales
      ? float(Repulsion(radii ? radii[i] / self_neighbor_radius_per_spacing : push_rule.spacing,
                        push_rule.radius * samples.scale(i))
                .maximum_step)
      : push_rule.maximum_step;
  if (length > maximum_step)
    push = (maximum_step / length) * push;
  double* const position = samples.positions + 3 * Wide(i);
  const double3 p = double3{position[0], position[1], position[2]} + to_double(push);
  position[0] = p.x;
  position[1] = p.y;
  position[2] = p.z;
  if (samples.fit)
  {
    const float4 fit = samples.fit[i];
    samples.fit[i] = with_w(xyz(fit) - push, fit.w); // c_i stays where it is
  }
  const int3 fixed = frame.fixed_point(p);
  moved_points[i] = make_int4(fixed.x, fixed.y, fixed.z, center.w);
}

__global__ void move_onto_fit(Samples samples)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const double3 offset = to_double(xyz(samples.fit[i]));
  samples.positions[3 * i] += offset.x;
  samples.positions[3 * i + 1] += offset.y;
  samples.positions[3 * i + 2] += offset.z;
}

} // namespace

void fit_compatible_points(const Execution_context& context, const Cell_grid& sample_grid,
                           bool is_in_order, const Cell_blocks& blocks, const Cell_grid& grid,
                           const float4* normals, const Fit_kernel<double>& kernel,
                           const Samples& samples, const Outcomes_of_fit& outcomes)
{
  fit_samples<<<blocks_for_queries(samples.size), threads_per_block, 0, context.stream>>>(
    sample_grid, is_in_order ? nullptr : sample_grid.order, blocks, grid, normals,
    kernel.as<float>(), Border_of_ball(kernel.radius, kernel.squared_bandwidth), samples, outcomes);
  check_launch("fit_samples");
}

void repel_tangentially(const Execution_context& context, const Cell_grid& sample_grid,
                        const Neighbor_lists& neighbors, const int4* places, double range,
                        double spacing, double radius, std::size_t number_of_steps,
                        const Samples& samples)
{
  const Repulsion repulsion(spacing, radius);
  const Push push = {{float(range), nullptr, samples.spreading_radii},
                     float(repulsion.squared_bandwidth),
                     float(repulsion.strength),
                     float(repulsion.maximum_step),
                     float(self_neighbor_radius_per_spacing * spacing),
                     spacing,
                     radius};
  const Arena_scope scope(context.scratch);
  int4 *points = sample_grid.points, *moved = context.scratch.take<int4>(samples.size);
  for (std::size_t step = 0; step < number_of_steps; ++step)
  {
    repel<<<blocks_for_queries(samples.size), threads_per_block, 0, context.stream>>>(
      sample_grid.frame, neighbors, push, places, points, samples, moved);
    check_launch("repel");
    std::swap(points, moved);
  }
}

void take_fitted_positions(const Execution_context& context, const Samples& samples)
{
  move_onto_fit<<<blocks_for(samples.size), threads_per_block, 0, context.stream>>>(samples);
  check_launch("move_onto_fit");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
