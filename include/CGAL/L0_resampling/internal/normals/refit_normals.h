// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_REFIT_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_REFIT_NORMALS_H

#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/kernels/local_surface.h>
#include <CGAL/L0_resampling/internal/normals/update_normals.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
The normal of a point, leaning to that of the plane through the points of its ball which agree with
it, see `lean_to_plane()`. That is about the smallest eigenvector of

\f[ \sum_j w_j (q_j - \bar q)(q_j - \bar q)^T, \qquad w_j
= \theta(\|q_j - q_i\|) \, \psi(n_i, n_j) \, e^{-h_{ij}^2/H^2}, \f]

with the weights of Eq. (1) and (2), and `symmetric_height()` for the points of one sheet.
*/
template <typename T>
Eigen::Matrix<T, 3, 1> refitted_normal(const Eigen::Matrix<T, 3, 1>& center,
                                       const Eigen::Matrix<T, 3, 1>& normal,
                                       Local_points<T>& candidates, const Local_normals<T>& normals,
                                       const Fit_kernel<T>& kernel)
{
  using L = Lanes<T>;
  const T own_x = normal[0], own_y = normal[1], own_z = normal[2];
  Plane_moments<L> lanes;
  candidates.for_each_run_in_ball(
    center, kernel.squared_radius(), [&](std::size_t k, const L& squared_distance) {
      const L dx = L::load(&candidates.x[k]) - center[0];
      const L dy = L::load(&candidates.y[k]) - center[1];
      const L dz = L::load(&candidates.z[k]) - center[2];
      const Seen_point<L> point(dx, dy, dz, L::load(&normals.x[k]), L::load(&normals.y[k]),
                                L::load(&normals.z[k]), own_x, own_y, own_z);
      lanes.add(dx, dy, dz, weight_in_ball(squared_distance, point.cosine, point.height, kernel));
    });
  const Triple refitted = lean_to_plane(sum_of_lanes(lanes), {normal[0], normal[1], normal[2]});
  return {T(refitted.x), T(refitted.y), T(refitted.z)};
}

/*!
Corrects filtered normals by the positions. Filtering is a mean: near a sharp edge it leaves normals
that lean to the other side. A plane through the points that agree with such a normal, which are
those of its own side, leans the other way, since it lacks their noisiest part. The mean of the two
is nearer to the truth than either; filtering once more then spreads it.

\param points sorted for `grid`
\param kernel at scale 1
\param normals in and out, one unit vector a point
*/
template <typename ConcurrencyTag, typename T>
void refit_normals(const Search_grid_3& grid, const Buffer<Vector>& points,
                   const Fit_kernel<double>& kernel, Progress& progress,
                   Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  const Fit_kernel<T> kernel_of_one = kernel.as<T>();
  update_normals<ConcurrencyTag>(
    grid, points, kernel.radius, progress, normals,
    [&](const Eigen::Matrix<T, 3, 1>& center, float scale, const Eigen::Matrix<T, 3, 1>& normal,
        Local_points<T>& candidates, const Local_normals<T>& candidate_normals) {
      return refitted_normal(center, normal, candidates, candidate_normals,
                             kernel_of_one.scaled(T(scale)));
    });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_REFIT_NORMALS_H
