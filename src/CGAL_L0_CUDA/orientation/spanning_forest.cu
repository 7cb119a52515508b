// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/orientation.cuh"

#include <cooperative_groups.h>

#include <algorithm>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

constexpr unsigned short doubtful = 0xffff;

/// Trees whose signs are fixed relative to each other.
struct Forest
{
  Link* roots; // of each sample: the root of its tree, and whether it is turned against it
  Link* hooks; // of each root: where it is hooked to in this round
  Wide* best;  // of each root: the edge that it joins another tree by
  const unsigned short* grades;    // of the edges, see `grade_edges()`
  unsigned* is_changed;            // one for each round
  unsigned* dipoles_of_sets;       // of each root, 0 but while they are counted
  unsigned* dipoles_of_large_sets; // one for each round
};

/// Marks each pair in the list of the higher sample, if both list it.
__global__ void mark_pairs(Graph graph)
{
  const Wide t = thread_index();
  const Wide i = t / lanes_of_edges;
  if (i >= graph.size)
    return;
  for (unsigned e = t % lanes_of_edges; e < graph.k; e += lanes_of_edges)
  {
    const unsigned other = graph.neighbor(i * graph.k + e);
    bool is_listed = false;
    for (unsigned back = 0; back < graph.k && other < i; ++back)
      is_listed = is_listed || graph.neighbor(Wide(other) * graph.k + back) == i;
    if (is_listed)
      graph.nearest[i * graph.k + e] = other | is_listed_by_other;
  }
}

/// \param grades of the edges: step, 0 for the surest; lowest bit: whether the normals disagree; or
/// `doubtful`
__global__ void grade_edges(Graph graph, unsigned short* grades)
{
  const Wide t = thread_index();
  const Wide i = t / lanes_of_edges;
  if (i >= graph.size)
    return;
  for (unsigned e = t % lanes_of_edges; e < graph.k; e += lanes_of_edges)
  {
    const Wide edge = i * graph.k + e;
    const unsigned other = graph.nearest[edge];
    const float a = other != nobody ? agreement_of(graph, i, other) : 0;
    const unsigned step = step_of_agreement(a);
    grades[edge] = fabsf(a) >= float(beyond_doubt)
                     ? static_cast<unsigned short>(step << 1 | unsigned(a < 0))
                     : doubtful;
  }
}

/// The order of the edges, in which no two are equal: the surest first, then by number.
__device__ Wide rank_of_edge(unsigned grade, Wide edge) { return Wide(grade >> 1) << 48 | edge; }

/// Where a root goes by its best edge.
__device__ Link link_by_edge(const Graph& graph, const Forest& forest, unsigned root)
{
  const Wide edge = __ldcg(&forest.best[root]) & ((Wide(1) << 48) - 1);
  const Link a = load(&forest.roots[edge / graph.k]), b = load(&forest.roots[graph.nearest[edge]]);
  const bool is_turned = a.is_turned() ^ b.is_turned() ^ bool(forest.grades[edge] & 1);
  return Link::to(a.target() == root ? b.target() : a.target(), is_turned);
}

/// Ends a round: each root with a best edge is hooked to where that leads, and all samples find
/// their new roots.
__device__ void join_trees(const cooperative_groups::grid_group& grid, const Graph& graph,
                           const Forest& forest)
{
  for_each(graph.size, [&](Wide i) {
    const unsigned root = unsigned(i);
    if (__ldcg(&forest.best[root]) == nothing)
      return;
    const Link link = link_by_edge(graph, forest, root);
    // two trees that chose each other chose one and the same: the lower root stays
    const bool is_mutual = link_by_edge(graph, forest, link.target()).target() == root;
    if (!is_mutual || link.target() < root)
      store(&forest.hooks[root], link);
  });
  grid.sync();
  for_each(graph.size, [&](Wide i) {
    const Link link = load(&forest.roots[i]);
    // The way is shortened for those behind: each word is a true statement at any time.
    const Link hook = follow(forest.hooks, load(&forest.hooks[link.target()]));
    store(&forest.hooks[link.target()], hook);
    store(&forest.roots[i], link + hook);
    __stcg(&forest.best[i], nothing);
  });
  grid.sync();
}

/// Whether large sets hold most of the samples, see `are_sets_large()`. For all threads of the
/// launch, once a round.
__device__ bool are_sets_large(const cooperative_groups::grid_group& grid, const Graph& graph,
                               const Forest& forest, unsigned round)
{
  const unsigned number_of_dipoles = min(graph.size, maximum_number_of_dipoles);
  const auto count_of_dipole = [&](Wide k) {
    return &forest.dipoles_of_sets
              [load(&forest.roots[sample_of_dipole(k, graph.size, number_of_dipoles)]).target()];
  };
  for_each(number_of_dipoles, [&](Wide k) { atomicAdd(count_of_dipole(k), 1u); });
  grid.sync();
  for_each(number_of_dipoles, [&](Wide k) {
    if (__ldcg(count_of_dipole(k)) >= dipoles_of_large_set)
      atomicAdd(&forest.dipoles_of_large_sets[round], 1u);
  });
  grid.sync();
  for_each(number_of_dipoles, [&](Wide k) { __stcg(count_of_dipole(k), 0u); });
  return internal::are_sets_large(__ldcg(&forest.dipoles_of_large_sets[round]), number_of_dipoles);
}

/// The edges of a sample that are looked at together, so that the memory has several reads to do at
/// once.
constexpr unsigned edges_of_batch = 4;

/*!
Joins samples over the edges beyond doubt, by the rounds of Boruvka (1926), as `grow_forest()` on
the CPU: every tree takes the best edge that leads out of it, all at once. The order of the edges is
total.
*/
__global__ void __launch_bounds__(threads_per_block) join_by_best_edges(Graph graph, Forest forest)
{
  const cooperative_groups::grid_group grid = cooperative_groups::this_grid();
  for_each(graph.size, [&](Wide i) {
    store(&forest.hooks[i], Link::to(unsigned(i), false));
    __stcg(&forest.best[i], nothing);
  });
  grid.sync();
  // a bit for each of the first samples of the thread: no sure edge leads out of its tree, nor ever
  // will
  Wide is_inner = 0;
  for (unsigned round = 0; round < maximum_number_of_rounds; ++round)
  {
    Wide bit = 1; // none from the 65th sample on
    for_each(graph.size, [&](Wide i) {
      const Wide own_bit = bit;
      bit <<= 1;
      if (is_inner & own_bit)
        return;
      const unsigned root = load(&forest.roots[i]).target();
      Wide best = nothing;
      for (unsigned first = 0; first < graph.k; first += edges_of_batch)
      {
        unsigned short grades[edges_of_batch];
        unsigned roots[edges_of_batch];
#pragma unroll
        for (unsigned b = 0; b < edges_of_batch; ++b)
          grades[b] = first + b < graph.k ? forest.grades[i * graph.k + first + b] : doubtful;
#pragma unroll
        for (unsigned b = 0; b < edges_of_batch; ++b)
          roots[b] = grades[b] == doubtful
                       ? root
                       : load(&forest.roots[graph.nearest[i * graph.k + first + b]]).target();
#pragma unroll
        for (unsigned b = 0; b < edges_of_batch; ++b)
        {
          if (roots[b] == root)
            continue;
          const Wide rank = rank_of_edge(grades[b], i * graph.k + first + b);
          best = min(best, rank);
          propose(&forest.best[roots[b]], rank);
        }
      }
      if (best == nothing)
      {
        is_inner |= own_bit;
        return;
      }
      propose(&forest.best[root], best);
      note(&forest.is_changed[round]);
    });
    grid.sync();
    if (__ldcg(&forest.is_changed[round]) == 0)
      break;
    join_trees(grid, graph, forest);
    if (are_sets_large(grid, graph, forest, round))
      break;
  }
}

__global__ void count_edges_between_sets(Graph graph, const Link* sets, unsigned* number_of_edges)
{
  unsigned count = 0;
  for_each_pair_of_neighbors(graph, thread_index(), Wide(gridDim.x) * blockDim.x,
                             [&](unsigned i, unsigned other) {
                               count += unsigned(sets[i].target() != sets[other].target());
                             });
  count = group_sum<32>(count);
  if (threadIdx.x % 32 == 0 && count > 0)
    atomicAdd(number_of_edges, count);
}

} // namespace

void launch_cooperatively(const Execution_context& context, void* kernel, unsigned long long size,
                          unsigned threads, int maximum_number_of_blocks, void** arguments)
{
  int blocks_per_multiprocessor = 0;
  CGAL_L0_CUDA_CHECK(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks_per_multiprocessor,
                                                                   kernel, int(threads), 0));
  const unsigned room = unsigned((std::min)(blocks_per_multiprocessor, maximum_number_of_blocks)
                                 * context.number_of_multiprocessors);
  const unsigned blocks = unsigned((std::min)(Wide(room), (size + threads - 1) / threads));
  CGAL_L0_CUDA_CHECK(
    cudaLaunchCooperativeKernel(kernel, dim3(blocks), dim3(threads), arguments, 0, context.stream));
}

unsigned grow_forest(const Execution_context& context, const Graph& graph, Link* faces)
{
  const unsigned m = graph.size;
  const cudaStream_t stream = context.stream;
  const Arena_scope scope(context.scratch);
  const unsigned blocks_of_edges = blocks_for(Wide(m) * lanes_of_edges);
  unsigned short* const grades = context.scratch.take<unsigned short>(Wide(m) * graph.k);
  grade_edges<<<blocks_of_edges, threads_per_block, 0, stream>>>(graph, grades);
  check_launch("grade_edges");
  Forest forest = {faces,
                   context.scratch.take<Link>(m),
                   context.scratch.take<Wide>(m),
                   grades,
                   context.scratch.take<unsigned>(maximum_number_of_rounds),
                   context.scratch.take<unsigned>(m),
                   context.scratch.take<unsigned>(maximum_number_of_rounds)};
  CGAL_L0_CUDA_CHECK(
    cudaMemsetAsync(forest.is_changed, 0, maximum_number_of_rounds * sizeof(unsigned), stream));
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(forest.dipoles_of_sets, 0, m * sizeof(unsigned), stream));
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(forest.dipoles_of_large_sets, 0,
                                     maximum_number_of_rounds * sizeof(unsigned), stream));
  Graph argument = graph;
  void* arguments[] = {&argument, &forest};
  launch_cooperatively(context, reinterpret_cast<void*>(join_by_best_edges), m, threads_per_block,
                       4, arguments);
  mark_pairs<<<blocks_of_edges, threads_per_block, 0, stream>>>(graph);
  check_launch("mark_pairs");
  const Device_counter<unsigned> counter(context);
  count_edges_between_sets<<<blocks_of_edges, threads_per_block, 0, stream>>>(graph, faces,
                                                                              counter.address());
  check_launch("count_edges_between_sets");
  return counter.read();
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
