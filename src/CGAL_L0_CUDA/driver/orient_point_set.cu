// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/estimate_memory.cuh"
#include "orientation/orient_measured_normals.cuh"
#include "search/Thinned_points.cuh"

#include <CGAL/L0_resampling/internal/driver/run.h>
#include <CGAL/L0_resampling/internal/kernels/crowded_subcells.h>
#include <CGAL/L0_resampling/internal/kernels/spacing_to_orient.h>

#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// \param hints of the positions; null for none
__global__ void place_samples(Positions positions, const float3* hints, Samples samples)
{
  const Wide i = thread_index();
  if (i >= positions.size)
    return;
  const double3 p = positions(unsigned(i));
  samples.positions[3 * i] = p.x;
  samples.positions[3 * i + 1] = p.y;
  samples.positions[3 * i + 2] = p.z;
  if (hints)
    samples.hints[i] = with_w(hints[i], 0);
}

/// \param packed xyz interleaved
/// \param mean_normals in and out: on the sides of the normals
__global__ void pack_normals(Samples samples, float3* packed, float3* mean_normals)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  packed[i] = xyz(samples.normals[i]);
  if (dot(packed[i], mean_normals[i]) < 0)
    mean_normals[i] = -1.f * mean_normals[i];
}

/// What a call that only orients has of samples.
Samples take_samples_to_orient(Device_arena& arena, unsigned size, bool with_hints)
{
  Samples samples;
  samples.size = size;
  samples.positions = arena.take<double>(3 * std::size_t(size));
  samples.normals = arena.take<float4>(size);
  samples.fit = arena.take<float4>(size); // the place of the sets
  samples.side_confidences = arena.take<float>(size);
  if (with_hints)
    samples.hints = arena.take<float4>(size);
  return samples;
}

/// As `orient_point_set()` on the CPU, stage by stage.
class Oriented_points : public Cuda_points
{
public:
  using Cuda_points::Cuda_points;

  Range_of_scales estimate_scale_field(double robust_diagonal, const Reference_scales& usual)
  {
    return needs_scales_to_orient(m_session.all_normals_given, usual.spacing, usual.noise)
             ? Cuda_points::estimate_scale_field(robust_diagonal, usual)
             : Range_of_scales();
  }

  void orient(const Plan& plan)
  {
    m_input.positions.frame = m_box.frame;
    Device_arena& arena = m_context.arena;
    Sample_counts* const counts = arena.take<Sample_counts>(1);
    CGAL_L0_CUDA_CHECK(cudaMemsetAsync(counts, 0, sizeof(Sample_counts), m_context.stream));
    const unsigned n = m_input.positions.size;
    unsigned* const of_points = arena.take<unsigned>(n);
    Samples samples = take_samples_to_orient(arena, n, m_input.hints != nullptr);
    float3* const mean_normals = arena.take<float3>(n);
    const double spacing = thin_points(plan, of_points, samples);

    begin_stage("orient normals", 0.5, samples.size);
    orient_measured_normals(m_context, m_box.low, m_box.high,
                            unsigned(plan.number_of_orientation_neighbors), spacing,
                            noise_of_heights(plan.noise), side_hints(), samples, counts,
                            mean_normals);
    float3* const normals = reinterpret_cast<float3*>(samples.fit);
    pack_normals<<<blocks_for(samples.size), threads_per_block, 0, m_context.stream>>>(
      samples, normals, mean_normals);
    check_launch("pack_normals");
    const Sample_counts* const found = m_context.scratch.fetch(counts, m_context.stream);
    m_stages.end();
    note_sides(*found, samples.size);
    m_session.representatives = {of_points, reinterpret_cast<const float*>(normals),
                                 reinterpret_cast<const float*>(mean_normals), samples.size};
  }

private:
  /// \param of_points out: the sample that stands for each point of the input
  /// \returns the spacing of the samples on the surface
  double thin_points(const Plan& plan, unsigned* of_points, Samples& samples)
  {
    const Arena_scope scope(m_context.arena);
    Thinned_points points(m_context, m_input, of_points);
    const bool has_scales = m_input.positions.scales != nullptr;
    const auto frame_of_cells = [&](double cell_size, double longest_query) {
      return Cell_frame::around(m_box.low, m_box.high, cell_size, longest_query, has_scales);
    };
    const Cell_frame frame = frame_of_cells(plan.cell_size, plan.longest_query());
    m_report.number_of_distinct_points = points.sort(frame).number_of_distinct;
    if (points.keep_one_of_each_place())
      points.sort(frame);
    const Cell_grid* grid = points.thin(maximum_number_of_points_of_subcell) ? &points.sort(frame)
                                                                             : &points.grid();
    find_normals(plan, points, *grid, samples.normals);
    points.take_order();
    points.take_normals(samples.normals);

    const unsigned number_of_points = points.positions().size;
    const double spacing = spacing_of_representatives(plan.sample_spacing, plan.noise);
    if (spacing > plan.sample_spacing)
    {
      const double cell_size = subcells_per_axis * spacing;
      points.sort(frame_of_cells(cell_size, cell_size));
      if (!points.thin(1))
        points.take_order();
    }
    samples.size = points.positions().size;
    place_samples<<<blocks_for(samples.size), threads_per_block, 0, m_context.stream>>>(
      points.positions(), points.hints(), samples);
    check_launch("place_samples");
    return spacing_on_surface(plan.sample_spacing, number_of_points, samples.size);
  }

  /// The given normals, and estimates of those that are not given.
  /// \param normals out, in the order of the grid
  void find_normals(const Plan& plan, const Thinned_points& points, const Cell_grid& grid,
                    float4* normals)
  {
    const float* const given = points.given_normals();
    if (!given || has_zero(m_context, given, grid.size))
    {
      begin_stage("PCA normals", 0.3, grid.size);
      const Arena_scope scope(m_context.scratch);
      const int reach = cells_in_reach(plan.pca_radius, plan.cell_size),
                reach_of_refits = cells_in_reach(plan.filter_radius, plan.cell_size);
      const auto blocks_in_reach = [&](int number_of_cells) {
        return find_blocks(grid, grid, number_of_cells, maximum_number_of_candidates,
                           m_context.scratch, m_context.stream);
      };
      Cell_blocks blocks = blocks_in_reach(reach);
      float4* refitted = m_context.scratch.take<float4>(grid.size);
      float4* estimated = normals;
      if (plan.number_of_refits % 2 != 0) // so that the last one writes where they are to be
        std::swap(estimated, refitted);
      m_report.number_of_degenerate_neighborhoods =
        estimate_pca_normals(m_context, points.positions(), grid, blocks, plan.pca_radius,
                             plan.looks_beyond_strips, nullptr, estimated);
      if (reach_of_refits != reach)
        blocks = blocks_in_reach(reach_of_refits);
      for (std::size_t refit = 0; refit < plan.number_of_refits; ++refit)
      {
        refit_normals(m_context, grid, blocks, plan.kernel_of_points(), estimated, refitted);
        std::swap(estimated, refitted);
      }
    }
    if (given)
      take_given_normals(m_context, grid, given, normals);
  }
};

} // namespace

void run_orientation(Session& session, const Parameters& parameters, Stages& stages,
                     Call_report& report)
{
  session.reserve(estimate_memory_to_orient(session.size, parameters, session.normals != nullptr,
                                            session.hints != nullptr));
  Oriented_points points(session, parameters, stages, report);
  points.orient(plan_call(parameters, points));
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
