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

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_QUERY_CUH
