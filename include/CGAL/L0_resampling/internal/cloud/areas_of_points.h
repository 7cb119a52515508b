// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/kernels/exact_ball.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <array>
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
    return double(EIGEN_PI) * radius * radius / double(area_units_of_disk);
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

/// What is found of a point in its ball.
struct Points_of_ball
{
  Index count = 0; ///< of the points, itself included
  Spread_in_ball spread;
};

/// What is found in the ball of each point.
/// \param points sorted for `grid`
/// \param radius at scale 1
/// \param units_per_length `units_per_length_for()` the grid and its queries
template <typename ConcurrencyTag, typename T>
Buffer<Points_of_ball> balls_of_points(const Search_grid_3& grid, const Buffer<Vector>& points,
                                       double radius, double units_per_length, Progress& progress)
{
  const int reach = cells_in_reach(radius, grid.cell_size());
  const Cell_sizes sizes(grid.cell_size(), grid.scales());
  Buffer<Points_of_ball> balls = filled_buffer(points.size(), Points_of_ball(),
                                               points.get_allocator());
  const auto make_visitor = [&]() {
    return [&](Search_grid_3::Range queries, Local_points<T>& candidates, const Vector& origin) {
      using L = Lanes<T>;
      // of all of these, which are of one cell
      const double size = size_of_cells(sizes.level_of(queries.first)), own_radius = radius * size;
      const Exact_ball ball(own_radius, units_per_length);
      // what relative coordinates are rounded by
      const double rounding = std::ldexp(own_radius + (reach + 1) * grid.cell_size() * size, -21);
      const T outer_squared_radius = T(square(own_radius + rounding));
      for (Index i = queries.first; i < queries.second; ++i)
      {
        const Eigen::Matrix<T, 3, 1> center = (points[i] - origin).template cast<T>();
        const auto place_in_units = [&](Index j) {
          const Vector& p = points[j];
          return std::array<std::int64_t, 3>{std::llrint(p[0] * units_per_length),
                                             std::llrint(p[1] * units_per_length),
                                             std::llrint(p[2] * units_per_length)};
        };
        const std::array<std::int64_t, 3> own = place_in_units(i);
        Plane_moments<std::int64_t> moments;
        const auto add = [&](Index j) {
          const std::array<std::int64_t, 3> other = place_in_units(j);
          const std::int64_t dx = other[0] - own[0], dy = other[1] - own[1], dz = other[2] - own[2];
          if (ball.holds(dx, dy, dz))
            ball.add(dx, dy, dz, moments);
        };
        candidates.for_each_run_in_ball(center, outer_squared_radius,
                                        [&](std::size_t k, const L& squared_distance) {
                                          T distances[L::size];
                                          squared_distance.store(distances);
                                          // padding is in no ball
                                          for (std::size_t lane = 0; lane < L::size; ++lane)
                                            if (distances[lane] < outer_squared_radius)
                                              add(candidates.indices[k + lane]);
                                        });
        const auto to_number = [](std::int64_t sum) { return double(sum); };
        balls[i] = {Index(moments.sum) * candidates.stride,
                    Spread_in_ball(moments.template transformed<double>(to_number),
                                   ball.radius_of_moments())};
      }
    };
  };
  for_each_cell<T, ConcurrencyTag>(grid, points, grid, points, reach, progress, make_visitor);
  return balls;
}

/// The areas that the points of cells stand for, once it is known what all disks are.
class Areas_of_cells
{
  double m_radius, m_spacing;

public:
  /// \param radius of the disk at scale 1
  /// \param units_of_disks what all points of the cloud stand for if each disk is covered
  /// \param number_of_samples of the cloud
  Areas_of_cells(double radius, std::uint64_t units_of_disks, std::size_t number_of_samples)
    : m_radius(radius), m_spacing(std::sqrt(double(units_of_disks) * Areas::area_per_unit_of(radius)
                                            / double(number_of_samples)))
  {}

  /// What each point of a cell stands for.
  /// \param balls of its points, so many
  std::uint64_t units_of_each(const Points_of_ball* balls, std::size_t count, int level) const
  {
    const double spacing_per_radius = m_spacing / (m_radius * size_of_cells(level));
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      sum += area_units_of_point(balls[i].count, level,
                                 balls[i].spread.share_of_disk(spacing_per_radius));
    return area_units_in_cell(sum, count);
  }
};

/// The area of the disk of a point, shared by those in its ball, as if they covered it.
inline std::uint64_t units_of_disk(const Points_of_ball& ball, const Cell_sizes& sizes,
                                   std::size_t i)
{
  return area_units_of_point(ball.count, sizes.level_of(i), 1);
}

/*!
The area that each point stands for: that of a disk, as far as the points in the ball of that radius
cover it, shared by these points. The disk is that of the level of the point, so that all areas are
whole numbers. The points of a cell share theirs evenly, as far from the surface those on it would
seem to be the denser ones. Parameters are those of `balls_of_points()`.

\param units_of_disks what all points stand for if each disk is covered: given, or found here
*/
template <typename ConcurrencyTag, typename T>
Areas areas_of_points(const Search_grid_3& grid, const Buffer<Vector>& points, double radius,
                      std::size_t number_of_samples, double units_per_length,
                      std::optional<std::uint64_t>& units_of_disks, Progress& progress)
{
  const Buffer<Points_of_ball> balls =
    balls_of_points<ConcurrencyTag, T>(grid, points, radius, units_per_length, progress);
  const Cell_sizes sizes(grid.cell_size(), grid.scales());
  Areas areas{Buffer<std::uint64_t>(points.get_allocator()), Areas::area_per_unit_of(radius)};
  areas.units.reserve(points.size());
  const std::uint64_t of_disks = known_or_found(units_of_disks, [&]() {
    std::uint64_t sum = 0;
    for_each_in_order(points.size(),
                      [&](std::size_t i) { sum += units_of_disk(balls[i], sizes, i); });
    return sum;
  });
  const Areas_of_cells of_cells(radius, of_disks, number_of_samples);
  for_each_in_order(grid.number_of_cells(), [&](std::size_t cell) {
    const Search_grid_3::Range of_cell = grid.points_of_cell(cell);
    const std::size_t count = of_cell.second - of_cell.first;
    areas.units.insert(areas.units.end(), count,
                       of_cells.units_of_each(&balls[of_cell.first], count,
                                              sizes.level_of(of_cell.first)));
  });
  return areas;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_AREAS_OF_POINTS_H
