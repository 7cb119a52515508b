// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"
#include "search/Morton_places.cuh"
#include "search/Warp.cuh"

#include <CGAL/L0_resampling/internal/kernels/scale_field.h>

#include <cstring>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void know_seeds(Morton_points places, unsigned number_of_seeds, Seed* known)
{
  const Wide i = warp_index();
  if (i < number_of_seeds)
    known[i] = seed_at(Warp(), places, i * points_of_seed);
}

__global__ void list_growths(const Seed* known, unsigned stride, unsigned size,
                             Growth_of_deviations* growths)
{
  const Wide i = thread_index();
  if (i < size)
    growths[i] = growth_at(known[i * stride]);
}

__global__ void find_wanted_scales(Morton_points seeds, const Seed* known, Reference_scales usual,
                                   double widening, double* wanted)
{
  const Wide i = warp_index();
  if (i < seeds.size)
    wanted[i] = wanted_scale(Warp(), seeds, known, usual, widening, i);
}

/// Writes the scale of a seed, and counts those that are not 1.
__device__ void take_scale(double scale, double* taken, unsigned* number_of_others)
{
  *taken = scale;
  if (scale != 1 && Warp().lane() == 0)
    atomicAdd(number_of_others, 1u);
}

__global__ void find_scales(Morton_points seeds, const Seed* known, const double* wanted,
                            double* scales, unsigned* number_of_others)
{
  const Wide i = warp_index();
  if (i < seeds.size)
    take_scale(scale_of_group(Warp(), seeds, known, wanted, i), scales + i, number_of_others);
}

__global__ void limit_scales(Morton_points seeds, const Seed* known, const double* scales,
                             double radius, double* limited)
{
  const Wide i = warp_index();
  if (i < seeds.size)
    limited[i] = limited_scale(Warp(), seeds, known, scales, radius, i);
}

__global__ void span_surfaces(Morton_points seeds, const Seed* known, const double* scales,
                              double estimated_radius, double* spanning, unsigned* number_of_others)
{
  const Wide i = warp_index();
  if (i < seeds.size)
    take_scale(spanning_scale(Warp(), seeds, known, scales, estimated_radius, i), spanning + i,
               number_of_others);
}

__global__ void take_scales(Morton_points seeds, const Seed* known, const double* scales,
                            Scale_of_seed* taken)
{
  const Wide i = warp_index();
  if (i < seeds.size)
    taken[i] = scale_of_seed(Warp(), seeds, known, scales, i);
}

__global__ void read_scales(Positions positions, Morton_points seeds,
                            const Scale_of_seed* scales_of_seeds, double radius, float* scales)
{
  const Wide i = warp_index();
  if (i >= positions.size)
    return;
  const double3 p = positions(unsigned(i));
  const double xyz[3] = {p.x, p.y, p.z};
  scales[i] = scale_at(Warp(), seeds, scales_of_seeds, radius, xyz);
}

/// Waits for the device.
double widening_by_correlation(const Seed* known, unsigned number_of_seeds, Device_arena& scratch,
                               cudaStream_t stream)
{
  const Arena_scope scope(scratch);
  const unsigned stride = unsigned(stride_of_growth(number_of_seeds)),
                 size = (number_of_seeds + stride - 1) / stride;
  Growth_of_deviations* const growths = scratch.take<Growth_of_deviations>(size);
  list_growths<<<blocks_for(size), threads_per_block, 0, stream>>>(known, stride, size, growths);
  check_launch("list_growths");
  std::vector<Growth_of_deviations> on_host(size);
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(on_host.data(), growths, size * sizeof(Growth_of_deviations),
                                     cudaMemcpyDeviceToHost, stream));
  CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(stream));
  return internal::widening_by_correlation(on_host);
}

/// Waits for the device.
Range_of_scales range_of(const float* scales, unsigned size, Device_arena& scratch,
                         cudaStream_t stream)
{
  const Arena_scope scope(scratch);
  // the bits of positive numbers ascend as they do
  unsigned *const bits = scratch.take<unsigned>(size), *const other = scratch.take<unsigned>(size);
  CGAL_L0_CUDA_CHECK(
    cudaMemcpyAsync(bits, scales, size * sizeof(float), cudaMemcpyDeviceToDevice, stream));
  const unsigned* const sorted = sort_values(bits, other, size, scratch, stream);
  const auto scale_of_rank = [&](unsigned rank) {
    const unsigned found = scratch.read(sorted + rank, stream);
    float scale;
    std::memcpy(&scale, &found, sizeof(scale));
    return scale;
  };
  return {scale_of_rank(0), scale_of_rank(size / 2), scale_of_rank(size - 1)};
}

} // namespace

Scales_of_points estimate_scale_field(const Execution_context& context, const Positions& positions,
                                      double extent, const Reference_scales& usual)
{
  const double radius = usual.radius;
  const unsigned n = positions.size;
  const cudaStream_t stream = context.stream;
  Device_arena& scratch = context.scratch;
  float* const scales = context.arena.take<float>(n);
  const Arena_scope scope(scratch);
  const Morton_points places = places_of(context, positions, cells_of_places(extent)),
                      seeds = one_of_places(context, places, points_of_seed);
  const unsigned size = unsigned(seeds.size);

  const unsigned blocks = blocks_for(Wide(size) * Warp::number_of_threads);
  Seed* const known = scratch.take<Seed>(size);
  double *of_seeds = scratch.take<double>(size), *limited = scratch.take<double>(size);
  const Device_counter<unsigned> number_of_others(context), number_spanning(context);
  know_seeds<<<blocks, threads_per_block, 0, stream>>>(places, size, known);
  check_launch("know_seeds");
  find_wanted_scales<<<blocks, threads_per_block, 0, stream>>>(
    seeds, known, usual, widening_by_correlation(known, size, scratch, stream), limited);
  check_launch("find_wanted_scales");
  find_scales<<<blocks, threads_per_block, 0, stream>>>(seeds, known, limited, of_seeds,
                                                        number_of_others.address());
  check_launch("find_scales");
  const int sweeps = number_of_others.read() > 0 ? sweeps_over_seeds : 0;
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    limit_scales<<<blocks, threads_per_block, 0, stream>>>(seeds, known, of_seeds, radius, limited);
    check_launch("limit_scales");
    std::swap(of_seeds, limited);
  }
  span_surfaces<<<blocks, threads_per_block, 0, stream>>>(
    seeds, known, of_seeds, usual.estimated_radius, limited, number_spanning.address());
  check_launch("span_surfaces");
  if (number_spanning.read() == 0)
    return {nullptr, {}};
  Scale_of_seed* const taken = scratch.take<Scale_of_seed>(size);
  take_scales<<<blocks, threads_per_block, 0, stream>>>(seeds, known, limited, taken);
  check_launch("take_scales");
  read_scales<<<blocks_for(Wide(n) * Warp::number_of_threads), threads_per_block, 0, stream>>>(
    positions, seeds, taken, radius, scales);
  check_launch("read_scales");
  return {scales, range_of(scales, n, scratch, stream)};
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
