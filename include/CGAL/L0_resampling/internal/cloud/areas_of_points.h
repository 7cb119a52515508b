// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/kernels/exact_ball.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The area of the surface that each point stands for.
struct Areas
{
  Buffer<std::uint64_t> units; ///< of each point, at least 1
  double area_per_unit;

  /// \param radius of the disk at scale 1
  static double area_per_unit_of(double radius)
  {
    return double(EIGEN_PI) * radius * radius / double(area_units_of_ball);
  }

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
radius. The disk is that of the level of the point, so that all areas are whole numbers. The points
of a cell share theirs evenly, as far from the surface those on it would seem to be the denser ones.

\param points sorted for `grid`
\param radius at scale 1
\param units_per_length `units_per_length_for()` the grid and its queries
\param units_of_balls what all points stand for as if they were of a surface: given, or found here
*/
template <typename ConcurrencyTag, typename T>
Areas areas_of_points(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                      std::size_t number_of_samples, double units_per_length,
                      std::optional<std::uint64_t>& units_of_balls, Progress& progress)
{
  const int reach = cells_in_reach(radius, grid.cell_size());
  const Cell_sizes sizes(grid.cell_size(), grid.scales());
  const auto exact_count = [&](Index i, const Local_points<T>& candidates, const Exact_ball& ball,
                               double squared_outer_radius) {
    std::uint64_t count = 0;
    for (Index j : candidates.indices)
    {
      const Vector &p = points[i], &q = points[j];
      const auto difference = [&](int axis) {
        return std::llrint(p[axis] * units_per_length) - std::llrint(q[axis] * units_per_length);
      };
      // from an outermost cell points may be too far away for fixed-point numbers
      count += (p - q).squaredNorm() <= squared_outer_radius
               && ball.holds(difference(0), difference(1), difference(2));
    }
    return count;
  };

  Areas areas{filled_buffer(points.size(), std::uint64_t(0), points.get_allocator()),
              Areas::area_per_unit_of(radius)};
  Buffer<Index> counts = filled_buffer(points.size(), Index(0), points.get_allocator()),
                half_counts = copy_of(counts);
  const auto make_visitor = [&]() {
    return [&](Search_grid_3::Range queries, const Local_points<T>& candidates,
               const Vector& origin) {
      using L = Lanes<T>;
      // of all of these, which are of one cell
      const double size = size_of_cells(sizes.level_of(queries.first)), own_radius = radius * size;
      const Exact_ball ball(own_radius, units_per_length);
      // Tolerance of relative coordinates: points within it of the border of a ball are tested
      // exactly.
      const double rounding = std::ldexp(own_radius + (reach + 1) * grid.cell_size() * size, -21);
      const auto inner = [&](double r) { return T((r - rounding) * std::abs(r - rounding)); };
      const auto outer = [&](double r) { return T((r + rounding) * (r + rounding)); };
      const T squared_radii[4] = {inner(own_radius), outer(own_radius), inner(own_radius / 2),
                                  outer(own_radius / 2)};
      for (Index i = queries.first; i < queries.second; ++i)
      {
        const Eigen::Matrix<T, 3, 1> center = (points[i] - origin).template cast<T>();
        L within[4];
        candidates.for_each_run_in_ball(
          center, squared_radii[1], [&](std::size_t, const L& squared_distance) {
            for (int k = 0; k < 4; ++k)
              within[k] += where_less(squared_distance, squared_radii[k], L(T(1)));
          });
        const auto count = [&](int k, const Exact_ball& exact) {
          const T sure = within[k].sum();
          return Index(sure == within[k + 1].sum()
                         ? std::uint64_t(sure)
                         : exact_count(i, candidates, exact, double(squared_radii[k + 1])))
                 * candidates.stride;
        };
        counts[i] = count(0, ball);
        half_counts[i] = count(2, ball.half());
      }
    };
  };
  for_each_cell<T, ConcurrencyTag>(grid, points, grid, points, reach, progress, make_visitor);

  const bool has_one_scale = grid.has_one_scale();
  const std::uint64_t fewest = has_one_scale ? 1 : fewest_points_of_disk;
  std::uint64_t total = 0;
  for_each_in_order(points.size(), [&](std::size_t i) {
    total += areas.units[i] = area_units_of_point(counts[i], sizes.level_of(i), fewest);
  });
  total = known_or_found(units_of_balls, [&]() { return total; });
  const double spacing = std::sqrt(double(total) * areas.area_per_unit / double(number_of_samples));
  for_each_in_order(grid.number_of_cells(), [&](std::size_t cell) {
    const Search_grid_3::Range of_cell = grid.points_of_cell(cell);
    const std::uint64_t count = of_cell.second - of_cell.first,
                        strip = part_of_strip(
                          spacing / (radius * size_of_cells(sizes.level_of(of_cell.first))));
    Growth_of_balls growth;
    std::uint64_t sum = 0;
    for (Index i = of_cell.first; i < of_cell.second; ++i)
    {
      sum += areas.units[i];
      growth.in_balls += counts[i] > 0 ? counts[i] - 1 : 0;
      growth.in_half_balls += half_counts[i] > 0 ? half_counts[i] - 1 : 0;
    }
    if (!has_one_scale)
      sum = growth.units_of_all(sum, strip);
    for (Index i = of_cell.first; i < of_cell.second; ++i)
      areas.units[i] = area_units_in_cell((std::max)(sum, count), count);
  });
  return areas;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H
