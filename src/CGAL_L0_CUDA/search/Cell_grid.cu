// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/Cell_grid.cuh"

#include <CGAL/L0_resampling/internal/kernels/exact_ball.h>

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <cub/device/device_select.cuh>
#include <cuda/std/functional>
#include <thrust/iterator/counting_iterator.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

// Ranking the points of a cell takes the square of their number: more than this are sorted axis by
// axis instead.
constexpr unsigned maximum_size_of_ranked_cell = 2048;

// Cells of the box, for each point, up to which they are counted.
constexpr double maximum_number_of_counted_cells_per_point = 12;

/// What the host has to know of a grid.
struct Grid_counts
{
  unsigned number_of_cells;
  unsigned has_large_cell;
  unsigned number_of_distinct;
  unsigned levels; // a bit for each that has cells
};

/// Calls a function of CUB: once for the size of its scratch memory, once for the work.
template <typename F>
void with_scratch(Device_arena& scratch, const char* name, const F& f)
{
  const Arena_scope scope(scratch);
  std::size_t bytes = 0;
  check(f(nullptr, bytes), name);
  void* const memory = scratch.take<char>(bytes);
  check(f(memory, bytes), name);
}

void sort_pairs(Key*& keys, Key*& other_keys, unsigned*& values, unsigned*& other_values,
                unsigned size, int bits, Device_arena& scratch, cudaStream_t stream)
{
  cub::DoubleBuffer<Key> key_buffer(keys, other_keys);
  cub::DoubleBuffer<unsigned> value_buffer(values, other_values);
  with_scratch(scratch, "DeviceRadixSort::SortPairs", [&](void* memory, std::size_t& bytes) {
    return cub::DeviceRadixSort::SortPairs(memory, bytes, key_buffer, value_buffer, size, 0, bits,
                                           stream);
  });
  keys = key_buffer.Current();
  other_keys = key_buffer.Alternate();
  values = value_buffer.Current();
  other_values = value_buffer.Alternate();
}

__global__ void compute_keys(Positions positions, Cell_frame frame, Key* keys, unsigned* indices,
                             Grid_counts* counts)
{
  const unsigned long long i = thread_index();
  if (i >= positions.size)
    return;
  const float scale = positions.scale(unsigned(i));
  keys[i] = frame.key(positions(unsigned(i)), scale);
  indices[i] = unsigned(i);
  const unsigned level = 1u << level_of_scale(scale);
  if ((counts->levels & level) == 0)
    atomicOr(&counts->levels, level);
}

/// The number of a cell among all of the box, empty ones too; ascends as keys do.
__device__ unsigned number_in_box(const Cell_frame& frame, Key key)
{
  const uint3 cell = frame.cell_of_key(key);
  return (cell.z * frame.count[1] + cell.y) * frame.count[0] + cell.x;
}

__global__ void count_points_of_cells(Positions positions, Cell_frame frame, Key* keys,
                                      unsigned* counts)
{
  const unsigned long long i = thread_index();
  if (i >= positions.size)
    return;
  keys[i] = frame.key(positions(unsigned(i)), 1);
  atomicAdd(&counts[number_in_box(frame, keys[i])], 1u);
}

/// \param places in: where the points of each cell begin; out: where they end
__global__ void put_into_cells(const Key* keys, unsigned size, Cell_frame frame, unsigned* places,
                               Key* sorted_keys, unsigned* indices)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  const unsigned place = atomicAdd(&places[number_in_box(frame, keys[i])], 1u);
  sorted_keys[place] = keys[i];
  indices[place] = unsigned(i);
}

/// Sorts by cell, but within a cell in any order. Where the box has few cells, counting their
/// points is quicker than sorting keys, each pass of which takes 10 microseconds for however few.
/// \param keys, indices out
void sort_by_counting(const Positions& positions, const Cell_frame& frame, unsigned number_of_cells,
                      Key* keys, Key* other_keys, unsigned* indices, Device_arena& scratch,
                      cudaStream_t stream)
{
  const Arena_scope scope(scratch);
  unsigned* const places = scratch.take<unsigned>(number_of_cells);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(places, 0, number_of_cells * sizeof(unsigned), stream));
  const unsigned blocks = blocks_for(positions.size);
  count_points_of_cells<<<blocks, threads_per_block, 0, stream>>>(positions, frame, other_keys,
                                                                  places);
  check_launch("count_points_of_cells");
  with_scratch(scratch, "DeviceScan::ExclusiveSum", [&](void* memory, std::size_t& bytes) {
    return cub::DeviceScan::ExclusiveSum(memory, bytes, places, places, number_of_cells, stream);
  });
  put_into_cells<<<blocks, threads_per_block, 0, stream>>>(other_keys, positions.size, frame,
                                                           places, keys, indices);
  check_launch("put_into_cells");
}

__global__ void mark_first_of_cells(const Key* keys, unsigned size, unsigned* flags)
{
  const unsigned long long i = thread_index();
  if (i < size)
    flags[i] = i == 0 || keys[i] != keys[i - 1];
}

/// \param numbers for each point that of its cell, from 1
__global__ void find_begins(const unsigned* numbers, unsigned size, unsigned* begins)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  if (i == 0 || numbers[i] != numbers[i - 1])
    begins[numbers[i] - 1] = unsigned(i);
  if (i == size - 1)
    begins[numbers[i]] = size;
}

__global__ void gather_positions(Positions positions, const unsigned* order, double3* gathered)
{
  const unsigned long long i = thread_index();
  if (i < positions.size)
    gathered[i] = positions(order[i]);
}

__device__ int compare(double a, double b) { return a < b ? -1 : a > b; }

__device__ int compare(double3 a, double3 b)
{
  const int x = compare(a.x, b.x), y = compare(a.y, b.y), z = compare(a.z, b.z);
  return x ? x : y ? y : z;
}

__device__ int compare(const float* normals, unsigned i, unsigned k)
{
  const float* const a = normals + 3 * (unsigned long long)(i);
  const float* const b = normals + 3 * (unsigned long long)(k);
  for (int axis = 0; axis < 3; ++axis)
    if (a[axis] != b[axis])
      return a[axis] < b[axis] ? -1 : 1;
  return 0;
}

/// Puts each point of a cell behind those that come before it by coordinates, normals and index.
__global__ void rank_points(Cell_frame frame, const double3* positions, const unsigned* indices,
                            const unsigned* numbers, const unsigned* begins, const float* normals,
                            unsigned size, Cell_grid grid, Grid_counts* counts)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  const unsigned cell = numbers[i] - 1, begin = begins[cell], end = begins[cell + 1];
  if (i == 0)
    counts->number_of_cells = numbers[size - 1];
  if (end - begin > maximum_size_of_ranked_cell)
  {
    counts->has_large_cell = 1;
    return;
  }
  const double3 p = positions[i];
  const unsigned index = indices[i];
  unsigned rank = 0;
  bool is_first = true;
  for (unsigned k = begin; k < end; ++k)
  {
    const double x = positions[k].x;
    if (x > p.x || k == i)
      continue;
    int comparison = -1;
    if (x == p.x)
    {
      comparison = compare(positions[k], p);
      if (comparison == 0)
      {
        comparison = normals ? compare(normals, indices[k], index) : 0;
        if (comparison == 0)
          comparison = indices[k] < index ? -1 : 1;
        is_first = is_first && comparison > 0;
      }
    }
    rank += comparison < 0;
  }
  const int3 fixed = frame.fixed_point(p);
  grid.points[begin + rank] = make_int4(fixed.x, fixed.y, fixed.z, int(cell));
  grid.order[begin + rank] = index;
  grid.is_first[begin + rank] = is_first;
  if (is_first)
    atomicAdd(&counts->number_of_distinct, 1u);
}

/// Keys of one pass of the sort axis by axis: coordinates for `axis` 0 to 2, normals for 3 to 5,
/// cells for 6.
__global__ void compute_axis_keys(Positions positions, Cell_frame frame, const float* normals,
                                  int axis, const unsigned* order, Key* keys)
{
  const unsigned long long i = thread_index();
  if (i >= positions.size)
    return;
  if (axis >= 3 && axis < 6)
  {
    keys[i] = ascending_bits(normals[3 * (unsigned long long)(order[i]) + (axis - 3)]);
    return;
  }
  const double3 p = positions(order[i]);
  keys[i] = axis == 6 ? frame.key(p, positions.scale(order[i]))
                      : ascending_bits(axis == 0   ? p.x
                                       : axis == 1 ? p.y
                                                   : p.z);
}

__global__ void take_sorted_points(Cell_frame frame, const double3* positions,
                                   const unsigned* indices, const unsigned* numbers, unsigned size,
                                   Cell_grid grid, Grid_counts* counts)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  const int3 fixed = frame.fixed_point(positions[i]);
  const bool is_first = i == 0 || compare(positions[i - 1], positions[i]) != 0;
  grid.points[i] = make_int4(fixed.x, fixed.y, fixed.z, int(numbers[i] - 1));
  grid.order[i] = indices[i];
  grid.is_first[i] = is_first;
  if (is_first)
    atomicAdd(&counts->number_of_distinct, 1u);
}

__global__ void copy_cells(const Key* point_keys, const unsigned* begins, Cell_grid grid)
{
  const unsigned long long c = thread_index();
  if (c > grid.number_of_cells)
    return;
  grid.begins[c] = begins[c];
  if (c < grid.number_of_cells)
    grid.keys[c] = point_keys[begins[c]];
}

__global__ void gather_scales(Positions positions, Cell_grid grid)
{
  const unsigned long long i = thread_index();
  if (i < grid.size)
    grid.scales[i] = positions.scale(grid.order[i]);
}

int bits_for(unsigned count)
{
  int bits = 0;
  while ((1ull << bits) < count)
    ++bits;
  return bits;
}

} // namespace

Cell_frame Cell_frame::around(const double (&low)[3], const double (&high)[3], double cell_size,
                              double longest_query, bool has_levels)
{
  Cell_frame frame;
  frame.cell_size = cell_size;
  frame.has_levels = has_levels;
  frame.units_per_length = units_per_length_for(cell_size, longest_query, has_levels);
  for (int axis = 0; axis < 3; ++axis)
  {
    frame.low[axis] = low[axis];
    frame.high[axis] = high[axis];
    frame.first[axis] = frame.first_of_level(level_of_one, axis);
    frame.count[axis] = frame.count_of_level(level_of_one, axis);
    frame.bits[axis] = bits_for(has_levels ? frame.count_of_level(0, axis) : frame.count[axis]);
  }
  return frame;
}

Cell_grid build_grid(const Positions& positions, const float* normals, const Cell_frame& frame,
                     Device_arena& arena, Device_arena& arena_of_order, Device_arena& scratch,
                     cudaStream_t stream)
{
  const unsigned n = positions.size, blocks = blocks_for(n);
  Cell_grid grid;
  grid.frame = frame;
  grid.size = n;
  grid.points = arena.take<int4>(n);
  grid.order = arena_of_order.take<unsigned>(n);
  grid.is_first = arena_of_order.take<unsigned char>(n);

  const Arena_scope scope(scratch);
  Grid_counts* const device_counts = scratch.take<Grid_counts>(1);
  // gathered last, where the other keys and the flags were before
  double3* const gathered = scratch.take<double3>(n);
  Key* const kept_keys = scratch.take<Key>(n);
  Key *keys = kept_keys, *other_keys = reinterpret_cast<Key*>(gathered);
  unsigned* const flags = reinterpret_cast<unsigned*>(other_keys + n);
  unsigned *indices = scratch.take<unsigned>(n), *other_indices = scratch.take<unsigned>(n);
  unsigned* const begins = scratch.take<unsigned>(std::size_t(n) + 1);

  const auto number_cells = [&]() {
    mark_first_of_cells<<<blocks, threads_per_block, 0, stream>>>(keys, n, flags);
    check_launch("mark_first_of_cells");
    with_scratch(scratch, "DeviceScan::InclusiveSum", [&](void* memory, std::size_t& bytes) {
      return cub::DeviceScan::InclusiveSum(memory, bytes, flags, other_indices, n, stream);
    });
    find_begins<<<blocks, threads_per_block, 0, stream>>>(other_indices, n, begins);
    check_launch("find_begins");
    if (keys != kept_keys)
    {
      CGAL_L0_CUDA_CHECK(
        cudaMemcpyAsync(kept_keys, keys, n * sizeof(Key), cudaMemcpyDeviceToDevice, stream));
      std::swap(keys, other_keys);
    }
    gather_positions<<<blocks, threads_per_block, 0, stream>>>(positions, indices, gathered);
    check_launch("gather_positions");
  };
  Grid_counts counts;
  const auto read_counts = [&]() { counts = scratch.read(device_counts, stream); };

  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(device_counts, 0, sizeof(Grid_counts), stream));
  const double cells_of_box = double(frame.count[0]) * double(frame.count[1])
                              * double(frame.count[2]);
  if (!frame.has_levels
      && cells_of_box <= (std::min)(maximum_number_of_counted_cells_per_point * double(n), 2e9))
    sort_by_counting(positions, frame, unsigned(cells_of_box), keys, other_keys, indices, scratch,
                     stream);
  else
  {
    compute_keys<<<blocks, threads_per_block, 0, stream>>>(positions, frame, keys, indices,
                                                           device_counts);
    check_launch("compute_keys");
    sort_pairs(keys, other_keys, indices, other_indices, n, frame.total_bits(), scratch, stream);
  }
  number_cells();
  rank_points<<<blocks, threads_per_block, 0, stream>>>(frame, gathered, indices, other_indices,
                                                        begins, normals, n, grid, device_counts);
  check_launch("rank_points");
  read_counts();

  if (counts.has_large_cell)
  {
    // A radix sort keeps the order of equal keys: the last pass decides first.
    CGAL_L0_CUDA_CHECK(cudaMemsetAsync(device_counts, 0, sizeof(Grid_counts), stream));
    compute_keys<<<blocks, threads_per_block, 0, stream>>>(positions, frame, keys, indices,
                                                           device_counts);
    check_launch("compute_keys");
    for (const int axis : {5, 4, 3, 2, 1, 0, 6})
    {
      if (axis >= 3 && axis < 6 && !normals)
        continue;
      compute_axis_keys<<<blocks, threads_per_block, 0, stream>>>(positions, frame, normals, axis,
                                                                  indices, keys);
      check_launch("compute_axis_keys");
      sort_pairs(keys, other_keys, indices, other_indices, n, axis == 6 ? frame.total_bits() : 64,
                 scratch, stream);
    }
    number_cells();
    take_sorted_points<<<blocks, threads_per_block, 0, stream>>>(
      frame, gathered, indices, other_indices, n, grid, device_counts);
    check_launch("take_sorted_points");
    const unsigned number_of_cells = counts.number_of_cells;
    read_counts();
    counts.number_of_cells = number_of_cells;
  }
  grid.number_of_cells = counts.number_of_cells;
  grid.number_of_distinct = counts.number_of_distinct;

  grid.keys = arena.take<Key>(grid.number_of_cells);
  grid.begins = arena.take<unsigned>(std::size_t(grid.number_of_cells) + 1);
  copy_cells<<<blocks_for(grid.number_of_cells + 1ull), threads_per_block, 0, stream>>>(
    keys, begins, grid);
  check_launch("copy_cells");
  if (frame.has_levels)
  {
    grid.levels = counts.levels;
    grid.scales = arena.take<float>(n);
    gather_scales<<<blocks, threads_per_block, 0, stream>>>(positions, grid);
    check_launch("gather_scales");
  }
  return grid;
}

unsigned list_flagged(const unsigned char* flags, unsigned size, unsigned* indices,
                      Device_arena& scratch, cudaStream_t stream)
{
  const Arena_scope scope(scratch);
  unsigned* const count = scratch.take<unsigned>(1);
  with_scratch(scratch, "DeviceSelect::Flagged", [&](void* memory, std::size_t& bytes) {
    return cub::DeviceSelect::Flagged(memory, bytes, thrust::counting_iterator<unsigned>(0), flags,
                                      indices, count, size, stream);
  });
  return scratch.read(count, stream);
}

template <typename T>
void sum_up(const T* counts, unsigned size, T* offsets, Device_arena& scratch, cudaStream_t stream)
{
  with_scratch(scratch, "DeviceScan::ExclusiveSum", [&](void* memory, std::size_t& bytes) {
    return cub::DeviceScan::ExclusiveSum(memory, bytes, counts, offsets, std::size_t(size) + 1,
                                         stream);
  });
}

template void sum_up(const unsigned*, unsigned, unsigned*, Device_arena&, cudaStream_t);
template void sum_up(const unsigned long long*, unsigned, unsigned long long*, Device_arena&,
                     cudaStream_t);

template <typename T>
T* sort_values(T* values, T* other, unsigned size, Device_arena& scratch, cudaStream_t stream)
{
  cub::DoubleBuffer<T> buffer(values, other);
  with_scratch(scratch, "DeviceRadixSort::SortKeys", [&](void* memory, std::size_t& bytes) {
    return cub::DeviceRadixSort::SortKeys(memory, bytes, buffer, size, 0, int(8 * sizeof(T)),
                                          stream);
  });
  return buffer.Current();
}

template unsigned* sort_values(unsigned*, unsigned*, unsigned, Device_arena&, cudaStream_t);
template unsigned long long* sort_values(unsigned long long*, unsigned long long*, unsigned,
                                         Device_arena&, cudaStream_t);
template double* sort_values(double*, double*, unsigned, Device_arena&, cudaStream_t);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
