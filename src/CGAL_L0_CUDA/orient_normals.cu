// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nearest_samples.cuh"
#include "orientation.cuh"

#include <cooperative_groups.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

// As on the CPU
constexpr unsigned number_of_steps = 1024; // of how sure edges are

constexpr Wide no_edge = ~Wide(0);
constexpr unsigned short doubtful = 0xffff;
constexpr unsigned threads_of_voting_block = 512;

/// Sets of samples whose signs are fixed relative to each other.
struct Forest
{
  Link* roots;                // of each sample: the root of its set, and whether it is turned against it
  Link* hooks;                // of each root: where it is hooked to in this round
  Wide* best;                 // of each root: the edge or the vote that it joins another set by
  long long* best_votes;      // of each root: the largest absolute agreement with another set
  const unsigned* sure_sizes; // of each sample: the size of its set once all that is sure was joined
  unsigned* is_changed;       // one for each round
};

constexpr unsigned maximum_number_of_rounds = 80; // a round halves the sets that can be joined, at least

/// All edges between two sets, added up in fixed point: integers may be added in any order.
struct Vote
{
  Wide pair; // the roots, the higher one in the lower bits
  long long agreement, total;
};

/// The votes of a round, in a hash table.
struct Votes
{
  Wide* edges; // between different sets, at the beginning
  unsigned number_of_edges;
  Vote* slots;
  unsigned number_of_slots; // a power of two
};

constexpr Wide no_pair = ~Wide(0);
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

__device__ Link load(const Link* link) { return {__ldcg(&link->word)}; }
__device__ void store(Link* link, Link value) { __stcg(&link->word, value.word); }

template <typename F>
__device__ void for_each(Wide size, const F& f)
{
  const Wide number_of_threads = Wide(gridDim.x) * blockDim.x;
  for (Wide i = thread_index(); i < size; i += number_of_threads)
    f(i);
}

/// The order of the edges, in which no two are equal: the surest first, then by number.
__device__ Wide rank_of_edge(unsigned grade, Wide edge) { return Wide(grade >> 1) << 48 | edge; }

__device__ void propose(Wide* best, Wide rank)
{
  if (rank < __ldcg(best))
    atomicMin(best, rank);
}

__device__ void note_change(const Forest& forest, unsigned round)
{
  if (__ldcg(&forest.is_changed[round]) == 0)
    __stcg(&forest.is_changed[round], 1u);
}

/// Where a root goes by its best edge.
__device__ Link link_by_edge(const Graph& graph, const Forest& forest, unsigned root)
{
  const Wide edge = __ldcg(&forest.best[root]) & ((Wide(1) << 48) - 1);
  const Link a = load(&forest.roots[edge / graph.k]), b = load(&forest.roots[graph.nearest[edge]]);
  const bool is_turned = a.is_turned() ^ b.is_turned() ^ bool(graph.grades[edge] & 1);
  return Link::to(a.target() == root ? b.target() : a.target(), is_turned);
}

/// Ends a round: each root with a best edge or vote is hooked to where that leads, and all samples find their new roots.
/// \param link_of the way of a root by its best edge or vote
template <typename Link_of>
__device__ void join_sets(const cooperative_groups::grid_group& grid, const Forest& forest, unsigned size,
                          const Link_of& link_of)
{
  for_each(size, [&](Wide i) {
    const unsigned root = unsigned(i);
    if (__ldcg(&forest.best[root]) == no_edge)
      return;
    const Link link = link_of(root);
    // two sets that chose each other chose one and the same: the lower root stays
    const bool is_mutual = link_of(link.target()).target() == root;
    if (!is_mutual || link.target() < root)
      store(&forest.hooks[root], link);
  });
  grid.sync();
  // Roots walk up, and shorten the way for those behind them: each word is a true statement at any time.
  for_each(size, [&](Wide i) {
    if (__ldcg(&forest.best[i]) == no_edge)
      return;
    Link link = load(&forest.hooks[i]);
    while (true)
    {
      const Link next = load(&forest.hooks[link.target()]);
      if (next.target() == link.target())
        break;
      link = Link::to(next.target(), link.is_turned() ^ next.is_turned());
      store(&forest.hooks[i], link);
    }
  });
  grid.sync();
  for_each(size, [&](Wide i) {
    const Link link = load(&forest.roots[i]), hook = load(&forest.hooks[link.target()]);
    store(&forest.roots[i], Link::to(hook.target(), link.is_turned() ^ hook.is_turned()));
    __stcg(&forest.best[i], no_edge);
  });
  grid.sync();
}

/*!
The maximum spanning forest over the edges beyond doubt, by the rounds of Boruvka (1926): every tree takes the best edge that leads out of it,
all at once. The order of the edges is total, so that the forest is the one that Kruskal's algorithm finds for that order.

\param edges out: those between different trees in the end, each in one direction, in no order
*/
__global__ void __launch_bounds__(threads_per_block)
  grow_forest(Graph graph, Forest forest, Wide* edges, unsigned* number_of_edges)
{
  const cooperative_groups::grid_group grid = cooperative_groups::this_grid();
  for_each(graph.size, [&](Wide i) {
    store(&forest.roots[i], Link::to(unsigned(i), false));
    store(&forest.hooks[i], Link::to(unsigned(i), false));
    __stcg(&forest.best[i], no_edge);
  });
  grid.sync();
  for (unsigned round = 0; round < maximum_number_of_rounds; ++round)
  {
    for_each(graph.size, [&](Wide i) {
      const unsigned root = load(&forest.roots[i]).target();
      Wide best = no_edge;
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
      if (best != no_edge)
      {
        propose(&forest.best[root], best);
        note_change(forest, round);
      }
    });
    grid.sync();
    if (__ldcg(&forest.is_changed[round]) == 0)
      break;
    join_sets(grid, forest, graph.size, [&](unsigned root) { return link_by_edge(graph, forest, root); });
  }

  for_each(graph.size, [&](Wide i) {
    const unsigned root = load(&forest.roots[i]).target();
    for (Wide edge = i * graph.k; edge < (i + 1) * graph.k; ++edge)
    {
      const unsigned other = graph.nearest[edge];
      if (other == nobody)
        break;
      if (load(&forest.roots[other]).target() == root)
        continue;
      bool is_other_way_round = false; // in the list of the other sample too: the lower one has it
      for (unsigned e = 0; e < graph.k && other < i; ++e)
        is_other_way_round = is_other_way_round || graph.nearest[Wide(other) * graph.k + e] == i;
      if (!is_other_way_round)
        edges[atomicAdd(number_of_edges, 1u)] = edge;
    }
  });
}

__device__ unsigned slot_of(const Votes& votes, Wide pair)
{
  Wide hash = (pair ^ pair >> 32) * 0x9E3779B97F4A7C15u;
  return unsigned(hash >> 32) & (votes.number_of_slots - 1);
}

__device__ void add_vote(const Votes& votes, Wide pair, float agreement)
{
  unsigned s = slot_of(votes, pair);
  for (;; s = (s + 1) & (votes.number_of_slots - 1))
  {
    const Wide found = atomicCAS(&votes.slots[s].pair, no_pair, pair);
    if (found == no_pair || found == pair)
      break;
  }
  const long long units = __double2ll_rn(agreement * units_per_vote);
  atomicAdd(reinterpret_cast<Wide*>(&votes.slots[s].agreement), Wide(units));
  atomicAdd(reinterpret_cast<Wide*>(&votes.slots[s].total), Wide(llabs(units)));
}

__device__ unsigned first_of(Wide pair) { return unsigned(pair >> 32); }
__device__ unsigned second_of(Wide pair) { return unsigned(pair); }

/// Where a root goes by its best vote.
__device__ Link link_by_vote(const Votes& votes, const Forest& forest, unsigned root)
{
  const Wide pair = __ldcg(&forest.best[root]);
  unsigned s = slot_of(votes, pair);
  while (__ldcg(&votes.slots[s].pair) != pair)
    s = (s + 1) & (votes.number_of_slots - 1);
  return Link::to(first_of(pair) == root ? second_of(pair) : first_of(pair), __ldcg(&votes.slots[s].agreement) < 0);
}

/// Joins sets that touch by majority, as `join_by_votes()` on the CPU.
__global__ void __launch_bounds__(threads_of_voting_block)
  join_by_votes(Graph graph, Forest forest, Votes votes, double majority)
{
  const cooperative_groups::grid_group grid = cooperative_groups::this_grid();
  for_each(graph.size, [&](Wide i) {
    forest.best_votes[i] = -1;
    store(&forest.hooks[i], Link::to(unsigned(i), false));
    __stcg(&forest.best[i], no_edge);
  });
  for (unsigned round = 0; round < maximum_number_of_rounds; ++round)
  {
    for_each(votes.number_of_slots, [&](Wide s) {
      __stcg(&votes.slots[s].pair, no_pair);
      votes.slots[s].agreement = 0;
      votes.slots[s].total = 0;
    });
    grid.sync();
    for_each(votes.number_of_edges, [&](Wide n) {
      const Wide edge = votes.edges[n];
      const Wide i = edge / graph.k;
      const unsigned other = graph.nearest[edge];
      const Link a = load(&forest.roots[i]), b = load(&forest.roots[other]);
      if (a.target() == b.target())
        return;
      const float agreement = agreement_of(graph, i, other);
      add_vote(votes, Wide(min(a.target(), b.target())) << 32 | max(a.target(), b.target()),
               a.is_turned() == b.is_turned() ? agreement : -agreement);
    });
    grid.sync();
    const auto for_each_majority = [&](const auto& f) {
      for_each(votes.number_of_slots, [&](Wide s) {
        const Wide pair = __ldcg(&votes.slots[s].pair);
        if (pair == no_pair)
          return;
        const long long size = llabs(__ldcg(&votes.slots[s].agreement));
        if (double(size) >= majority * double(__ldcg(&votes.slots[s].total)))
          f(pair, size);
      });
    };
    for_each_majority([&](Wide pair, long long size) {
      atomicMax(&forest.best_votes[first_of(pair)], size);
      atomicMax(&forest.best_votes[second_of(pair)], size);
      note_change(forest, round);
    });
    grid.sync();
    if (__ldcg(&forest.is_changed[round]) == 0)
      return;
    for_each_majority([&](Wide pair, long long size) {
      for (const unsigned root : {first_of(pair), second_of(pair)})
        if (size == __ldcg(&forest.best_votes[root]))
          propose(&forest.best[root], pair);
    });
    grid.sync();
    for_each(graph.size, [&](Wide i) { __stcg(&forest.best_votes[i], -1ll); });
    join_sets(grid, forest, graph.size, [&](unsigned root) { return link_by_vote(votes, forest, root); });
  }
}

__global__ void count_samples_of_sets(const Link* sets, unsigned size, unsigned* sizes)
{
  const Wide i = thread_index();
  if (i >= size)
    return;
  const unsigned root = sets[i].target(), peers = __match_any_sync(__activemask(), root);
  if (is_leader_of(peers))
    atomicAdd(&sizes[root], unsigned(__popc(peers)));
}

__global__ void tell_sizes(const Link* sets, unsigned size, const unsigned* sizes, unsigned* sizes_of_samples)
{
  const Wide i = thread_index();
  if (i < size)
    sizes_of_samples[i] = sizes[sets[i].target()];
}

/// Sums over a tree, in fixed point: integers may be added in any order.
struct Tree_sums
{
  long long center[3];
  long long normal[3];
  long long flux, largest_flux;
  unsigned size;
  unsigned largest_sure_size;
};

/// \param scale units of the fixed-point numbers per length of the frame
struct Tree_scale
{
  double units_per_length;
  double units_per_normal;
};

/// Adds up over the threads of a warp that have the same root, so that a tree's sums are not the bottleneck.
__device__ void add(long long* sum, long long value, unsigned peers, bool is_leader)
{
  const long long total = peer_sum(peers, value);
  if (is_leader && total != 0)
    atomicAdd(reinterpret_cast<Wide*>(sum), Wide(total));
}

__global__ void find_centers(Forest forest, Samples samples, Tree_scale scale, Tree_sums* trees)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const unsigned root = forest.roots[i].target();
  const unsigned peers = __match_any_sync(__activemask(), root);
  const bool is_leader = is_leader_of(peers);
  Tree_sums& tree = trees[root];
  for (int axis = 0; axis < 3; ++axis)
    add(&tree.center[axis], __double2ll_rn(samples.positions[3 * i + axis] * scale.units_per_length), peers, is_leader);
  atomicMax(&tree.largest_sure_size, forest.sure_sizes[i]);
  if (is_leader)
    atomicAdd(&tree.size, unsigned(__popc(peers)));
}

__global__ void find_fluxes(Forest forest, Samples samples, Tree_scale scale, Tree_sums* trees,
                            unsigned* number_of_oriented)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const Link link = forest.roots[i];
  const unsigned root = link.target();
  const unsigned peers = __match_any_sync(__activemask(), root);
  const bool is_leader = is_leader_of(peers);
  Tree_sums& tree = trees[root];
  const double sign = link.is_turned() ? -1 : 1, length = 1 / scale.units_per_length / tree.size;
  const double3 from_center = {samples.positions[3 * i] - double(tree.center[0]) * length,
                               samples.positions[3 * i + 1] - double(tree.center[1]) * length,
                               samples.positions[3 * i + 2] - double(tree.center[2]) * length};
  const double3 normal = sign * to_double(xyz(samples.normals[i]));
  add(&tree.flux, __double2ll_rn(dot(normal, from_center) * scale.units_per_length), peers, is_leader);
  add(&tree.largest_flux, __double2ll_rn(sqrt(dot(from_center, from_center)) * scale.units_per_length), peers, is_leader);
  add(&tree.normal[0], __double2ll_rn(normal.x * scale.units_per_normal), peers, is_leader);
  add(&tree.normal[1], __double2ll_rn(normal.y * scale.units_per_normal), peers, is_leader);
  add(&tree.normal[2], __double2ll_rn(normal.z * scale.units_per_normal), peers, is_leader);
  const bool is_oriented = tree.size > 1 && forest.sure_sizes[i] == tree.largest_sure_size;
  const unsigned oriented = __ballot_sync(peers, is_oriented) & peers;
  if (is_leader && oriented)
    atomicAdd(number_of_oriented, unsigned(__popc(oriented)));
}

/// As `is_turned_inwards()` on the CPU.
__device__ bool is_turned_inwards(const Tree_sums& tree)
{
  const double rounding = 1e-9;
  if (fabs(double(tree.flux)) > rounding * double(tree.largest_flux))
    return tree.flux < 0;
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (llabs(tree.normal[other]) > llabs(tree.normal[axis]))
      axis = other;
  return tree.normal[axis] < 0;
}

__global__ void turn_normals(Forest forest, const Tree_sums* trees, Samples samples)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const Link link = forest.roots[i];
  if (is_turned_inwards(trees[link.target()]) == link.is_turned())
    return;
  const float4 n = samples.normals[i];
  samples.normals[i] = make_float4(-n.x, -n.y, -n.z, n.w);
}

/// Launches a kernel that waits for all its threads.
/// \param most_blocks on a multiprocessor: barriers take the longer the more blocks there are
void launch_cooperatively(const Workplace& workplace, void* kernel, unsigned size, unsigned threads, int most_blocks,
                          void** arguments)
{
  int blocks_per_multiprocessor = 0;
  CGAL_L0_CUDA_CHECK(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&blocks_per_multiprocessor, kernel, int(threads), 0));
  const unsigned room = unsigned((std::min)(blocks_per_multiprocessor, most_blocks) * workplace.number_of_multiprocessors);
  const unsigned blocks = (std::min)(room, unsigned((Wide(size) + threads - 1) / threads));
  CGAL_L0_CUDA_CHECK(cudaLaunchCooperativeKernel(kernel, dim3(blocks), dim3(threads), arguments, 0, workplace.stream));
}

} // namespace

double orient_normals(const Workplace& workplace, const double (&low)[3], const double (&high)[3],
                      unsigned number_of_neighbors, double spacing, const Samples& samples)
{
  const unsigned m = samples.size;
  const cudaStream_t stream = workplace.stream;
  const Arena_scope arena_scope(workplace.arena), scratch_scope(workplace.scratch);
  const unsigned* const nearest = find_nearest_samples(workplace, low, high, number_of_neighbors,
                                                       spacing * std::sqrt(double(number_of_neighbors) / 2), samples);
  Graph graph = {m,       number_of_neighbors,
                 nearest, workplace.arena.take<unsigned short>(Wide(m) * number_of_neighbors),
                 samples, float(spacing * spacing)};
  grade_edges<<<blocks_for(Wide(m) * number_of_neighbors), threads_per_block, 0, stream>>>(graph);
  check_launch("grade_edges");

  unsigned* const sure_sizes = workplace.arena.take<unsigned>(m);
  Forest forest = {workplace.arena.take<Link>(m),
                   workplace.arena.take<Link>(m),
                   workplace.arena.take<Wide>(m),
                   workplace.arena.take<long long>(m),
                   sure_sizes,
                   workplace.arena.take<unsigned>(maximum_number_of_rounds)};
  const auto forget_changes = [&]() {
    CGAL_L0_CUDA_CHECK(cudaMemsetAsync(forest.is_changed, 0, maximum_number_of_rounds * sizeof(unsigned), stream));
  };
  {
    const Arena_scope voting_scope(workplace.scratch);
    Votes votes;
    votes.edges = workplace.scratch.take<Wide>(Wide(m) * number_of_neighbors); // at most so many; mostly few
    {
      const Device_counter<unsigned> counter(workplace.scratch, stream);
      unsigned* number_of_edges = counter.address();
      forget_changes();
      void* arguments[] = {&graph, &forest, &votes.edges, &number_of_edges};
      launch_cooperatively(workplace, reinterpret_cast<void*>(grow_forest), m, threads_per_block, 4, arguments);
      votes.number_of_edges = counter.read();
    }
    votes.number_of_slots = 64;
    while (votes.number_of_slots < Wide(votes.number_of_edges) / 4 * 5 && votes.number_of_slots < 0x80000000u)
      votes.number_of_slots *= 2;
    votes.slots = workplace.arena.take<Vote>(votes.number_of_slots);

    // As on the CPU: the votes join faces to parts and parts to trees, unless the fields of faces and parts know better.
    Link *const faces = workplace.scratch.take<Link>(m), *const parts = workplace.scratch.take<Link>(m);
    const auto copy = [&](const Link* from, Link* to) {
      CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(to, from, m * sizeof(Link), cudaMemcpyDeviceToDevice, stream));
    };
    const auto join_by_majority = [&](double majority) {
      forget_changes();
      void* arguments[] = {&graph, &forest, &votes, &majority};
      launch_cooperatively(workplace, reinterpret_cast<void*>(join_by_votes), m, threads_of_voting_block, 1, arguments);
    };
    const auto join_faces_and_parts = [&]() {
      join_by_majority(clear_majority);
      copy(forest.roots, parts);
      join_by_majority(0);
    };
    const auto is_joined_by_field = [&](Link* sets) {
      return join_by_field(workplace, graph, votes.edges, votes.number_of_edges, forest.roots, spacing, sets);
    };
    copy(forest.roots, faces);
    join_faces_and_parts();
    if (is_joined_by_field(faces))
    {
      copy(faces, forest.roots);
      join_faces_and_parts();
    }
    {
      const Arena_scope sizes_scope(workplace.scratch);
      unsigned* const sizes = workplace.scratch.take<unsigned>(m);
      CGAL_L0_CUDA_CHECK(cudaMemsetAsync(sizes, 0, m * sizeof(unsigned), stream));
      count_samples_of_sets<<<blocks_for(m), threads_per_block, 0, stream>>>(parts, m, sizes);
      check_launch("count_samples_of_sets");
      tell_sizes<<<blocks_for(m), threads_per_block, 0, stream>>>(parts, m, sizes, sure_sizes);
      check_launch("tell_sizes");
    }
    if (is_joined_by_field(parts))
    {
      copy(parts, forest.roots);
      join_by_majority(0);
    }
  }

  double extent = 0;
  for (int axis = 0; axis < 3; ++axis)
    extent = (std::max)({extent, std::abs(low[axis]), std::abs(high[axis])});
  // 2^32 values below 2^30 units each do not overflow
  const Tree_scale scale = {std::ldexp(1., 28 - std::ilogb((std::max)(extent, 1.))), std::ldexp(1., 29)};
  Tree_sums* const trees = workplace.scratch.take<Tree_sums>(m);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(trees, 0, m * sizeof(Tree_sums), stream));
  const Device_counter<unsigned> number_of_oriented(workplace.scratch, stream);
  find_centers<<<blocks_for(m), threads_per_block, 0, stream>>>(forest, samples, scale, trees);
  check_launch("find_centers");
  find_fluxes<<<blocks_for(m), threads_per_block, 0, stream>>>(forest, samples, scale, trees,
                                                               number_of_oriented.address());
  check_launch("find_fluxes");
  turn_normals<<<blocks_for(m), threads_per_block, 0, stream>>>(forest, trees, samples);
  check_launch("turn_normals");
  return double(number_of_oriented.read()) / m;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
