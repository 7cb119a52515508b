// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H

#include <CGAL/L0_resampling/internal/ball_queries.h>
#include <CGAL/L0_resampling/internal/exact_ball.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The area of the surface that each point stands for.
struct Areas
{
  Buffer<std::uint64_t> units; ///< of each point, at least 1
  double area_per_unit;

  double of_point(std::size_t i) const { return double(units[i]) * area_per_unit; }

  double total() const
  {
    std::uint64_t sum = 0;
    for (std::uint64_t u : units)
      sum += u;
    return double(sum) * area_per_unit;
  }
};

/*!
The area that each point stands for: that of a disk, shared by the points in the ball of that
radius. The points of a cell share theirs evenly, as far from the surface those on it would seem to
be the denser ones.

\param points sorted for `grid`
\param units_per_length `units_per_length_for()` the grid and its queries
*/
template <typename ConcurrencyTag, typename T>
Areas areas_of_points(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                      double units_per_length, Progress& progress)
{
  const Exact_ball ball(radius, units_per_length);
  const int reach = cells_in_reach(radius, grid.cell_size());
  // Tolerance of relative coordinates: points within it of the border of the ball are tested
  // exactly.
  const double rounding = std::ldexp(radius + (reach + 1) * grid.cell_size(), -21);
  const T squared_inner_radius = T((radius - rounding) * std::abs(radius - rounding)),
          squared_outer_radius = T((radius + rounding) * (radius + rounding));
  const auto exact_count = [&](Index i, const Local_points<T>& candidates) {
    std::uint64_t count = 0;
    for (Index j : candidates.indices)
    {
      const Vector &p = points[i], &q = points[j];
      const auto difference = [&](int axis) {
        return std::llrint(p[axis] * units_per_length) - std::llrint(q[axis] * units_per_length);
      };
      // from an outermost cell points may be too far away for fixed-point numbers
      count += (p - q).squaredNorm() <= double(squared_outer_radius)
               && ball.holds(difference(0), difference(1), difference(2));
    }
    return count;
  };

  Areas areas{filled_buffer(points.size(), std::uint64_t(0), points.get_allocator()),
              double(EIGEN_PI) * radius * radius / double(area_units_of_ball)};
  const auto make_visitor = [&]() {
    return
      [&](Search_grid_3::Range queries, const Local_points<T>& candidates, const Vector& origin) {
        using L = Lanes<T>;
        for (Index i = queries.first; i < queries.second; ++i)
        {
          const Eigen::Matrix<T, 3, 1> center = (points[i] - origin).template cast<T>();
          L inner, outer;
          candidates.for_each_run_in_ball(
            center, squared_outer_radius, [&](std::size_t, const L& squared_distance) {
              inner += where_less(squared_distance, squared_inner_radius, L(T(1)));
              outer += where_less(squared_distance, squared_outer_radius, L(T(1)));
            });
          const T count = inner.sum();
          areas.units[i] = area_units_of_point(
            (count == outer.sum() ? std::uint64_t(count) : exact_count(i, candidates))
            * candidates.stride);
        }
      };
  };
  for_each_cell<T, ConcurrencyTag>(grid, points, grid, points, reach, progress, make_visitor);

  for_each_in_order(grid.number_of_cells(), [&](std::size_t cell) {
    const Search_grid_3::Range of_cell = grid.points_of_cell(cell);
    std::uint64_t sum = 0;
    for (Index i = of_cell.first; i < of_cell.second; ++i)
      sum += areas.units[i];
    for (Index i = of_cell.first; i < of_cell.second; ++i)
      areas.units[i] = area_units_in_cell(sum, of_cell.second - of_cell.first);
  });
  return areas;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H
