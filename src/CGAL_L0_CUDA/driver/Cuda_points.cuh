// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_CUDA_POINTS_CUH
#define CGAL_L0_CUDA_CUDA_POINTS_CUH

#include "driver/Session.cuh"
#include "driver/stages.cuh"

#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// The points of the session that a call works with.
struct Input
{
  Positions positions;  // with their scales
  const float* normals; // of them; null if none were given
  bool all_normals_given;
  const float* hints; // of them; null if none were given
};

/// The points of a call on the device, and what `plan_call()` asks of them, as `Cpu_points`.
class Cuda_points
{
protected:
  Session& m_session;
  const Parameters& m_parameters;
  const Execution_context m_context;
  Stages& m_stages;
  Call_report& m_report;
  Framed_box m_box;
  Input m_input = {};

public:
  /// \param parameters that tell of the sides of the normals
  Cuda_points(Session& session, const Parameters& parameters, Stages& stages, Call_report& report);
  Cuda_points(const Cuda_points&) = delete;
  Cuda_points& operator=(const Cuda_points&) = delete;

  void begin_stage(const char* name, double share, std::size_t) { m_stages.begin(name, share); }

  Call_report& report() { return m_report; }
  const Frame& frame() const { return m_box.frame; }
  std::size_t number_of_points() const { return m_input.positions.size; }

  Facts find_facts();
  Scales estimate_scales(double paper_radius);
  Range_of_scales estimate_scale_field(double robust_diagonal, const Reference_scales& usual);
  void set_unit(double unit) { m_box.set_unit(unit); }

protected:
  Side_hints side_hints() const;

  /// Into the report.
  /// \param number_of_samples that were turned
  void note_sides(const Sample_counts& counts, unsigned number_of_samples);

private:
  Positions points_in(const Frame& frame, const float* scales) const;
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_CUDA_POINTS_CUH
