// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_LOOPS_OVER_SAMPLES_CUH
#define CGAL_L0_CUDA_LOOPS_OVER_SAMPLES_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

// How the threads of a kernel that is as large as the device, and no larger, walk over all samples.

// Threads that share a sample: it has some 10 to 50 self neighbors.
constexpr int lanes_per_sample = 2;

/// Walks over the samples of a group of lanes, all groups in step.
template <typename F>
__device__ void for_each_sample_of_group(unsigned size, const F& f)
{
  const Wide number_of_groups = Wide(gridDim.x) * blockDim.x / lanes_per_sample;
  const Wide group = thread_index() / lanes_per_sample;
  const unsigned lane = threadIdx.x % lanes_per_sample;
  for (Wide begin = 0; begin < size; begin += number_of_groups)
  {
    const Wide i = begin + group;
    // groups without a sample repeat the last one: whole warps have to take part in sums
    f(unsigned(i < size ? i : size - 1), lane, i < size);
  }
}

template <typename F>
__device__ void for_each_sample(unsigned size, const F& f)
{
  const Wide number_of_threads = Wide(gridDim.x) * blockDim.x;
  for (Wide i = thread_index(); i < size; i += number_of_threads)
    f(unsigned(i));
}

/// Walks over the pairs of a lane in batches: calls `load(k, e)` for each pair of a batch, and then
/// `use(loaded, e)`, so that the memory has several reads to do at once.
template <int batch, typename Load, typename Use>
__device__ void for_each_pair(const Neighbor_lists& neighbors, uint2 row, unsigned lane,
                              const Load& load, const Use& use)
{
  const Wide last = row.y;
  for (Wide e = Wide(row.x) + lane; e < last; e += batch * lanes_per_sample)
  {
    decltype(load(0u, e)) loaded[batch];
#pragma unroll
    for (int b = 0; b < batch; ++b)
    {
      const Wide own = e + b * lanes_per_sample, other = own < last ? own : e;
      loaded[b] = load(neighbors.indices[other], other);
    }
#pragma unroll
    for (int b = 0; b < batch; ++b)
      if (e + b * lanes_per_sample < last)
        use(loaded[b], e + b * lanes_per_sample);
  }
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_LOOPS_OVER_SAMPLES_CUH
