// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation.cuh"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

constexpr unsigned no_set = ~0u;
constexpr unsigned threads_of_turning_block = 704; // one for each set
static_assert(threads_of_turning_block >= maximum_number_of_sets, "too few threads for the sets");
static_assert(threads_of_turning_block % 32 == 0, "warps are whole");

/// A sample that stands for those around it.
struct Dipole
{
  double3 position, normal; // that in the sense of its set
  unsigned tree;            // of its set, if that has another set of the field in it; or `no_set`
  unsigned set;
};

/// The larger sets of samples, and how far they agree two by two, in fixed point.
struct Field
{
  Dipole* dipoles;
  unsigned* roots_of_dipoles;
  unsigned* trees_of_dipoles;
  unsigned number_of_dipoles;
  unsigned*
    // of each dipole that is the first one of its set: how many dipoles that has; of others 0
    sizes_of_sets;
  unsigned* number_of_all_sets;  // that have a dipole
  unsigned char* stands_for_set; // of each dipole: the first one of a set of the field
  double area;                   // that a dipole stands for
  double spacing;                // of the samples
  unsigned*
    set_of_root; // of each sample that is a root: its number among the larger sets, or `no_set`
  unsigned* number_of_sets;
  unsigned* roots; // of the sets
  unsigned* trees; // that they belong to
  int* signs;      // relative to the tree
  long long*
    // a row of `maximum_number_of_sets` for each set; those of a and b, and of b and a, stand for
    // each other
    agreements;
  long long* links; // of groups of sets, as many

  __device__ long long* row(unsigned set) const
  {
    return agreements + Wide(set) * maximum_number_of_sets;
  }
  __device__ bool are_of_one_tree(unsigned a, unsigned b) const
  {
    return a != no_set && b != no_set && a != b && trees[a] == trees[b];
  }
};

__device__ void add_to(long long* sum, long long value)
{
  atomicAdd(reinterpret_cast<Wide*>(sum), Wide(value));
}

__global__ void place_dipoles(Field field, Samples samples, const Link* sets)
{
  const Wide k = thread_index();
  if (k >= field.number_of_dipoles)
    return;
  const unsigned i = unsigned(sample_of_dipole(k, samples.size, field.number_of_dipoles));
  const Link link = sets[i];
  const double* const p = samples.positions + 3 * Wide(i);
  field.dipoles[k] = {{p[0], p[1], p[2]},
                      (link.is_turned() ? -1. : 1.) * to_double(xyz(samples.normals[i])),
                      no_set,
                      no_set};
  field.roots_of_dipoles[k] = link.target();
}

/// One warp for each dipole.
__global__ void find_sets(Field field, const Link* trees)
{
  const Wide k = thread_index() / 32;
  if (k >= field.number_of_dipoles) // whole warps leave
    return;
  const unsigned root = field.roots_of_dipoles[k];
  unsigned count = 0;
  bool is_first = true;
  for (unsigned other = threadIdx.x % 32; other < field.number_of_dipoles; other += 32)
    if (field.roots_of_dipoles[other] == root)
    {
      ++count;
      is_first = is_first && other >= k;
    }
  count = group_sum<32>(count);
  is_first = __all_sync(0xffffffffu, is_first);
  if (threadIdx.x % 32 != 0)
    return;
  field.trees_of_dipoles[k] = trees[root].target();
  field.sizes_of_sets[k] = is_first ? count : 0;
  if (is_first)
    atomicAdd(field.number_of_all_sets, 1u);
}

/// The larger sets of the trees that these stand for. One warp for each dipole.
__global__ void choose_sets(Field field, unsigned number_of_samples)
{
  const Wide k = thread_index() / 32;
  if (k >= field.number_of_dipoles) // whole warps leave
    return;
  const unsigned fewest = fewest_dipoles_of_a_set(number_of_samples, *field.number_of_all_sets);
  const bool is_large = field.sizes_of_sets[k] >= fewest;
  const unsigned tree = field.trees_of_dipoles[k];
  const unsigned end = is_large ? field.number_of_dipoles : 0;
  unsigned count = 0, count_of_large_sets = 0;
#pragma unroll 8 // so that the memory has several reads to do at once
  for (unsigned other = threadIdx.x % 32; other < end; other += 32)
  {
    const unsigned size_of_set = field.sizes_of_sets[other],
                   other_tree = field.trees_of_dipoles[other];
    const unsigned size = other_tree == tree ? size_of_set : 0;
    count += size;
    count_of_large_sets += size >= fewest ? size : 0;
  }
  count = group_sum<32>(count);
  count_of_large_sets = group_sum<32>(count_of_large_sets);
  if (threadIdx.x % 32 == 0)
    field.stands_for_set[k] = is_large && stand_for_tree(count_of_large_sets, count);
}

/// Numbers the sets of the field by their roots. One warp for each dipole.
__global__ void number_sets(Field field, const Link* trees)
{
  const Wide k = thread_index() / 32;
  if (k >= field.number_of_dipoles || !field.stands_for_set[k]) // whole warps leave
    return;
  const unsigned root = field.roots_of_dipoles[k];
  unsigned set = 0;
  for (unsigned other = threadIdx.x % 32; other < field.number_of_dipoles; other += 32)
    set += unsigned(field.stands_for_set[other]) & unsigned(field.roots_of_dipoles[other] < root);
  set = group_sum<32>(set);
  if (threadIdx.x % 32 != 0)
    return;
  const Link link = trees[root];
  field.set_of_root[root] = set;
  field.roots[set] = root;
  field.trees[set] = link.target();
  field.signs[set] = link.is_turned() ? -1 : 1;
  atomicAdd(field.number_of_sets, 1u);
}

__global__ void find_trees_of_dipoles(Field field)
{
  const Wide k = thread_index();
  if (k >= field.number_of_dipoles)
    return;
  const unsigned set = field.set_of_root[field.roots_of_dipoles[k]], size = *field.number_of_sets;
  if (set == no_set)
    return;
  bool has_rival = false;
  for (unsigned other = 0; other < size; ++other)
    has_rival = has_rival || (other != set && field.trees[other] == field.trees[set]);
  field.dipoles[k].set = set;
  if (has_rival)
    field.dipoles[k].tree = field.trees[set];
}

/// One block for each dipole: its agreement with all those behind it.
__global__ void add_dipoles(Field field)
{
  __shared__ long long sums[maximum_number_of_sets];
  const Dipole a = field.dipoles[blockIdx.x];
  if (a.tree == no_set)
    return;
  for (unsigned set = threadIdx.x; set < maximum_number_of_sets; set += blockDim.x)
    sums[set] = 0;
  __syncthreads();
  for (unsigned first = blockIdx.x + 1; first < field.number_of_dipoles; first += blockDim.x)
  {
    const unsigned k = first + threadIdx.x;
    long long units = 0;
    unsigned set = no_set;
    if (k < field.number_of_dipoles && field.dipoles[k].tree == a.tree
        && field.dipoles[k].set != a.set)
    {
      const Dipole& b = field.dipoles[k];
      const double3 d = {b.position.x - a.position.x, b.position.y - a.position.y,
                         b.position.z - a.position.z};
      const double agreement = dipole_agreement(dot(a.normal, b.normal),
                                                dot(a.normal, d) * dot(b.normal, d), dot(d, d),
                                                squared_core_of_dipole(field.area))
                               * (field.area * field.area / field.spacing);
      set = b.set;
      if (isfinite(agreement))
        units = __double2ll_rn(agreement * units_per_vote);
    }
    // neighbors in the order are mostly of one set
    const unsigned peers = __match_any_sync(0xffffffffu, set);
    if (set == no_set)
      continue;
    const long long sum = peer_sum(peers, units);
    if (is_leader_of(peers))
      add_to(&sums[set], sum);
  }
  __syncthreads();
  for (unsigned set = threadIdx.x; set < maximum_number_of_sets; set += blockDim.x)
    if (sums[set] != 0)
    {
      add_to(&field.row(a.set)[set], sums[set]);
      add_to(&field.row(set)[a.set], sums[set]);
    }
}

__global__ void add_votes_between_sets(Field field, Graph graph, const Link* sets)
{
  for_each_pair_of_neighbors(
    graph, thread_index(), Wide(gridDim.x) * blockDim.x, [&](unsigned i, unsigned other) {
      const Link a = sets[i], b = sets[other];
      if (a.target() == b.target())
        return;
      const unsigned set_a = field.set_of_root[a.target()], set_b = field.set_of_root[b.target()];
      if (!field.are_of_one_tree(set_a, set_b))
        return;
      const double agreement = agreement_of(graph, i, other);
      const long long units = __double2ll_rn((a.is_turned() == b.is_turned() ? 1 : -1) * agreement
                                             * units_per_vote);
      add_to(&field.row(set_a)[set_b], units);
      add_to(&field.row(set_b)[set_a], units);
    });
}

/// How far a set or a group of them, or two, agree; of those of equal agreement the first one is
/// less.
struct Agreement
{
  long long units;
  unsigned set, other; // the latter for two

  __device__ bool operator<(const Agreement& b) const
  {
    return units < b.units || (units == b.units && set < b.set);
  }
};

/// What the threads of `turn_sets()` tell each other.
struct Turning
{
  Agreement of_warps[threads_of_turning_block / 32];
  int signs[maximum_number_of_sets];
  unsigned char is_turned[maximum_number_of_sets];
  long long rest_of_second, rest_of_whole; // how far groups that become one agree with all others
  // the groups whose closest one has to be found anew, and what was found
  unsigned number_of_searches, searches[maximum_number_of_sets];
  unsigned closest[maximum_number_of_sets];
  long long links[maximum_number_of_sets];
};

/// The least of a block, for all its threads.
/// \param of_warps shared
__device__ Agreement least_of_block(Agreement own, Agreement* of_warps)
{
  for (int offset = 16; offset > 0; offset /= 2)
  {
    const Agreement other = {__shfl_down_sync(0xffffffffu, own.units, offset),
                             __shfl_down_sync(0xffffffffu, own.set, offset),
                             __shfl_down_sync(0xffffffffu, own.other, offset)};
    if (other < own)
      own = other;
  }
  __syncthreads(); // nobody reads the last ones any more
  if (threadIdx.x % 32 == 0)
    of_warps[threadIdx.x / 32] = own;
  __syncthreads();
  Agreement least = of_warps[0];
  for (unsigned warp = 1; warp < threads_of_turning_block / 32; ++warp)
    if (of_warps[warp] < least)
      least = of_warps[warp];
  return least;
}

/// Groups of sets, as on the CPU: the two that agree most become one, again and again. A group
/// stands at one of its sets; each thread looks after one set, and after the group that stands
/// there.
struct Groups
{
  long long*
    // how far two groups agree, a row of `maximum_number_of_sets` for each; 0 where one of them has
    // become part of another
    links;
  unsigned size;       // number of sets
  unsigned closest;    // the group that the thread's agrees most with, or `no_set`
  long long link;      // to that
  unsigned group;      // that the thread's set belongs to
  long long with_rest; // how far the thread's group agrees with all others

  __device__ long long& link_of(unsigned a, unsigned b) const
  {
    return links[Wide(a) * maximum_number_of_sets + b];
  }

  __device__ void find_closest(unsigned a)
  {
    closest = no_set;
    link = 0;
    for (unsigned b = 0; b < size; ++b)
      if (const long long other = link_of(b, a); other > link)
      {
        link = other;
        closest = b;
      }
  }

  /// As `find_closest()`, for the group that stands at `a`, by all threads of a warp.
  __device__ void find_closest_by_warp(unsigned a, Turning& turning) const
  {
    Agreement most = {0, no_set, no_set}; // the least, of opposite links
    for (unsigned b = threadIdx.x % 32; b < size; b += 32)
      if (const Agreement other = {-link_of(a, b), b, no_set}; other.units < most.units)
        most = other;
    for (int offset = 16; offset > 0; offset /= 2)
    {
      const Agreement other = {__shfl_down_sync(0xffffffffu, most.units, offset),
                               __shfl_down_sync(0xffffffffu, most.set, offset), no_set};
      if (other < most)
        most = other;
    }
    if (threadIdx.x % 32 != 0)
      return;
    turning.closest[a] = most.set;
    turning.links[a] = -most.units;
  }

  /// The second becomes part of the first.
  /// \param turning shared
  __device__ void join(unsigned first, unsigned second, unsigned a, Turning& turning)
  {
    if (a == 0)
      turning.number_of_searches = 0;

    if (a < size)
    {
      const long long sum = a == first || a == second ? 0 : link_of(first, a) + link_of(second, a);
      link_of(first, a) = link_of(a, first) = sum;
      link_of(second, a) = link_of(a, second) = 0;
      if (group == second)
        group = first;
    }
    __syncthreads();
    const bool searches = a < size
                          && (a == first || a == second || closest == first || closest == second);
    if (searches)
      turning.searches[atomicAdd(&turning.number_of_searches, 1u)] = a;
    else if (a < size && link_of(first, a) > link)
    {
      closest = first;
      link = link_of(first, a);
    }
    __syncthreads();
    for (unsigned n = a / 32; n < turning.number_of_searches; n += threads_of_turning_block / 32)
      find_closest_by_warp(turning.searches[n], turning);
    __syncthreads();
    if (searches)
    {
      closest = turning.closest[a];
      link = turning.links[a];
    }
  }
};

/// Finds the group of sets that disagrees most with all others.
/// \param with_others how far the thread's set agrees with all others
/// \param turning shared
/// \returns whether the thread's set is one of it
__device__ bool is_in_disagreeing_group(const Field& field, long long with_others, Turning& turning)
{
  const unsigned a = threadIdx.x;
  Groups groups = {field.links, *field.number_of_sets, no_set, 0, a, with_others};
  if (a < groups.size)
    for (unsigned b = 0; b < groups.size; ++b)
      groups.link_of(b, a) = a == b ? 0 : turning.signs[a] * turning.signs[b] * field.row(b)[a];
  if (a < groups.size)
    groups.find_closest(a); // what it reads, this thread has written
  long long least = -__double2ll_rn(least_disagreement_of_groups * units_per_vote);
  bool is_in_least = false;
  while (true)
  {
    const Agreement most = least_of_block({-groups.link, a, groups.closest}, turning.of_warps);
    if (most.units >= 0)
      return is_in_least;
    const unsigned first = most.set, second = most.other;
    if (a == second)
      turning.rest_of_second = groups.with_rest;
    groups.join(first, second, a, turning);
    if (a == first)
      turning.rest_of_whole = groups.with_rest += turning.rest_of_second + 2 * most.units;
    __syncthreads();
    if (turning.rest_of_whole < least)
    {
      least = turning.rest_of_whole;
      is_in_least = groups.group == first;
    }
  }
}

/// Turns the set that disagrees most, or the group of them, one after the other, until none does.
/// Run by one block, with a thread for each set.
__global__ void turn_sets(Field field, unsigned* number_of_turns)
{
  __shared__ Turning turning;
  const unsigned size = *field.number_of_sets, a = threadIdx.x;
  if (a < size)
    turning.signs[a] = field.signs[a];
  __syncthreads();
  const auto agreement_with = [&](unsigned b) {
    return turning.signs[a] * turning.signs[b] * field.row(b)[a];
  };
  long long with_others = 0; // the agreement of the thread's set with all others
  for (unsigned b = 0; b < size && a < size; ++b)
    with_others += agreement_with(b);
  for (unsigned turn = 0; turn < 10 * size; ++turn) // rounding might go round in circles
  {
    const Agreement least = least_of_block({with_others, a, no_set}, turning.of_warps);
    const bool turns = least.units < -__double2ll_rn(least_disagreement * units_per_vote)
                         ? a == least.set
                         : is_in_disagreeing_group(field, with_others, turning);
    if (a < size)
      turning.is_turned[a] = turns;
    if (__syncthreads_or(turns) == 0)
      break;
    if (a == 0)
      ++*number_of_turns;
    for (unsigned b = 0; b < size && a < size; ++b)
      if (bool(turning.is_turned[b]) != turns)
        with_others -= 2 * agreement_with(b);
    __syncthreads(); // nobody reads the signs any more
    if (turns)
      field.signs[a] = turning.signs[a] = -turning.signs[a];
    __syncthreads();
  }
}

/// Hooks each set of the field to the first one of its tree.
__global__ void join_field(Field field, unsigned size, Link* sets)
{
  const Wide i = thread_index();
  if (i >= size)
    return;
  const unsigned set = field.set_of_root[sets[i].target()];
  if (set == no_set)
    return;
  unsigned first = 0;
  while (field.trees[first] != field.trees[set])
    ++first;
  sets[i] = Link::to(field.roots[first],
                     sets[i].is_turned() ^ (field.signs[first] != field.signs[set]));
}

} // namespace

bool join_by_field(const Workplace& workplace, const Graph& graph, const Link* trees,
                   double spacing, Link* sets)
{
  const cudaStream_t stream = workplace.stream;
  const Arena_scope scope(workplace.scratch);
  const unsigned m = graph.size, number_of_dipoles = (std::min)(m, maximum_number_of_dipoles);
  const Device_counter<uint3> numbers(
    workplace); // of all sets, of those of the field, and of turns
  const Field field = {
    workplace.scratch.take<Dipole>(number_of_dipoles),
    workplace.scratch.take<unsigned>(number_of_dipoles),
    workplace.scratch.take<unsigned>(number_of_dipoles),
    number_of_dipoles,
    workplace.scratch.take<unsigned>(number_of_dipoles),
    &numbers.address()->x,
    workplace.scratch.take<unsigned char>(number_of_dipoles),
    spacing * spacing * double(m) / double(number_of_dipoles),
    spacing,
    workplace.scratch.take<unsigned>(m),
    &numbers.address()->y,
    workplace.scratch.take<unsigned>(maximum_number_of_sets),
    workplace.scratch.take<unsigned>(maximum_number_of_sets),
    workplace.scratch.take<int>(maximum_number_of_sets),
    workplace.scratch.take<long long>(Wide(maximum_number_of_sets) * maximum_number_of_sets),
    workplace.scratch.take<long long>(Wide(maximum_number_of_sets) * maximum_number_of_sets)};
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(field.set_of_root, 0xff, m * sizeof(unsigned), stream));
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(
    field.agreements, 0, Wide(maximum_number_of_sets) * maximum_number_of_sets * sizeof(long long),
    stream));
  place_dipoles<<<blocks_for(number_of_dipoles), threads_per_block, 0, stream>>>(
    field, graph.samples, sets);
  check_launch("place_dipoles");
  find_sets<<<blocks_for(32ull * number_of_dipoles), threads_per_block, 0, stream>>>(field, trees);
  check_launch("find_sets");
  choose_sets<<<blocks_for(32ull * number_of_dipoles), threads_per_block, 0, stream>>>(field, m);
  check_launch("choose_sets");
  number_sets<<<blocks_for(32ull * number_of_dipoles), threads_per_block, 0, stream>>>(field,
                                                                                       trees);
  check_launch("number_sets");
  find_trees_of_dipoles<<<blocks_for(number_of_dipoles), threads_per_block, 0, stream>>>(field);
  check_launch("find_trees_of_dipoles");
  add_dipoles<<<number_of_dipoles, threads_per_block, 0, stream>>>(field);
  check_launch("add_dipoles");
  add_votes_between_sets<<<blocks_for(Wide(m) * lanes_of_edges), threads_per_block, 0, stream>>>(
    field, graph, sets);
  check_launch("add_votes_between_sets");
  turn_sets<<<1, threads_of_turning_block, 0, stream>>>(field, &numbers.address()->z);
  check_launch("turn_sets");
  if (numbers.read().z == 0)
    return false;
  join_field<<<blocks_for(m), threads_per_block, 0, stream>>>(field, m, sets);
  check_launch("join_field");
  return true;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
