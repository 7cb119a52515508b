// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_GRID_SUM_CUH
#define CGAL_L0_CUDA_GRID_SUM_CUH

#include "core/vectors.cuh"

#include <cooperative_groups.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/*!
Sums of up to `maximum_count` numbers over all threads of a cooperative launch, the same bits in
each thread and in each run: warps, blocks and the grid add up in a fixed order. One object serves
one kernel; it alternates between two arrays, so that one barrier a sum is enough.
*/
template <int maximum_count>
class Grid_sum
{
  double* m_partial_sums; // 2 x number of blocks x maximum_count
  double* m_shared;       // warps of a block x maximum_count
  bool m_is_odd = false;

public:
  __host__ __device__ static constexpr unsigned size_of_shared(unsigned threads_of_block)
  {
    return threads_of_block / 32 * maximum_count;
  }

  __device__ Grid_sum(double* partial_sums, double* shared)
    : m_partial_sums(partial_sums), m_shared(shared)
  {}

  /// \param values in: those of the thread; out: the sums
  template <int count>
  __device__ void operator()(double (&values)[count])
  {
    static_assert(count <= maximum_count, "the arrays have no room for so many numbers");
    double* const partial_sums = m_partial_sums + (m_is_odd ? gridDim.x * maximum_count : 0);
    m_is_odd = !m_is_odd;
    sum_over_block(values);
    if (threadIdx.x == 0)
      for (int c = 0; c < count; ++c)
        partial_sums[blockIdx.x * count + c] = values[c];
    cooperative_groups::this_grid().sync();
    for (int c = 0; c < count; ++c)
      values[c] = 0;
    for (unsigned b = threadIdx.x; b < gridDim.x; b += blockDim.x)
      for (int c = 0; c < count; ++c)
        values[c] += __ldcg(partial_sums + b * count + c);
    sum_over_block(values);
  }

private:
  template <int count>
  __device__ void sum_over_block(double (&values)[count])
  {
    const unsigned warp = threadIdx.x / 32, number_of_warps = blockDim.x / 32;
    for (int c = 0; c < count; ++c)
      values[c] = group_sum<32>(values[c]);
    __syncthreads(); // the last sum has been read
    if (threadIdx.x % 32 == 0)
      for (int c = 0; c < count; ++c)
        m_shared[warp * count + c] = values[c];
    __syncthreads();
    for (int c = 0; c < count; ++c)
      values[c] = group_sum<32>(
        threadIdx.x % 32 < number_of_warps ? m_shared[threadIdx.x % 32 * count + c] : 0.);
  }
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_GRID_SUM_CUH
