// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_QUERY_CUH
#define CGAL_L0_CUDA_QUERY_CUH

#include "search/Cell_grid.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// The query of a group of lanes. Groups beyond the last query repeat it, since whole warps have to
/// take part in sums.
struct Query
{
  unsigned index, lane;
  bool writes;

  __device__ explicit Query(unsigned size)
  {
    const unsigned long long q = thread_index() / lanes;
    lane = threadIdx.x % lanes;
    index = q < size ? unsigned(q) : size - 1;
    writes = q < size && lane == 0;
  }
};

/// Blocks of threads that have a group of lanes for each query.
inline unsigned blocks_for_queries(unsigned long long count) { return blocks_for(count * lanes); }

/// The queries of a block of threads.
constexpr unsigned queries_per_block = threads_per_block / lanes;

/// Hands what the groups of lanes of a block have summed to as many of its first threads: what one
/// thread does for a query fills whole warps there, of which the groups would leave most idle.
/// Lies in shared memory.
template <typename T>
class Sums_of_block
{
  alignas(T) unsigned char m_memory[queries_per_block * sizeof(T)];

public:
  /// For all threads of the block; `of_query()` may be called after the next barrier.
  __device__ void set(const Query& query, const T& sums)
  {
    if (query.lane == 0)
      reinterpret_cast<T*>(m_memory)[threadIdx.x / lanes] = sums;
  }

  /// For one of the first `queries_per_block` threads.
  __device__ const T& of_query() const { return reinterpret_cast<const T*>(m_memory)[threadIdx.x]; }
};

/// The query of a single thread of the first ones of a block.
struct Single_query
{
  unsigned index;
  bool exists;

  __device__ explicit Single_query(unsigned size)
  {
    const unsigned long long q = (unsigned long long)(blockIdx.x) * queries_per_block + threadIdx.x;
    exists = threadIdx.x < queries_per_block && q < size;
    index = exists ? unsigned(q) : 0;
  }
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_QUERY_CUH
