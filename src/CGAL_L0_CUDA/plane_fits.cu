// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Plane_fit.cuh"
#include "plane_fits.cuh"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

using Wide = unsigned long long;

constexpr unsigned threads_per_query = 128;

/// Sums over a block of `threads_per_query` threads, for its first thread.
template <typename T, int count>
__device__ void sum_over_block(T (&values)[count])
{
  __shared__ T shared[threads_per_query / 32][count];
  for (int c = 0; c < count; ++c)
    values[c] = group_sum<32>(values[c]);
  __syncthreads();
  if (threadIdx.x % 32 == 0)
    for (int c = 0; c < count; ++c)
      shared[threadIdx.x / 32][c] = values[c];
  __syncthreads();
  if (threadIdx.x == 0)
    for (unsigned w = 1; w < threads_per_query / 32; ++w)
      for (int c = 0; c < count; ++c)
        values[c] += shared[w][c];
}

/// One block of threads for each query, one thread for each row of cells around it, however many there are.
template <typename Query_point>
__global__ void fit_planes_around(Cell_grid grid, Query_point query_point, int reach, float radius, Plane_fit* fits)
{
  const int4 center = grid.points[query_point(blockIdx.x)];
  const float unit = grid.frame.unit(), squared_radius = radius * radius;
  const uint3 cell = grid.frame.cell_of_key(grid.keys[center.w]);
  const int width = 2 * reach + 1, number_of_rows = width * width;

  Wide count[1] = {0};
  for (int row = int(threadIdx.x); row < number_of_rows; row += int(threads_per_query))
  {
    const uint2 range = range_of_row(grid, cell, reach, row);
    count[0] += range.y - range.x;
  }
  sum_over_block(count);
  __shared__ unsigned shared_stride;
  if (threadIdx.x == 0)
  {
    shared_stride = 1;
    while (count[0] / shared_stride > maximum_number_of_candidates)
      shared_stride *= 2;
  }
  __syncthreads();
  const Wide stride = shared_stride;

  Moments moments;
  for (int row = int(threadIdx.x); row < number_of_rows; row += int(threads_per_query))
  {
    const uint2 range = range_of_row(grid, cell, reach, row);
    for (Wide j = (range.x + stride - 1) & ~(stride - 1); j < range.y; j += stride)
    {
      const float3 d = difference(grid.points[j], center, unit);
      if (dot(d, d) < squared_radius)
        moments.add(d);
    }
  }
  sum_over_block(moments.values);
  if (threadIdx.x == 0)
  {
    Plane_fit fit = moments.plane(squared_radius);
    fit.number_of_points *= unsigned(stride);
    fits[blockIdx.x] = fit;
  }
}

struct Every_so_manieth
{
  unsigned stride;
  __device__ unsigned operator()(unsigned q) const { return q * stride; }
};

struct Listed
{
  const unsigned* list;
  __device__ unsigned operator()(unsigned q) const { return list[q]; }
};

__global__ void take_fits(const Plane_fit* fits, const unsigned* open, unsigned number_of_open, float4* normals, unsigned char* is_degenerate)
{
  const Wide q = thread_index();
  if (q >= number_of_open)
    return;
  normals[open[q]] = with_w(fits[q].normal, 0);
  is_degenerate[open[q]] = !fits[q].spans_plane;
}

double median(std::vector<double>& values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

void refit_planes_of(const Workplace& workplace, const Cell_grid& grid, const unsigned* open, unsigned number_of_open, double radius,
                     float4* normals, unsigned char* is_degenerate)
{
  const Arena_scope scope(workplace.scratch);
  Plane_fit* const fits = workplace.scratch.take<Plane_fit>(number_of_open);
  fit_planes_around<<<number_of_open, threads_per_query, 0, workplace.stream>>>(grid, Listed{open}, cells_in_reach(radius, grid.frame.cell_size),
                                                                              float(radius), fits);
  check_launch("fit_planes_around");
  take_fits<<<blocks_for(number_of_open), threads_per_block, 0, workplace.stream>>>(fits, open, number_of_open, normals, is_degenerate);
  check_launch("take_fits");
}

Scales estimate_scales(const Workplace& workplace, const Positions& positions, const double (&low)[3], const double (&high)[3],
                       double initial_radius)
{
  const unsigned number_of_queries = 1000;   // as on the CPU, and so are the next three
  const double fewest_points = 15, flat = 0.25;
  const int reaches[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
  const double cell_size = initial_radius / 4, pi = 3.141592653589793;

  const Arena_scope arena_scope(workplace.arena), scratch_scope(workplace.scratch);
  const Cell_grid grid = build_grid(positions, nullptr, Cell_frame::around(low, high, cell_size, 32 * cell_size), workplace.arena,
                                    workplace.scratch, workplace.stream);
  const unsigned stride = (std::max)(positions.size / number_of_queries, 1u);
  const unsigned size = (positions.size + stride - 1) / stride;
  Plane_fit* const device_fits = workplace.scratch.take<Plane_fit>(size);
  std::vector<Plane_fit> fits(size);
  std::vector<double> variances(size), counts(size);
  Scales scales = {cell_size, 0};
  for (const int reach : reaches)
  {
    const double radius = reach * cell_size;
    fit_planes_around<<<size, threads_per_query, 0, workplace.stream>>>(grid, Every_so_manieth{stride}, reach, float(radius), device_fits);
    check_launch("fit_planes_around");
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(fits.data(), device_fits, size * sizeof(Plane_fit), cudaMemcpyDeviceToHost, workplace.stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(workplace.stream));
    for (unsigned q = 0; q < size; ++q)
    {
      variances[q] = fits[q].variance;
      counts[q] = fits[q].number_of_points;
    }
    const double count = median(counts);
    if (count < fewest_points && reach < 32)
      continue;
    scales.spacing = radius * std::sqrt(pi / (std::max)(count, 1.));
    scales.noise = std::sqrt(median(variances));
    if (scales.noise < flat * radius)
      break;
  }
  return scales;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
