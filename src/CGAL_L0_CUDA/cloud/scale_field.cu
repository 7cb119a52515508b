// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"

#include <CGAL/L0_resampling/internal/kernels/scale_field.h>

#include <cstring>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

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

/// The seed or point of the warp of a thread.
__device__ Wide warp_index() { return thread_index() / Warp::number_of_threads; }

__global__ void find_codes(Positions positions, Morton_cells cells, Wide* codes)
{
  const Wide i = thread_index();
  if (i >= positions.size)
    return;
  const double3 p = positions(unsigned(i));
  const double xyz[3] = {p.x, p.y, p.z};
  codes[i] = cells.code(xyz);
}

__global__ void mark_first_of_codes(const Wide* codes, unsigned size, unsigned char* is_first)
{
  const Wide i = thread_index();
  if (i < size)
    is_first[i] = i == 0 || codes[i] != codes[i - 1];
}

/// \param list of the codes to take; null for one of so many
__global__ void take_places(const Wide* from, const unsigned* list, unsigned stride, unsigned size,
                            Morton_cells cells, std::uint64_t* codes, double* xyz)
{
  const Wide i = thread_index();
  if (i >= size)
    return;
  const Wide code = from[list ? list[i] : i * stride];
  codes[i] = code;
  for (int axis = 0; axis < 3; ++axis)
    xyz[3 * i + axis] = cells.middle(code, axis);
}

__global__ void know_seeds(Morton_points places, unsigned number_of_seeds, Seed* known,
                           double* reaches)
{
  const Wide i = warp_index();
  if (i >= number_of_seeds)
    return;
  const Seed seed = seed_at(Warp(), places, i * points_of_seed);
  known[i] = seed;
  reaches[i] = reach_of_seed(seed);
}

__global__ void list_growths(const Seed* known, unsigned stride, unsigned size,
                             Growth_of_deviations* growths)
{
  const Wide i = thread_index();
  if (i < size)
    growths[i] = growth_at(known[i * stride]);
}

__global__ void find_wanted_scales(Morton_points seeds, const Seed* known, Usual_scales usual,
                                   double widening, double* wanted)
{
  const Wide i = warp_index();
  if (i < seeds.size)
    wanted[i] = wanted_scale(Warp(), seeds, known, usual, widening, i);
}

__global__ void find_scales(Morton_points seeds, const Seed* known, const double* wanted,
                            double* scales, unsigned* number_of_others)
{
  const Wide i = warp_index();
  if (i >= seeds.size)
    return;
  const double scale = scale_of_group(Warp(), seeds, known, wanted, i);
  scales[i] = scale;
  if (scale != 1 && Warp().lane() == 0)
    atomicAdd(number_of_others, 1u);
}

__global__ void limit_scales(Morton_points seeds, const Seed* known, const double* scales,
                             double radius, double* limited)
{
  const Wide i = warp_index();
  if (i < seeds.size)
    limited[i] = limited_scale(Warp(), seeds, known, scales, radius, i);
}

__global__ void read_scales(Positions positions, Morton_points seeds, const double* reaches,
                            const double* scales_of_seeds, double radius, float* scales)
{
  const Wide i = warp_index();
  if (i >= positions.size)
    return;
  const double3 p = positions(unsigned(i));
  const double xyz[3] = {p.x, p.y, p.z};
  scales[i] = scale_at(Warp(), seeds, reaches, scales_of_seeds, radius, xyz);
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

Scales_of_points estimate_scale_field(const Workplace& workplace, const Positions& positions,
                                      double extent, const Usual_scales& usual)
{
  const double radius = usual.radius;
  const unsigned n = positions.size;
  const cudaStream_t stream = workplace.stream;
  Device_arena& scratch = workplace.scratch;
  float* const scales = workplace.arena.take<float>(n);
  const Arena_scope scope(scratch);
  const Morton_cells cells = Morton_cells::of_extent(4 * extent);
  const auto take = [&](const Wide* from, const unsigned* list, unsigned stride, unsigned size) {
    std::uint64_t* const codes = scratch.take<std::uint64_t>(size);
    double* const xyz = scratch.take<double>(3 * std::size_t(size));
    take_places<<<blocks_for(size), threads_per_block, 0, stream>>>(from, list, stride, size, cells,
                                                                    codes, xyz);
    check_launch("take_places");
    return Morton_points{cells, size, codes, xyz};
  };
  Wide *const codes = scratch.take<Wide>(n), *const other_codes = scratch.take<Wide>(n);
  find_codes<<<blocks_for(n), threads_per_block, 0, stream>>>(positions, cells, codes);
  check_launch("find_codes");
  const Wide* const sorted = sort_values(codes, other_codes, n, scratch, stream);
  unsigned char* const is_first = scratch.take<unsigned char>(n);
  unsigned* const list = scratch.take<unsigned>(n);
  mark_first_of_codes<<<blocks_for(n), threads_per_block, 0, stream>>>(sorted, n, is_first);
  check_launch("mark_first_of_codes");
  const unsigned number_of_places = list_flagged(is_first, n, list, scratch, stream);
  const Morton_points places = take(sorted, list, 1, number_of_places);
  const unsigned size = unsigned((number_of_places + points_of_seed - 1) / points_of_seed);
  const Morton_points seeds = take(reinterpret_cast<const Wide*>(places.codes), nullptr,
                                   points_of_seed, size);

  const unsigned blocks = blocks_for(Wide(size) * Warp::number_of_threads);
  Seed* const known = scratch.take<Seed>(size);
  double *const reaches = scratch.take<double>(size), *of_seeds = scratch.take<double>(size),
                *limited = scratch.take<double>(size);
  const Device_counter<unsigned> number_of_others(workplace);
  know_seeds<<<blocks, threads_per_block, 0, stream>>>(places, size, known, reaches);
  check_launch("know_seeds");
  find_wanted_scales<<<blocks, threads_per_block, 0, stream>>>(
    seeds, known, usual, widening_by_correlation(known, size, scratch, stream), limited);
  check_launch("find_wanted_scales");
  find_scales<<<blocks, threads_per_block, 0, stream>>>(seeds, known, limited, of_seeds,
                                                        number_of_others.address());
  check_launch("find_scales");
  if (number_of_others.read() == 0)
    return {nullptr, {}};
  for (int sweep = 0; sweep < sweeps_over_seeds; ++sweep)
  {
    limit_scales<<<blocks, threads_per_block, 0, stream>>>(seeds, known, of_seeds, radius, limited);
    check_launch("limit_scales");
    std::swap(of_seeds, limited);
  }
  read_scales<<<blocks_for(Wide(n) * Warp::number_of_threads), threads_per_block, 0, stream>>>(
    positions, seeds, reaches, of_seeds, radius, scales);
  check_launch("read_scales");
  return {scales, range_of(scales, n, scratch, stream)};
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
