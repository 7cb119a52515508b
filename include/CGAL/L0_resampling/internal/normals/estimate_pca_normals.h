// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PCA_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PCA_NORMALS_H

#include <CGAL/L0_resampling/internal/cloud/estimate_plane.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The balls around some points.
/// \param points that `list` counts
/// \param scales of the points
/// \param sorted_points the same, sorted for `grid`
/// \param list out: in another order
/// \param radius of the largest ball that is looked at
/// \param visit `visit(k, plane_of_ball)`, in any order: of the point `list[k]`, `plane_of_ball(r)`
/// is the plane in its ball of this radius, at scale 1
template <typename ConcurrencyTag, typename T, typename Visit>
void visit_balls_of_list(const Buffer<Vector>& points, const Search_grid_3& grid,
                         const Buffer<Vector>& sorted_points, const Scales_view& scales,
                         double radius, Progress& progress, Buffer<Index>& list, const Visit& visit)
{
  Buffer<Vector> listed_points(points.get_allocator());
  listed_points.reserve(list.size());
  for_each_in_order(list.size(), [&](std::size_t k) { listed_points.push_back(points[list[k]]); });
  const Sorted_queries queries(ConcurrencyTag(), listed_points,
                               Cell_sizes(grid.cell_size(), listed_scales(scales, list)));
  apply_order(queries.order, list);
  const auto make_visitor = [&]() {
    return [&](Search_grid_3::Range range, Local_points<T>& candidates, const Vector& origin) {
      for (Index k = range.first; k < range.second; ++k)
        visit(k, [&](double radius_of_ball) {
          return fit_plane<T>((queries.points[k] - origin).template cast<T>(), candidates,
                              T(square(radius_of_ball * queries.grid.scale(k))));
        });
    };
  };
  for_each_cell<T, ConcurrencyTag>(queries.grid, queries.points, grid, sorted_points,
                                   cells_in_reach(radius, grid.cell_size()), progress,
                                   make_visitor);
}

/// Fits planes to the balls of this radius around the points listed in `open`, and strikes those
/// off that found one. Parameters as of `visit_balls_of_list()`.
template <typename ConcurrencyTag, typename T>
void refit_in_larger_balls(const Buffer<Vector>& points, const Search_grid_3& grid,
                           const Buffer<Vector>& sorted_points, const Scales_view& scales,
                           double radius, Progress& progress, Buffer<Index>& open,
                           Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  const Index closed = (std::numeric_limits<Index>::max)();
  visit_balls_of_list<ConcurrencyTag, T>(points, grid, sorted_points, scales, radius, progress,
                                         open, [&](Index k, const auto& plane_of_ball) {
                                           const Plane_of_ball fit = plane_of_ball(radius);
                                           normals[open[k]] = fit.template normal_as<T>();
                                           if (fit.spans_plane)
                                             open[k] = closed;
                                         });
  open.erase(std::remove(open.begin(), open.end(), closed), open.end());
}

/// Computes an unoriented normal for each point from the points of its ball. A point whose ball
/// spans no plane takes the normal of the next larger ball that does, of twice, four times ... the
/// radius; if none does, whatever the largest gave.
/// \param points sorted for `grid`
/// \param radius at scale 1
/// \param looks_beyond_strips whether points whose ball lies in a strip look at one of twice the
/// radius, see `normal_beyond_strip()`
/// \param numbers_of_points how many points of the input each point stands for; empty if only for
/// itself
/// \param normals out: one unit vector a point
/// \returns the number of points of the input whose own ball spanned no plane, and of those on a
/// line, see `lies_on_line()`
template <typename ConcurrencyTag, typename T>
std::size_t estimate_pca_normals(const Search_grid_3& grid, const Buffer<Vector>& points,
                                 const Buffer<Index>& numbers_of_points, double radius,
                                 bool looks_beyond_strips, Progress& progress,
                                 Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  enum class State : unsigned char
  {
    DONE,
    IN_STRIP,
    ON_LINE,
    WITHOUT_PLANE
  };
  Buffer<State> states(points.size(), State::DONE, points.get_allocator());
  const auto make_visitor = [&]() {
    return [&](Search_grid_3::Range queries, Local_points<T>& candidates, const Vector& origin) {
      for (Index i = queries.first; i < queries.second; ++i)
      {
        const Plane_of_ball fit = fit_plane<T>((points[i] - origin).template cast<T>(), candidates,
                                               T(square(radius * grid.scale(i))));
        normals[i] = fit.template normal_as<T>();
        states[i] = !fit.spans_plane ? State::WITHOUT_PLANE
                    : fit.share < 1  ? State::IN_STRIP
                                     : State::DONE;
      }
    };
  };
  for_each_cell<T, ConcurrencyTag>(
    grid, points, grid, points, cells_in_reach(radius, grid.cell_size()), progress, make_visitor);
  const auto all_in = [&](State state) {
    Buffer<Index> list(points.get_allocator());
    for_each_in_order(points.size(), [&](std::size_t i) {
      if (states[i] == state)
        list.push_back(Index(i));
    });
    return list;
  };

  if (looks_beyond_strips)
  {
    Buffer<Index> strips = all_in(State::IN_STRIP);
    visit_balls_of_list<ConcurrencyTag, T>(points, grid, points, grid.scales(), 2 * radius,
                                           progress, strips,
                                           [&](Index k, const auto& plane_of_ball) {
                                             const Plane_of_ball own = plane_of_ball(radius),
                                                                 wide = plane_of_ball(2 * radius);
                                             const Triple n = normal_beyond_strip(own, wide);
                                             normals[strips[k]] = {T(n.x), T(n.y), T(n.z)};
                                             if (lies_on_line(own, wide))
                                               states[strips[k]] = State::ON_LINE;
                                           });
  }

  // Few points in a healthy cloud: the others leave the loop, what is left meets coarser and
  // coarser grids.
  Buffer<Index> open = all_in(State::WITHOUT_PLANE);
  std::size_t number_in_input = 0;
  const auto count = [&](const Buffer<Index>& degenerate) {
    for (Index i : degenerate)
      number_in_input += numbers_of_points.empty() ? 1 : numbers_of_points[i];
  };
  count(all_in(State::ON_LINE));
  count(open);
  for (int doubling = 1; doubling <= number_of_radius_doublings && !open.empty(); ++doubling)
  {
    const double larger_radius = std::ldexp(radius, doubling);
    if (cells_in_reach(larger_radius, grid.cell_size()) <= farthest_reach_of_refits)
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
