// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H

#include <CGAL/L0_resampling/internal/cloud/estimate_plane.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/kernels/scales_of_balls.h>
#include <CGAL/L0_resampling/internal/search/thin_crowds.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Of the candidates in the ball around `center`, over the plane through it.
template <typename T>
Height_moments<double> moments_over_plane(const Eigen::Matrix<T, 3, 1>& center,
                                          const Eigen::Matrix<T, 3, 1>& normal,
                                          Local_points<T>& candidates, T squared_radius)
{
  using L = Lanes<T>;
  Height_moments<L> lanes;
  candidates.for_each_run_in_ball(
    center, squared_radius, [&](std::size_t k, const L& squared_distance) {
      const L height = (L::load(&candidates.x[k]) - center[0]) * normal[0]
                       + (L::load(&candidates.y[k]) - center[1]) * normal[1]
                       + (L::load(&candidates.z[k]) - center[2]) * normal[2];
      lanes.add(height, where_less(squared_distance, squared_radius, L(T(1))));
    });
  return sum_of_lanes(lanes);
}

/// The points that tell the scales of a point set. Of points at one place one counts, and of those
/// that all but coincide a few, however many there are: they tell nothing of a plane, and balls
/// would shrink to a few places.
class Points_of_scales
{
  Buffer<Vector> m_points;
  std::optional<Search_grid_3> m_grid;

public:
  /// \param initial_radius a length; the largest ball is 8 times as large
  template <typename ConcurrencyTag>
  Points_of_scales(ConcurrencyTag tag, const Buffer<Vector>& points, double initial_radius)
    : m_points(copy_of(points))
  {
    const double cell_size = cell_size_of_scales;
    Working_frame::divide<ConcurrencyTag>(initial_radius, m_points);
    apply_order<ConcurrencyTag>(Search_grid_3::sorted_order<ConcurrencyTag>(m_points, cell_size),
                                m_points);
    m_grid.emplace(tag, m_points, cell_size);
    thin_crowds<ConcurrencyTag>(*m_grid, m_points, maximum_number_of_points_of_subcell)
      .keep(m_points);
    m_points.resize(std::size_t(std::unique(m_points.begin(), m_points.end()) - m_points.begin()));
    if (m_points.size() < m_grid->number_of_points())
      m_grid.emplace(tag, m_points, cell_size);
  }

  /// In units of the initial radius, sorted for the grid, all different.
  const Buffer<Vector>& points() const { return m_points; }
  const Search_grid_3& grid() const { return *m_grid; }

  /// \param queries some of the points, in their order
  /// \param reach of the balls, in cells
  template <typename ConcurrencyTag, typename T>
  std::vector<Ball_of_points> balls_around(const Buffer<Vector>& queries, int reach,
                                           Progress& progress) const
  {
    const Search_grid_3 query_grid(queries, m_grid->cell_size());
    const double radius = reach * m_grid->cell_size();
    std::vector<Ball_of_points> balls(queries.size());
    for_each_cell<T, ConcurrencyTag>(
      query_grid, queries, *m_grid, m_points, reach, progress, [&]() {
        return [&](Search_grid_3::Range range, Local_points<T>& candidates, const Vector& origin) {
          for (Index i = range.first; i < range.second; ++i)
          {
            const Eigen::Matrix<T, 3, 1> center = (queries[i] - origin).template cast<T>();
            const Plane_of_ball fit = fit_plane<T>(center, candidates, T(radius * radius));
            balls[i] = ball_of_points(
              double(fit.number_of_points), double(candidates.stride), fit.variance,
              moments_over_plane(center, fit.normal_as<T>(), candidates, T(radius * radius)));
          }
        };
      });
    return balls;
  }
};

/// Around one of how many points of `Points_of_scales` balls are looked at.
inline std::uint64_t stride_of_balls(std::uint64_t number_of_points)
{
  return (std::max)(number_of_points / number_of_balls, std::uint64_t(1));
}

/// The scales of a point set, by `scales_of_growing_balls()`.
/// \param initial_radius a length. The paper's r_p is a good one
/// \returns spacing and noise in units of `initial_radius`
template <typename ConcurrencyTag, typename T>
Scales estimate_scales(const Buffer<Vector>& unsorted_points, double initial_radius,
                       Progress& progress)
{
  const Points_of_scales points(ConcurrencyTag(), unsorted_points, initial_radius);
  const std::size_t size = points.points().size(), stride = std::size_t(stride_of_balls(size));
  return scales_of_growing_balls(cell_size_of_scales, [&](int reach, double) {
    Buffer<Vector> queries(unsorted_points.get_allocator());
    for (std::size_t i = 0; i < size; i += stride * stride_at_reach(reach))
      queries.push_back(points.points()[i]);
    return points.balls_around<ConcurrencyTag, T>(queries, reach, progress);
  });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H
