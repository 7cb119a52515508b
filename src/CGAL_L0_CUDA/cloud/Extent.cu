// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cloud/Extent.cuh"

#include <CGAL/L0_resampling/internal/core/Parameters.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

// All that is wanted are order statistics of the coordinates, and entering the frame keeps their
// order: one sort an axis gives them all.
constexpr int number_of_ranks = 7; // least, 0.5 %, 5 %, median, 95 %, 99.5 %, greatest

__global__ void take_axis(const double* points, unsigned size, int axis, double* coordinates)
{
  const unsigned long long i = thread_index();
  if (i < size)
    coordinates[i] = points[3 * i + unsigned(axis)];
}

struct Ranks
{
  unsigned places[number_of_ranks];
};

__global__ void take_ranks(const double* sorted, Ranks ranks, double* values)
{
  if (threadIdx.x < number_of_ranks)
    values[threadIdx.x] = sorted[ranks.places[threadIdx.x]];
}

/// The outermost of the sorted coordinates that lie in [low, high] once they are in the frame.
__global__ void find_innermost_box(const double* sorted, unsigned size, Frame frame, int axis,
                                   double low, double high, double* box)
{
  if (threadIdx.x > 1)
    return;
  // thread 0: the first that is not below `low`; thread 1: the first above `high`, whose
  // predecessor is wanted
  unsigned first = 0, count = size;
  while (count > 0)
  {
    const unsigned half = count / 2;
    const double x = frame.enter(sorted[first + half], axis);
    if (threadIdx.x == 0 ? x < low : x <= high)
    {
      first += half + 1;
      count -= half + 1;
    }
    else
      count = half;
  }
  box[threadIdx.x] = frame.enter(sorted[threadIdx.x == 0 ? first : first - 1], axis);
}

double number_of_ascending_bits(unsigned long long bits)
{
  const unsigned long long sign = 1ull << 63, raw = bits & sign ? bits ^ sign : ~bits;
  double value;
  std::memcpy(&value, &raw, sizeof(value));
  return value;
}

/// Each warp finds the box of its points.
/// \param complements_of_low, high in and out: ascending bits of the corners, the former inverted
__global__ void find_corners(const double* points, unsigned size,
                             unsigned long long* complements_of_low, unsigned long long* high)
{
  double least[3] = {INFINITY, INFINITY, INFINITY}, greatest[3] = {-INFINITY, -INFINITY, -INFINITY};
  const unsigned long long step = (unsigned long long)(gridDim.x) * blockDim.x;
  for (unsigned long long i = thread_index(); i < size; i += step)
    for (int axis = 0; axis < 3; ++axis)
    {
      least[axis] = fmin(least[axis], points[3 * i + unsigned(axis)]);
      greatest[axis] = fmax(greatest[axis], points[3 * i + unsigned(axis)]);
    }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int offset = 16; offset > 0; offset /= 2)
    {
      least[axis] = fmin(least[axis], __shfl_xor_sync(0xffffffffu, least[axis], offset));
      greatest[axis] = fmax(greatest[axis], __shfl_xor_sync(0xffffffffu, greatest[axis], offset));
    }
    if (threadIdx.x % 32 == 0)
    {
      atomicMax(&complements_of_low[axis], ~ascending_bits(least[axis]));
      atomicMax(&high[axis], ascending_bits(greatest[axis]));
    }
  }
}

} // namespace

void find_box(const Execution_context& context, const double* points, unsigned size,
              double (&low)[3], double (&high)[3])
{
  const Arena_scope scope(context.scratch);
  unsigned long long corners[6];
  unsigned long long* const on_device = context.scratch.take<unsigned long long>(6);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(on_device, 0, sizeof(corners), context.stream));
  const unsigned blocks = (std::min)(blocks_for(size),
                                     4 * unsigned(context.number_of_multiprocessors));
  find_corners<<<blocks, threads_per_block, 0, context.stream>>>(points, size, on_device,
                                                                 on_device + 3);
  check_launch("find_corners");
  CGAL_L0_CUDA_CHECK(
    cudaMemcpyAsync(corners, on_device, sizeof(corners), cudaMemcpyDeviceToHost, context.stream));
  CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(context.stream));
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = number_of_ascending_bits(~corners[axis]);
    high[axis] = number_of_ascending_bits(corners[3 + axis]);
  }
}

void find_plain_extent(const Execution_context& context, const double* points, unsigned size,
                       double (&extent)[3])
{
  double low[3], high[3];
  find_box(context, points, size, low, high);
  for (int axis = 0; axis < 3; ++axis)
    extent[axis] = high[axis] - low[axis];
}

Extent find_extent(const Execution_context& context, const double* points, unsigned size)
{
  const cudaStream_t stream = context.stream;
  const Arena_scope scope(context.scratch);
  double* const other = context.scratch.take<double>(size);
  double* const values = context.scratch.take<double>(3 * number_of_ranks);
  const unsigned margin = size / 20, trimmed = unsigned(margin_of_extent(size));
  const Ranks ranks = {
    {0, trimmed, margin, size / 2, size - 1 - margin, size - 1 - trimmed, size - 1}};
  double* sorted[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    double* const coordinates = context.scratch.take<double>(size);
    take_axis<<<blocks_for(size), threads_per_block, 0, stream>>>(points, size, axis, coordinates);
    check_launch("take_axis");
    sorted[axis] = sort_values(coordinates, other, size, context.scratch, stream);
    if (sorted[axis] != coordinates)
    {
      CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(coordinates, other, size * sizeof(double),
                                         cudaMemcpyDeviceToDevice, stream));
      sorted[axis] = coordinates;
    }
    take_ranks<<<1, 32, 0, stream>>>(sorted[axis], ranks, values + axis * number_of_ranks);
    check_launch("take_ranks");
  }
  double ranked[3][number_of_ranks];
  CGAL_L0_CUDA_CHECK(
    cudaMemcpyAsync(ranked, values, sizeof(ranked), cudaMemcpyDeviceToHost, stream));
  CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(stream));

  Extent extent;
  double largest = 0;
  for (const auto& axis : ranked)
    largest = (std::max)({largest, std::abs(axis[0]), std::abs(axis[number_of_ranks - 1])});
  if (largest > 0)
    extent.frame.exponent = -std::ilogb(largest) - 1;
  for (int axis = 0; axis < 3; ++axis)
    extent.frame.origin[axis] = std::ldexp(ranked[axis][3], extent.frame.exponent);
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    extent.low_of_input[axis] = ranked[axis][0];
    extent.high_of_input[axis] = ranked[axis][number_of_ranks - 1];
    for (double& value : ranked[axis])
      value = extent.frame.enter(value, axis);
    extent.low[axis] = ranked[axis][0];
    extent.high[axis] = ranked[axis][6];
    extent.trimmed[axis] = ranked[axis][5] - ranked[axis][1];
    reach = (std::max)(reach, ranked[axis][4] - ranked[axis][2]);
  }

  double box[3][2];
  for (int axis = 0; axis < 3; ++axis)
  {
    find_innermost_box<<<1, 32, 0, stream>>>(sorted[axis], size, extent.frame, axis,
                                             ranked[axis][2] - reach, ranked[axis][4] + reach,
                                             values + 2 * axis);
    check_launch("find_innermost_box");
  }
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(box, values, sizeof(box), cudaMemcpyDeviceToHost, stream));
  CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(stream));
  const auto length = [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); };
  extent.robust_diagonal =
    reach == 0 ? length(extent.high[0] - extent.low[0], extent.high[1] - extent.low[1],
                        extent.high[2] - extent.low[2])
               : length(box[0][1] - box[0][0], box[1][1] - box[1][0], box[2][1] - box[2][0]);
  return extent;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
