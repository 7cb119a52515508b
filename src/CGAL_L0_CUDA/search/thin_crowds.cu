// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/Query.cuh"
#include "search/representatives.cuh"

#include <CGAL/L0_resampling/internal/kernels/crowded_subcells.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

constexpr unsigned lanes_of_warp = 32, warps_per_block = 4;

/// One warp counts the points in the subcells of a cell.
struct Cell_of_warp
{
  unsigned begin, end;
  unsigned* counts; ///< one for each subcell, in shared memory; set if the cell is crowded

  __device__ static unsigned index()
  {
    return blockIdx.x * warps_per_block + threadIdx.x / lanes_of_warp;
  }

  /// \returns whether a subcell holds more than `limit` points; the same in all threads of the warp
  __device__ bool count(const Positions& positions, const Cell_grid& grid, unsigned limit)
  {
    const unsigned cell = index(), lane = threadIdx.x % lanes_of_warp;
    begin = grid.begins[cell];
    end = grid.begins[cell + 1];
    if (end - begin <= limit || is_outermost(grid.frame, grid.keys[cell]))
      return false;
    for (unsigned s = lane; s < subcells_of_cell; s += lanes_of_warp)
      counts[s] = 0;
    __syncwarp();
    for (unsigned j = begin + lane; j < end; j += lanes_of_warp)
      atomicAdd(&counts[subcell(positions, grid, j)], 1u);
    __syncwarp();
    bool is_crowded = false;
    for (unsigned s = lane; s < subcells_of_cell; s += lanes_of_warp)
      is_crowded = is_crowded || counts[s] > limit;
    return __any_sync(0xffffffffu, is_crowded);
  }

  __device__ static unsigned subcell(const Positions& positions, const Cell_grid& grid, unsigned j)
  {
    const double3 p = positions(grid.order[j]);
    const double xyz[3] = {p.x, p.y, p.z};
    const int level = grid.frame.level_of_key(grid.keys[grid.points[j].w]);
    return subcell_of(xyz, grid.frame.size_of_level(level));
  }

private:
  /// Whether the cell collects all that lies beyond, as `Search_grid_3::is_unbounded()`.
  __device__ static bool is_outermost(const Cell_frame& frame, Key key)
  {
    const int level = frame.level_of_key(key);
    const uint3 cell = frame.cell_of_key(key);
    const auto is_on_axis = [&](unsigned place, int axis) {
      const double absolute = frame.first_of_level(level, axis) + place;
      return absolute <= -Cell_frame::half_range || absolute >= Cell_frame::half_range - 1;
    };
    return is_on_axis(cell.x, 0) || is_on_axis(cell.y, 1) || is_on_axis(cell.z, 2);
  }
};

__global__ void count_crowded_cells(Positions positions, Cell_grid grid, unsigned limit,
                                    unsigned* number)
{
  __shared__ unsigned counts[warps_per_block][subcells_of_cell];
  if (Cell_of_warp::index() >= grid.number_of_cells)
    return;
  Cell_of_warp cell = {0, 0, counts[threadIdx.x / lanes_of_warp]};
  if (cell.count(positions, grid, limit) && threadIdx.x % lanes_of_warp == 0)
    atomicAdd(number, 1u);
}

/// \param of_points out: for each point of the grid, the one that stands for it
__global__ void find_representatives(Positions positions, Cell_grid grid, unsigned limit,
                                     unsigned* of_points, unsigned char* is_kept)
{
  __shared__ unsigned counts[warps_per_block][subcells_of_cell],
    ranks[warps_per_block][subcells_of_cell], last_kept[warps_per_block][subcells_of_cell];
  if (Cell_of_warp::index() >= grid.number_of_cells)
    return;
  const unsigned warp = threadIdx.x / lanes_of_warp, lane = threadIdx.x % lanes_of_warp;
  Cell_of_warp cell = {0, 0, counts[warp]};
  const bool is_crowded = cell.count(positions, grid, limit);
  for (unsigned s = lane; s < subcells_of_cell; s += lanes_of_warp)
    ranks[warp][s] = 0;
  __syncwarp();
  // The points of a subcell are counted in their order: those of lower lanes come first.
  for (unsigned first = cell.begin; first < cell.end; first += lanes_of_warp)
  {
    const unsigned j = first + lane;
    const bool is_point = j < cell.end;
    const unsigned s = is_point && is_crowded ? Cell_of_warp::subcell(positions, grid, j)
                                              : subcells_of_cell;
    const unsigned of_same_subcell = __match_any_sync(0xffffffffu, s);
    bool keep = is_point;
    unsigned representative = j;
    if (s < subcells_of_cell)
    {
      const unsigned before = of_same_subcell & ((1u << lane) - 1);
      keep = is_kept_of_crowd(ranks[warp][s] + unsigned(__popc(before)), cell.counts[s], limit);
    }
    const unsigned kept = __ballot_sync(0xffffffffu, keep);
    if (s < subcells_of_cell)
    {
      const unsigned kept_before = kept & of_same_subcell
                                   & ((2u << lane) - 1); // and the point itself
      representative = kept_before ? first + (31u - unsigned(__clz(int(kept_before))))
                                   : last_kept[warp][s];
    }
    __syncwarp();
    if (s < subcells_of_cell && lane == 31u - unsigned(__clz(int(of_same_subcell))))
    {
      ranks[warp][s] += unsigned(__popc(of_same_subcell));
      last_kept[warp][s] = representative;
    }
    __syncwarp();
    if (is_point)
    {
      of_points[j] = representative;
      is_kept[j] = keep;
    }
  }
}

__global__ void number_the_kept(const unsigned* kept, unsigned size, unsigned* numbers)
{
  const unsigned long long k = thread_index();
  if (k < size)
    numbers[kept[k]] = unsigned(k);
}

/// \param of_points in: for each point, the one that stands for it; out: the number of that one
__global__ void tell_numbers(unsigned* of_points, unsigned size, const unsigned* numbers)
{
  const unsigned long long j = thread_index();
  if (j < size)
    of_points[j] = numbers[of_points[j]];
}

__global__ void count_represented(const unsigned* places, unsigned size,
                                  unsigned* numbers_of_points)
{
  const unsigned long long j = thread_index();
  if (j < size)
    atomicAdd(&numbers_of_points[places[j]], 1u);
}

/// The followers in the order of the grid, behind each other.
/// \param numbers of the kept ones among themselves
__global__ void part_followers(Samples samples, const unsigned* order, const unsigned* of_points,
                               const unsigned* followers, unsigned number_of_followers,
                               const unsigned* numbers, Duplicate_samples result)
{
  const unsigned long long f = thread_index();
  if (f >= number_of_followers)
    return;
  const unsigned j = followers[f], leader = of_points[j];
  result.leaders[f] = numbers[leader];
  for (int axis = 0; axis < 3; ++axis)
    result.offsets[3 * f + axis] = samples.positions[3ull * order[j] + axis]
                                   - samples.positions[3ull * order[leader] + axis];
  if (samples.are_own)
    result.are_own[f] = samples.are_own[order[j]];
  atomicAdd(&result.numbers_of_samples[numbers[leader]], 1u);
}

__global__ void fill_ascending(unsigned size, unsigned* start_indices, unsigned* numbers_of_samples)
{
  const unsigned long long i = thread_index();
  if (i >= size)
    return;
  start_indices[i] = unsigned(i);
  numbers_of_samples[i] = 1;
}

__global__ void invert_flags(unsigned size, unsigned char* flags)
{
  const unsigned long long i = thread_index();
  if (i < size)
    flags[i] = !flags[i];
}

/// \param list what the order counts; null if that is what it lists
/// \param kept which points of the grid; null for all
__global__ void list_order(const unsigned* list, const unsigned* order, const unsigned* kept,
                           unsigned size, unsigned* listed)
{
  const unsigned long long k = thread_index();
  if (k >= size)
    return;
  const unsigned before = order[kept ? kept[k] : unsigned(k)];
  listed[k] = list ? list[before] : before;
}

__global__ void find_places(Samples samples, unsigned* places)
{
  const unsigned long long i = thread_index();
  if (i < samples.size)
    places[samples.start_indices[i]] = unsigned(i);
}

__global__ void append(Samples samples, Duplicate_samples followers, const unsigned* places)
{
  const unsigned long long f = thread_index();
  if (f >= followers.size)
    return;
  const unsigned long long i = samples.size + f, leader = places[followers.leaders[f]];
  for (int axis = 0; axis < 3; ++axis)
    samples.positions[3 * i + axis] = samples.positions[3 * leader + axis]
                                      + followers.offsets[3 * f + axis];
  samples.normals[i] = samples.normals[leader];
  samples.side_confidences[i] = samples.side_confidences[leader];
  if (samples.scales)
    samples.scales[i] = samples.scales[leader];
  if (samples.noises)
    samples.noises[i] = samples.noises[leader];
  if (samples.position_deviations)
  {
    samples.position_deviations[i] = samples.position_deviations[leader];
    samples.normal_deviations[i] = samples.normal_deviations[leader];
  }
  if (samples.are_own)
    samples.are_own[i] = followers.are_own[f];
  if (samples.trees)
    samples.trees[i] = samples.trees[leader];
}

unsigned blocks_for_cells(const Cell_grid& grid)
{
  return (grid.number_of_cells + warps_per_block - 1) / warps_per_block;
}

/// \returns whether there are crowds; waits for the device
bool has_crowds(const Execution_context& context, const Positions& positions, const Cell_grid& grid,
                unsigned limit)
{
  const Arena_scope scope(context.scratch);
  const Device_counter<unsigned> number_of_crowded_cells(context);
  count_crowded_cells<<<blocks_for_cells(grid), lanes_of_warp * warps_per_block, 0,
                        context.stream>>>(positions, grid, limit,
                                          number_of_crowded_cells.address());
  check_launch("count_crowded_cells");
  return number_of_crowded_cells.read() > 0;
}

/// For the points of a grid, in its order: who stands for each, and the kept ones.
struct Representatives_of_crowds
{
  unsigned* of_points;
  unsigned char* is_kept;
  unsigned* kept;
  unsigned number_of_kept;
};

/// From the scratch arena.
Representatives_of_crowds representatives(const Execution_context& context,
                                          const Positions& positions, const Cell_grid& grid,
                                          unsigned limit)
{
  Representatives_of_crowds result = {context.scratch.take<unsigned>(grid.size),
                                      context.scratch.take<unsigned char>(grid.size),
                                      context.scratch.take<unsigned>(grid.size), 0};
  find_representatives<<<blocks_for_cells(grid), lanes_of_warp * warps_per_block, 0,
                         context.stream>>>(positions, grid, limit, result.of_points,
                                           result.is_kept);
  check_launch("find_representatives");
  result.number_of_kept = list_flagged(result.is_kept, grid.size, result.kept, context.scratch,
                                       context.stream);
  return result;
}

/// \param places of what stands for the points of the grid; null if each does for itself
/// \param of_former out: the same for the points in their order before
__global__ void find_new_places(const unsigned* order, const unsigned* places, unsigned size,
                                unsigned* of_former)
{
  const Wide j = thread_index();
  if (j < size)
    of_former[order[j]] = places ? places[j] : unsigned(j);
}

} // namespace

Representatives representatives_of_crowds(const Execution_context& context,
                                          const Positions& positions, const Cell_grid& grid,
                                          unsigned limit)
{
  if (!has_crowds(context, positions, grid, limit))
    return {nullptr, nullptr, grid.size};
  const cudaStream_t stream = context.stream;
  const Representatives_of_crowds found = representatives(context, positions, grid, limit);
  const Arena_scope scope(context.scratch);
  unsigned* const numbers = context.scratch.take<unsigned>(grid.size);
  number_the_kept<<<blocks_for(found.number_of_kept), threads_per_block, 0, stream>>>(
    found.kept, found.number_of_kept, numbers);
  check_launch("number_the_kept");
  tell_numbers<<<blocks_for(grid.size), threads_per_block, 0, stream>>>(found.of_points, grid.size,
                                                                        numbers);
  check_launch("tell_numbers");
  return {found.of_points, found.kept, found.number_of_kept};
}

void find_places_of_points(const Execution_context& context, const Cell_grid& grid,
                           const Representatives& representatives, unsigned* of_former)
{
  find_new_places<<<blocks_for(grid.size), threads_per_block, 0, context.stream>>>(
    grid.order, representatives.places, grid.size, of_former);
  check_launch("find_new_places");
}

void list_kept(const Execution_context& context, const Positions& positions, const Cell_grid& grid,
               const unsigned* kept, unsigned number_of_kept, unsigned* listed)
{
  list_order<<<blocks_for(number_of_kept), threads_per_block, 0, context.stream>>>(
    positions.list, grid.order, kept, number_of_kept, listed);
  check_launch("list_order");
}

const unsigned* thin_crowds(const Execution_context& context, const Positions& positions,
                            const Cell_grid& grid, unsigned& size,
                            const unsigned*& numbers_of_points)
{
  numbers_of_points = nullptr;
  const Arena_scope scope(context.scratch);
  const Representatives found = representatives_of_crowds(context, positions, grid,
                                                          maximum_number_of_points_of_subcell);
  size = found.number_of_kept;
  if (found.are_all_points())
    return nullptr;
  unsigned *const listed = context.arena.take<unsigned>(grid.size), *const numbers =
                                                                      context.arena.take<unsigned>(
                                                                        grid.size);
  list_kept(context, positions, grid, found.kept, size, listed);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(numbers, 0, size * sizeof(unsigned), context.stream));
  count_represented<<<blocks_for(grid.size), threads_per_block, 0, context.stream>>>(
    found.places, grid.size, numbers);
  check_launch("count_represented");
  numbers_of_points = numbers;
  return listed;
}

Duplicate_samples take_followers(const Execution_context& context, const Cell_frame& frame,
                                 Samples& samples)
{
  const cudaStream_t stream = context.stream;
  const unsigned m = samples.size;
  const Positions positions = {samples.positions,      m, Frame(), true, nullptr,
                               samples.spreading_radii};
  const Arena_scope arena_scope(context.arena);
  const Cell_grid grid = build_grid(positions, nullptr, frame, context.arena, context.scratch,
                                    stream);
  if (!has_crowds(context, positions, grid, maximum_number_of_samples_of_subcell))
    return {};
  // what outlives this function first
  Duplicate_samples followers;
  followers.leaders = context.scratch.take<unsigned>(m);
  followers.offsets = context.scratch.take<double>(3 * std::size_t(m));
  followers.numbers_of_samples = context.scratch.take<unsigned>(m);
  followers.are_own = samples.are_own ? context.scratch.take<unsigned char>(m) : nullptr;
  unsigned* const start_indices = context.scratch.take<unsigned>(m);

  const Arena_scope scope(context.scratch);
  const Representatives_of_crowds found = representatives(context, positions, grid,
                                                          maximum_number_of_samples_of_subcell);
  const unsigned number_of_kept = found.number_of_kept;
  followers.size = m - number_of_kept;
  unsigned *const numbers = context.scratch.take<unsigned>(m),
                  *const others = context.scratch.take<unsigned>(m),
                  *const order_of_kept = context.scratch.take<unsigned>(m);
  number_the_kept<<<blocks_for(number_of_kept), threads_per_block, 0, stream>>>(
    found.kept, number_of_kept, numbers);
  check_launch("number_the_kept");
  invert_flags<<<blocks_for(m), threads_per_block, 0, stream>>>(m, found.is_kept);
  check_launch("invert_flags");
  list_flagged(found.is_kept, m, others, context.scratch, stream);
  fill_ascending<<<blocks_for(number_of_kept), threads_per_block, 0, stream>>>(
    number_of_kept, start_indices, followers.numbers_of_samples);
  check_launch("fill_ascending");
  part_followers<<<blocks_for(followers.size), threads_per_block, 0, stream>>>(
    samples, grid.order, found.of_points, others, followers.size, numbers, followers);
  check_launch("part_followers");
  list_kept(context, positions, grid, found.kept, number_of_kept, order_of_kept);
  keep_listed(context, order_of_kept, number_of_kept, samples);
  samples.start_indices = start_indices; // of those that are left, in their order
  return followers;
}

void append_followers(const Execution_context& context, const Duplicate_samples& followers,
                      Samples& samples)
{
  if (followers.size == 0)
    return;
  const Arena_scope scope(context.scratch);
  unsigned* const places = context.scratch.take<unsigned>(samples.size);
  find_places<<<blocks_for(samples.size), threads_per_block, 0, context.stream>>>(samples, places);
  check_launch("find_places");
  append<<<blocks_for(followers.size), threads_per_block, 0, context.stream>>>(samples, followers,
                                                                               places);
  check_launch("append");
  samples.size += followers.size;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
