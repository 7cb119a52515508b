// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/Morton_places.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

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

/// Parameters are those of the kernel.
Morton_points taken(const Execution_context& context, const Wide* from, const unsigned* list,
                    unsigned stride, unsigned size, const Morton_cells& cells)
{
  std::uint64_t* const codes = context.scratch.take<std::uint64_t>(size);
  double* const xyz = context.scratch.take<double>(3 * std::size_t(size));
  take_places<<<blocks_for(size), threads_per_block, 0, context.stream>>>(from, list, stride, size,
                                                                          cells, codes, xyz);
  check_launch("take_places");
  return {cells, size, codes, xyz};
}

} // namespace

Morton_points places_of(const Execution_context& context, const Positions& positions,
                        const Morton_cells& cells)
{
  const unsigned n = positions.size;
  const cudaStream_t stream = context.stream;
  Device_arena& scratch = context.scratch;
  Wide *const codes = scratch.take<Wide>(n), *const other_codes = scratch.take<Wide>(n);
  find_codes<<<blocks_for(n), threads_per_block, 0, stream>>>(positions, cells, codes);
  check_launch("find_codes");
  const Wide* const sorted = sort_values(codes, other_codes, n, scratch, stream);
  unsigned char* const is_first = scratch.take<unsigned char>(n);
  unsigned* const list = scratch.take<unsigned>(n);
  mark_first_of_codes<<<blocks_for(n), threads_per_block, 0, stream>>>(sorted, n, is_first);
  check_launch("mark_first_of_codes");
  return taken(context, sorted, list, 1, list_flagged(is_first, n, list, scratch, stream), cells);
}

Morton_points one_of_places(const Execution_context& context, const Morton_points& places,
                            unsigned stride)
{
  return taken(context, reinterpret_cast<const Wide*>(places.codes), nullptr, stride,
               unsigned((places.size + stride - 1) / stride), places.cells);
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
