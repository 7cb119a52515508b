// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_REPRESENTATIVES_CUH
#define CGAL_L0_CUDA_REPRESENTATIVES_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// The points of a grid that stand for all of them, as on the CPU.
struct Representatives
{
  const unsigned* places; // for each point, in the order of the grid, which of the kept ones stands
                          // for it; null if each stands for itself
  const unsigned* kept;   // the kept ones, ascending; null for all
  unsigned number_of_kept;

  bool are_all_points() const { return !places; }
};

/// Of points of which no subcell keeps more than `limit`, as `thin_crowds()` on the CPU. Waits for
/// the device. The arrays are taken from the scratch arena.
/// \param positions those that `grid` was built of
Representatives representatives_of_crowds(const Execution_context& context,
                                          const Positions& positions, const Cell_grid& grid,
                                          unsigned limit);

/// Finds where the points that stand for others are among the kept ones, in the order of the points
/// that `grid` was built of.
/// \param of_former out: a place a point
void find_places_of_points(const Execution_context& context, const Cell_grid& grid,
                           const Representatives& representatives, unsigned* of_former);

/// Lists which points of the input the kept points of a grid are.
/// \param positions those that `grid` was built of
/// \param kept null for all
void list_kept(const Execution_context& context, const Positions& positions, const Cell_grid& grid,
               const unsigned* kept, unsigned number_of_kept, unsigned* listed);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_REPRESENTATIVES_CUH
