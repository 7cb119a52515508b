// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/guarded.cuh"

#include <CGAL/L0_resampling/internal/device/cuda_device_arrays.h>

#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

using Hash = unsigned long long;

__device__ double number_at(const Device_rows& rows, unsigned row, int column)
{
  const char* const address = static_cast<const char*>(rows.data)
                              + std::ptrdiff_t(row) * rows.row_stride + column * rows.column_stride;
  return rows.is_double ? *reinterpret_cast<const double*>(address)
                        : double(*reinterpret_cast<const float*>(address));
}

__device__ double3 row_at(const Device_rows& rows, unsigned row)
{
  return {number_at(rows, row, 0), number_at(rows, row, 1), number_at(rows, row, 2)};
}

__device__ bool is_finite(double3 v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }

/// \param last_from_end in: 0; out: how far the first point that is not finite is from the end; 0
/// if there is none
__global__ void look_for_non_finite(Device_rows rows, unsigned size, unsigned char* are_finite,
                                    unsigned* last_from_end)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  const bool is = is_finite(row_at(rows, unsigned(i)));
  are_finite[i] = is;
  if (!is)
    atomicMax(last_from_end, size - unsigned(i));
}

/// \param list of the rows that are taken; null for the first `size`
__global__ void take_rows(Device_rows rows, const unsigned* list, unsigned size, double* taken)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  const double3 row = row_at(rows, list ? list[i] : unsigned(i));
  taken[3 * i] = row.x;
  taken[3 * i + 1] = row.y;
  taken[3 * i + 2] = row.z;
}

/// Vectors of unit length, or zero where the caller's is of no use, as `read_directions()` on the
/// host.
/// \param viewpoints_of points that the rows are viewpoints of, whose directions are taken; null
/// where the rows are directions
/// \param has_one_sign whether the first coordinate that is not zero is made positive, as
/// `read_normals()` does
__global__ void take_directions(Device_rows rows, const unsigned* list, unsigned size,
                                const double* viewpoints_of, bool has_one_sign, float* taken)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  double3 v = row_at(rows, list ? list[i] : unsigned(i));
  if (viewpoints_of) // half way, as the whole one may not be finite
  {
    const double* const p = viewpoints_of + 3 * i;
    v = {0.5 * v.x - 0.5 * p[0], 0.5 * v.y - 0.5 * p[1], 0.5 * v.z - 0.5 * p[2]};
  }
  const double largest = fmax(fmax(fabs(v.x), fabs(v.y)), fabs(v.z));
  double3 direction = {0, 0, 0};
  if (is_finite(v) && largest > 0)
  {
    const double3 scaled = {v.x / largest, v.y / largest, v.z / largest};
    const double length = sqrt(dot(scaled, scaled));
    direction = {scaled.x / length, scaled.y / length, scaled.z / length};
  }
  float3 rounded = to_float(direction);
  const bool is_negative =
    rounded.x < 0 || (rounded.x == 0 && (rounded.y < 0 || (rounded.y == 0 && rounded.z < 0)));
  if (has_one_sign && is_negative)
    rounded = {-rounded.x, -rounded.y, -rounded.z};
  taken[3 * i] = rounded.x;
  taken[3 * i + 1] = rounded.y;
  taken[3 * i + 2] = rounded.z;
}

template <typename FT>
struct Box
{
  FT low[3], high[3];
};

__device__ Hash bits_of(float number) { return __float_as_uint(number); }
__device__ Hash bits_of(double number) { return Hash(__double_as_longlong(number)); }

/// A bijection that changes every bit of the result with half the probability if one bit of the
/// argument changes.
__device__ Hash mixed(Hash bits)
{
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ull;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebull;
  return bits ^ (bits >> 31);
}

template <typename FT>
__global__ void round_result(const double* positions, const float* normals, unsigned size,
                             Box<FT> box, FT* rounded_positions, FT* rounded_normals, Hash* hashes)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  Hash hash = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const FT x = FT(
      fmin(fmax(positions[3 * i + axis], double(box.low[axis])), double(box.high[axis])));
    rounded_positions[3 * i + axis] = x;
    rounded_normals[3 * i + axis] = FT(normals[3 * i + axis]);
    hash = mixed(hash ^ (x == 0 ? 0 : bits_of(x))); // 0 and -0 are equal
  }
  hashes[i] = hash;
}

__global__ void count_equal_neighbors(const Hash* sorted, unsigned size, unsigned* count)
{
  const unsigned long long i = thread_index();
  if (i + 1 < size && sorted[i] == sorted[i + 1])
    atomicAdd(count, 1u);
}

} // namespace

Answer wait_for(Session& session, std::int64_t stream)
{
  return guarded(&session, [&]() {
    cudaEvent_t event;
    CGAL_L0_CUDA_CHECK(cudaEventCreateWithFlags(&event, cudaEventDisableTiming));
    const cudaError_t recorded =
      cudaEventRecord(event, reinterpret_cast<cudaStream_t>(std::intptr_t(stream)));
    const cudaError_t waits = recorded == cudaSuccess
                                ? cudaStreamWaitEvent(session.stream, event, 0)
                                : cudaSuccess;
    cudaEventDestroy(event); // once the work before it is done
    check(recorded, "cudaEventRecord");
    check(waits, "cudaStreamWaitEvent");
  });
}

Answer upload_from_device(Session& session, const Device_rows& points, std::size_t size,
                          const Device_rows* normals, const Device_rows* hints,
                          bool hints_are_viewpoints, bool drop_non_finite,
                          std::size_t maximum_memory, Device_points& taken)
{
  return guarded(&session, [&]() {
    taken = Device_points();
    taken.first_non_finite = size;
    const Session::Input_arrays arrays = session.reserve_input(size, normals, hints,
                                                               maximum_memory);
    const Execution_context context = session.context();
    unsigned kept = unsigned(size);
    {
      const Arena_scope scope(session.scratch);
      unsigned char* const are_finite = session.scratch.take<unsigned char>(size);
      const Device_counter<unsigned> last_from_end(context);
      look_for_non_finite<<<blocks_for(size), threads_per_block, 0, session.stream>>>(
        points, unsigned(size), are_finite, last_from_end.address());
      check_launch("look_for_non_finite");
      const unsigned* list = nullptr;
      const unsigned from_end = last_from_end.read();
      taken.first_non_finite = size - from_end;
      if (from_end > 0)
      {
        if (!drop_non_finite)
          return;
        unsigned* const indices = session.scratch.take<unsigned>(size);
        kept = list_flagged(are_finite, unsigned(size), indices, session.scratch, session.stream);
        list = indices;
      }
      if (kept == 0)
        return;
      take_rows<<<blocks_for(kept), threads_per_block, 0, session.stream>>>(points, list, kept,
                                                                            arrays.points);
      check_launch("take_rows");
      const auto take_vectors = [&](const Device_rows* rows, const double* viewpoints_of,
                                    bool has_one_sign, float* target) {
        if (!rows)
          return;
        take_directions<<<blocks_for(kept), threads_per_block, 0, session.stream>>>(
          *rows, list, kept, viewpoints_of, has_one_sign, target);
        check_launch("take_directions");
      };
      take_vectors(normals, nullptr, true, arrays.normals);
      take_vectors(hints, hints_are_viewpoints ? arrays.points : nullptr, false, arrays.hints);
    }
    session.filter_input(arrays, kept);
    taken.size = kept;
    for (int axis = 0; axis < 3; ++axis)
    {
      taken.low[axis] = session.extent.low_of_input[axis];
      taken.high[axis] = session.extent.high_of_input[axis];
    }
  });
}

template <typename FT>
Answer download_to_device(Session& session, const FT* low, const FT* high, FT* positions,
                          FT* normals, bool& may_have_equal_points)
{
  return guarded(&session, [&]() {
    const unsigned m = session.number_of_samples;
    Box<FT> box;
    for (int axis = 0; axis < 3; ++axis)
    {
      box.low[axis] = low[axis];
      box.high[axis] = high[axis];
    }
    const Arena_scope scope(session.scratch);
    Hash* const hashes = session.scratch.take<Hash>(m);
    Hash* const other = session.scratch.take<Hash>(m);
    const Device_counter<unsigned> equal(session.context());
    round_result<<<blocks_for(m), threads_per_block, 0, session.stream>>>(
      session.positions, session.sample_normals, m, box, positions, normals, hashes);
    check_launch("round_result");
    const Hash* const sorted = sort_values(hashes, other, m, session.scratch, session.stream);
    count_equal_neighbors<<<blocks_for(m), threads_per_block, 0, session.stream>>>(sorted, m,
                                                                                   equal.address());
    check_launch("count_equal_neighbors");
    may_have_equal_points = equal.read() > 0; // waits for all of it
  });
}

template Answer download_to_device(Session&, const float*, const float*, float*, float*, bool&);
template Answer download_to_device(Session&, const double*, const double*, double*, double*, bool&);

Answer find_device_of(const void* data, int& device)
{
  return guarded(nullptr, [&]() {
    cudaPointerAttributes attributes;
    CGAL_L0_CUDA_CHECK(cudaPointerGetAttributes(&attributes, data));
    if (attributes.type != cudaMemoryTypeDevice && attributes.type != cudaMemoryTypeManaged)
      throw Failure(Status::DEVICE_FAILED, "the memory is of no device");
    device = attributes.device;
  });
}

Answer allocate(Session& session, std::size_t bytes, void*& data)
{
  data = nullptr;
  return guarded(&session, [&]() { CGAL_L0_CUDA_CHECK(cudaMalloc(&data, bytes)); });
}

void give_back(int device, void* data) noexcept
{
  if (is_forked()) // what a child cannot give back, its end does
    return;
  int previous = 0;
  const bool has_previous = cudaGetDevice(&previous) == cudaSuccess;
  cudaSetDevice(device);
  cudaFree(data);
  if (has_previous)
    cudaSetDevice(previous);
  cudaGetLastError();
}

Answer copy_to_device(Session& session, const void* source, std::size_t bytes, void* target)
{
  return guarded(&session, [&]() {
    CGAL_L0_CUDA_CHECK(
      cudaMemcpyAsync(target, source, bytes, cudaMemcpyHostToDevice, session.stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

Answer copy_to_host(int device, const void* source, std::size_t bytes, void* target)
{
  return guarded(nullptr, [&]() {
    const Device_scope scope(device);
    CGAL_L0_CUDA_CHECK(cudaMemcpy(target, source, bytes, cudaMemcpyDeviceToHost));
  });
}

Answer copy_to_host(Session& session, const Device_rows& rows, std::size_t size, double* target)
{
  return guarded(&session, [&]() {
    const Arena_scope scope(session.scratch);
    double* const gathered = session.scratch.take<double>(3 * size);
    take_rows<<<blocks_for(size), threads_per_block, 0, session.stream>>>(rows, nullptr,
                                                                          unsigned(size), gathered);
    check_launch("take_rows");
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(target, gathered, 3 * size * sizeof(double),
                                       cudaMemcpyDeviceToHost, session.stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
