// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/Cuda_backend.cuh"
#include "driver/estimate_memory.cuh"
#include "driver/guarded.cuh"

#include <CGAL/L0_resampling/internal/device/cuda_tiles.h>
#include <CGAL/L0_resampling/internal/driver/run.h>

#include <algorithm>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// Of all points of the session: outliers, until more is known.
__global__ void begin_points(unsigned size, const float* scales, Point_in_cloud* points)
{
  const Wide i = thread_index();
  if (i >= size)
    return;
  Point_in_cloud point;
  point.scale = Scales_view{scales}[i];
  points[i] = point;
}

/// Of the points that are no outliers, and may be thinned.
/// \param list which of the points they are; null for all
__global__ void note_kept(const unsigned* list, unsigned size, Point_in_cloud* points)
{
  const Wide k = thread_index();
  if (k < size)
    points[list ? list[k] : k].units = 1;
}

/// Of the points of the grid.
/// \param list what its order counts; null if that is all points
/// \param numbers of the samples that start on each
__global__ void note_places(Cell_grid grid, const unsigned* list, const Wide* units_of_cells,
                            const unsigned* numbers, Point_in_cloud* points)
{
  const Wide i = thread_index();
  if (i >= grid.size)
    return;
  const unsigned before = grid.order[i];
  Point_in_cloud& point = points[list ? list[before] : before];
  point.units = units_of_cells[grid.points[i].w];
  point.index = unsigned(i);
  point.number_of_samples = numbers[i];
}

/// The first stages for all points of a cloud, as `Fact_finder` on the CPU.
class Fact_finder : public Cuda_backend
{
  Range_of_scales m_range;
  const unsigned* m_list = nullptr; // of the points that are no outliers; null for all
  unsigned m_number_of_listed = 0;

public:
  Fact_finder(Session& session, const Parameters& parameters, Stages& stages, Call_report& report)
    : Cuda_backend(session, parameters, 0, stages, report)
  {}

  Range_of_scales estimate_scale_field(double robust_diagonal, const Reference_scales& usual)
  {
    m_range = Cuda_backend::estimate_scale_field(robust_diagonal, usual);
    return m_range;
  }

  const Range_of_scales& range_of_scales() const { return m_range; }

  void begin() { m_input.positions.frame = m_box.frame; }

  void sort_points(const Plan& plan)
  {
    m_list = m_input.positions.list;
    m_number_of_listed = m_input.positions.size;
    Cuda_backend::sort_points(plan);
  }

  /// Without outliers, and thinned.
  std::size_t number_of_sorted_points() const { return m_grid.size; }
  std::size_t number_of_places() const { return m_grid.number_of_distinct; }

  double mean_number_of_neighbors(const Plan& plan)
  {
    sum_up_input_density(m_context, m_grid, m_filter->blocks, plan.filter_radius,
                         float(plan.squared_bandwidth), m_normals, m_filter->ball_counts.address());
    const double mean = double(m_filter->ball_counts.read().neighbors) / double(m_grid.size);
    m_filter.reset();
    return mean;
  }

  double total_area(const Plan& plan)
  {
    m_areas = areas_of_points(m_context, m_grid, plan.area_radius(),
                              unsigned(plan.number_of_samples));
    return m_areas.total;
  }

  /// \param points out, on the host: what is found of each point of the session
  void choose_samples(const Plan& plan, Point_in_cloud* points)
  {
    const cudaStream_t stream = m_context.stream;
    const unsigned size = m_session.size;
    unsigned* const numbers = m_context.arena.take<unsigned>(m_grid.size);
    count_starts(m_context, m_grid, plan.starts_evenly ? &m_areas : nullptr,
                 unsigned(plan.number_of_samples), plan.random_seed, numbers);
    Point_in_cloud* const on_device = m_context.arena.take<Point_in_cloud>(size);
    begin_points<<<blocks_for(size), threads_per_block, 0, stream>>>(size, m_input.positions.scales,
                                                                     on_device);
    check_launch("begin_points");
    note_kept<<<blocks_for(m_number_of_listed), threads_per_block, 0, stream>>>(
      m_list, m_number_of_listed, on_device);
    check_launch("note_kept");
    note_places<<<blocks_for(m_grid.size), threads_per_block, 0, stream>>>(
      m_grid, m_input.positions.list, m_areas.of_cells, numbers, on_device);
    check_launch("note_places");
    CGAL_L0_CUDA_CHECK(
      cudaMemcpyAsync(points, on_device, size * sizeof(*points), cudaMemcpyDeviceToHost, stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(stream));
  }
};

} // namespace

Answer find_facts(Session& session, const double* points, std::size_t size,
                  const Parameters& parameters, Progress_callback progress, Call_report& report,
                  Facts_of_tiles& facts, Point_in_cloud* points_in_cloud)
{
  report = Call_report();
  const Answer uploaded = upload(session, points, size, nullptr, nullptr,
                                 parameters.maximum_memory);
  if (uploaded.status != Status::DONE)
    return uploaded;
  return guarded(&session, [&]() {
    const std::size_t of_grid = 52, of_starts = 28; // and scales, areas, and what is found, a point
    session.reserve((std::max)(estimate_memory(size, 0, parameters, false),
                               (of_grid + of_starts + sizeof(Point_in_cloud)) * size
                                 + 16 * parameters.number_of_output_points));
    Stages stages(session, progress, report);
    Fact_finder finder(session, parameters, stages, report);
    facts = {};
    facts.exponent_of_frame = session.extent.frame.exponent;
    std::copy_n(session.extent.frame.origin, 3, facts.origin_of_frame);
    facts.extents = finder.find_facts();
    const Plan plan = plan_call(parameters, finder);
    facts.extents.scales = session.scales;
    facts.range_of_scales = finder.range_of_scales();
    finder.begin();
    if (plan.drops_outliers())
    {
      finder.begin_stage("find outliers", 0.4, size);
      finder.drop_outliers(plan);
    }
    finder.begin_stage("areas", 0.3, size);
    finder.sort_points(plan);
    facts.number_of_points = finder.number_of_sorted_points();
    facts.number_of_places = finder.number_of_places();
    facts.mean_number_of_neighbors = finder.mean_number_of_neighbors(plan);
    facts.area = finder.total_area(plan);
    finder.choose_samples(plan, points_in_cloud);
    stages.end();
  });
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
