// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/Cuda_points.cuh"
#include "driver/estimate_memory.cuh"
#include "driver/guarded.cuh"

#include <CGAL/L0_resampling/internal/device/cuda_tiles.h>

#include <algorithm>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// \param packed xyz interleaved
__global__ void unpack_normals(const float* packed, Samples samples)
{
  const Wide i = thread_index();
  if (i < samples.size)
    samples.normals[i] = make_float4(packed[3 * i], packed[3 * i + 1], packed[3 * i + 2], 0);
}

/// \param order where each sample was before
__global__ void put_normals_back(Samples samples, const unsigned* order, float* packed)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const float4 normal = samples.normals[i];
  float* const place = packed + 3 * Wide(order[i]);
  place[0] = normal.x;
  place[1] = normal.y;
  place[2] = normal.z;
}

/// The samples of all tiles, where only their sides are not known.
class Samples_of_tiles : public Cuda_points
{
  Samples m_samples;

public:
  /// \param positions, normals on the host
  Samples_of_tiles(Session& session, const double* positions, const float* normals, unsigned size,
                   const Parameters& parameters, Stages& stages, Call_report& report)
    : Cuda_points(session, parameters, stages, report)
  {
    Device_arena& arena = m_context.arena;
    m_samples.size = size;
    m_samples.positions = arena.take<double>(3 * std::size_t(size));
    m_samples.normals = arena.take<float4>(size);
    m_samples.fit = arena.take<float4>(size); // the place of the sets, and of packed normals
    m_samples.side_confidences = arena.take<float>(size);
    copy(m_samples.positions, positions, cudaMemcpyHostToDevice);
    copy(packed_normals(), normals, cudaMemcpyHostToDevice);
    unpack_normals<<<blocks_for(size), threads_per_block, 0, m_context.stream>>>(packed_normals(),
                                                                                 m_samples);
    check_launch("unpack_normals");
  }

  void orient(const Place_of_cloud& place, const Plan& plan)
  {
    m_box.frame.exponent = place.exponent_of_frame;
    std::copy_n(place.origin_of_frame, 3, m_box.frame.origin);
    for (int axis = 0; axis < 3; ++axis)
    {
      m_box.low[axis] = m_box.frame.enter(place.low[axis], axis);
      m_box.high[axis] = m_box.frame.enter(place.high[axis], axis);
    }
    set_unit(plan.unit);
    Device_arena& arena = m_context.arena;
    Sample_counts* const counts = arena.take<Sample_counts>(1);
    CGAL_L0_CUDA_CHECK(cudaMemsetAsync(counts, 0, sizeof(Sample_counts), m_context.stream));
    unsigned* const order = arena.take<unsigned>(m_samples.size);
    sort_by_places(m_context, m_box.low, m_box.high, plan.cell_size_of_places(), m_samples, order);
    orient_normals(m_context, m_box.low, m_box.high, unsigned(plan.number_of_orientation_neighbors),
                   plan.sample_spacing, side_hints(), m_samples, counts);
    put_normals_back<<<blocks_for(m_samples.size), threads_per_block, 0, m_context.stream>>>(
      m_samples, order, packed_normals());
    check_launch("put_normals_back");
    note_sides(m_context.scratch.read(counts, m_context.stream), m_samples.size);
  }

  /// \param normals out, on the host
  void download(float* normals) { copy(normals, packed_normals(), cudaMemcpyDeviceToHost); }

private:
  float* packed_normals() const { return reinterpret_cast<float*>(m_samples.fit); }

  /// Three numbers a sample.
  template <typename T>
  void copy(T* to, const T* from, cudaMemcpyKind kind) const
  {
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(to, from, 3 * sizeof(T) * std::size_t(m_samples.size), kind,
                                       m_context.stream));
  }
};

} // namespace

Answer orient_tiles(Session& session, const double* positions, std::size_t size,
                    const Place_of_cloud& place, const Plan& plan, const Parameters& parameters,
                    Progress_callback progress, Call_report& report, float* normals)
{
  report = Call_report();
  return guarded(&session, [&]() {
    session.memory_limit.limit = parameters.maximum_memory;
    session.reserve(estimate_memory_to_orient_tiles(size, parameters));
    Stages stages(session, progress, report);
    stages.begin("orient normals", 1);
    Samples_of_tiles samples(session, positions, normals, unsigned(size), parameters, stages,
                             report);
    samples.orient(place, plan);
    samples.download(normals);
    stages.end();
  });
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
