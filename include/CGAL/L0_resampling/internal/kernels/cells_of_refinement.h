// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CELLS_OF_REFINEMENT_H
#define CGAL_L0_RESAMPLING_INTERNAL_CELLS_OF_REFINEMENT_H

#include <CGAL/L0_resampling/internal/kernels/lengths_of_refinement.h>
#include <CGAL/L0_resampling/internal/kernels/split_of_sheet.h>

#include <algorithm>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Whether balls are looked for in cells of this size. Larger ones have cells of their own, of half
/// the radius: the blocks around cells have a list of as many rows as this allows. Blocks of too
/// many samples are thinned, which has to be the same on all processors.
inline bool is_reached_in_cells(double radius, double cell_size) { return radius <= 4 * cell_size; }

/// The size of the cells in which balls around samples are looked for: that of the points, unless
/// their radius, which the caller may choose, is far smaller than the balls of the refinement, as
/// these follow the spacing of the points.
inline double cell_size_of_refinement(const Lengths_of_refinement& lengths,
                                      double cell_size_of_points)
{
  double units = radius_of_majority;
  for (int scale = 0; scale < number_of_fit_scales; ++scale)
    units = (std::max)({units, radius_of_bias(scale),
                        scale < first_scale_of_merged_disks ? radius_of_fit(scale) : 0});
  const double radius = (std::max)(units * lengths.unit,
                                   lengths.widened(widening_of_split).reach_of_disk());
  return is_reached_in_cells(radius, cell_size_of_points) ? cell_size_of_points : radius / 2;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CELLS_OF_REFINEMENT_H
