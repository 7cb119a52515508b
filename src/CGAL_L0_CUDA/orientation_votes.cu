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

constexpr unsigned threads_of_voting_block = 1024;

// So few votes are left to one block of threads, which waits for itself only.
constexpr unsigned most_slots_of_block = 4096;

constexpr unsigned fewest_slots = 64;

/// The votes as the kernels see them.
struct Votes
{
  Vote* tables[2];
  unsigned number_of_slots; // of each table, at most
  Link* hooks;
  Wide* best;
  long long* best_votes;
  Voting_state* state;
};

__device__ Wide pair_of(unsigned a, unsigned b) { return Wide(min(a, b)) << 32 | max(a, b); }

/// \param count of the votes in the table
__device__ void add_vote(Vote* table, unsigned number_of_slots, unsigned* count, Wide pair, long long agreement,
                         long long total)
{
  const unsigned hash = unsigned(((pair ^ pair >> 32) * 0x9E3779B97F4A7C15u) >> 32);
  unsigned s = unsigned(Wide(hash) * number_of_slots >> 32);
  for (;; s = s + 1 < number_of_slots ? s + 1 : 0)
  {
    const Wide found = atomicCAS(&table[s].pair, 0ull, pair);
    if (found == 0)
      atomicAdd(count, 1u);
    if (found == 0 || found == pair)
      break;
  }
  atomicAdd(reinterpret_cast<Wide*>(&table[s].agreement), Wide(agreement));
  atomicAdd(reinterpret_cast<Wide*>(&table[s].total), Wide(total));
}

/// Slots for so many votes.
__device__ unsigned slots_for(unsigned count, unsigned most) { return min(max(2 * count, fewest_slots), most); }

__global__ void start_voting(unsigned size, Votes votes)
{
  const Wide i = thread_index();
  if (i == 0)
    votes.state->number_of_slots = votes.number_of_slots;
  if (i >= size)
    return;
  votes.hooks[i] = Link::to(unsigned(i), false);
  votes.best[i] = nothing;
  votes.best_votes[i] = -1;
}

__global__ void add_votes_of_edges(Graph graph, const Link* sets, Votes votes)
{
  const Wide i = thread_index();
  if (i >= graph.size)
    return;
  const Link own = sets[i];
  for_each_edge_between_sets(graph, sets, i, [&](unsigned other) {
    const Link link = sets[other];
    const long long units = __double2ll_rn(agreement_of(graph, i, other) * units_per_vote);
    add_vote(votes.tables[0], votes.number_of_slots, &votes.state->counts[0], pair_of(own.target(), link.target()),
             own.is_turned() == link.is_turned() ? units : -units, llabs(units));
  });
}

/// Runs rounds of joining, for the threads of a team.
/// \param is_done called after each round, with the slots that the next one looks at: whether that is for others to run
/// \returns whether all rounds were run
template <typename Team, typename F>
__device__ bool run_rounds(const Team& team, const Votes& votes, double majority, Voting_state& state, const F& is_done)
{
  const auto for_each_vote = [&](const auto& f) {
    for (Wide s = team.thread_rank(); s < state.number_of_slots; s += team.size())
    {
      const Vote* const vote = votes.tables[state.table] + s;
      if (const Wide pair = __ldcg(&vote->pair))
        f(pair, unsigned(pair >> 32), unsigned(pair), __ldcg(&vote->agreement), __ldcg(&vote->total));
    }
  };
  const auto for_each_majority = [&](const auto& f) {
    for_each_vote([&](Wide pair, unsigned a, unsigned b, long long agreement, long long total) {
      if (double(llabs(agreement)) >= majority * double(total))
        f(pair, a, b, agreement);
    });
  };

  while (state.round < 2 * maximum_number_of_rounds)
  {
    if (is_done())
      return false;
    const unsigned next_slots = slots_for(__ldcg(&votes.state->counts[state.round]), votes.number_of_slots);
    Vote* const next_table = votes.tables[1 - state.table];
    for (Wide s = team.thread_rank(); s < next_slots; s += team.size())
      next_table[s] = {0, 0, 0};
    unsigned* const is_changed = &votes.state->is_changed[state.round];
    for_each_majority([&](Wide, unsigned a, unsigned b, long long agreement) {
      atomicMax(&votes.best_votes[a], llabs(agreement));
      atomicMax(&votes.best_votes[b], llabs(agreement));
      note(is_changed);
    });
    team.sync();
    if (__ldcg(is_changed) == 0)
      return true;
    for_each_majority([&](Wide pair, unsigned a, unsigned b, long long agreement) {
      for (const unsigned root : {a, b})
        if (llabs(agreement) == __ldcg(&votes.best_votes[root]))
          propose(&votes.best[root], pair);
    });
    team.sync();
    for_each_majority([&](Wide pair, unsigned a, unsigned b, long long agreement) {
      const bool is_best_of_a = __ldcg(&votes.best[a]) == pair, is_best_of_b = __ldcg(&votes.best[b]) == pair;
      // two sets that chose each other chose one and the same: the lower root, which is a, stays
      if (is_best_of_b)
        store(&votes.hooks[b], Link::to(a, agreement < 0));
      else if (is_best_of_a)
        store(&votes.hooks[a], Link::to(b, agreement < 0));
    });
    team.sync();
    // Roots walk up, and shorten the way for those behind them: each word is a true statement at any time.
    for_each_vote([&](Wide, unsigned a, unsigned b, long long, long long) {
      for (const unsigned root : {a, b})
        store(&votes.hooks[root], follow(votes.hooks, load(&votes.hooks[root])));
    });
    team.sync();
    for_each_vote([&](Wide, unsigned a, unsigned b, long long agreement, long long total) {
      const Link to_a = load(&votes.hooks[a]), to_b = load(&votes.hooks[b]);
      for (const unsigned root : {a, b})
      {
        __stcg(&votes.best[root], nothing);
        __stcg(&votes.best_votes[root], -1ll);
      }
      if (to_a.target() != to_b.target())
        add_vote(next_table, next_slots, &votes.state->counts[state.round + 1], pair_of(to_a.target(), to_b.target()),
                 to_a.is_turned() == to_b.is_turned() ? agreement : -agreement, total);
    });
    team.sync();
    ++state.round;
    state.table = 1 - state.table;
    state.number_of_slots = next_slots;
  }
  return true;
}

__global__ void __launch_bounds__(threads_of_voting_block) join_by_votes(Votes votes, double majority)
{
  // a copy for each thread, all alike
  Voting_state state;
  state.table = __ldcg(&votes.state->table);
  state.number_of_slots = __ldcg(&votes.state->number_of_slots);
  state.round = __ldcg(&votes.state->round);
  const auto grid = cooperative_groups::this_grid();
  const auto block = cooperative_groups::this_thread_block();
  grid.sync(); // before one of them writes it
  const bool is_done = run_rounds(grid, votes, majority, state,
                                  [&]() { return state.number_of_slots <= most_slots_of_block; });
  if (blockIdx.x != 0)
    return;
  if (!is_done)
    run_rounds(block, votes, majority, state, []() { return false; });
  if (threadIdx.x == 0)
  {
    votes.state->table = state.table;
    votes.state->number_of_slots = state.number_of_slots;
    votes.state->round = state.round;
  }
}

__global__ void tell_joined(const Link* sets, const Link* hooks, unsigned size, Link* joined)
{
  const Wide i = thread_index();
  if (i < size)
    joined[i] = follow(hooks, sets[i]);
}

} // namespace

Voting::Voting(const Workplace& workplace, const Graph& graph, unsigned number_of_edges)
  : m_workplace(workplace), m_graph(graph), m_number_of_edges(number_of_edges),
    m_number_of_slots((std::max)(number_of_edges + number_of_edges / 4, fewest_slots)),
    m_hooks(workplace.scratch.take<Link>(graph.size)), m_best(workplace.scratch.take<Wide>(graph.size)),
    m_best_votes(workplace.scratch.take<long long>(graph.size)), m_tables{workplace.scratch.take<Vote>(m_number_of_slots),
                                                                          workplace.scratch.take<Vote>(m_number_of_slots)},
    m_state(workplace.scratch.take<Voting_state>(1))
{}

void Voting::begin(const Link* sets)
{
  const unsigned m = m_graph.size;
  const cudaStream_t stream = m_workplace.stream;
  m_sets = sets;
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(m_state, 0, sizeof(Voting_state), stream));
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(m_tables[0], 0, m_number_of_slots * sizeof(Vote), stream));
  const Votes votes = {{m_tables[0], m_tables[1]}, m_number_of_slots, m_hooks, m_best, m_best_votes, m_state};
  start_voting<<<blocks_for(m), threads_per_block, 0, stream>>>(m, votes);
  check_launch("start_voting");
  if (m_number_of_edges == 0)
    return;
  add_votes_of_edges<<<blocks_for(m), threads_per_block, 0, stream>>>(m_graph, sets, votes);
  check_launch("add_votes_of_edges");
}

void Voting::join(double majority, Link* joined) const
{
  const unsigned m = m_graph.size;
  if (m_number_of_edges > 0)
  {
    Votes votes = {{m_tables[0], m_tables[1]}, m_number_of_slots, m_hooks, m_best, m_best_votes, m_state};
    void* arguments[] = {&votes, &majority};
    launch_cooperatively(m_workplace, reinterpret_cast<void*>(join_by_votes), m_number_of_slots,
                         threads_of_voting_block, 1, arguments);
  }
  tell_joined<<<blocks_for(m), threads_per_block, 0, m_workplace.stream>>>(m_sets, m_hooks, m, joined);
  check_launch("tell_joined");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
