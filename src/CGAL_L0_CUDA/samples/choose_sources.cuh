// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_CHOOSE_SOURCES_CUH
#define CGAL_L0_CUDA_CHOOSE_SOURCES_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Some of the numbers from 0 on, ascending; `list` is null where they are the first `size`.
struct Index_subset
{
  const unsigned* list;
  unsigned size;

  __device__ unsigned operator[](Wide k) const { return list ? list[k] : unsigned(k); }
};

/// Where samples start, by the numbers of distinct points: on a point, or between it and another.
struct Sources
{
  Index_subset on_points, near_points;
};

/// Of ascending numbers, the place of the last that is not above `value`; the first is not.
__device__ inline unsigned last_not_above(const unsigned* numbers, unsigned size, Wide value)
{
  unsigned first = 0;
  for (unsigned rest = size - 1; rest > 0;)
  {
    const unsigned half = (rest + 1) / 2;
    if (numbers[first + half] <= value)
    {
      first += half;
      rest -= half;
    }
    else
      rest = half - 1;
  }
  return first;
}

/// What is known of the points of a grid.
struct Known_points
{
  const Point_in_cloud* points; // of the session; null if nothing is known
  const unsigned *list,         // which of these were sorted; null for all
    *order;                     // where each stood before

  __device__ const Point_in_cloud& operator()(unsigned i) const
  {
    return points[list ? list[order[i]] : order[i]];
  }

  /// The number of a point in the order of the whole cloud.
  __device__ unsigned cloud_index(unsigned i) const { return points ? (*this)(i).index : i; }
};

/// The first of the points at each place, from the scratch arena.
Index_subset distinct_points(const Execution_context& context, const Cell_grid& grid);

/// From the scratch arena.
/// \param areas null if samples spread as the points do
Sources chosen_sources(const Execution_context& context, const Cell_grid& grid,
                       const Index_subset& distinct, const Areas* areas, unsigned number_of_samples,
                       Wide seed);

/// From the scratch arena.
/// \param m number of samples
Sources known_sources(const Execution_context& context, const Known_points& known,
                      const Cell_grid& grid, const Index_subset& distinct, unsigned m);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_CHOOSE_SOURCES_CUH
