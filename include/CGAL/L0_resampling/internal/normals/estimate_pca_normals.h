// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PCA_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PCA_NORMALS_H

#include <CGAL/L0_resampling/internal/cloud/estimate_plane.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Fits planes to the balls of this radius around the points listed in `open`, and strikes those
/// off that found one.
/// \param points that `open` and `normals` count
/// \param scales of the points
/// \param sorted_points the same, sorted for `grid`
template <typename ConcurrencyTag, typename T>
void refit_in_larger_balls(const Buffer<Vector>& points, const Search_grid_3& grid,
                           const Buffer<Vector>& sorted_points, const Scales_view& scales,
                           double radius, Progress& progress, Buffer<Index>& open,
                           Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  Buffer<Vector> open_points(points.get_allocator());
  open_points.reserve(open.size());
  for_each_in_order(open.size(), [&](std::size_t k) { open_points.push_back(points[open[k]]); });
  const Sorted_queries queries(ConcurrencyTag(), open_points,
                               Cell_sizes(grid.cell_size(), listed_scales(scales, open)));
  apply_order(queries.order, open);

  const Index closed = (std::numeric_limits<Index>::max)();
  const auto make_visitor = [&]() {
    return
      [&](Search_grid_3::Range range, const Local_points<T>& candidates, const Vector& origin) {
        for (Index k = range.first; k < range.second; ++k)
        {
          const Plane_fit<T> fit = fit_plane<T>((queries.points[k] - origin).template cast<T>(),
                                                candidates,
                                                T(square(radius * queries.grid.scale(k))));
          normals[open[k]] = fit.normal;
          if (fit.spans_plane)
            open[k] = closed;
        }
      };
  };
  for_each_cell<T, ConcurrencyTag>(queries.grid, queries.points, grid, sorted_points,
                                   cells_in_reach(radius, grid.cell_size()), progress,
                                   make_visitor);
  open.erase(std::remove(open.begin(), open.end(), closed), open.end());
}

/// Computes an unoriented normal for each point from the points of its ball. A point whose ball
/// spans no plane takes the normal of the next larger ball that does, of twice, four times ... the
/// radius; if none does, whatever the largest gave.
/// \param points sorted for `grid`
/// \param radius at scale 1
/// \param numbers_of_points how many points of the input each point stands for; empty if only for
/// itself
/// \param normals out: one unit vector a point
/// \returns the number of points of the input whose own ball spanned no plane
template <typename ConcurrencyTag, typename T>
std::size_t estimate_pca_normals(const Search_grid_3& grid, const Buffer<Vector>& points,
                                 const Buffer<Index>& numbers_of_points, double radius,
                                 Progress& progress, Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  Buffer<unsigned char> is_degenerate(points.size(), 0, points.get_allocator());
  std::atomic<std::size_t> number_of_degenerate{0};
  const auto make_visitor = [&]() {
    return
      [&](Search_grid_3::Range queries, const Local_points<T>& candidates, const Vector& origin) {
        for (Index i = queries.first; i < queries.second; ++i)
        {
          const Plane_fit<T> fit = fit_plane<T>((points[i] - origin).template cast<T>(), candidates,
                                                T(square(radius * grid.scale(i))));
          normals[i] = fit.normal;
          if (!fit.spans_plane)
          {
            is_degenerate[i] = 1;
            ++number_of_degenerate;
          }
        }
      };
  };
  for_each_cell<T, ConcurrencyTag>(
    grid, points, grid, points, cells_in_reach(radius, grid.cell_size()), progress, make_visitor);
  if (number_of_degenerate == 0)
    return 0;

  // Few points in a healthy cloud: the others leave the loop, what is left meets coarser and
  // coarser grids.
  Buffer<Index> open(points.get_allocator());
  open.reserve(number_of_degenerate);
  std::size_t number_in_input = 0;
  for_each_in_order(points.size(), [&](std::size_t i) {
    if (!is_degenerate[i])
      return;
    open.push_back(Index(i));
    number_in_input += numbers_of_points.empty() ? 1 : numbers_of_points[i];
  });
  for (int doubling = 1; doubling <= number_of_radius_doublings && !open.empty(); ++doubling)
  {
    const double larger_radius = std::ldexp(radius, doubling);
    const int farthest_reach =
      3; // sorting all points anew costs more than to look at so many cells for a few of them
    if (cells_in_reach(larger_radius, grid.cell_size()) <= farthest_reach)
      refit_in_larger_balls<ConcurrencyTag>(points, grid, points, grid.scales(), larger_radius,
                                            progress, open, normals);
    else
    {
      const Sorted_queries coarse(ConcurrencyTag(), points,
                                  Cell_sizes(larger_radius, grid.scales()));
      refit_in_larger_balls<ConcurrencyTag>(points, coarse.grid, coarse.points, grid.scales(),
                                            larger_radius, progress, open, normals);
    }
  }
  return number_in_input;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PCA_NORMALS_H
