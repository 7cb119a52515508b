// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_VECTORS_CUH
#define CGAL_L0_CUDA_VECTORS_CUH

#include <cuda_runtime.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

__host__ __device__ inline float3 operator+(float3 a, float3 b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
__host__ __device__ inline float3 operator-(float3 a, float3 b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
__host__ __device__ inline float3 operator*(float s, float3 a)
{
  return {s * a.x, s * a.y, s * a.z};
}
__host__ __device__ inline float3& operator+=(float3& a, float3 b) { return a = a + b; }
__host__ __device__ inline float3& operator-=(float3& a, float3 b) { return a = a - b; }
__host__ __device__ inline float dot(float3 a, float3 b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
__host__ __device__ inline float3 xyz(float4 a) { return {a.x, a.y, a.z}; }
__host__ __device__ inline float4 with_w(float3 a, float w) { return {a.x, a.y, a.z, w}; }

__host__ __device__ inline double3 operator+(double3 a, double3 b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
__host__ __device__ inline double3 operator-(double3 a, double3 b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
__host__ __device__ inline double3 operator*(double s, double3 a)
{
  return {s * a.x, s * a.y, s * a.z};
}
__host__ __device__ inline double dot(double3 a, double3 b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
__host__ __device__ inline double3 to_double(float3 a)
{
  return {double(a.x), double(a.y), double(a.z)};
}
__host__ __device__ inline float3 to_float(double3 a)
{
  return {float(a.x), float(a.y), float(a.z)};
}

#ifdef __CUDACC__

/// Bits that ascend with the number.
__device__ inline unsigned long long ascending_bits(double value)
{
  const long long bits = __double_as_longlong(value + 0.); // -0 becomes 0
  return (unsigned long long)(bits) ^ (bits < 0 ? ~0ull : 1ull << 63);
}

/// A vector no longer than 1 in 8 bytes: 21 bits for each coordinate.
struct Short_vector
{
  unsigned long long bits;

  __device__ static Short_vector of(float3 v)
  {
    const auto fixed = [](float x) {
      return static_cast<unsigned long long>(__float2int_rn(x * steps)) & mask;
    };
    return {fixed(v.x) << (2 * width) | fixed(v.y) << width | fixed(v.z)};
  }

  __device__ float3 vector() const { return {coordinate(2), coordinate(1), coordinate(0)}; }

private:
  static constexpr int width = 21;
  static constexpr unsigned long long mask = (1ull << width) - 1;
  static constexpr float steps = float((1 << (width - 1)) - 1);

  __device__ float coordinate(int place) const
  {
    const int unused = 64 - width;
    return float(static_cast<long long>(bits << (unused - place * width)) >> unused) * (1 / steps);
  }
};

/// Indices of what there may be more of than samples: pairs, and places in arrays of several
/// numbers each.
using Wide = unsigned long long;

/// The index of the thread in the launch.
__device__ inline unsigned long long thread_index()
{
  return (unsigned long long)(blockIdx.x) * blockDim.x + threadIdx.x;
}

/// The index of the warp of the thread.
__device__ inline unsigned long long warp_index() { return thread_index() / 32; }

/// The sum over a group of `lanes` neighboring threads, the same bits in each of them. Whole warps
/// have to call it.
template <int lanes, typename T>
__device__ inline T group_sum(T value)
{
  for (int offset = lanes / 2; offset > 0; offset /= 2)
    value += __shfl_xor_sync(0xffffffffu, value, offset);
  return value;
}

/// The greatest of a group, as `group_sum()`.
template <int lanes>
__device__ inline float group_maximum(float value)
{
  for (int offset = lanes / 2; offset > 0; offset /= 2)
    value = fmaxf(value, __shfl_xor_sync(0xffffffffu, value, offset));
  return value;
}

template <int lanes>
__device__ inline float3 group_sum(float3 v)
{
  return {group_sum<lanes>(v.x), group_sum<lanes>(v.y), group_sum<lanes>(v.z)};
}

/// The sum over the threads of a warp that `peers` names, which all have to call it, in each of
/// them.
template <typename T>
__device__ inline T peer_sum(unsigned peers, T value)
{
  if (peers == 0xffffffffu)
    return group_sum<32>(value);
  T sum = 0;
  for (unsigned rest = peers; rest; rest &= rest - 1)
    sum += __shfl_sync(peers, value, __ffs(int(rest)) - 1);
  return sum;
}

/// Whether the thread is the first of `peers`.
__device__ inline bool is_leader_of(unsigned peers)
{
  return threadIdx.x % 32 == unsigned(__ffs(int(peers))) - 1;
}

#endif // __CUDACC__

constexpr unsigned threads_per_block = 256;

/// The number of blocks that have a thread for each of `count` things.
inline unsigned blocks_for(unsigned long long count)
{
  return unsigned((count + threads_per_block - 1) / threads_per_block);
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_VECTORS_CUH
