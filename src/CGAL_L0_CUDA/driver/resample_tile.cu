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

__global__ void take_scales(const Point_in_cloud* points, unsigned size, float* scales)
{
  const Wide i = thread_index();
  if (i < size)
    scales[i] = points[i].scale;
}

__global__ void flag_kept(const Point_in_cloud* points, unsigned size, unsigned char* is_kept)
{
  const Wide i = thread_index();
  if (i < size)
    is_kept[i] = points[i].units > 0;
}

/// All points of a cell stand for as much.
__global__ void take_units(Cell_grid grid, const Point_in_cloud* points, const unsigned* list,
                           Wide* units_of_cells)
{
  const Wide cell = thread_index();
  if (cell >= grid.number_of_cells)
    return;
  const unsigned before = grid.order[grid.begins[cell]];
  units_of_cells[cell] = points[list ? list[before] : before].units;
}

/// How many points each point of the grid stands for; 0 if the tile does not keep them.
/// \param list which of the points the grid was built of; null for all
/// \param numbers_of_points that it stands for; null if only for itself
__global__ void count_own(Cell_grid grid, const Point_in_cloud* points, const unsigned* list,
                          const unsigned* numbers_of_points, unsigned* numbers_of_own)
{
  const Wide i = thread_index();
  if (i >= grid.size)
    return;
  const unsigned place = grid.order[i];
  numbers_of_own[i] = points[list ? list[place] : place].is_own
                        ? (numbers_of_points ? numbers_of_points[i] : 1)
                        : 0;
}

__global__ void copy_unoriented(Samples samples, Unoriented_samples unoriented)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const float3 normal = xyz(samples.normals[i]);
  for (int axis = 0; axis < 3; ++axis)
    unoriented.positions[3 * i + axis] = samples.positions[3 * i + axis];
  unoriented.normals[3 * i] = normal.x;
  unoriented.normals[3 * i + 1] = normal.y;
  unoriented.normals[3 * i + 2] = normal.z;
  unoriented.are_own[i] = samples.are_own[i];
}

/// Each sample is a tree, which has no side yet.
__global__ void begin_trees(Samples samples)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  samples.trees[i] = unsigned(i);
  samples.side_confidences[i] = 0;
}

/// The stages for a part of a cloud, as `Tile_backend` on the CPU.
class Tile_backend : public Cuda_backend
{
  const Facts_of_tiles& m_facts;
  const bool m_finds_sides;
  const std::size_t m_maximum_number_of_samples;

public:
  Tile_backend(Session& session, const Parameters& parameters, const Tile_of_cloud& tile,
               Stages& stages, Call_report& report)
    : Cuda_backend(session, parameters, unsigned(tile.number_of_samples), stages, report),
      m_facts(tile.facts), m_finds_sides(tile.finds_sides),
      m_maximum_number_of_samples(tile.number_of_samples)
  {}

  void begin(const Plan& plan)
  {
    if (!m_finds_sides) // below the points, which go before the call ends
    {
      Device_arena& arena = m_context.arena;
      m_session.unoriented = {arena.take<double>(3 * m_maximum_number_of_samples),
                              arena.take<float>(3 * m_maximum_number_of_samples),
                              arena.take<unsigned char>(m_maximum_number_of_samples), 0};
    }
    Cuda_backend::begin(plan);
  }

  Facts find_facts()
  {
    Cuda_backend::find_facts();
    return m_facts.extents;
  }

  Scales estimate_scales(double) { return m_facts.extents.scales; }

  Range_of_scales estimate_scale_field(double, const Reference_scales&)
  {
    if (!m_facts.range_of_scales.is_one())
    {
      float* const scales = m_context.arena.take<float>(m_session.size);
      take_scales<<<blocks_for(m_session.size), threads_per_block, 0, m_context.stream>>>(
        m_session.points_in_cloud, m_session.size, scales);
      check_launch("take_scales");
      m_input.positions.scales = scales;
    }
    return m_facts.range_of_scales;
  }

  void drop_outliers(const Plan&)
  {
    unsigned* const kept = m_context.arena.take<unsigned>(m_session.size);
    const Arena_scope scope(m_context.scratch);
    unsigned char* const is_kept = m_context.scratch.take<unsigned char>(m_session.size);
    flag_kept<<<blocks_for(m_session.size), threads_per_block, 0, m_context.stream>>>(
      m_session.points_in_cloud, m_session.size, is_kept);
    check_launch("flag_kept");
    const unsigned number_of_kept = list_flagged(is_kept, m_session.size, kept, m_context.scratch,
                                                 m_context.stream);
    m_report.number_of_outliers = m_session.size - number_of_kept;
    if (number_of_kept == m_session.size)
      return;
    m_input.positions.size = number_of_kept;
    m_input.positions.list = kept;
  }

  void estimate_pca_normals(const Plan& plan)
  {
    const Arena_scope scope(m_context.scratch);
    unsigned* const numbers_of_own = m_context.scratch.take<unsigned>(m_grid.size);
    count_own<<<blocks_for(m_grid.size), threads_per_block, 0, m_context.stream>>>(
      m_grid, m_session.points_in_cloud, m_input.positions.list, m_numbers_of_points,
      numbers_of_own);
    check_launch("count_own");
    Cuda_backend::estimate_pca_normals(plan, numbers_of_own);
  }

  void weigh_density(const Plan& plan)
  {
    Cuda_backend::weigh_density(plan, m_facts.mean_number_of_neighbors);
  }

  double total_area(const Plan& plan)
  {
    m_areas_scope.emplace(m_context.arena);
    Wide* units_of_cells = nullptr;
    if (plan.keeps_spacings)
    {
      units_of_cells = m_context.arena.take<Wide>(m_grid.number_of_cells);
      take_units<<<blocks_for(m_grid.number_of_cells), threads_per_block, 0, m_context.stream>>>(
        m_grid, m_session.points_in_cloud, m_input.positions.list, units_of_cells);
      check_launch("take_units");
    }
    m_areas = {units_of_cells, area_per_unit_of(plan.area_radius()), m_facts.area};
    return m_areas.total;
  }

  void choose_samples(const Plan& plan)
  {
    const Known_starts known = {m_session.points_in_cloud, m_facts.number_of_points,
                                m_facts.number_of_places, plan.number_of_samples};
    Cuda_backend::choose_samples(plan, &known);
  }

  void orient_normals(const Plan& plan)
  {
    if (m_finds_sides)
      Cuda_backend::orient_normals(plan);
    else
      keep_unoriented();
  }

private:
  void keep_unoriented()
  {
    m_session.unoriented.size = m_samples.size;
    copy_unoriented<<<blocks_for(m_samples.size), threads_per_block, 0, m_context.stream>>>(
      m_samples, m_session.unoriented);
    check_launch("copy_unoriented");
    begin_trees<<<blocks_for(m_samples.size), threads_per_block, 0, m_context.stream>>>(m_samples);
    check_launch("begin_trees");
  }
};

/// Brings a tile to the device, in place of the points of the session.
void upload_tile(Session& session, const double* points, unsigned size, const Tile_of_cloud& tile)
{
  session.size = 0;
  session.has_scales = false;
  session.input.clear();
  session.input_memory.reserve((3 * sizeof(double) + sizeof(Point_in_cloud)) * std::size_t(size)
                               + 1024);
  double* const on_device = session.input.take<double>(3 * std::size_t(size));
  Point_in_cloud* const known = session.input.take<Point_in_cloud>(size);
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(on_device, points, 3 * sizeof(double) * size,
                                     cudaMemcpyHostToDevice, session.stream));
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(known, tile.points, sizeof(Point_in_cloud) * size,
                                     cudaMemcpyHostToDevice, session.stream));
  Frame frame;
  frame.exponent = tile.facts.exponent_of_frame;
  std::copy_n(tile.facts.origin_of_frame, 3, frame.origin);
  session.take_tile(on_device, known, size, frame, tile.facts.extents.robust_diagonal);
}

} // namespace

Answer free_memory(std::size_t& bytes)
{
  bytes = 0;
  const Answer found = find_device();
  if (found.status != Status::DONE)
    return found;
  return guarded(nullptr, [&]() {
    std::size_t total;
    CGAL_L0_CUDA_CHECK(cudaMemGetInfo(&bytes, &total));
  });
}

Answer resample_tile(Session& session, const double* points, std::size_t size,
                     const Tile_of_cloud& tile, const Parameters& parameters,
                     Progress_callback progress, Call_report& report,
                     std::size_t& number_of_unoriented)
{
  report = Call_report();
  number_of_unoriented = 0;
  return guarded(&session, [&]() {
    session.memory_limit.limit = parameters.maximum_memory;
    // of each sample
    const std::size_t of_unoriented = 3 * sizeof(double) + 3 * sizeof(float)
                                      + sizeof(unsigned char),
                      of_tile = sizeof(unsigned) + sizeof(unsigned char)
                                + (tile.finds_sides ? 0 : of_unoriented);
    session.reserve(estimate_memory(size, tile.number_of_samples, parameters, false)
                    + of_tile * tile.number_of_samples);
    upload_tile(session, points, unsigned(size), tile);
    Stages stages(session, progress, report);
    Tile_backend backend(session, parameters, tile, stages, report);
    run(plan_call(parameters, backend), backend);
    number_of_unoriented = session.unoriented.size;
  });
}

Answer download_tile(Session& session, float* side_confidences, std::uint32_t* trees,
                     unsigned char* are_own)
{
  return guarded(&session, [&]() {
    const std::size_t m = session.number_of_samples;
    const auto copy = [&](auto* to, const auto* from) {
      CGAL_L0_CUDA_CHECK(
        cudaMemcpyAsync(to, from, m * sizeof(*to), cudaMemcpyDeviceToHost, session.stream));
    };
    copy(side_confidences, session.side_confidences);
    copy(trees, session.trees);
    copy(are_own, session.are_own);
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

Answer download_unoriented(Session& session, double* positions, float* normals,
                           unsigned char* are_own)
{
  return guarded(&session, [&]() {
    const Unoriented_samples& from = session.unoriented;
    const std::size_t m = from.size;
    const auto copy = [&](auto* to, const auto* array, std::size_t count) {
      CGAL_L0_CUDA_CHECK(
        cudaMemcpyAsync(to, array, count * sizeof(*to), cudaMemcpyDeviceToHost, session.stream));
    };
    copy(positions, from.positions, 3 * m);
    copy(normals, from.normals, 3 * m);
    copy(are_own, from.are_own, m);
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
