// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/orientation.cuh"

#include <CGAL/L0_resampling/internal/kernels/height_tolerance.h>

#include <cfloat>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void find_tolerances(Graph graph, float squared_spacing, float squared_noise)
{
  const Wide i = thread_index();
  if (i >= graph.size)
    return;
  const double* const p = graph.samples.positions + 3 * i;
  const float4 own = graph.samples.normals[i];
  const unsigned* const nearest = graph.nearest + i * graph.k;
  unsigned count = 0; // those that are there come first
  while (count < graph.k && nearest[count] != nobody)
    ++count;
  const auto to_neighbor = [&](unsigned k) {
    const double* const q = graph.samples.positions + 3 * Wide(nearest[k]);
    return make_float3(float(q[0] - p[0]), float(q[1] - p[1]), float(q[2] - p[2]));
  };
  graph.samples.normals[i].w = squared_height_tolerance(
    count,
    [&](unsigned k) {
      const float3 d = to_neighbor(k);
      return dot(d, d);
    },
    [&](unsigned k) { return fabsf(dot(xyz(own), to_neighbor(k))); }, squared_spacing,
    squared_noise);
}

/// \param sums out: as on the CPU
__global__ void add_up_normals(Graph voters, const Link* trees, Side_hints hints, float3* sums)
{
  const Wide i = thread_index();
  if (i >= voters.size)
    return;
  const double* const p = voters.samples.positions + 3 * i;
  const float4 normal = voters.samples.normals[i];
  const Link tree = trees[i];
  const float3 own = (tree.is_turned() ? -1.f : 1.f) * xyz(normal);
  float3 sum = {0, 0, 0};
  if (hints.certain_side_of(voters.samples, i) == 0)
    for (unsigned e = 0; e < voters.k; ++e)
    {
      const unsigned other = voters.nearest[i * voters.k + e];
      if (other == nobody) // those that are there come first
        break;
      const Link others_tree = trees[other];
      if (others_tree.target() != tree.target())
        continue;
      const double* const q = voters.samples.positions + 3 * Wide(other);
      const float3 d = {float(q[0] - p[0]), float(q[1] - p[1]), float(q[2] - p[2])};
      const float4 others = voters.samples.normals[other];
      const float height = dot(own, d), other_height = dot(xyz(others), d);
      const float weight = share_of_one_sheet(height * height + other_height * other_height,
                                              fmaxf(fmaxf(normal.w, others.w), FLT_MIN));
      sum = sum + (others_tree.is_turned() ? -weight : weight) * xyz(others);
    }
  const float votes = dot(sum, own);
  sums[i] = isfinite(votes) ? sum + (votes < 0 ? -1.f : 1.f) * own : own;
}

__global__ void turn_losers(const float3* sums, const Link* trees, Samples samples)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const float4 n = samples.normals[i];
  if (dot(sums[i], (trees[i].is_turned() ? -1.f : 1.f) * xyz(n)) < 0)
    samples.normals[i] = make_float4(-n.x, -n.y, -n.z, n.w);
}

} // namespace

void find_height_tolerances(const Execution_context& context, const Graph& graph, double spacing,
                            double noise_of_heights)
{
  find_tolerances<<<blocks_for(graph.size), threads_per_block, 0, context.stream>>>(
    graph, float(spacing * spacing), float(noise_of_heights * noise_of_heights));
  check_launch("find_tolerances");
}

void turn_outvoted(const Execution_context& context, const Graph& voters, const Link* trees,
                   const Side_hints& hints, float3* sums)
{
  for (int sweep = 0; sweep < sweeps_over_outvoted; ++sweep)
  {
    add_up_normals<<<blocks_for(voters.size), threads_per_block, 0, context.stream>>>(voters, trees,
                                                                                      hints, sums);
    check_launch("add_up_normals");
    turn_losers<<<blocks_for(voters.size), threads_per_block, 0, context.stream>>>(sums, trees,
                                                                                   voters.samples);
    check_launch("turn_losers");
  }
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
