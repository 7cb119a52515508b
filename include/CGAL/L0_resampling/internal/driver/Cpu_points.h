// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CPU_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_CPU_POINTS_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/cloud/estimate_scale_field.h>
#include <CGAL/L0_resampling/internal/cloud/estimate_scales.h>
#include <CGAL/L0_resampling/internal/cloud/extents.h>
#include <CGAL/L0_resampling/internal/cloud/prepare_points.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The points of a call on the CPU, and what `plan_call()` asks of them.
template <typename ConcurrencyTag>
class Cpu_points
{
protected:
  Progress& m_progress;
  Report& m_report;
  Facts_of_cloud m_facts;
  Working_frame m_frame;
  Prepared_points m_input;

public:
  /// \param points finite, at least one; used up
  /// \param given what is known of the cloud that the points are a part of
  Cpu_points(Buffer<Vector>& points, Progress& progress, Report& report,
             const Facts_of_cloud& given = {})
    : m_progress(progress), m_report(report), m_facts(given), m_input(points)
  {}

  /// Those given, and those found so far.
  const Facts_of_cloud& facts() const { return m_facts; }

  void begin_stage(const std::string& name, double share, std::size_t number_of_steps)
  {
    m_progress.begin_stage(name, share, number_of_steps);
  }

  Report& report() { return m_report; }
  const Working_frame& frame() const { return m_frame; }
  std::size_t number_of_points() const { return m_input.points.size(); }
  Buffer<float>& scales() { return m_input.scales; } ///< of the points; none if all are 1

  /// \param ratios of the noise of each point to that of the cloud; none if all are 1
  void take_noise_ratios(Buffer<float> ratios) { m_input.noise_ratios = std::move(ratios); }

  /// Facts of the points in a frame that they enter.
  Facts find_facts()
  {
    const Buffer<Vector>& points = m_input.points;
    if (m_facts.frame)
      m_frame.enter<ConcurrencyTag>(m_input.points, *m_facts.frame);
    else
      m_frame.enter<ConcurrencyTag>(m_input.points);
    m_facts.frame = m_frame.place();
    return known_or_found(m_facts.extents, [&]() {
      return Facts{points.size(), box_diagonal(points), robust_diagonal<ConcurrencyTag>(points),
                   m_frame.exponent()};
    });
  }

  /// \param paper_radius the unit of the scales
  Scales estimate_scales(double paper_radius)
  {
    const Scales& scales = known_or_found(m_facts.scales, [&]() {
      return internal::estimate_scales<ConcurrencyTag, Local>(m_input.points, paper_radius,
                                                              m_progress);
    });
    m_report.estimated_spacing = m_frame.length_of_input(scales.spacing * paper_radius);
    m_report.estimated_noise = m_frame.length_of_input(scales.noise * paper_radius);
    return scales;
  }

  Range_of_scales estimate_scale_field(double robust_diagonal, const Reference_scales& usual)
  {
    std::optional<Range_of_scales>& known = m_facts.range_of_scales;
    if (m_input.scales.empty() && (!known || !known->is_one()))
    {
      const auto scales_by = [&](const Scale_field& field) {
        return field.of_points<ConcurrencyTag>(m_input.points);
      };
      m_input.scales =
        m_facts.field ? scales_by(*m_facts.field)
                      : scales_by(internal::estimate_scale_field<ConcurrencyTag>(
                        m_input.points, m_input.noise_ratios, robust_diagonal, usual, m_progress));
    }
    return known_or_found(known, [&]() { return range_of(m_input.scales); });
  }

  void set_unit(double unit) { m_frame.set_unit<ConcurrencyTag>(unit, m_input.points); }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CPU_POINTS_H
