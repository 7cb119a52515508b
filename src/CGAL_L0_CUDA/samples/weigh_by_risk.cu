// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/stages_of_refinement.cuh"
#include "search/Query.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void find_reference(Samples samples, Lengths_of_refinement lengths,
                               const Surfaces_of_scale* surfaces, const Surfaces_of_scale* smallest,
                               Surface_of_disks* references)
{
  const Wide i = thread_index();
  if (i < samples.size)
    references[i] =
      reference_of(surfaces[i].quadric, smallest[i].quadric,
                   lengths_at(lengths, samples, unsigned(i)).share_of_smallest_reference());
}

/// By how much the surfaces of a sample differ from its reference.
struct Compared_sample
{
  float4 normal;      // and 1 if the plane counts, 2 more if the quadric does
  float4 differences; // heights and slopes of plane and quadric, as they are averaged
};

__global__ void compare(Samples samples, const Surface_of_disks* references,
                        const Surfaces_of_scale* surfaces, Compared_sample* compared)
{
  const Wide k = thread_index();
  if (k >= samples.size)
    return;
  const auto plane = differences(surfaces[k].plane, references[k]),
             quadric = differences(surfaces[k].quadric, references[k]);
  compared[k] = {with_w(xyz(samples.normals[k]), plane.weight + 2 * quadric.weight),
                 make_float4(plane.heights, plane.slopes, quadric.heights, quadric.slopes)};
}

__device__ Differences_from_reference<float> group_sum_of(
  const Differences_from_reference<float>& sums)
{
  return {group_sum<lanes>(sums.weight), group_sum<lanes>(sums.heights),
          group_sum<lanes>(sums.slopes)};
}

__global__ void weigh(Cell_grid sample_grid, Cell_blocks blocks, double radius_of_one,
                      Samples samples, const Compared_sample* compared,
                      const Surface_of_disks* references, const Surfaces_of_scale* surfaces,
                      Mean_surface* means)
{
  const Query query(samples.size);
  const unsigned i = query.index;
  const int4 center = sample_grid.points[i];
  const double radius = radius_of_one * samples.scale(i);
  const float squared_radius = float(square(radius)), unit = sample_grid.frame.unit();
  const float3 normal = xyz(samples.normals[i]);
  const bool has_reference = references[i].is_determined();
  Differences_from_reference<float> of_plane, of_quadric;
  if (has_reference)
    for_each_candidate(
      sample_grid, blocks, center, query.lane, float(radius), [&](unsigned k, const int4& place) {
        const float3 d = difference(place, center, unit);
        const Compared_sample other = compared[k];
        const float weight = weight_of_difference(dot(d, d), squared_radius,
                                                  dot(normal, xyz(other.normal))),
                    quadric_weight = other.normal.w >= 2 ? weight : 0,
                    plane_weight = other.normal.w == 1 || other.normal.w == 3 ? weight : 0;
        of_plane.weight += plane_weight;
        of_plane.heights += plane_weight * other.differences.x;
        of_plane.slopes += plane_weight * other.differences.y;
        of_quadric.weight += quadric_weight;
        of_quadric.heights += quadric_weight * other.differences.z;
        of_quadric.slopes += quadric_weight * other.differences.w;
      });
  of_plane = group_sum_of(of_plane);
  of_quadric = group_sum_of(of_quadric);
  if (!query.writes || !has_reference)
    return;
  Mean_surface mean = means[i];
  const auto add_to_mean = [&](const Surface_of_disks& surface,
                               const Differences_from_reference<float>& sums) {
    if (surface.is_determined() && sums.weight > 0)
      mean.add(surface, risk_of_surface(surface, references[i], sums));
  };
  add_to_mean(surfaces[i].plane, of_plane);
  add_to_mean(surfaces[i].quadric, of_quadric);
  means[i] = mean;
}

__global__ void settle_on_mean(Samples samples, Lengths_of_refinement lengths,
                               const Mean_surface* means, Bend* bends, Variances_of_fit* variances)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const Lengths_of_refinement own_lengths = lengths_at(lengths, samples, unsigned(i));
  if (variances)
    variances[i] = Variances_of_fit(means[i], own_lengths);
  const float4 own = samples.normals[i];
  const Triple normal = {own.x, own.y, own.z};
  const Settled_on_mean settled(means[i], normal, own_lengths);
  double* const position = samples.positions + 3 * i;
  position[0] += settled.height * normal.x;
  position[1] += settled.height * normal.y;
  position[2] += settled.height * normal.z;
  samples.normals[i] = make_float4(float(settled.normal.x), float(settled.normal.y),
                                   float(settled.normal.z), 0);
  bends[i] = settled.bend;
}

} // namespace

void find_references(const Execution_context& context, const Lengths_of_refinement& lengths,
                     const Samples& samples, const Surfaces_of_scale* surfaces,
                     const Surfaces_of_scale* smallest, Surface_of_disks* references)
{
  find_reference<<<blocks_for(samples.size), threads_per_block, 0, context.stream>>>(
    samples, lengths, surfaces, smallest, references);
  check_launch("find_reference");
}

void weigh_by_risk(const Execution_context& context, const Cell_grid& sample_grid, double radius,
                   const Samples& samples, const Surface_of_disks* references,
                   const Surfaces_of_scale* surfaces, Mean_surface* means)
{
  const cudaStream_t stream = context.stream;
  const Arena_scope scope(context.scratch);
  Compared_sample* const compared = context.scratch.take<Compared_sample>(samples.size);
  compare<<<blocks_for(samples.size), threads_per_block, 0, stream>>>(samples, references, surfaces,
                                                                      compared);
  check_launch("compare");
  const Cell_blocks blocks = find_blocks(sample_grid, sample_grid,
                                         cells_in_reach(radius, sample_grid.frame.cell_size),
                                         maximum_number_of_candidates, context.scratch, stream);
  weigh<<<blocks_for_queries(samples.size), threads_per_block, 0, stream>>>(
    sample_grid, blocks, radius, samples, compared, references, surfaces, means);
  check_launch("weigh");
}

void settle_on_means(const Execution_context& context, const Lengths_of_refinement& lengths,
                     const Mean_surface* means, const Samples& samples, Bend* bends,
                     Variances_of_fit* variances)
{
  settle_on_mean<<<blocks_for(samples.size), threads_per_block, 0, context.stream>>>(
    samples, lengths, means, bends, variances);
  check_launch("settle_on_mean");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
