// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_ORIENTATION_CUH
#define CGAL_L0_CUDA_ORIENTATION_CUH

#include "driver/stages.cuh"
#include "search/nearest_samples.cuh"

#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Samples that links can tell apart.
constexpr unsigned maximum_number_of_linked_samples = (1u << 31) - 1;

/// What has to turn for `i` to fit `target`: the target's index, and whether the signs differ. One
/// word, so that it is read and written at once.
struct Link
{
  unsigned word;

  __device__ static Link to(unsigned target, bool is_turned)
  {
    return {target << 1 | unsigned(is_turned)};
  }
  __device__ unsigned target() const { return word >> 1; }
  __device__ bool is_turned() const { return word & 1; }
};

/// The way from a sample to where the target of its link leads.
__device__ inline Link operator+(Link first, Link second)
{
  return Link::to(second.target(), first.is_turned() ^ second.is_turned());
}

// Links that other threads may write at the same time.
__device__ inline Link load(const Link* link) { return {__ldcg(&link->word)}; }
__device__ inline void store(Link* link, Link value) { __stcg(&link->word, value.word); }

/// A sample that stands for those around it.
struct Dipole
{
  double3 position, normal; // that in the sense of its set
  unsigned root;            // of the set
};

/// The k-th of so many dipoles.
__device__ inline Dipole dipole_of(const Samples& samples, const Link* sets, Wide k,
                                   unsigned number_of_dipoles)
{
  const unsigned i = unsigned(sample_of_dipole(k, samples.size, number_of_dipoles));
  const Link link = sets[i];
  const double* const p = samples.positions + 3 * Wide(i);
  return {{p[0], p[1], p[2]},
          (link.is_turned() ? -1. : 1.) * to_double(xyz(samples.normals[i])),
          link.target()};
}

/// Set in what sample i lists as a neighbor: that sample lists i too, and has the pair for both. It
/// is set where there is nobody, too.
constexpr unsigned is_listed_by_other = 1u << 31;

/// The graph of nearest neighbors: edge `i k + e` leads from sample i to its e-th neighbor.
struct Graph
{
  unsigned size;
  unsigned k;
  unsigned* nearest; // with the bit `is_listed_by_other` once the forest has grown
  Samples samples;
  float squared_spacing;
  bool has_tolerances; // whether the fourth numbers of the normals are `squared_height_tolerance()`

  __device__ unsigned neighbor(Wide edge) const { return nearest[edge] & ~is_listed_by_other; }
};

/// Threads that share the edges of a sample.
constexpr unsigned lanes_of_edges = 4;

/// Calls `f(i, other)` for each pair of neighbors once.
/// \param thread of `number_of_threads` that share the work
template <typename F>
__device__ void for_each_pair_of_neighbors(const Graph& graph, Wide thread, Wide number_of_threads,
                                           const F& f)
{
  for (Wide t = thread; t < Wide(graph.size) * lanes_of_edges; t += number_of_threads)
  {
    const unsigned i = unsigned(t / lanes_of_edges);
    for (unsigned e = t % lanes_of_edges; e < graph.k; e += lanes_of_edges)
      if (const unsigned other = graph.nearest[Wide(i) * graph.k + e]; other < is_listed_by_other)
        f(i, other);
  }
}

/// Calls `f(i)` for i below `size`, by all threads of a launch that fits on the device at once.
template <typename F>
__device__ void for_each(Wide size, const F& f)
{
  const Wide number_of_threads = Wide(gridDim.x) * blockDim.x;
  for (Wide i = thread_index(); i < size; i += number_of_threads)
    f(i);
}

__device__ inline void propose(Wide* best, Wide rank)
{
  if (rank < __ldcg(best))
    atomicMin(best, rank);
}

__device__ inline void note(unsigned* flag)
{
  if (__ldcg(flag) == 0)
    __stcg(flag, 1u);
}

/// Where a root is hooked to in the end: follows the links as far as they lead.
__device__ inline Link follow(const Link* hooks, Link link)
{
  while (true)
  {
    const Link next = load(hooks + link.target());
    if (next.target() == link.target())
      return link;
    link = link + next;
  }
}

/// In place of the best edge of a root.
constexpr Wide nothing = ~Wide(0);

/// Rounds of joining: each halves the sets that can be joined, at least.
constexpr unsigned maximum_number_of_rounds = 80;

/// Launches a kernel that waits for all its threads.
/// \param maximum_number_of_blocks on a multiprocessor: barriers take the longer the more blocks
/// there are
void launch_cooperatively(const Execution_context& context, void* kernel, unsigned long long size,
                          unsigned threads, int maximum_number_of_blocks, void** arguments);

/// Grades the edges, marks the pairs that are listed twice, and joins the samples over those beyond
/// doubt until sets are large.
/// \param faces the root of each sample; in: of what is joined from the start
/// \returns the number of edges between different sets; waits for the device
unsigned grow_forest(const Execution_context& context, const Graph& graph, Link* faces);

/// Votes are added up in fixed point: integers may be added in any order.
constexpr double units_per_vote = 4294967296.;

/// `orientation_agreement()` of two samples.
__device__ inline float agreement_of(const Graph& graph, Wide i, unsigned other)
{
  const double* const p = graph.samples.positions + 3 * i;
  const double* const q = graph.samples.positions + 3 * Wide(other);
  const float3 e = {float(q[0] - p[0]), float(q[1] - p[1]), float(q[2] - p[2])};
  const float4 own = graph.samples.normals[i], others = graph.samples.normals[other];
  const float3 n = xyz(own), other_n = xyz(others);
  return orientation_agreement(dot(n, other_n), dot(n, e), -dot(other_n, e),
                               graph.has_tolerances ? fmaxf(own.w, others.w)
                                                    : graph.squared_spacing);
}

/// Finds the tolerances of a graph of points as they were measured, as
/// `squared_height_tolerances()` on the CPU.
/// \param graph before the forest has grown
void find_height_tolerances(const Execution_context& context, const Graph& graph, double spacing,
                            double noise_of_heights);

/// As `turn_outvoted()` on the CPU.
/// \param voters a graph of more neighbors, no pair of which is marked, with tolerances
/// \param trees the root of each sample
/// \param sums out: of the normals around each sample
void turn_outvoted(const Execution_context& context, const Graph& voters, const Link* trees,
                   const Side_hints& hints, float3* sums);

/// All edges between two sets, added up in fixed point: integers may be added in any order.
struct Vote
{
  Wide pair; // the roots, the higher one in the lower bits; 0, which is no pair, in an empty slot
  long long agreement, total;
};

/// How far the rounds are.
struct Voting_state
{
  unsigned
    has_table; // whether the votes are in a table, and need not be counted from the edges any more
  unsigned table;           // which one holds them
  unsigned number_of_slots; // of it
  unsigned round;
  unsigned number_of_doublings; // of the parts that the votes are counted in
  unsigned is_full[16];         // for each such number, whether a part was too large for the tables
  unsigned is_changed[2 * maximum_number_of_rounds];
  unsigned counts[2 * maximum_number_of_rounds + 1]; // of votes, at the beginning of each round
};

/*!
The votes of the edges between sets, in hash tables, and who was joined by them. There may be
several times as many votes as samples at first, and a fraction of that a few rounds later. So the
first rounds count them from the edges, a part at a time if there is no room for all; once they fit
into a table, rounds pass them on from one table to another.
*/
class Voting
{
  const Execution_context& m_context;
  const Graph& m_graph;
  unsigned m_number_of_edges, m_slots_of_table;
  const Link* m_sets = nullptr; // before any was joined
  Vote* m_slots;                // of two tables
  Link* m_hooks;                // of each root: where it was hooked to
  Wide* m_best;                 // of each root: the vote that it joins another set by
  Voting_state* m_state;

public:
  /// Takes its arrays from the scratch arena.
  /// \param number_of_edges between sets, at most
  Voting(const Execution_context& context, const Graph& graph, unsigned number_of_edges);

  /// Lets the edges between the sets vote.
  /// \param sets the root of each sample
  void begin(const Link* sets);

  /// Joins sets that touch by majority, round by round, as `join_by_votes()` on the CPU.
  /// \param majority the share of the votes that the winning side has to be ahead by
  /// \param joined out: the root of each sample
  void join(double majority, Link* joined) const;
};

/// What `join_by_field()` takes from the scratch arena beside a number for each sample: two tables
/// of sets by sets, one of dipoles by sets, and the dipoles.
constexpr std::size_t bytes_of_field =
  2 * sizeof(long long) * maximum_number_of_sets * maximum_number_of_sets
  + sizeof(float) * maximum_number_of_dipoles * maximum_number_of_sets
  + 88 * std::size_t(maximum_number_of_dipoles) + (std::size_t(1) << 16);

/// Joins the larger ones of connected sets if their field asks to turn some of them
/// against the others, as `join_by_field()` on the CPU.
/// \param trees what the votes make of the sets
/// \param sets in and out: the root of each sample
/// \returns whether any was turned; if not, nothing was joined. Waits for the device
bool join_by_field(const Execution_context& context, const Graph& graph, const Link* trees,
                   double spacing, Link* sets);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_ORIENTATION_CUH
