// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIND_DEVIATIONS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIND_DEVIATIONS_H

#include <CGAL/L0_resampling/internal/kernels/deviation_of_sample.h>
#include <CGAL/L0_resampling/internal/normals/Local_normals.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Finds how far samples may be off the surface: what the covariance of their fits tells, and how much
the normals around differ.

\param sorted the samples, in cells
\param normals of the samples, in their own order
\param variance_of called with a sample
\param ball_of called with a sample
\param reach of the largest ball, in cells
\param deviations out, in the order of the samples
*/
template <typename ConcurrencyTag, typename VarianceOf, typename BallOf>
void find_deviations(const Sorted_queries& sorted, const Buffer<Local_vector>& normals,
                     const VarianceOf& variance_of, const BallOf& ball_of, int reach,
                     Progress& progress, Buffer<Deviations>& deviations)
{
  using L = Lanes<Local>;
  const Buffer<Local_vector> sorted_normals = values_in_order<ConcurrencyTag>(sorted.order,
                                                                              normals);
  const auto make_visitor = [&]() {
    return [&, around = Local_normals<Local>()](Search_grid_3::Range queries,
                                                Local_points<Local>& candidates,
                                                const Vector& origin) mutable {
      around.gather(candidates, sorted_normals);
      for (Index q = queries.first; q < queries.second; ++q)
      {
        const Index i = sorted.order[q];
        const Eigen::Matrix<Local, 3, 1> center =
                                           (sorted.points[q] - origin).template cast<Local>(),
                                         normal = sorted_normals[q];
        const Ball_of_normals ball = ball_of(i);
        Angles_around<L> sums;
        candidates.for_each_run_in_ball(
          center, ball.squared_radius, [&](std::size_t k, const L& squared_distance) {
            sums.add(ball, squared_distance,
                     squared_difference_of_normals(L(normal[0]), L(normal[1]), L(normal[2]),
                                                   L::load(&around.x[k]), L::load(&around.y[k]),
                                                   L::load(&around.z[k])));
          });
        deviations[i] = deviations_of_sample(
          variance_of(i), Angles_around<Local>{sums.weight.sum(), sums.squared_angles.sum()});
      }
    };
  };
  for_each_cell<Local, ConcurrencyTag>(sorted.grid, sorted.points, sorted.grid, sorted.points,
                                       reach, progress, make_visitor);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIND_DEVIATIONS_H
