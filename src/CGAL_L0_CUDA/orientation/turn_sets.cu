// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/Field_of_sets.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

constexpr unsigned threads_of_turning_block = 704; // one for each set
static_assert(threads_of_turning_block >= maximum_number_of_sets, "too few threads for the sets");
static_assert(threads_of_turning_block % 32 == 0, "warps are whole");

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
__device__ Agreement minimum_of_block(Agreement own, Agreement* of_warps)
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
__device__ bool is_in_disagreeing_group(const Field_of_sets& field, long long with_others,
                                        Turning& turning)
{
  const unsigned a = threadIdx.x;
  Groups groups = {field.links, *field.number_of_sets, no_set, 0, a, with_others};
  if (a < groups.size)
    for (unsigned b = 0; b < groups.size; ++b)
      groups.link_of(b, a) = a == b ? 0 : turning.signs[a] * turning.signs[b] * field.row(b)[a];
  if (a < groups.size)
    groups.find_closest(a); // what it reads, this thread has written
  long long least = -__double2ll_rn(minimum_disagreement_of_groups * units_per_vote);
  bool is_in_least = false;
  while (true)
  {
    const Agreement most = minimum_of_block({-groups.link, a, groups.closest}, turning.of_warps);
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

/// Run by one block, with a thread for each set.
__global__ void turn_sets(Field_of_sets field, unsigned* number_of_turns)
{
  __shared__ Turning turning;
  const unsigned size = *field.number_of_sets, a = threadIdx.x;
  if (a < size)
    turning.signs[a] = field.signs[a];
  __syncthreads();
  const auto agreement_with = [&](unsigned b) {
    return turning.signs[a] * turning.signs[b] * field.row(b)[a];
  };
  // the agreement of the thread's set with all others
  long long with_others = a < size ? turning.signs[a] * field.unary_terms[a] : 0;
  for (unsigned b = 0; b < size && a < size; ++b)
    with_others += agreement_with(b);
  for (unsigned turn = 0; turn < 10 * size; ++turn) // rounding might go round in circles
  {
    const Agreement least = minimum_of_block({with_others, a, no_set}, turning.of_warps);
    const bool turns = least.units < -__double2ll_rn(minimum_disagreement * units_per_vote)
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

} // namespace

void flip_disagreeing_sets(const Field_of_sets& field, unsigned* number_of_turns,
                           cudaStream_t stream)
{
  turn_sets<<<1, threads_of_turning_block, 0, stream>>>(field, number_of_turns);
  check_launch("turn_sets");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
