// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_GATHERED_CUH
#define CGAL_L0_CUDA_GATHERED_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

template <typename T>
__global__ void gather(const unsigned* order, unsigned size, const T* values, T* sorted)
{
  const Wide k = thread_index();
  if (k < size)
    sorted[k] = values[order[k]];
}

/// The values that stand in the places `order`, in an array from the arena.
template <typename T>
T* gathered(Device_arena& arena, cudaStream_t stream, const unsigned* order, unsigned size,
            const T* values)
{
  T* const sorted = arena.take<T>(size);
  gather<<<blocks_for(size), threads_per_block, 0, stream>>>(order, size, values, sorted);
  check_launch("gather");
  return sorted;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_GATHERED_CUH
