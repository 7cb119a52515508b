// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/Refinement.cuh"

#include <CGAL/L0_resampling/internal/kernels/cells_of_refinement.h>
#include <CGAL/L0_resampling/internal/kernels/merged_disk.h>

#include <algorithm>
#include <type_traits>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void begin_samples(Samples refined)
{
  const Wide i = thread_index();
  if (i >= refined.size)
    return;
  refined.start_indices[i] = unsigned(i);
  refined.noise_ratios[i] = 1;
  const float3 normal = xyz(refined.normals[i]);
  const bool is_turned = is_negative(normal.x, normal.y, normal.z);
  refined.sides[i] = is_turned ? Side_after_refinement::TURNED : Side_after_refinement::AS_IT_IS;
  if (is_turned)
    refined.normals[i] = with_w(-1.f * normal, 0);
}

__global__ void put_back_samples(Samples refined, Samples samples)
{
  const Wide i = thread_index();
  if (i >= refined.size)
    return;
  const Wide k = refined.start_indices[i];
  for (int axis = 0; axis < 3; ++axis)
    samples.positions[3 * k + axis] = refined.positions[3 * i + axis];
  const Side_after_refinement side = refined.sides[i];
  samples.normals[k] =
    with_w((side == Side_after_refinement::TURNED ? -1.f : 1.f) * xyz(refined.normals[i]), 0);
  if (samples.trees && side == Side_after_refinement::OUTWARDS)
    samples.trees[k] = tree_of_known_sides;
}

} // namespace

Samples samples_to_refine(const Execution_context& context, const Samples& samples)
{
  const std::size_t m = samples.size;
  const auto copy = [&](const auto* from, std::size_t count) {
    using Value = std::remove_const_t<std::remove_pointer_t<decltype(from)>>;
    if (!from)
      return static_cast<Value*>(nullptr);
    Value* const to = context.arena.take<Value>(count);
    CGAL_L0_CUDA_CHECK(
      cudaMemcpyAsync(to, from, count * sizeof(Value), cudaMemcpyDeviceToDevice, context.stream));
    return to;
  };
  Samples refined;
  refined.size = samples.size;
  refined.positions = copy(samples.positions, 3 * m);
  refined.normals = copy(samples.normals, m);
  refined.outward = copy(samples.outward, m);
  refined.scales = copy(samples.scales, m);
  refined.spreading_radii = copy(samples.spreading_radii, m);
  refined.position_deviations = samples.position_deviations;
  refined.normal_deviations = samples.normal_deviations;
  refined.start_indices = context.arena.take<unsigned>(m);
  refined.noise_ratios = context.arena.take<float>(m);
  refined.sides = context.arena.take<Side_after_refinement>(m);
  begin_samples<<<blocks_for(m), threads_per_block, 0, context.stream>>>(refined);
  check_launch("begin_samples");
  return refined;
}

void put_back(const Execution_context& context, const Samples& refined, const Samples& samples)
{
  put_back_samples<<<blocks_for(refined.size), threads_per_block, 0, context.stream>>>(refined,
                                                                                       samples);
  check_launch("put_back_samples");
}

Refinement::Refinement(const Execution_context& context, const Lengths_of_refinement& lengths,
                       const Framed_box& box, double minimum_cell_size, const Cell_frame& of_points,
                       const Samples& samples)
  : m_context(context), m_lengths(lengths), m_box(box), m_minimum_cell_size(minimum_cell_size),
    m_samples(samples), m_fits_scope(context.arena)
{
  Device_arena& arena = context.arena;
  {
    const Arena_scope scope(context.scratch);
    m_grid = build_grid(m_samples.in_frame(), nullptr, frame_of_samples(of_points), arena,
                        context.scratch, context.scratch, context.stream);
    reorder(context, m_grid.order, m_samples);
    m_grid.forget_order();
  }
  const unsigned m = samples.size;
  m_shares = {arena.take<float>(m), arena.take<float>(m), nullptr};
}

void Refinement::share(const Positions& points, const Cell_grid& grid, double widening,
                       const Shares_of_samples& shares)
{
  const Arena_scope arena_scope(m_context.arena), scope(m_context.scratch);
  const bool are_cells_shared = m_grid.frame.cell_size == grid.frame.cell_size;
  cuda::share_points(m_context, m_lengths, widening,
                     are_cells_shared
                       ? grid
                       : build_grid(points, nullptr, m_grid.frame, m_context.arena,
                                    m_context.scratch, m_context.scratch, m_context.stream),
                     m_grid, m_samples, shares);
}

void Refinement::split_sheets(const Positions& points, const Cell_grid& grid, bool are_sides_known)
{
  Device_arena& arena = m_context.arena;
  const Arena_scope scope(arena);
  Shares_of_samples shares = m_shares;
  shares.scatters = arena.take<float4>(m_samples.size);
  share(points, grid, widening_of_split, shares);
  const Scattered_disks disks = {m_samples.normals, shares.scatters};
  const auto is_wide_enough = [&](double units) {
    return is_reached_in_cells(units * m_lengths.unit, m_grid.frame.cell_size);
  };
  const auto grid_for = [&](double units) {
    const double radius = units * m_lengths.unit;
    return is_wide_enough(units)
             ? m_grid
             : build_grid(m_samples.in_frame(), nullptr,
                          frame_of((std::max)(radius / 2, m_minimum_cell_size), radius), arena,
                          m_context.scratch, m_context.stream);
  };
  const Cell_grid grid_of_balls = grid_for(radius_of_split),
                  region_grid = grid_for(radius_of_region);
  const bool is_sorted = is_wide_enough(radius_of_split);
  cuda::split_sheets(m_context, m_lengths, grid_of_balls, is_sorted ? nullptr : grid_of_balls.order,
                     is_sorted ? disks : in_order_of(m_context, grid_of_balls, disks), region_grid,
                     is_wide_enough(radius_of_region) ? nullptr : region_grid.order, m_grid,
                     !are_sides_known, m_samples);
}

void Refinement::share_points(const Positions& points, const Cell_grid& grid)
{
  Device_arena& arena = m_context.arena;
  const unsigned m = m_samples.size;
  m_means = arena.take<Mean_surface>(m);
  m_predictions = arena.take<Surface_of_disks>(m);
  m_references = arena.take<Surface_of_disks>(m);
  m_surfaces = arena.take<Surfaces_of_scale>(m);
  m_smallest_scope.emplace(arena);
  m_smallest_surfaces = arena.take<Surfaces_of_scale>(m);
  // as they are made on the CPU: of zeros only
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(m_means, 0, m * sizeof(Mean_surface), m_context.stream));
  CGAL_L0_CUDA_CHECK(
    cudaMemsetAsync(m_predictions, 0, m * sizeof(Surface_of_disks), m_context.stream));
  share(points, grid, 1, m_shares);
}

Cell_frame Refinement::frame_of_samples(const Cell_frame& of_points) const
{
  const double cell_size = cell_size_of_refinement(m_lengths, of_points.cell_size);
  return cell_size == of_points.cell_size ? of_points : frame_of(cell_size, 2 * cell_size);
}

void Refinement::fit_disks(int scale)
{
  const auto fit = [&](const Cell_grid& sample_grid, bool is_in_order, const Cell_grid& disk_grid,
                       const Disks& disks) {
    cuda::fit_disks(m_context, m_lengths, sample_grid, is_in_order, disk_grid, disks, scale,
                    m_samples, m_shares.variances, m_predictions,
                    scale < scale_of_reference ? m_smallest_surfaces : m_surfaces);
  };
  if (scale < first_scale_of_merged_disks)
  {
    fit(m_grid, true, m_grid,
        {m_samples.size, m_samples.positions, m_samples.normals, m_shares.informations,
         m_samples.scales});
    return;
  }
  const Arena_scope scope(m_context.arena);
  const double radius = radius_of_fit(scale) * m_lengths.unit,
               cell_size = (std::max)(cell_of_merged_disks * radius, m_minimum_cell_size);
  const Disks disks = merge_disks(m_context, frame_of(cell_size, cell_size), m_samples,
                                  m_shares.informations);
  const Cell_frame frame = frame_of((std::max)(radius / 2, m_minimum_cell_size), radius);
  const auto grid_of = [&](const Positions& positions) {
    return build_grid(positions, nullptr, frame, m_context.arena, m_context.scratch,
                      m_context.stream);
  };
  const Cell_grid disk_grid = grid_of(
    {disks.positions, disks.size, Frame(), true, nullptr, disks.scales});
  const Disks sorted = in_order_of(m_context, disk_grid, disks);
  fit(grid_of(m_samples.in_frame()), false, disk_grid, sorted);
}

void Refinement::weigh(const Surfaces_of_scale* surfaces, int scale)
{
  cuda::weigh_by_risk(m_context, m_grid, radius_of_bias(scale) * m_lengths.unit, m_samples,
                      m_references, surfaces, m_means);
}

/// Of each scale, in order. Surfaces of the smallest balls wait for their reference.
void Refinement::weigh_by_risk(int scale)
{
  if (scale < scale_of_reference)
    return;
  if (scale == scale_of_reference)
  {
    find_references(m_context, m_lengths, m_samples, m_surfaces, m_smallest_surfaces, m_references);
    weigh(m_smallest_surfaces, 0);
    m_smallest_scope.reset();
  }
  weigh(m_surfaces, scale);
}

void Refinement::take_mean_surfaces()
{
  m_bends_scope.emplace(m_context.scratch);
  m_bends = m_context.scratch.take<Bend>(m_samples.size);
  if (m_samples.position_deviations)
    m_variances = m_context.scratch.take<Variances_of_fit>(m_samples.size);
  settle_on_means(m_context, m_lengths, m_means, m_samples, m_bends, m_variances);
  m_fits_scope.reset();
}

void Refinement::keep_clear_of_creases()
{
  const double range = reach_of_clearance * m_lengths.spacing,
               cell_size = (std::max)(range, m_minimum_cell_size);
  cuda::keep_clear_of_creases(m_context,
                              Cell_frame::around(m_box.low, m_box.high, cell_size, range),
                              m_lengths.spacing, m_bends, m_samples);
}

void Refinement::find_deviations()
{
  const double radius = Ball_of_normals::maximum_radius(m_lengths);
  cuda::find_deviations(m_context, frame_of((std::max)(radius, m_minimum_cell_size), radius),
                        m_lengths, m_variances, m_samples);
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
