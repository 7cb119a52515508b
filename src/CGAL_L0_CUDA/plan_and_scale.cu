// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "plan_and_scale.cuh"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

double Framed_box::diagonal() const
{
  const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
  return std::sqrt(x * x + y * y + z * z);
}

void Framed_box::set_unit(double unit)
{
  frame.unit *= unit;
  for (double* corner : {low, high})
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] /= unit;
}

Plan plan_and_scale(
  const Extent& extent, unsigned n, const Parameters& parameters,
  const std::function<Scales(const Framed_box&)>& scales_in,
  const std::function<Range_of_scales(const Framed_box&, const Usual_scales&)>& range_of_scales_in,
  Framed_box& box, Call_report& report)
{
  box.frame = extent.frame;
  std::copy(extent.low, extent.low + 3, box.low);
  std::copy(extent.high, extent.high + 3, box.high);
  Facts facts = {n, box.diagonal(), extent.robust_diagonal, box.frame.exponent, {0, 0}};
  if (Plan::needs_scales(parameters))
  {
    Framed_box in_paper_radii = box;
    in_paper_radii.set_unit(paper_radius(facts));
    facts.scales = scales_in(in_paper_radii);
    report.estimated_spacing = box.frame.length_of_input(facts.scales.spacing
                                                         * paper_radius(facts));
    report.estimated_noise = box.frame.length_of_input(facts.scales.noise * paper_radius(facts));
  }
  Plan plan = make_plan(parameters, facts);
  Range_of_scales range;
  if (plan.follows_scales)
    range = range_of_scales_in(box, usual_scales(plan, facts));
  plan.largest_radius = range.largest;
  box.set_unit(plan.unit);
  report_radii(plan, range, box.frame, report);
  return plan;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
