// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_UPDATE_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_UPDATE_NORMALS_H

#include <CGAL/L0_resampling/internal/kernels/Bilateral_kernel.h>
#include <CGAL/L0_resampling/internal/normals/Local_normals.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What Eq. (1) and (2) need beside the points.
template <typename T>
struct Normal_filter
{
  double radius;       ///< \f$ r_q \f$
  T squared_bandwidth; ///< \f$ \sigma_q^2 \f$
  T normal_bandwidth;  ///< \f$ (1 - \cos\sigma_n)^2 \f$

  Normal_filter scaled(T scale) const
  {
    return {radius * scale, squared_bandwidth * scale * scale, normal_bandwidth};
  }

  Bilateral_kernel<T> kernel() const
  {
    return {T(radius * radius), squared_bandwidth, normal_bandwidth};
  }
};

/// Replaces each normal by `f(center, scale, normal, candidates, candidate_normals)`, which reads
/// only the old ones. Candidates are all points within `radius` times the scale, and others; their
/// coordinates and `center` are relative to one origin.
template <typename ConcurrencyTag, typename T, typename F>
void update_normals(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                    Progress& progress, Buffer<Eigen::Matrix<T, 3, 1>>& normals, const F& f)
{
  Buffer<Eigen::Matrix<T, 3, 1>> updated = copy_of(normals);
  const auto make_visitor = [&]() {
    return [&, local_normals = Local_normals<T>()](Search_grid_3::Range queries,
                                                   Local_points<T>& candidates,
                                                   const Vector& origin) mutable {
      local_normals.gather(candidates, normals);
      for (Index i = queries.first; i < queries.second; ++i)
        updated[i] = f((points[i] - origin).template cast<T>().eval(), grid.scale(i), normals[i],
                       candidates, local_normals);
    };
  };
  for_each_cell<T, ConcurrencyTag>(
    grid, points, grid, points, cells_in_reach(radius, grid.cell_size()), progress, make_visitor);
  normals.swap(updated);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_UPDATE_NORMALS_H
