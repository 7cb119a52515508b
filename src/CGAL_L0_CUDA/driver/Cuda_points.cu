// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/Cuda_points.cuh"

#include <algorithm>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

Cuda_points::Cuda_points(Session& session, const Parameters& parameters, Stages& stages,
                         Call_report& report)
  : m_session(session), m_parameters(parameters), m_context(session.context()), m_stages(stages),
    m_report(report)
{}

Positions Cuda_points::points_in(const Frame& frame, const float* scales) const
{
  return {m_session.points, m_session.size, frame, false, nullptr, scales};
}

Facts Cuda_points::find_facts()
{
  const Extent& extent = m_session.extent;
  m_box.frame = extent.frame;
  std::copy(extent.low, extent.low + 3, m_box.low);
  std::copy(extent.high, extent.high + 3, m_box.high);
  m_input = {points_in(m_box.frame, nullptr), m_session.normals, m_session.all_normals_given,
             m_session.hints};
  return {m_session.size, m_box.diagonal(), extent.robust_diagonal, m_box.frame.exponent};
}

Scales Cuda_points::estimate_scales(double paper_radius)
{
  if (!m_session.has_scales)
  {
    Framed_box box = m_box;
    box.set_unit(paper_radius);
    m_session.scales = cuda::estimate_scales(m_context, points_in(box.frame, nullptr), box.low,
                                             box.high, 1);
    m_session.has_scales = true;
  }
  const Scales& scales = m_session.scales;
  m_report.estimated_spacing = m_box.frame.length_of_input(scales.spacing * paper_radius);
  m_report.estimated_noise = m_box.frame.length_of_input(scales.noise * paper_radius);
  return scales;
}

Range_of_scales Cuda_points::estimate_scale_field(double robust_diagonal,
                                                  const Reference_scales& usual)
{
  const Scales_of_points found = cuda::estimate_scale_field(m_context, m_input.positions,
                                                            robust_diagonal, usual);
  m_input.positions.scales = found.scales;
  return found.range;
}

/// What the caller says of the sides of the samples.
Side_hints Cuda_points::side_hints() const
{
  const Parameters& parameters = m_parameters;
  Side_hints hints = {parameters.has_viewpoint, parameters.viewpoint,
                      parameters.has_viewpoint || parameters.hints_are_viewpoints};
  if (hints.viewpoint.weight > 0)
  {
    for (int axis = 0; axis < 3; ++axis)
      hints.viewpoint.coordinates[axis] = m_box.frame.enter(parameters.viewpoint.coordinates[axis],
                                                            axis);
    bring_nearer(hints.viewpoint.coordinates, parameters.viewpoint.coordinates);
  }
  return hints;
}

void Cuda_points::note_sides(const Sample_counts& counts, unsigned number_of_samples)
{
  m_report.oriented_share = double(counts.oriented) / number_of_samples;
  m_report.hinted_share = double(counts.hinted) / number_of_samples;
  m_report.right_side_share = double(counts.confidence) / Sample_counts::units_per_confidence
                              / number_of_samples;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
