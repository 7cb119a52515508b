// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/Plane_fit.cuh"
#include "search/Query.cuh"
#include "driver/stages.cuh"

#include <CGAL/L0_resampling/internal/kernels/Border_of_ball.h>
#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// What the fit needs beside the points.
struct Fit
{
  float radius, squared_bandwidth, normal_bandwidth, squared_sheet_height;
  Border_of_ball border; // at scale 1

  __device__ Fit scaled(float scale) const
  {
    Fit fit = *this;
    fit.radius *= scale;
    fit.squared_bandwidth *= scale * scale;
    fit.squared_sheet_height *= scale * scale;
    return fit;
  }
};

/// What the points of a ball that agree with a normal add up to, as on the CPU.
struct Compatible_points
{
  float all, weight, squared_weights, height, squared_heights;
  float3 offset, normal;
};

/// The points around a sample, for the lanes that share it.
struct Surroundings
{
  const Query& query;
  const int4& center;
  const Cell_grid& grid;
  const Cell_blocks& blocks;
  const float4* normals;
  const Fit& fit;

  /// \param visit called with the place of each point relative to the sample, its normal, and its
  /// scale in the ball
  template <typename Visit>
  __device__ void for_each(const Visit& visit) const
  {
    const float unit = grid.frame.unit(), squared_radius = fit.radius * fit.radius;
    for_each_candidate(grid, blocks, center, query.lane, fit.radius,
                       [&](unsigned j, const int4& point) {
                         const float3 d = difference(point, center, unit);
                         const float4 other = normals[j];
                         visit(d, xyz(other), share_in_ball(dot(d, d), squared_radius) * other.w);
                       });
  }

  __device__ Compatible_points sum_compatible_points(const float3& normal,
                                                     float squared_sheet_height) const
  {
    Compatible_points sums = {0, 0, 0, 0, 0, {0, 0, 0}, {0, 0, 0}};
    for_each([&](const float3& d, const float3& other, float scale) {
      const float cosine = dot(other, normal), sign = with_sign_of(cosine, 1.f);
      const float h = symmetric_height(dot(d, normal), sign * dot(d, other));
      const float weight = scale
                           * sheet_weight(dot(d, d), fit.squared_bandwidth, cosine,
                                          fit.normal_bandwidth, h, squared_sheet_height);
      sums.all += scale;
      sums.weight += weight;
      sums.squared_weights += weight * weight;
      sums.height += weight * h;
      sums.squared_heights += weight * h * h;
      sums.offset += weight * d;
      sums.normal += (sign * weight) * other;
    });
    return {group_sum<lanes>(sums.all),
            group_sum<lanes>(sums.weight),
            group_sum<lanes>(sums.squared_weights),
            group_sum<lanes>(sums.height),
            group_sum<lanes>(sums.squared_heights),
            group_sum<lanes>(sums.offset),
            group_sum<lanes>(sums.normal)};
  }

  __device__ float3 normal_of_most(const float3& own, double weight_of_own) const
  {
    Moments moments;
    for_each([&](const float3& d, const float3& other, float scale) {
      moments.add(other, scale * gaussian_weight(dot(d, d), fit.squared_bandwidth));
    });
    moments.sum_over_group<lanes>();
    Plane_moments<double> all = moments.all();
    all.add(own.x, own.y, own.z, weight_of_own);
    return to_float(all.main_direction());
  }
};

/// The fit of the default method, as `fit_compatible_points()` on the CPU, which says why.
/// \param number_of_lonely in and out, if not null: the samples without compatible points add up
__global__ void fit_samples(Cell_grid sample_grid, const unsigned* order, Cell_blocks blocks,
                            Cell_grid grid, const float4* normals, Fit fit_of_one, Samples samples,
                            unsigned* number_of_lonely)
{
  const Query query(samples.size);
  const int4 center = sample_grid.points[query.index];
  const unsigned i = order ? order[query.index] : query.index;
  const float scale = samples.scale(i);
  const Fit fit = fit_of_one.scaled(scale);
  const Surroundings surroundings = {query, center, grid, blocks, normals, fit};
  float3 normal = xyz(samples.normals[i]);
  Compatible_points sums = surroundings.sum_compatible_points(normal, fit.squared_sheet_height);
  const Unsupported_sample support(sums.weight, sums.all, fit.squared_sheet_height,
                                   fit.radius * fit.radius);
  const double sheet_height =
    support.is_unsupported ? support.squared_sheet_height
                           : squared_sheet_height_among(fit.squared_sheet_height,
                                                        weighted_variance(sums.weight, sums.height,
                                                                          sums.squared_heights));
  // the lanes of a warp add up together
  if (__any_sync(0xffffffffu, support.is_unsupported))
  {
    const float3 normal_of_most = surroundings.normal_of_most(normal, support.weight_of_own_normal);
    if (support.is_unsupported)
      normal = normal_of_most;
  }
  if (__any_sync(0xffffffffu, sheet_height != fit.squared_sheet_height))
    sums = surroundings.sum_compatible_points(normal, float(sheet_height));
  if (!query.writes)
    return;

  const double total = sums.weight;
  samples.outward[i] = Short_vector::zero();
  if (
    !(total
      // no compatible points: the sample is drawn to where it was last fitted, and keeps its normal
      > 1e-3))
  {
    samples.fit[i].w = 1;
    samples.normals[i].w = 0;
    if (number_of_lonely)
      atomicAdd(number_of_lonely, 1u);
    return;
  }
  const double3 old_normal = to_double(normal), mean = (1 / total) * to_double(sums.offset);
  const double3 offset = mean - dot(old_normal, mean) * old_normal;
  const double distance = sqrt(dot(offset, offset));
  double3 to_centroid = (sums.height / total) * old_normal;
  const double way_back = scale * fit.border.way_back(distance / scale);
  if (way_back > 0)
    to_centroid = to_centroid + (way_back / distance) * offset;
  samples.fit[i] = with_w(to_float(to_centroid), float(total));
  const double held_back = fit.border.share_held_back(distance / scale);
  if (held_back > 0)
    samples.outward[i] = Short_vector::of(to_float((-sqrt(held_back) / distance) * offset));
  const double3 mean_normal = to_double(sums.normal);
  const double length = sqrt(dot(mean_normal, mean_normal));
  const float3 new_normal = length > 1e-3 * total ? to_float((1 / length) * mean_normal)
                                                  : xyz(samples.normals[i]);
  samples.normals[i] =
    with_w(new_normal,
           float(variance_of_mean(total, sums.squared_weights, sums.height, sums.squared_heights)));
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
    {
      const float scale = 2 * push_rule.spreading_radius / (radii[i] + radii[k]);
      squared_distance *= scale * scale;
    }
    push += (push_rule.strength
             * share_in_ball(dot(former_d, former_d),
                             Range_of_pairs::squared(own_limit, push_rule.range.limit(k)))
             * gaussian_weight(squared_distance, push_rule.squared_bandwidth))
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
  const float4 fit = samples.fit[i];
  samples.fit[i] = with_w(xyz(fit) - push, fit.w); // c_i stays where it is
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

void fit_compatible_points(const Workplace& workplace, const Cell_grid& sample_grid,
                           bool is_in_order, const Cell_blocks& blocks, const Cell_grid& grid,
                           const float4* normals, double radius, double squared_sheet_height,
                           double normal_bandwidth, const Samples& samples,
                           unsigned* number_of_lonely)
{
  const double bandwidth = fit_bandwidth_factor * radius;
  const Fit fit = {float(radius), float(bandwidth * bandwidth), float(normal_bandwidth),
                   float(squared_sheet_height), Border_of_ball(radius, bandwidth)};
  fit_samples<<<blocks_for_queries(samples.size), threads_per_block, 0, workplace.stream>>>(
    sample_grid, is_in_order ? nullptr : sample_grid.order, blocks, grid, normals, fit, samples,
    number_of_lonely);
  check_launch("fit_samples");
}

void repel_tangentially(const Workplace& workplace, const Cell_grid& sample_grid,
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
  const Arena_scope scope(workplace.scratch);
  int4 *points = sample_grid.points, *moved = workplace.scratch.take<int4>(samples.size);
  for (std::size_t step = 0; step < number_of_steps; ++step)
  {
    repel<<<blocks_for_queries(samples.size), threads_per_block, 0, workplace.stream>>>(
      sample_grid.frame, neighbors, push, places, points, samples, moved);
    check_launch("repel");
    std::swap(points, moved);
  }
}

void take_fitted_positions(const Workplace& workplace, const Samples& samples)
{
  move_onto_fit<<<blocks_for(samples.size), threads_per_block, 0, workplace.stream>>>(samples);
  check_launch("move_onto_fit");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
