// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SEE_CREASES_H
#define CGAL_L0_RESAMPLING_INTERNAL_SEE_CREASES_H

#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/creases/crease_points.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <cmath>
#include <cstddef>
#include <mutex>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A crease or corner point relative to the sample that sees it, so that it depends on nothing
/// but the samples around this one.
template <typename Point>
struct Seen_from_sample
{
  Vector sample;
  Point point;
};

/// Creases and corners as samples see them, those of a sample one after the other.
struct Seen_creases
{
  std::vector<Seen_from_sample<Crease_point>> points;
  std::vector<Seen_from_sample<Corner_point>> corners;
};

/// Calls `f(k)` for each candidate nearer than `radius`, and for some just beyond, which roundings
/// may have put there.
template <typename F>
void for_each_near(Local_points<Local>& candidates, const Local_vector& center, double radius,
                   const F& f)
{
  const double safe = 1.001;
  const Local squared_radius = Local(radius * radius * safe);
  candidates.for_each_run_in_ball(
    center, squared_radius, [&](std::size_t first, const Lanes<Local>& distances) {
      Local squared_distances[Lanes<Local>::size];
      distances.store(squared_distances);
      for (std::size_t lane = 0; lane < std::size_t(Lanes<Local>::size); ++lane)
        if (squared_distances[lane] < squared_radius)
          f(candidates.indices[first + lane]);
    });
}

/// Whether each sample has one of another face within `reach_of_crease`.
template <typename ConcurrencyTag, typename FT>
Buffer<unsigned char> are_beside_creases(const Buffer<Vector>& positions,
                                         const Buffer<Eigen::Matrix<FT, 3, 1>>& normals,
                                         double spacing, Progress& progress)
{
  const double reach = reach_of_crease * spacing;
  const Sorted_queries sorted(ConcurrencyTag(), positions, Cell_sizes(reach));
  const Buffer<Eigen::Matrix<FT, 3, 1>> sorted_normals =
    values_in_order<ConcurrencyTag>(sorted.order, normals);
  const double cosine_of_other = std::cos(minimum_crease_angle);

  Buffer<unsigned char> are_beside = filled_buffer(positions.size(), static_cast<unsigned char>(0),
                                                   positions.get_allocator());
  for_each_cell<Local, ConcurrencyTag>(
    sorted.grid, sorted.points, sorted.grid, sorted.points, 1, progress, [&]() {
      return
        [&](Search_grid_3::Range queries, Local_points<Local>& candidates, const Vector& origin) {
          for (Index q = queries.first; q < queries.second; ++q)
          {
            const Vector& place = sorted.points[q];
            bool is_beside = false;
            for_each_near(candidates, (place - origin).template cast<Local>(), reach, [&](Index k) {
              is_beside = is_beside
                          || (double(sorted_normals[k].dot(sorted_normals[q])) < cosine_of_other
                              && (sorted.points[k] - place).squaredNorm() < square(reach));
            });
            are_beside[sorted.order[q]] = is_beside;
          }
        };
    });
  return are_beside;
}

/*!
Finds what the first so many samples see, each from those around it in the order of cells that do
not depend on others. So a part of a cloud sees what all of it does, to the bit.

\param number_of_own the samples that look; the others are only looked at
\param seen out: appended
*/
template <typename ConcurrencyTag, typename FT>
void see_creases(const Buffer<Vector>& positions, const Buffer<Eigen::Matrix<FT, 3, 1>>& normals,
                 std::size_t number_of_own, double spacing, Progress& progress, Seen_creases& seen)
{
  const double reach = reach_of_crease_point * spacing;
  const Sorted_queries sorted(ConcurrencyTag(), positions, Cell_sizes(reach));
  const Buffer<Eigen::Matrix<FT, 3, 1>> sorted_normals =
    values_in_order<ConcurrencyTag>(sorted.order, normals);
  const Buffer<unsigned char> are_beside = are_beside_creases<ConcurrencyTag>(positions, normals,
                                                                              spacing, progress);
  Buffer<Index> looking(positions.get_allocator());
  for (Index i : sorted.order)
    if (i < number_of_own && are_beside[i])
      looking.push_back(i);
  const Sorted_queries queries(ConcurrencyTag(), positions, Cell_sizes(reach), std::move(looking));

  std::mutex mutex;
  const auto make_visitor = [&]() {
    return
      [&, around = std::vector<Oriented_sample>(), creases = Creases_of_sample()](
        Search_grid_3::Range range, Local_points<Local>& candidates, const Vector& origin) mutable {
        for (Index q = range.first; q < range.second; ++q)
        {
          const Vector& place = queries.points[q];
          around.clear();
          for_each_near(candidates, (place - origin).template cast<Local>(), reach, [&](Index k) {
            const Vector way = (sorted.points[k] - place) / spacing;
            if (way.squaredNorm() < square(reach_of_crease_point))
              around.push_back({way, sorted_normals[k].template cast<double>()});
          });
          const Vector normal = normals[queries.order[q]].template cast<double>();
          creases.find({Vector::Zero(), normal}, around);

          const std::lock_guard<std::mutex> lock(mutex);
          for (const Crease_point& point : creases.points())
            seen.points.push_back({place, point});
          for (const Corner_point& corner : creases.corners())
            seen.corners.push_back({place, corner});
        }
      };
  };
  for_each_cell<Local, ConcurrencyTag>(queries.grid, queries.points, sorted.grid, sorted.points, 1,
                                       progress, make_visitor);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SEE_CREASES_H
