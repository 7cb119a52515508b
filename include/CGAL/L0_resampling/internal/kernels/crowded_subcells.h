// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CROWDED_SUBCELLS_H
#define CGAL_L0_RESAMPLING_INTERNAL_CROWDED_SUBCELLS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Subcells along each axis of a cell, and in a cell.
constexpr unsigned subcells_per_axis = 8;
constexpr unsigned subcells_of_cell = subcells_per_axis * subcells_per_axis * subcells_per_axis;

/// The most input points of a subcell of cells of size r_p, and the most samples of one of cells of
/// size of the radius of the self neighbors, that are worked on. An even set has a few in each, as
/// its spacing is about a third of the radius. An even set of points with much noise has more: it
/// reaches the limit where the noise is 18 times the spacing.
constexpr std::uint32_t maximum_number_of_points_of_subcell = 16,
                        maximum_number_of_samples_of_subcell = 16;

/// The number of the subcell of its cell that a point is in.
/// \param xyz within the range of the cells
CGAL_L0_HOST_DEVICE inline unsigned subcell_of(const double* xyz, double cell_size)
{
  unsigned number = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const double x = xyz[axis] / cell_size;
    const double subcell = std::floor(x * subcells_per_axis) - subcells_per_axis * std::floor(x);
    number = number * subcells_per_axis + unsigned(subcell);
  }
  return number;
}

/// Whether the point of this rank is one of the `limit` that are kept of `count`, evenly spread
/// over the ranks; the first one always is.
CGAL_L0_HOST_DEVICE inline bool is_kept_of_crowd(std::uint64_t rank, std::uint64_t count,
                                                 std::uint64_t limit)
{
  return count <= limit || rank == 0 || rank * limit / count != (rank - 1) * limit / count;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CROWDED_SUBCELLS_H
