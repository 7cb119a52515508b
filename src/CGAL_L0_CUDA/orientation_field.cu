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

// As on the CPU
constexpr unsigned maximum_number_of_dipoles = 2048, fewest_dipoles_of_a_set = 6;
constexpr unsigned maximum_number_of_sets = maximum_number_of_dipoles / fewest_dipoles_of_a_set;
constexpr double weight_of_votes = 3;

constexpr unsigned no_set = ~0u;
constexpr unsigned threads_of_single_block = 1024;

/// A sample that stands for those around it.
struct Dipole
{
  double3 position, normal; // that in the sense of its set
  unsigned root;
  unsigned set; // or `no_set`
};

/// The larger sets of samples, and how far they agree two by two, in fixed point.
struct Field
{
  Dipole* dipoles;
  unsigned number_of_dipoles;
  double area;           // that a dipole stands for
  double spacing;        // of the samples
  unsigned* set_of_root; // of each sample that is a root: its number among the larger sets, or `no_set`
  unsigned* number_of_sets;
  unsigned* roots;       // of the sets
  unsigned* trees;       // that they belong to
  int* signs;            // relative to the tree
  long long* agreements; // a row of `maximum_number_of_sets` for each set

  __device__ long long* row(unsigned set) const { return agreements + Wide(set) * maximum_number_of_sets; }
  __device__ bool are_of_one_tree(unsigned a, unsigned b) const
  {
    return a != no_set && b != no_set && a != b && trees[a] == trees[b];
  }
};

__device__ void add_to(long long* sum, long long value) { atomicAdd(reinterpret_cast<Wide*>(sum), Wide(value)); }

__global__ void place_dipoles(Field field, Samples samples, const Link* sets)
{
  const Wide k = thread_index();
  if (k >= field.number_of_dipoles)
    return;
  const unsigned i = unsigned((2 * k + 1) * samples.size / (2 * field.number_of_dipoles));
  const Link link = sets[i];
  const double* const p = samples.positions + 3 * Wide(i);
  field.dipoles[k] = {
    {p[0], p[1], p[2]}, (link.is_turned() ? -1. : 1.) * to_double(xyz(samples.normals[i])), link.target(), no_set};
}

/// Numbers the sets with enough dipoles by their roots. Run by one block.
__global__ void number_sets(Field field, const Link* trees)
{
  __shared__ unsigned roots[maximum_number_of_dipoles];
  __shared__ bool stands_for_set[maximum_number_of_dipoles]; // the first dipole of a large set
  const unsigned size = field.number_of_dipoles;
  for (unsigned k = threadIdx.x; k < size; k += blockDim.x)
    roots[k] = field.dipoles[k].root;
  __syncthreads();
  for (unsigned k = threadIdx.x; k < size; k += blockDim.x)
  {
    unsigned count = 0;
    bool is_first = true;
    for (unsigned other = 0; other < size; ++other)
      if (roots[other] == roots[k])
      {
        ++count;
        is_first = is_first && other >= k;
      }
    stands_for_set[k] = is_first && count >= fewest_dipoles_of_a_set;
  }
  __syncthreads();
  for (unsigned k = threadIdx.x; k < size; k += blockDim.x)
    if (stands_for_set[k])
    {
      const unsigned root = roots[k];
      unsigned set = 0;
      for (unsigned other = 0; other < size; ++other)
        set += unsigned(stands_for_set[other] && roots[other] < root);
      const Link link = trees[root];
      field.set_of_root[root] = set;
      field.roots[set] = root;
      field.trees[set] = link.target();
      field.signs[set] = link.is_turned() ? -1 : 1;
      atomicAdd(field.number_of_sets, 1u);
    }
  __syncthreads();
  for (unsigned k = threadIdx.x; k < size; k += blockDim.x)
    field.dipoles[k].set = field.set_of_root[roots[k]];
}

/// One block for each dipole: its agreement with all others.
__global__ void add_dipoles(Field field)
{
  __shared__ long long sums[maximum_number_of_sets];
  const Dipole a = field.dipoles[blockIdx.x];
  if (a.set == no_set)
    return;
  for (unsigned set = threadIdx.x; set < maximum_number_of_sets; set += blockDim.x)
    sums[set] = 0;
  __syncthreads();
  for (unsigned k = threadIdx.x; k < field.number_of_dipoles; k += blockDim.x)
  {
    const Dipole& b = field.dipoles[k];
    if (!field.are_of_one_tree(a.set, b.set))
      continue;
    const double3 d = {b.position.x - a.position.x, b.position.y - a.position.y, b.position.z - a.position.z};
    const double squared_distance = dot(d, d) + field.area;
    const double agreement = (dot(a.normal, b.normal) - 3 * dot(a.normal, d) * dot(b.normal, d) / squared_distance)
                             / (squared_distance * sqrt(squared_distance)) * field.area * field.area / field.spacing;
    if (isfinite(agreement))
      add_to(&sums[b.set], __double2ll_rn(agreement * units_per_vote));
  }
  __syncthreads();
  for (unsigned set = threadIdx.x; set < maximum_number_of_sets; set += blockDim.x)
    if (sums[set] != 0)
      add_to(&field.row(a.set)[set], sums[set]);
}

__global__ void add_votes_of_edges(Field field, Graph graph, const Wide* edges, unsigned number_of_edges, const Link* sets)
{
  const Wide n = thread_index();
  if (n >= number_of_edges)
    return;
  const Wide i = edges[n] / graph.k;
  const unsigned other = graph.nearest[edges[n]];
  const Link a = sets[i], b = sets[other];
  const unsigned set_a = field.set_of_root[a.target()], set_b = field.set_of_root[b.target()];
  if (!field.are_of_one_tree(set_a, set_b))
    return;
  const double agreement = agreement_of(graph, i, other);
  const long long units = __double2ll_rn((a.is_turned() == b.is_turned() ? 1 : -1) * weight_of_votes * agreement
                                         * units_per_vote);
  add_to(&field.row(set_a)[set_b], units);
  add_to(&field.row(set_b)[set_a], units);
}

/// Turns the set that disagrees most, one after the other, until none does. Run by one block.
__global__ void turn_sets(Field field, unsigned* number_of_turns)
{
  __shared__ long long least;
  __shared__ unsigned set_of_least;
  const unsigned size = *field.number_of_sets;
  for (unsigned turn = 0; turn < 10 * size; ++turn) // rounding might go round in circles
  {
    if (threadIdx.x == 0)
    {
      least = 0;
      set_of_least = no_set;
    }
    __syncthreads();
    long long own = 0;
    if (threadIdx.x < size)
    {
      for (unsigned b = 0; b < size; ++b)
        own += field.signs[b] * field.row(threadIdx.x)[b];
      own *= field.signs[threadIdx.x];
      atomicMin(&least, own);
    }
    __syncthreads();
    if (own < 0 && own == least)
      atomicMin(&set_of_least, threadIdx.x);
    __syncthreads();
    if (set_of_least == no_set)
      return;
    if (threadIdx.x == 0)
    {
      field.signs[set_of_least] = -field.signs[set_of_least];
      ++*number_of_turns;
    }
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
  sets[i] = Link::to(field.roots[first], sets[i].is_turned() ^ (field.signs[first] != field.signs[set]));
}

} // namespace

bool join_by_field(const Workplace& workplace, const Graph& graph, const Wide* edges, unsigned number_of_edges,
                   const Link* trees, double spacing, Link* sets)
{
  const cudaStream_t stream = workplace.stream;
  const Arena_scope scope(workplace.scratch);
  const unsigned m = graph.size, number_of_dipoles = (std::min)(m, maximum_number_of_dipoles);
  const Device_counter<unsigned> number_of_sets(workplace.scratch, stream), number_of_turns(workplace.scratch, stream);
  const Field field = {workplace.scratch.take<Dipole>(number_of_dipoles),
                       number_of_dipoles,
                       spacing * spacing * double(m) / double(number_of_dipoles),
                       spacing,
                       workplace.scratch.take<unsigned>(m),
                       number_of_sets.address(),
                       workplace.scratch.take<unsigned>(maximum_number_of_sets),
                       workplace.scratch.take<unsigned>(maximum_number_of_sets),
                       workplace.scratch.take<int>(maximum_number_of_sets),
                       workplace.scratch.take<long long>(Wide(maximum_number_of_sets) * maximum_number_of_sets)};
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(field.set_of_root, 0xff, m * sizeof(unsigned), stream));
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(field.agreements, 0,
                                     Wide(maximum_number_of_sets) * maximum_number_of_sets * sizeof(long long), stream));
  place_dipoles<<<blocks_for(number_of_dipoles), threads_per_block, 0, stream>>>(field, graph.samples, sets);
  check_launch("place_dipoles");
  number_sets<<<1, threads_of_single_block, 0, stream>>>(field, trees);
  check_launch("number_sets");
  add_dipoles<<<number_of_dipoles, threads_per_block, 0, stream>>>(field);
  check_launch("add_dipoles");
  if (number_of_edges > 0)
  {
    add_votes_of_edges<<<blocks_for(number_of_edges), threads_per_block, 0, stream>>>(field, graph, edges,
                                                                                      number_of_edges, sets);
    check_launch("add_votes_of_edges");
  }
  turn_sets<<<1, threads_of_single_block, 0, stream>>>(field, number_of_turns.address());
  check_launch("turn_sets");
  if (number_of_turns.read() == 0)
    return false;
  join_field<<<blocks_for(m), threads_per_block, 0, stream>>>(field, m, sets);
  check_launch("join_field");
  return true;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
