// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_PLAN_AND_SCALE_CUH
#define CGAL_L0_CUDA_PLAN_AND_SCALE_CUH

#include "Extent.cuh"
#include "plane_fits.cuh"

#include <CGAL/L0_resampling/internal/Plan.h>

#include <functional>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// A frame, and the bounding box of the points in it.
struct Framed_box
{
  Frame frame;
  double low[3], high[3];

  double diagonal() const;

  /// Makes `unit`, a length in the frame, the unit of frame and box.
  void set_unit(double unit);
};

/// Finds the facts of the cloud, plans the call, and makes r_p the unit of the frame, as
/// `plan_and_scale()` on the CPU.
/// \param scales_in called with the frame whose unit is the paper's radius, if spacing and noise of
/// the points are wanted, in that unit
/// \param range_of_scales_in called if the radius follows the field of scales: estimates it
/// \param box out: in the frame whose unit is r_p
Plan plan_and_scale(
  const Extent& extent, unsigned n, const Parameters& parameters,
  const std::function<Scales(const Framed_box&)>& scales_in,
  const std::function<Range_of_scales(const Framed_box&, const Usual_scales&)>& range_of_scales_in,
  Framed_box& box, Call_report& report);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_PLAN_AND_SCALE_CUH
