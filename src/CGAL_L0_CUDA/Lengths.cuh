// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_LENGTHS_CUH
#define CGAL_L0_CUDA_LENGTHS_CUH

#include "Extent.cuh"
#include "plane_fits.cuh"

#include <CGAL/L0_resampling/internal/Parameters.h>

#include <algorithm>
#include <functional>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// The lengths of a call, in its frame; as on the CPU.
struct Lengths
{
  Frame frame;
  double low[3], high[3]; // bounding box of the points
  double radius, filter_radius, self_neighbor_radius;
  double noise; // standard deviation across the surface; default method only
  double sample_spacing, cell_size, smallest_cell_size;

  /// Scales frame and box so that `r`, a length in the frame, comes to lie in [1, 2).
  /// \returns the factor
  double scale_to(double r)
  {
    const double scale = frame.scale_to(r);
    for (double* corner : {low, high})
      for (int axis = 0; axis < 3; ++axis)
        corner[axis] *= scale;
    return scale;
  }

  /// The default method's spacing of the samples, and what follows from it.
  void set_sample_spacing(double spacing)
  {
    sample_spacing = spacing;
    self_neighbor_radius = (std::min)(self_neighbor_radius_per_spacing * spacing, radius);
  }
};

/// Chooses the lengths that the caller left open, as the CPU does.
/// \param scales_in called with the frame of the paper's radius, and that radius there, if spacing and noise of the points are wanted
Lengths choose_lengths(const Extent& extent, unsigned n, const Parameters& parameters,
                       const std::function<Scales(const Lengths&)>& scales_in, Call_report& report);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_LENGTHS_CUH
