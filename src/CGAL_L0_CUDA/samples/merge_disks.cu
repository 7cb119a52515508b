// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/gathered.cuh"
#include "samples/stages_of_refinement.cuh"

#include <CGAL/L0_resampling/internal/kernels/merged_disk.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// Merged disks stand where the samples of their cells begin, until they are counted.
struct Merged_in_cells
{
  Merged_disk* disks;
  float* scales; // of the first of each; null if all are 1
};

/// One warp a cell: all of it reads disks, one thread joins them, as which are joined depends on
/// their order.
/// \param grid of the samples
/// \param numbers out: of the merged disks of each cell
__global__ void merge_in_cells(Cell_grid grid, Samples samples, const float* informations,
                               Merged_in_cells merged, unsigned* numbers)
{
  constexpr unsigned disks_at_once = 32;
  __shared__ alignas(
    Merged_disk) unsigned char memory[threads_per_block / 32][disks_at_once * sizeof(Merged_disk)];
  const Wide cell = warp_index();
  if (cell >= grid.number_of_cells) // whole warps leave
    return;
  Merged_disk* const disks = reinterpret_cast<Merged_disk*>(memory[threadIdx.x / 32]);
  const unsigned first = grid.begins[cell], end = grid.begins[cell + 1], lane = threadIdx.x % 32;
  const double height_of_face =
    maximum_height_of_merged * grid.frame.size_of_level(grid.frame.level_of_key(grid.keys[cell]));
  Merged_disk* const of_cell = merged.disks + first;
  unsigned number = 0;
  for (unsigned begin = first; begin < end; begin += disks_at_once)
  {
    const unsigned count = min(disks_at_once, end - begin);
    if (lane < count)
    {
      const Wide k = grid.order[begin + lane];
      const double* const p = samples.positions + 3 * k;
      const float4 normal = samples.normals[k];
      disks[lane] = Merged_disk({p[0], p[1], p[2]}, {normal.x, normal.y, normal.z}, normal.w,
                                informations[k]);
    }
    __syncwarp();
    for (unsigned s = 0; s < count && lane == 0; ++s)
    {
      unsigned m = 0;
      while (m < number && !of_cell[m].is_of_face(disks[s], height_of_face))
        ++m;
      if (m < number)
      {
        of_cell[m].add(disks[s]);
        continue;
      }
      of_cell[number] = disks[s];
      if (merged.scales)
        merged.scales[first + number] = samples.scales[grid.order[begin + s]];
      ++number;
    }
    __syncwarp();
  }
  if (lane == 0)
    numbers[cell] = number;
}

struct Disk_arrays
{
  double* positions;
  float4* normals;
  float *informations, *scales;
};

/// \param offsets how many disks are in the cells before
__global__ void take_merged(Cell_grid grid, Merged_in_cells merged, const unsigned* offsets,
                            Disk_arrays disks)
{
  const Wide cell = thread_index();
  if (cell >= grid.number_of_cells)
    return;
  const unsigned first = grid.begins[cell], offset = offsets[cell],
                 number = offsets[cell + 1] - offset;
  for (unsigned m = 0; m < number; ++m)
  {
    const Merged_disk disk = merged.disks[first + m];
    const Triple p = disk.position(), n = disk.normal();
    const Wide k = offset + m;
    disks.positions[3 * k] = p.x;
    disks.positions[3 * k + 1] = p.y;
    disks.positions[3 * k + 2] = p.z;
    disks.normals[k] = make_float4(float(n.x), float(n.y), float(n.z), float(disk.height()));
    disks.informations[k] = float(disk.information);
    if (disks.scales)
      disks.scales[k] = merged.scales[first + m];
  }
}

} // namespace

Disks merge_disks(const Execution_context& context, const Cell_frame& frame, const Samples& samples,
                  const float* informations)
{
  const cudaStream_t stream = context.stream;
  Device_arena &arena = context.arena, &scratch = context.scratch;
  const Arena_scope scope(scratch);
  const Cell_grid grid = build_grid(samples.in_frame(), nullptr, frame, scratch, arena, stream);
  const unsigned cells = grid.number_of_cells;
  const Merged_in_cells merged = {scratch.take<Merged_disk>(samples.size),
                                  samples.scales ? scratch.take<float>(samples.size) : nullptr};
  unsigned* const offsets = scratch.take<unsigned>(std::size_t(cells) + 1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(offsets + cells, 0, sizeof(unsigned), stream));
  merge_in_cells<<<blocks_for(32ull * cells), threads_per_block, 0, stream>>>(
    grid, samples, informations, merged, offsets);
  check_launch("merge_in_cells");
  sum_up(offsets, cells, offsets, scratch, stream);
  const unsigned size = scratch.read(offsets + cells, stream);
  const Disk_arrays disks = {arena.take<double>(3 * std::size_t(size)), arena.take<float4>(size),
                             arena.take<float>(size),
                             samples.scales ? arena.take<float>(size) : nullptr};
  take_merged<<<blocks_for(cells), threads_per_block, 0, stream>>>(grid, merged, offsets, disks);
  check_launch("take_merged");
  return {size, disks.positions, disks.normals, disks.informations, disks.scales};
}

Disks in_order_of(const Execution_context& context, const Cell_grid& grid, const Disks& disks)
{
  const auto sorted = [&](const auto* values) {
    return gathered(context.arena, context.stream, grid.order, grid.size, values);
  };
  return {disks.size, nullptr, sorted(disks.normals), sorted(disks.informations), nullptr};
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
