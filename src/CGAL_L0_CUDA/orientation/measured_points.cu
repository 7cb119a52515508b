// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/orientation.cuh"

#include <CGAL/L0_resampling/internal/kernels/height_tolerance.h>

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

/// \param units_per_vote of the fixed-point numbers
/// \param votes of each sample; 0 at first
__global__ void add_up_votes(Graph graph, const Link* trees, float units_per_vote, int* votes)
{
  for_each_pair_of_neighbors(
    graph, thread_index(), Wide(gridDim.x) * blockDim.x, [&](unsigned i, unsigned other) {
      const bool is_turned = trees[i].is_turned() != trees[other].is_turned();
      const float agreement = agreement_of(graph, i, other);
      const int vote = __float2int_rn((is_turned ? -agreement : agreement) * units_per_vote);
      atomicAdd(&votes[i], vote);
      atomicAdd(&votes[other], vote);
    });
}

__global__ void turn_losers(const int* votes, Side_hints hints, Samples samples)
{
  const Wide i = thread_index();
  if (i >= samples.size || votes[i] >= 0 || hints.certain_side_of(samples, i) != 0)
    return;
  const float4 n = samples.normals[i];
  samples.normals[i] = make_float4(-n.x, -n.y, -n.z, n.w);
}

} // namespace

void find_height_tolerances(const Workplace& workplace, const Graph& graph, double spacing,
                            double noise_of_heights)
{
  find_tolerances<<<blocks_for(graph.size), threads_per_block, 0, workplace.stream>>>(
    graph, float(spacing * spacing), float(noise_of_heights * noise_of_heights));
  check_launch("find_tolerances");
}

void turn_outvoted(const Workplace& workplace, const Graph& graph, const Link* trees,
                   const Side_hints& hints)
{
  const unsigned m = graph.size;
  const cudaStream_t stream = workplace.stream;
  const Arena_scope scope(workplace.scratch);
  int* const votes = workplace.scratch.take<int>(m);
  // a point is listed by a few times as many as it lists: a share of 2^31 for each of them
  const float most_voters_per_neighbor = 64,
              units = 2147483648.f / (most_voters_per_neighbor * float(graph.k));
  for (int sweep = 0; sweep < sweeps_over_outvoted; ++sweep)
  {
    CGAL_L0_CUDA_CHECK(cudaMemsetAsync(votes, 0, m * sizeof(int), stream));
    add_up_votes<<<blocks_for(Wide(m) * lanes_of_edges), threads_per_block, 0, stream>>>(
      graph, trees, units, votes);
    check_launch("add_up_votes");
    turn_losers<<<blocks_for(m), threads_per_block, 0, stream>>>(votes, hints, graph.samples);
    check_launch("turn_losers");
  }
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
