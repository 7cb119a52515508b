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

/// What the lanes of a query counted in its ball, and in the one of half the radius.
struct Counts_in_balls
{
  unsigned in_ball = 0, in_half_ball = 0;

  /// \param stride of the block: every so many of its points were looked at
  /// \param counts, half_counts one a query
  __device__ void sum_up(const Query& query, unsigned stride, unsigned* counts,
                         unsigned* half_counts)
  {
    in_ball = group_sum<lanes>(in_ball) * stride;
    in_half_ball = group_sum<lanes>(in_half_ball) * stride;
    if (!query.writes)
      return;
    counts[query.index] = in_ball;
    half_counts[query.index] = in_half_ball;
  }
};

/// Blocks of threads that have a group of lanes for each query.
inline unsigned blocks_for_queries(unsigned long long count) { return blocks_for(count * lanes); }

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_QUERY_CUH
