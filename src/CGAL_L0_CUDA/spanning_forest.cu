// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation.cuh"

#include <cooperative_groups.h>

#include <algorithm>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

// As on the CPU
constexpr unsigned number_of_steps = 1024; // of how sure edges are

constexpr unsigned short doubtful = 0xffff;

/// Trees whose signs are fixed relative to each other.
struct Forest
{
  Link* roots;          // of each sample: the root of its tree, and whether it is turned against it
  Link* hooks;          // of each root: where it is hooked to in this round
  Wide* best;           // of each root: the edge that it joins another tree by
  unsigned* is_changed; // one for each round
};

__global__ void grade_edges(Graph graph)
{
  const Wide t = thread_index();
  const Wide i = t / graph.k;
  if (i >= graph.size || graph.nearest[t] == nobody)
    return;
  const float a = agreement_of(graph, i, graph.nearest[t]);
  const unsigned step = unsigned((1 - fminf(fabsf(a), 1.f)) * (number_of_steps - 1));
  graph.grades[t] = fabsf(a) >= float(beyond_doubt) ? static_cast<unsigned short>(step << 1 | unsigned(a < 0)) : doubtful;
}

/// The order of the edges, in which no two are equal: the surest first, then by number.
__device__ Wide rank_of_edge(unsigned grade, Wide edge) { return Wide(grade >> 1) << 48 | edge; }

/// Where a root goes by its best edge.
__device__ Link link_by_edge(const Graph& graph, const Forest& forest, unsigned root)
{
  const Wide edge = __ldcg(&forest.best[root]) & ((Wide(1) << 48) - 1);
  const Link a = load(&forest.roots[edge / graph.k]), b = load(&forest.roots[graph.nearest[edge]]);
  const bool is_turned = a.is_turned() ^ b.is_turned() ^ bool(graph.grades[edge] & 1);
  return Link::to(a.target() == root ? b.target() : a.target(), is_turned);
}

/// Ends a round: each root with a best edge is hooked to where that leads, and all samples find their new roots.
__device__ void join_trees(const cooperative_groups::grid_group& grid, const Graph& graph, const Forest& forest)
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
  // Roots walk up, and shorten the way for those behind them: each word is a true statement at any time.
  for_each(graph.size, [&](Wide i) {
    if (__ldcg(&forest.best[i]) != nothing)
      store(&forest.hooks[i], follow(forest.hooks, load(&forest.hooks[i])));
  });
  grid.sync();
  for_each(graph.size, [&](Wide i) {
    const Link link = load(&forest.roots[i]);
    store(&forest.roots[i], link + load(&forest.hooks[link.target()]));
    __stcg(&forest.best[i], nothing);
  });
  grid.sync();
}

/*!
The maximum spanning forest over the edges beyond doubt, by the rounds of Boruvka (1926): every tree takes the best edge that leads out of it,
all at once. The order of the edges is total, so that the forest is the one that Kruskal's algorithm finds for that order.

\param number_of_edges out: of those between different trees in the end
*/
__global__ void __launch_bounds__(threads_per_block)
  join_by_best_edges(Graph graph, Forest forest, unsigned* number_of_edges)
{
  const cooperative_groups::grid_group grid = cooperative_groups::this_grid();
  for_each(graph.size, [&](Wide i) {
    store(&forest.roots[i], Link::to(unsigned(i), false));
    store(&forest.hooks[i], Link::to(unsigned(i), false));
    __stcg(&forest.best[i], nothing);
  });
  grid.sync();
  Wide is_inner =
    0; // a bit for each of the first samples of the thread: no edge beyond doubt leads out of its tree, nor ever will
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
      for (Wide edge = i * graph.k; edge < (i + 1) * graph.k; ++edge)
      {
        const unsigned other = graph.nearest[edge];
        if (other == nobody)
          break;
        const unsigned short grade = graph.grades[edge];
        if (grade == doubtful)
          continue;
        const unsigned other_root = load(&forest.roots[other]).target();
        if (other_root == root)
          continue;
        const Wide rank = rank_of_edge(grade, edge);
        best = min(best, rank);
        propose(&forest.best[other_root], rank);
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
  }

  unsigned count = 0;
  for_each(graph.size, [&](Wide i) { for_each_edge_between_sets(graph, forest.roots, i, [&](unsigned) { ++count; }); });
  count = group_sum<32>(count);
  if (threadIdx.x % 32 == 0 && count > 0)
    atomicAdd(number_of_edges, count);
}

} // namespace

void launch_cooperatively(const Workplace& workplace, void* kernel, unsigned long long size, unsigned threads,
                          int most_blocks, void** arguments)
{
  int blocks_per_multiprocessor = 0;
  CGAL_L0_CUDA_CHECK(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks_per_multiprocessor, kernel, int(threads), 0));
  const unsigned room = unsigned((std::min)(blocks_per_multiprocessor, most_blocks) * workplace.number_of_multiprocessors);
  const unsigned blocks = unsigned((std::min)(Wide(room), (size + threads - 1) / threads));
  CGAL_L0_CUDA_CHECK(cudaLaunchCooperativeKernel(kernel, dim3(blocks), dim3(threads), arguments, 0, workplace.stream));
}

unsigned grow_forest(const Workplace& workplace, const Graph& graph, Link* faces)
{
  const unsigned m = graph.size;
  const cudaStream_t stream = workplace.stream;
  const Arena_scope scope(workplace.scratch);
  grade_edges<<<blocks_for(Wide(m) * graph.k), threads_per_block, 0, stream>>>(graph);
  check_launch("grade_edges");
  Forest forest = {faces, workplace.scratch.take<Link>(m), workplace.scratch.take<Wide>(m),
                   workplace.scratch.take<unsigned>(maximum_number_of_rounds)};
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(forest.is_changed, 0, maximum_number_of_rounds * sizeof(unsigned), stream));
  const Device_counter<unsigned> counter(workplace);
  Graph argument = graph;
  unsigned* number_of_edges = counter.address();
  void* arguments[] = {&argument, &forest, &number_of_edges};
  launch_cooperatively(workplace, reinterpret_cast<void*>(join_by_best_edges), m, threads_per_block, 4, arguments);
  return counter.read();
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
