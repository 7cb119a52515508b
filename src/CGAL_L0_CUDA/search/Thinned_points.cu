// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/Thinned_points.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

constexpr unsigned lanes_of_warp = 32;

__global__ void fill_with_places(unsigned size, unsigned* places)
{
  const Wide i = thread_index();
  if (i < size)
    places[i] = unsigned(i);
}

/// One more than there are points, of which the last is 0.
__global__ void count_first(const unsigned char* is_first, unsigned size, unsigned* counts)
{
  const Wide i = thread_index();
  if (i <= size)
    counts[i] = i < size ? is_first[i] : 0;
}

/// \param numbers_before how many places begin before each point
__global__ void number_places(const unsigned char* is_first, const unsigned* numbers_before,
                              unsigned size, unsigned* places)
{
  const Wide i = thread_index();
  if (i < size)
    places[i] = numbers_before[i] + is_first[i] - 1;
}

/// Whether a vector is given, and the other one is not or is less: by x, then y, then z.
__device__ bool is_larger(float3 v, float3 other)
{
  const auto is_zero = [](float3 w) { return w.x == 0 && w.y == 0 && w.z == 0; };
  if (is_zero(v) || is_zero(other))
    return !is_zero(v);
  return v.x != other.x ? v.x > other.x : v.y != other.y ? v.y > other.y : v.z > other.z;
}

/// One warp for each place, which may be that of any number of points.
/// \param order of the grid
/// \param begins the first point of each place in it
__global__ void take_largest(const float3* vectors, const unsigned* order, unsigned size,
                             const unsigned* begins, unsigned number_of_places, float3* taken)
{
  const Wide place = thread_index() / lanes_of_warp;
  if (place >= number_of_places)
    return;
  const unsigned lane = threadIdx.x % lanes_of_warp;
  const unsigned end = place + 1 < number_of_places ? begins[place + 1] : size;
  float3 largest = {0, 0, 0};
  for (Wide j = Wide(begins[place]) + lane; j < end; j += lanes_of_warp)
  {
    const float3 v = vectors[order[j]];
    if (is_larger(v, largest))
      largest = v;
  }
  for (int offset = lanes_of_warp / 2; offset > 0; offset /= 2)
  {
    const float3 other = {__shfl_xor_sync(0xffffffffu, largest.x, offset),
                          __shfl_xor_sync(0xffffffffu, largest.y, offset),
                          __shfl_xor_sync(0xffffffffu, largest.z, offset)};
    if (is_larger(other, largest))
      largest = other;
  }
  if (lane == 0)
    taken[place] = largest;
}

/// \param order of the grid
/// \param kept which points of the grid; null for all
template <typename Vector>
__global__ void take_kept(const Vector* vectors, const unsigned* order, const unsigned* kept,
                          unsigned size, Vector* taken)
{
  const Wide k = thread_index();
  if (k < size)
    taken[k] = vectors[order[kept ? kept[k] : unsigned(k)]];
}

__global__ void follow_places(const unsigned* of_former, unsigned size, unsigned* of_input)
{
  const Wide i = thread_index();
  if (i < size)
    of_input[i] = of_former[of_input[i]];
}

/// Replaces values by what `f` writes, of which there are no more.
template <typename T, typename F>
void replace(const Execution_context& context, T* values, unsigned size, const F& f)
{
  const Arena_scope scope(context.scratch);
  T* const taken = context.scratch.take<T>(size);
  f(taken);
  CGAL_L0_CUDA_CHECK(
    cudaMemcpyAsync(values, taken, size * sizeof(T), cudaMemcpyDeviceToDevice, context.stream));
}

/// Room for vectors that the points may lose one after the other; null for none.
float3* copy_of(const Execution_context& context, const float* vectors, unsigned size)
{
  if (!vectors)
    return nullptr;
  float3* const copy = context.arena.take<float3>(size);
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(copy, vectors, size * sizeof(float3), cudaMemcpyDeviceToDevice,
                                     context.stream));
  return copy;
}

} // namespace

Thinned_points::Thinned_points(const Execution_context& context, const Input& input,
                               unsigned* of_input)
  : m_context(context), m_size_of_input(input.positions.size), m_of_input(of_input),
    m_positions(input.positions), m_list(context.arena.take<unsigned>(m_size_of_input)),
    m_normals(copy_of(context, input.normals, m_size_of_input)),
    m_hints(copy_of(context, input.hints, m_size_of_input))
{
  fill_with_places<<<blocks_for(m_size_of_input), threads_per_block, 0, context.stream>>>(
    m_size_of_input, m_of_input);
  check_launch("fill_with_places");
}

const Cell_grid& Thinned_points::sort(const Cell_frame& frame)
{
  m_grid_scope.reset();
  m_grid_scope.emplace(m_context.arena);
  m_grid = build_grid(m_positions, nullptr, frame, m_context.arena, m_context.scratch,
                      m_context.stream);
  return m_grid;
}

bool Thinned_points::keep_one_of_each_place()
{
  const unsigned n = m_grid.size, number_of_places = m_grid.number_of_distinct;
  if (number_of_places == n)
    return false;
  const cudaStream_t stream = m_context.stream;
  const Arena_scope scope(m_context.scratch);
  unsigned *const places = m_context.scratch.take<unsigned>(n), *const begins =
                                                                  m_context.scratch.take<unsigned>(
                                                                    n);
  list_flagged(m_grid.is_first, n, begins, m_context.scratch, stream);
  {
    const Arena_scope counts_scope(m_context.scratch);
    unsigned* const counts = m_context.scratch.take<unsigned>(std::size_t(n) + 1);
    count_first<<<blocks_for(Wide(n) + 1), threads_per_block, 0, stream>>>(m_grid.is_first, n,
                                                                           counts);
    check_launch("count_first");
    sum_up(counts, n, counts, m_context.scratch, stream);
    number_places<<<blocks_for(n), threads_per_block, 0, stream>>>(m_grid.is_first, counts, n,
                                                                   places);
    check_launch("number_places");
  }
  for (float3* const vectors : {m_normals, m_hints})
    if (vectors)
      replace(m_context, vectors, number_of_places, [&](float3* taken) {
        take_largest<<<blocks_for(Wide(number_of_places) * lanes_of_warp), threads_per_block, 0,
                       stream>>>(vectors, m_grid.order, n, begins, number_of_places, taken);
        check_launch("take_largest");
      });
  move_to({places, begins, number_of_places});
  return true;
}

bool Thinned_points::thin(unsigned limit)
{
  const Arena_scope scope(m_context.scratch);
  const Representatives found = representatives_of_crowds(m_context, m_positions, m_grid, limit);
  if (found.are_all_points())
    return false;
  keep(found);
  return true;
}

void Thinned_points::take_order() { keep({nullptr, nullptr, m_grid.size}); }

void Thinned_points::keep(const Representatives& representatives)
{
  const auto take = [&](auto* vectors) {
    const unsigned size = representatives.number_of_kept;
    if (vectors)
      replace(m_context, vectors, size, [&](auto* taken) {
        take_kept<<<blocks_for(size), threads_per_block, 0, m_context.stream>>>(
          vectors, m_grid.order, representatives.kept, size, taken);
        check_launch("take_kept");
      });
  };
  take(m_normals);
  take(m_hints);
  take(m_all_normals);
  move_to(representatives);
}

/// Keeps the positions of the representatives, and tells the points of the input where they are.
void Thinned_points::move_to(const Representatives& representatives)
{
  const cudaStream_t stream = m_context.stream;
  const unsigned size = representatives.number_of_kept;
  replace(m_context, m_list, size, [&](unsigned* listed) {
    list_kept(m_context, m_positions, m_grid, representatives.kept, size, listed);
  });
  m_positions.list = m_list;
  m_positions.size = size;
  const Arena_scope scope(m_context.scratch);
  unsigned* const of_former = m_context.scratch.take<unsigned>(m_grid.size);
  find_places_of_points(m_context, m_grid, representatives, of_former);
  follow_places<<<blocks_for(m_size_of_input), threads_per_block, 0, stream>>>(
    of_former, m_size_of_input, m_of_input);
  check_launch("follow_places");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
