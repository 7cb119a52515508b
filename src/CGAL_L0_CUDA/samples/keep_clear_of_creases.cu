// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/gathered.cuh"
#include "samples/stages_of_refinement.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// Calls `f(k, point)` for the points of the block around a cell in the order of `Local_points` on
/// the CPU, all of them by one thread.
template <typename F>
__device__ void for_each_in_order(const Cell_grid& grid, const Cell_blocks& blocks, unsigned cell,
                                  const F& f)
{
  const unsigned stride = blocks.centers[cell].stride;
  const uint2* const ranges = blocks.ranges_of(cell);
  for (int row = 0, rows = blocks.number_of_ranges(cell); row < rows; ++row)
  {
    const uint2 range = ranges[row];
    if (range.x == range.y)
      continue;
    const unsigned skipped = stride > 1 ? (phase_of_row(ranges, row) - range.x) & (stride - 1) : 0;
    for (unsigned k = range.x + skipped; k < range.y; k += stride)
      f(k, grid.points[k]);
  }
}

/// One thread a sample: which samples make a face depends on their order, and few are near a
/// crease.
/// \param normals in the order of the grid, as they were before any sample slides
__global__ void slide_clear(Cell_grid grid, Cell_blocks blocks, const float4* normals, double range,
                            double spacing, const Bend* bends, Samples samples)
{
  const Wide q = thread_index();
  if (q >= grid.size)
    return;
  const int4 center = grid.points[q];
  const float unit = grid.frame.unit();
  const float3 own = xyz(normals[q]);
  const Triple normal = {own.x, own.y, own.z};
  Faces_around faces;
  float3 to_own = {0, 0, 0};
  float weight_of_own = 0;
  for_each_in_order(grid, blocks, unsigned(center.w), [&](unsigned k, const int4& place) {
    const float3 to_center = difference(center, place, unit), other = xyz(normals[k]);
    const double weight = 1 - double(dot(to_center, to_center)) / square(range);
    if (!(weight > 0))
      return;
    if (fabsf(dot(own, other)) < maximum_cosine_across_crease)
      faces.add({other.x, other.y, other.z}, {to_center.x, to_center.y, to_center.z}, weight);
    else
    {
      to_own = to_own + float(-weight) * to_center;
      weight_of_own += float(weight);
    }
  });
  if (weight_of_own > 0)
    faces.set_own_face({double(to_own.x / weight_of_own), double(to_own.y / weight_of_own),
                        double(to_own.z / weight_of_own)});
  const Triple way = faces.way_out(normal, spacing);
  if (!(dot(way, way) > 0))
    return;
  const Wide i = grid.order[q];
  const Slide slide(way, normal, bends[i]);
  double* const position = samples.positions + 3 * i;
  position[0] += slide.way.x;
  position[1] += slide.way.y;
  position[2] += slide.way.z;
  samples.normals[i] = make_float4(float(slide.normal.x), float(slide.normal.y),
                                   float(slide.normal.z), 0);
}

} // namespace

void keep_clear_of_creases(const Execution_context& context, const Cell_frame& frame,
                           double spacing, const Bend* bends, const Samples& samples)
{
  const cudaStream_t stream = context.stream;
  Device_arena &arena = context.arena, &scratch = context.scratch;
  const Arena_scope scope(arena);
  const Cell_grid grid = build_grid({samples.positions, samples.size, Frame(), true}, nullptr,
                                    frame, arena, scratch, stream);
  const Cell_blocks blocks = find_blocks(grid, grid, 1, maximum_number_of_candidates, arena,
                                         stream);
  const float4* const normals = gathered(arena, stream, grid.order, grid.size, samples.normals);
  slide_clear<<<blocks_for(samples.size), threads_per_block, 0, stream>>>(
    grid, blocks, normals, reach_of_clearance * spacing, spacing, bends, samples);
  check_launch("slide_clear");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
