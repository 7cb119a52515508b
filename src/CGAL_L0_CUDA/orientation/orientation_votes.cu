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

constexpr unsigned threads_of_voting_block = 512;

// So few votes are left to one block of threads, which waits for itself only.
constexpr unsigned maximum_number_of_slots_of_block = 4096;

constexpr unsigned minimum_number_of_slots = 64;

/// The votes as the kernels see them.
struct Votes
{
  Vote* slots;
  unsigned slots_of_table; // of two, one behind the other
  Link* hooks;
  Wide* best;
  Voting_state* state;

  __device__ Vote* table(unsigned t) const { return slots + Wide(t) * slots_of_table; }
};

__device__ Wide pair_of(unsigned a, unsigned b) { return Wide(min(a, b)) << 32 | max(a, b); }

__device__ Wide hash_of(Wide pair) { return (pair ^ pair >> 32) * 0x9E3779B97F4A7C15u; }

/// Which of so many parts of about equal size a pair belongs to, whatever its place in a table.
__device__ unsigned part_of(Wide pair, unsigned number_of_parts)
{
  const Wide hash = hash_of(pair), mixed = (hash ^ hash >> 29) * 0xBF58476D1CE4E5B9u;
  return unsigned((mixed >> 32) * number_of_parts >> 32);
}

/// \param is_full null for a table that has room for all; else the vote may be left out, which is
/// noted there
/// \returns whether it is the first of its pair
__device__ bool add_vote(Vote* table, unsigned number_of_slots, Wide pair, long long agreement,
                         long long total, unsigned* is_full)
{
  // Strides of their own lead pairs away from places where many meet: a warp waits for the longest
  // of its searches. One after the other, in the end, they see all slots.
  const unsigned number_of_strides = 32, longest_search = 4096;
  const Wide hash = hash_of(pair);
  const unsigned stride = unsigned((hash & 0xffffffff) * number_of_slots >> 32);
  unsigned s = unsigned((hash >> 32) * number_of_slots >> 32);
  Wide found;
  for (unsigned search = 0;; ++search)
  {
    if (is_full != nullptr && search == min(longest_search, number_of_slots))
    {
      note(is_full);
      return false;
    }
    found = __ldcg(&table[s].pair);
    if (found == 0)
      found = atomicCAS(&table[s].pair, 0ull, pair);
    if (found == 0 || found == pair)
      break;
    s += search < number_of_strides ? stride : 1;
    s = s < number_of_slots ? s : s - number_of_slots;
  }
  atomicAdd(reinterpret_cast<Wide*>(&table[s].agreement), Wide(agreement));
  atomicAdd(reinterpret_cast<Wide*>(&table[s].total), Wide(total));
  return found == 0;
}

/// Slots for so many votes, if a table can have them.
__device__ unsigned slots_for(unsigned count, unsigned most)
{
  return min(max(2 * count, minimum_number_of_slots), most);
}

/// Slots without which looking for a free one takes long.
__host__ __device__ constexpr Wide minimum_number_of_slots_for(unsigned count)
{
  return Wide(count) + count / 4;
}

/// The vote that a root joins another set by: the larger, the better; of equal ones, that with the
/// lower root. None is 0.
__device__ Wide rank_of_vote(long long agreement, unsigned other)
{
  const unsigned size = __float_as_uint(float(llabs(agreement)));
  return Wide(size) << 32 | (maximum_number_of_linked_samples - other) << 1
         | unsigned(agreement < 0);
}

__device__ Link link_by_vote(Wide rank)
{
  return Link::to(maximum_number_of_linked_samples - (unsigned(rank) >> 1), rank & 1);
}

__device__ void propose_vote(Wide* best, Wide rank)
{
  if (rank > __ldcg(best))
    atomicMax(best, rank);
}

/// Hooks a root to where its best vote leads.
__device__ void hook(const Votes& votes, unsigned root, Link link)
{
  // two sets that chose each other chose one and the same: the lower root stays
  const Wide of_other = __ldcg(&votes.best[link.target()]);
  const bool is_mutual = of_other != 0 && link_by_vote(of_other).target() == root;
  if (!is_mutual || link.target() < root)
    store(&votes.hooks[root], link);
}

/// Where a root is hooked to in the end. Shortens the way for those behind it: each word is a true
/// statement at any time.
__device__ Link walk_up(const Votes& votes, unsigned root)
{
  const Link link = follow(votes.hooks, load(&votes.hooks[root]));
  store(&votes.hooks[root], link);
  return link;
}

/// Adds up over a warp, all of which has to call it, and adds that to the count.
__device__ void add_count(unsigned* count, unsigned of_thread)
{
  const unsigned sum = group_sum<32>(of_thread);
  if (threadIdx.x % 32 == 0 && sum > 0)
    atomicAdd(count, sum);
}

__global__ void start_voting(unsigned size, Votes votes)
{
  const Wide i = thread_index();
  if (i >= size)
    return;
  votes.hooks[i] = Link::to(unsigned(i), false);
  votes.best[i] = 0;
}

/// For the threads of a team: calls `f(pair, agreement, total)` for the votes in some slots.
template <typename Team, typename F>
__device__ void for_each_vote(const Team& team, const Vote* table, unsigned number_of_slots,
                              const F& f)
{
  for (Wide s = team.thread_rank(); s < number_of_slots; s += team.size())
    if (const Wide pair = __ldcg(&table[s].pair); pair != 0)
      f(pair, __ldcg(&table[s].agreement), __ldcg(&table[s].total));
}

template <typename Team>
__device__ void clear_slots(const Team& team, Vote* table, unsigned number_of_slots)
{
  for (Wide s = team.thread_rank(); s < number_of_slots; s += team.size())
    table[s] = {0, 0, 0};
}

/// Proposes the votes in some slots to the roots of their sets.
template <typename Team>
__device__ void propose_votes(const Team& team, const Votes& votes, const Vote* table,
                              unsigned number_of_slots, double majority, unsigned* is_changed)
{
  for_each_vote(team, table, number_of_slots, [&](Wide pair, long long agreement, long long total) {
    if (double(llabs(agreement)) < majority * double(total))
      return;
    const unsigned a = unsigned(pair >> 32), b = unsigned(pair);
    propose_vote(&votes.best[a], rank_of_vote(agreement, b));
    propose_vote(&votes.best[b], rank_of_vote(agreement, a));
    note(is_changed);
  });
}

/*!
Calls `f(i, other)` for each pair of neighbors that is wanted, once, for the threads of a team, in
whole warps. Few of the pairs that a warp looks at are wanted: they wait until there is one for each
thread.
\param is_wanted called with the pairs
*/
template <typename Team, typename Is_wanted, typename F>
__device__ void for_each_wanted_pair(const Team& team, const Graph& graph,
                                     const Is_wanted& is_wanted, const F& f)
{
  __shared__ uint2 queues[threads_of_voting_block / 32][64];
  uint2* const queue = queues[threadIdx.x / 32];
  const unsigned lane = threadIdx.x % 32, all = 0xffffffffu;
  const Wide end = Wide(graph.size) * lanes_of_edges;
  unsigned length = 0;
  for (Wide first = team.thread_rank() - lane; first < end; first += team.size())
  {
    const Wide i = (first + lane) / lanes_of_edges;
    for (unsigned first_edge = 0; first_edge < graph.k; first_edge += lanes_of_edges)
    {
      const unsigned e = first_edge + lane % lanes_of_edges;
      const unsigned other = i < graph.size && e < graph.k ? graph.nearest[i * graph.k + e]
                                                           : nobody;
      const bool waits = other < is_listed_by_other && is_wanted(unsigned(i), other);
      const unsigned waiting = __ballot_sync(all, waits);
      if (waits)
        queue[length + unsigned(__popc(waiting & ((1u << lane) - 1)))] = {unsigned(i), other};
      length += unsigned(__popc(waiting));
      __syncwarp();
      if (length < 32)
        continue;
      length -= 32;
      const uint2 pair = queue[length + lane];
      __syncwarp();
      f(pair.x, pair.y);
    }
  }
  if (lane < length)
    f(queue[lane].x, queue[lane].y);
  __syncwarp();
}

/// Counts the votes of the edges between sets, those of one part of the pairs.
/// \param sets the root of each sample now
/// \param count out: of pairs
/// \param is_full as of `add_vote()`
template <typename Team>
__device__ void count_votes_of_edges(const Team& team, const Graph& graph, const Link* sets,
                                     unsigned part, unsigned number_of_parts, Vote* table,
                                     unsigned number_of_slots, unsigned* count, unsigned* is_full)
{
  unsigned own_count = 0;
  const auto is_wanted = [&](unsigned i, unsigned other) {
    const unsigned a = load(sets + i).target(), b = load(sets + other).target();
    return a != b && (number_of_parts == 1 || part_of(pair_of(a, b), number_of_parts) == part);
  };
  for_each_wanted_pair(team, graph, is_wanted, [&](unsigned i, unsigned other) {
    const Link a = load(sets + i), b = load(sets + other);
    const Wide pair = pair_of(a.target(), b.target());
    const long long units = __double2ll_rn(agreement_of(graph, i, other) * units_per_vote);
    own_count += add_vote(table, number_of_slots, pair,
                          a.is_turned() == b.is_turned() ? units : -units, llabs(units), is_full);
  });
  add_count(count, own_count);
}

/// Runs rounds of joining with votes from the edges, until these fit into a table, which is then
/// filled.
/// \param number_of_edges between sets, at most
/// \param joined the root of each sample, before and after
/// \returns whether all rounds were run
__device__ bool run_rounds_over_edges(const cooperative_groups::grid_group& grid,
                                      const Graph& graph, const Votes& votes,
                                      unsigned number_of_edges, double majority,
                                      Voting_state& state, Link* joined)
{
  for (; 2 * maximum_number_of_rounds > state.round; ++state.round)
  {
    const unsigned maximum_number_of_votes = state.round > 0
                                               ? __ldcg(&votes.state->counts[state.round - 1])
                                               : number_of_edges;
    unsigned* const count = &votes.state->counts[state.round];
    if (minimum_number_of_slots_for(maximum_number_of_votes) <= votes.slots_of_table)
    {
      state.has_table = 1;
      state.table = 0;
      state.number_of_slots = slots_for(maximum_number_of_votes, votes.slots_of_table);
      clear_slots(grid, votes.table(0), state.number_of_slots);
      grid.sync();
      count_votes_of_edges(grid, graph, joined, 0, 1, votes.table(0), state.number_of_slots, count,
                           nullptr);
      grid.sync();
      return false;
    }
    const Wide number_of_slots = 2 * Wide(votes.slots_of_table); // both tables are one
    const unsigned minimum_number_of_parts = unsigned(
      (minimum_number_of_slots_for(maximum_number_of_votes) + number_of_slots - 1)
      / number_of_slots);
    unsigned* const is_changed = &votes.state->is_changed[state.round];
    for (unsigned part = 0; part < minimum_number_of_parts << state.number_of_doublings;)
    {
      unsigned* const is_full = &votes.state->is_full[state.number_of_doublings];
      clear_slots(grid, votes.slots, unsigned(number_of_slots));
      grid.sync();
      count_votes_of_edges(grid, graph, joined, part,
                           minimum_number_of_parts << state.number_of_doublings, votes.slots,
                           unsigned(number_of_slots), count, is_full);
      grid.sync();
      if (__ldcg(is_full)
          // by an uneven hash: once more from the first part; what was proposed will be proposed
          // again
          != 0)
      {
        ++state.number_of_doublings;
        part = 0;
        if (grid.thread_rank() == 0)
          *count = 0;
        continue;
      }
      propose_votes(grid, votes, votes.slots, unsigned(number_of_slots), majority, is_changed);
      grid.sync();
      ++part;
    }
    if (__ldcg(is_changed) == 0)
    {
      ++state.round; // whose votes are those of this one
      return true;
    }
    for_each(graph.size, [&](Wide i) {
      if (const Wide best = __ldcg(&votes.best[i]))
        hook(votes, unsigned(i), link_by_vote(best));
    });
    grid.sync();
    for_each(graph.size, [&](Wide i) {
      const Link link = load(joined + i);
      store(joined + i, link + walk_up(votes, link.target()));
      __stcg(&votes.best[i], 0ull);
    });
    grid.sync();
  }
  return true;
}

/// Runs rounds of joining with votes in a table, for the threads of a team.
/// \param is_done called before each round, whether that is for others to run
/// \returns whether all rounds were run
template <typename Team, typename F>
__device__ bool run_rounds(const Team& team, const Votes& votes, double majority,
                           Voting_state& state, const F& is_done)
{
  while (state.round < 2 * maximum_number_of_rounds)
  {
    if (is_done())
      return false;
    const Vote* const table = votes.table(state.table);
    Vote* const next_table = votes.table(1 - state.table);
    const unsigned next_slots = slots_for(__ldcg(&votes.state->counts[state.round]),
                                          votes.slots_of_table);
    unsigned* const is_changed = &votes.state->is_changed[state.round];
    clear_slots(team, next_table, next_slots);
    propose_votes(team, votes, table, state.number_of_slots, majority, is_changed);
    team.sync();
    if (__ldcg(is_changed) == 0)
      return true;
    for_each_vote(team, table, state.number_of_slots, [&](Wide pair, long long, long long) {
      const unsigned roots[2] = {unsigned(pair >> 32), unsigned(pair)};
      for (int k = 0; k < 2; ++k)
      {
        const Wide best = __ldcg(&votes.best[roots[k]]);
        if (best != 0 && link_by_vote(best).target() == roots[1 - k])
          hook(votes, roots[k], link_by_vote(best));
      }
    });
    team.sync();
    unsigned own_count = 0;
    for_each_vote(
      team, table, state.number_of_slots, [&](Wide pair, long long agreement, long long total) {
        const unsigned a = unsigned(pair >> 32), b = unsigned(pair);
        const Link to_a = walk_up(votes, a), to_b = walk_up(votes, b);
        __stcg(&votes.best[a], 0ull);
        __stcg(&votes.best[b], 0ull);
        if (to_a.target() != to_b.target())
          own_count += add_vote(next_table, next_slots, pair_of(to_a.target(), to_b.target()),
                                to_a.is_turned() == to_b.is_turned() ? agreement : -agreement,
                                total, nullptr);
      });
    add_count(&votes.state->counts[state.round + 1], own_count);
    team.sync();
    ++state.round;
    state.table = 1 - state.table;
    state.number_of_slots = next_slots;
  }
  return true;
}

__global__ void __launch_bounds__(threads_of_voting_block, 2)
  join_by_votes(Graph graph, Votes votes, unsigned number_of_edges, double majority,
                const Link* sets, Link* joined)
{
  // a copy for each thread, all alike
  Voting_state state;
  state.has_table = __ldcg(&votes.state->has_table);
  state.table = __ldcg(&votes.state->table);
  state.number_of_slots = __ldcg(&votes.state->number_of_slots);
  state.round = __ldcg(&votes.state->round);
  state.number_of_doublings = __ldcg(&votes.state->number_of_doublings);
  const auto grid = cooperative_groups::this_grid();
  const auto block = cooperative_groups::this_thread_block();
  if (!state.has_table)
    for_each(graph.size, [&](Wide i) { store(joined + i, follow(votes.hooks, sets[i])); });
  grid.sync(); // before one of them writes the state
  bool is_done = !state.has_table
                 && run_rounds_over_edges(grid, graph, votes, number_of_edges, majority, state,
                                          joined);
  const bool has_table = state.has_table;
  if (has_table)
    is_done = run_rounds(grid, votes, majority, state, [&]() {
      return state.number_of_slots <= maximum_number_of_slots_of_block;
    });
  if (blockIdx.x != 0)
    return;
  if (!is_done)
    run_rounds(block, votes, majority, state, []() { return false; });
  if (threadIdx.x == 0)
  {
    votes.state->has_table = state.has_table;
    votes.state->table = state.table;
    votes.state->number_of_slots = state.number_of_slots;
    votes.state->round = state.round;
    votes.state->number_of_doublings = state.number_of_doublings;
  }
}

__global__ void tell_joined(const Link* sets, const Link* hooks, unsigned size, Link* joined)
{
  const Wide i = thread_index();
  if (i < size)
    joined[i] = follow(hooks, sets[i]);
}

/// As many as the votes of all edges need, but no more than there is room for anyway, or than twice
/// the samples. How many there are changes no result.
unsigned slots_of_table(const Device_arena& arena, unsigned number_of_samples,
                        unsigned number_of_edges)
{
  const std::size_t of_others = 20 * std::size_t(number_of_samples)
                                + bytes_of_field; // `Voting` and the field take it
  const std::size_t room = arena.room() > of_others
                             ? (arena.room() - of_others) / (2 * sizeof(Vote))
                             : 0;
  const Wide most = (std::min)((std::max)(Wide(room), 2 * Wide(number_of_samples)),
                               Wide(0x7fffffff));
  return unsigned((std::max)((std::min)(minimum_number_of_slots_for(number_of_edges), most),
                             Wide(minimum_number_of_slots)));
}

} // namespace

Voting::Voting(const Execution_context& context, const Graph& graph, unsigned number_of_edges)
  : m_context(context), m_graph(graph), m_number_of_edges(number_of_edges),
    m_slots_of_table(slots_of_table(context.scratch, graph.size, number_of_edges)),
    m_slots(context.scratch.take<Vote>(2 * std::size_t(m_slots_of_table))),
    m_hooks(context.scratch.take<Link>(graph.size)), m_best(context.scratch.take<Wide>(graph.size)),
    m_state(context.scratch.take<Voting_state>(1))
{}

void Voting::begin(const Link* sets)
{
  const unsigned m = m_graph.size;
  const cudaStream_t stream = m_context.stream;
  m_sets = sets;
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(m_state, 0, sizeof(Voting_state), stream));
  start_voting<<<blocks_for(m), threads_per_block, 0, stream>>>(m, {m_slots, m_slots_of_table,
                                                                    m_hooks, m_best, m_state});
  check_launch("start_voting");
}

void Voting::join(double majority, Link* joined) const
{
  const unsigned m = m_graph.size;
  if (m_number_of_edges > 0)
  {
    Graph graph = m_graph;
    Votes votes = {m_slots, m_slots_of_table, m_hooks, m_best, m_state};
    unsigned number_of_edges = m_number_of_edges;
    const Link* sets = m_sets;
    void* arguments[] = {&graph, &votes, &number_of_edges, &majority, &sets, &joined};
    launch_cooperatively(m_context, reinterpret_cast<void*>(join_by_votes),
                         Wide(m) * lanes_of_edges, threads_of_voting_block, 2, arguments);
  }
  tell_joined<<<blocks_for(m), threads_per_block, 0, m_context.stream>>>(m_sets, m_hooks, m,
                                                                         joined);
  check_launch("tell_joined");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
