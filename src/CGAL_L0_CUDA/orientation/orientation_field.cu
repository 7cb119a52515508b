// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/add_up_by_sets.cuh"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void place_dipoles(Field_of_sets field, Samples samples, const Link* sets)
{
  const Wide k = thread_index();
  if (k >= field.number_of_dipoles)
    return;
  const Dipole dipole = dipole_of(samples, sets, k, field.number_of_dipoles);
  field.dipoles[k] = {dipole.position, dipole.normal, field.area, no_set, no_set};
  field.roots_of_dipoles[k] = dipole.root;
}

/// One warp for each dipole.
__global__ void find_sets(Field_of_sets field, const Link* trees)
{
  const Wide k = warp_index();
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
__global__ void choose_sets(Field_of_sets field, unsigned number_of_samples)
{
  const Wide k = warp_index();
  if (k >= field.number_of_dipoles) // whole warps leave
    return;
  const unsigned fewest = minimum_number_of_dipoles_of_a_set(number_of_samples,
                                                             *field.number_of_all_sets);
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
__global__ void number_sets(Field_of_sets field, const Link* trees)
{
  const Wide k = warp_index();
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
  field.numbers_of_dipoles[set] = field.sizes_of_sets[k];
  field.signs[set] = link.is_turned() ? -1 : 1;
  atomicAdd(field.number_of_sets, 1u);
}

__global__ void find_trees_of_dipoles(Field_of_sets field)
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

/// Less where the dipoles of a set crowd. One warp for each dipole.
__global__ void find_areas_of_dipoles(Field_of_sets field)
{
  const Wide k = warp_index();
  if (k >= field.number_of_dipoles || field.dipoles[k].tree == no_set) // whole warps leave
    return;
  const Dipole_of_field& own = field.dipoles[k];
  const double squared_core = squared_core_of_dipole(field.area);
  double crowding = 0;
  for (unsigned other = threadIdx.x % 32; other < field.number_of_dipoles; other += 32)
    if (field.dipoles[other].set == own.set)
    {
      const double3 d = field.dipoles[other].position - own.position;
      crowding += crowding_of_dipole(dot(field.dipoles[other].normal, own.normal), dot(d, d),
                                     squared_core);
    }
  crowding = group_sum<32>(crowding);
  if (threadIdx.x % 32 == 0)
    field.dipoles[k].area = share_of_dipole(crowding) * field.area;
}

/// One block for each dipole: its agreement with all those behind it.
__global__ void add_dipoles(Field_of_sets field)
{
  __shared__ long long sums[maximum_number_of_sets];
  const Dipole_of_field a = field.dipoles[blockIdx.x];
  if (a.tree == no_set)
    return;
  const auto units_of_agreement = [&](const Dipole_of_field& b) {
    const double3 d = b.position - a.position;
    const double agreement = dipole_agreement(dot(a.normal, b.normal),
                                              dot(a.normal, d) * dot(b.normal, d), dot(d, d),
                                              squared_core_of_dipole(field.area))
                             * (a.area * b.area / field.spacing);
    return b.set != a.set && isfinite(agreement) ? __double2ll_rn(agreement * units_per_vote) : 0ll;
  };
  add_up_by_sets(field, blockIdx.x + 1, a.tree, units_of_agreement, sums);
  for (unsigned set = threadIdx.x; set < maximum_number_of_sets; set += blockDim.x)
    if (sums[set] != 0)
    {
      add_to(&field.row(a.set)[set], sums[set]);
      add_to(&field.row(set)[a.set], sums[set]);
    }
}

__global__ void add_votes_between_sets(Field_of_sets field, Graph graph, const Link* sets)
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

/// Hooks each set of the field to the first one of its tree.
__global__ void join_field(Field_of_sets field, unsigned size, Link* sets)
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

bool join_by_field(const Execution_context& context, const Graph& graph, const Link* trees,
                   double spacing, Link* sets)
{
  const cudaStream_t stream = context.stream;
  const Arena_scope scope(context.scratch);
  const unsigned m = graph.size, number_of_dipoles = (std::min)(m, maximum_number_of_dipoles);
  const Device_counter<uint3> numbers(context); // of all sets, of those of the field, and of turns
  const Field_of_sets field = {
    context.scratch.take<Dipole_of_field>(number_of_dipoles),
    context.scratch.take<unsigned>(number_of_dipoles),
    context.scratch.take<unsigned>(number_of_dipoles),
    number_of_dipoles,
    context.scratch.take<unsigned>(number_of_dipoles),
    &numbers.address()->x,
    context.scratch.take<unsigned char>(number_of_dipoles),
    spacing * spacing * double(m) / double(number_of_dipoles),
    spacing,
    context.scratch.take<unsigned>(m),
    &numbers.address()->y,
    context.scratch.take<unsigned>(maximum_number_of_sets),
    context.scratch.take<unsigned>(maximum_number_of_sets),
    context.scratch.take<unsigned>(maximum_number_of_sets),
    context.scratch.take<int>(maximum_number_of_sets),
    context.scratch.take<long long>(Wide(maximum_number_of_sets) * maximum_number_of_sets),
    context.scratch.take<long long>(Wide(maximum_number_of_sets) * maximum_number_of_sets),
    context.scratch.take<long long>(maximum_number_of_sets),
    context.scratch.take<float>(Wide(number_of_dipoles) * maximum_number_of_sets)};
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(field.set_of_root, 0xff, m * sizeof(unsigned), stream));
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(
    field.agreements, 0, Wide(maximum_number_of_sets) * maximum_number_of_sets * sizeof(long long),
    stream));
  CGAL_L0_CUDA_CHECK(
    cudaMemsetAsync(field.unary_terms, 0, maximum_number_of_sets * sizeof(long long), stream));
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
  find_areas_of_dipoles<<<blocks_for(32ull * number_of_dipoles), threads_per_block, 0, stream>>>(
    field);
  check_launch("find_areas_of_dipoles");
  add_dipoles<<<number_of_dipoles, threads_per_block, 0, stream>>>(field);
  check_launch("add_dipoles");
  add_votes_between_sets<<<blocks_for(Wide(m) * lanes_of_edges), threads_per_block, 0, stream>>>(
    field, graph, sets);
  check_launch("add_votes_between_sets");
  flip_disagreeing_sets(field, &numbers.address()->z, stream);
  add_windings(field, m, stream);
  flip_disagreeing_sets(field, &numbers.address()->z, stream);
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
