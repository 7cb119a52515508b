// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H

#include <CGAL/L0_resampling/internal/estimate_plane.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// How far apart the points lie within the surface, and how far off it. Lengths.
struct Scales
{
  double spacing;   ///< square root of the area a point
  double noise;     ///< standard deviation across the surface
};

/*!
Estimates the scales from plane fits around a thousand points, in balls that grow until the points of the median ball lie in a plane
rather than fill the ball: until their standard deviation across it is below a quarter of the radius, half of what a filled ball has. That
deviation is the noise, and the number of points gives the spacing.

\param initial_radius where the largest ball is 8 times as large; the paper's r_p is a good one
*/
template <typename ConcurrencyTag, typename T>
Scales estimate_scales(const Buffer<Vector>& unsorted_points, double initial_radius, Progress& progress)
{
  const std::size_t number_of_queries = 1000, fewest_points = 15;
  const double flat = 0.25;

  const double cell_size = initial_radius / 4;
  Buffer<Vector> points(unsorted_points);
  apply_order(Search_grid_3::sorted_order<ConcurrencyTag>(points, cell_size), points);
  const Search_grid_3 grid(points, cell_size);
  Buffer<Vector> queries(points.get_allocator());
  const std::size_t stride = (std::max)(points.size() / number_of_queries, std::size_t(1));
  for (std::size_t i = 0; i < points.size(); i += stride)
    queries.push_back(points[i]);
  const Search_grid_3 query_grid(queries, cell_size);

  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  Scales scales{cell_size, 0};
  std::vector<double> variances(queries.size()), counts(queries.size());
  for (const int reach : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32})
  {
    const double radius = reach * cell_size;
    for_each_cell<T, ConcurrencyTag>(query_grid, queries, grid, points, reach, progress, [&]() {
      return [&](Search_grid_3::Range range, const Local_points<T>& candidates, const Vector& origin) {
        for (Index i = range.first; i < range.second; ++i)
        {
          const Plane_fit<T> fit = fit_plane<T>((queries[i] - origin).template cast<T>(), candidates, T(radius * radius));
          variances[i] = fit.variance;
          counts[i] = double(fit.number_of_points) * double(candidates.stride);
        }
      };
    });
    const double count = median(counts);
    if (count < double(fewest_points) && reach < 32)
      continue;
    scales.spacing = radius * std::sqrt(EIGEN_PI / (std::max)(count, 1.));
    scales.noise = std::sqrt(median(variances));
    if (scales.noise < flat * radius)
      break;
  }
  return scales;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H
