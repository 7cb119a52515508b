// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_WARP_CUH
#define CGAL_L0_CUDA_WARP_CUH

#include "search/Cell_grid.cuh"

#include <CGAL/L0_resampling/internal/kernels/Morton_points.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// The threads of a warp, which share a ball: `One_thread` says what the functions do.
struct Warp
{
  static constexpr int number_of_threads = 32;
  static constexpr unsigned all_lanes = 0xffffffffu;

  __device__ int lane() const { return int(threadIdx.x % number_of_threads); }

  template <typename F>
  __device__ void for_each_range(const Strided_range& own, const F& f) const
  {
    for (unsigned rest = __ballot_sync(all_lanes, own.begin < own.end); rest; rest &= rest - 1)
    {
      const int lane = __ffs(int(rest)) - 1;
      f(Strided_range{__shfl_sync(all_lanes, own.begin, lane),
                      __shfl_sync(all_lanes, own.end, lane),
                      __shfl_sync(all_lanes, own.stride, lane)});
    }
  }

  __device__ double sum(double value) const { return group_sum<number_of_threads>(value); }
  __device__ double least(double value) const
  {
    for (int offset = number_of_threads / 2; offset > 0; offset /= 2)
      value = fmin(value, __shfl_xor_sync(all_lanes, value, offset));
    return value;
  }

  __device__ bool all(bool value) const { return __all_sync(all_lanes, value); }

  /// Each lane holds the numbers whose ranks leave it as the remainder, ascending.
  template <typename T, int capacity>
  class Sorted_numbers
  {
    static constexpr int rows = (capacity + number_of_threads - 1) / number_of_threads;
    T m_values[rows];
    int m_size = 0;

  public:
    __device__ explicit Sorted_numbers(const Warp&) {}

    __device__ int size() const { return m_size; }
    __device__ T operator[](int rank) const
    {
      T value = m_values[0];
      for (int row = 1; row < rows; ++row)
        value = rank / number_of_threads == row ? m_values[row] : value;
      return __shfl_sync(all_lanes, value, rank % number_of_threads);
    }

    __device__ void add_if_room(T value, bool is_there)
    {
      for (unsigned rest = __ballot_sync(all_lanes, is_there); rest && m_size < capacity;
           rest &= rest - 1)
        insert(__shfl_sync(all_lanes, value, __ffs(int(rest)) - 1));
    }

    __device__ void add_if_small(T value, bool is_there)
    {
      const bool is_small = m_size < capacity || value < (*this)[capacity - 1];
      for (unsigned rest = __ballot_sync(all_lanes, is_there && is_small); rest; rest &= rest - 1)
        insert(__shfl_sync(all_lanes, value, __ffs(int(rest)) - 1));
    }

  private:
    /// Moves the larger numbers up by one place; the last goes if there is none for it.
    __device__ void insert(T value)
    {
      const int lane = int(threadIdx.x % number_of_threads);
      int place = 0;
      for (int row = 0; row < rows; ++row)
        place += __popc(__ballot_sync(all_lanes, row * number_of_threads + lane < m_size
                                                   && !(value < m_values[row])));
      for (int row = rows - 1; row >= 0; --row)
      {
        const T below = __shfl_up_sync(all_lanes, m_values[row], 1),
                last_of_row_before = __shfl_sync(all_lanes, m_values[row > 0 ? row - 1 : 0],
                                                 number_of_threads - 1);
        const int rank = row * number_of_threads + lane;
        if (rank > place)
          m_values[row] = lane > 0 ? below : last_of_row_before;
        else if (rank == place)
          m_values[row] = value;
      }
      m_size += m_size < capacity;
    }
  };
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_WARP_CUH
