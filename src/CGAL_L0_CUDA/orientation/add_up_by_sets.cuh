// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_ADD_UP_BY_SETS_CUH
#define CGAL_L0_CUDA_ADD_UP_BY_SETS_CUH

#include "orientation/Field_of_sets.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

__device__ inline void add_to(long long* sum, long long value)
{
  atomicAdd(reinterpret_cast<Wide*>(sum), Wide(value));
}

/// Adds up what each dipole of a tree says, for each set. For all threads of a block at once.
/// \param first the first dipole that is asked
/// \param units of a dipole, in fixed point
/// \param sums shared, out
template <typename Units>
__device__ void add_up_by_sets(const Field_of_sets& field, unsigned first, unsigned tree,
                               const Units& units, long long (&sums)[maximum_number_of_sets])
{
  for (unsigned set = threadIdx.x; set < maximum_number_of_sets; set += blockDim.x)
    sums[set] = 0;
  __syncthreads();
  for (; first < field.number_of_dipoles; first += blockDim.x)
  {
    const unsigned k = first + threadIdx.x;
    const bool is_asked = k < field.number_of_dipoles && field.dipoles[k].tree == tree;
    const unsigned set = is_asked ? field.dipoles[k].set : no_set;
    // neighbors in the order are mostly of one set
    const unsigned peers = __match_any_sync(0xffffffffu, set);
    if (!is_asked)
      continue;
    const long long sum = peer_sum(peers, units(field.dipoles[k]));
    if (is_leader_of(peers))
      add_to(&sums[set], sum);
  }
  __syncthreads();
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_ADD_UP_BY_SETS_CUH
