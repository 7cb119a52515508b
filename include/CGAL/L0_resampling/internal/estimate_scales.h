// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H

#include <CGAL/L0_resampling/internal/Height_moments.h>
#include <CGAL/L0_resampling/internal/deviation_in_ball.h>
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
  double spacing; ///< square root of the area a place
  double noise;   ///< standard deviation across the surface
};

/// Of the candidates in the ball around `center`, over the plane through it.
template <typename T>
Height_moments<double> moments_over_plane(const Eigen::Matrix<T, 3, 1>& center, const Eigen::Matrix<T, 3, 1>& normal,
                                          const Local_points<T>& candidates, T squared_radius)
{
  using L = Lanes<T>;
  Height_moments<L> lanes;
  candidates.for_each_run_in_ball(center, squared_radius, [&](std::size_t k, const L& squared_distance) {
    const L height = (L::load(&candidates.x[k]) - center[0]) * normal[0]
                     + (L::load(&candidates.y[k]) - center[1]) * normal[1]
                     + (L::load(&candidates.z[k]) - center[2]) * normal[2];
    lanes.add(height, where_less(squared_distance, squared_radius, L(T(1))));
  });
  return sum_of_lanes(lanes);
}

/*!
Estimates the scales from plane fits around a thousand points, in balls that grow until their points lie in a plane rather than fill the ball: until
the standard deviation across it is surely below what it is in a filled ball. That deviation tells the noise, see `sheet_of_deviations()`, and the
number of points gives the spacing. Of the deviations of all balls the third tenth counts: edges, curvature, thin parts and outliers only ever raise them, and the more the larger the balls
are; so the balls should not grow for longer than they have to.

Of points at one place one counts, however many there are: they tell nothing of a plane, and balls would shrink to a few places.

Balls that hold two sheets, as those of a thin plate do, would grow for ever and find its thickness. They are known by `single_sheet_index()`; then the noise
and the number of points are those of one sheet.

\param initial_radius where the largest ball is 8 times as large; the paper's r_p is a good one
*/
template <typename ConcurrencyTag, typename T>
Scales estimate_scales(const Buffer<Vector>& unsorted_points, double initial_radius, Progress& progress)
{
  const std::size_t number_of_queries = 1000, fewest_points = 30;
  const double flat = 0.25, surely_flat = 0.15;

  const double cell_size = initial_radius / 4;
  Buffer<Vector> points = copy_of(unsorted_points);
  apply_order(Search_grid_3::sorted_order<ConcurrencyTag>(points, cell_size), points);
  points.resize(std::size_t(std::unique(points.begin(), points.end()) - points.begin()));
  const Search_grid_3 grid(points, cell_size);
  Buffer<Vector> queries(points.get_allocator());
  const std::size_t stride = (std::max)(points.size() / number_of_queries, std::size_t(1));
  for (std::size_t i = 0; i < points.size(); i += stride)
    queries.push_back(points[i]);
  const Search_grid_3 query_grid(queries, cell_size);

  const auto quantile = [](std::vector<double> values, double share) {
    const auto place = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  Scales scales{cell_size, 0};
  std::vector<double> variances(queries.size()), counts(queries.size()), indices(queries.size());
  std::vector<Shape_of_heights> shapes(queries.size());
  for (const int reach : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32})
  {
    const double radius = reach * cell_size;
    for_each_cell<T, ConcurrencyTag>(query_grid, queries, grid, points, reach, progress, [&]() {
      return [&](Search_grid_3::Range range, const Local_points<T>& candidates, const Vector& origin) {
        for (Index i = range.first; i < range.second; ++i)
        {
          const Eigen::Matrix<T, 3, 1> center = (queries[i] - origin).template cast<T>();
          const Plane_fit<T> fit = fit_plane<T>(center, candidates, T(radius * radius));
          const double n = double(fit.number_of_points);
          counts[i] = n * double(candidates.stride);
          variances[i] = n > 3 ? fit.variance * n / (n - 3) : fit.variance; // the plane took three degrees of freedom
          shapes[i] = moments_over_plane(center, fit.normal, candidates, T(radius * radius)).shape(n);
          indices[i] = shapes[i].single_sheet_index();
        }
      };
    });
    if (quantile(counts, 0.5) < double(fewest_points) && reach < 32)
      continue;
    const auto set_scales = [&]() {
      scales = {double(radius * std::sqrt(EIGEN_PI / (std::max)(quantile(counts, 0.5), 1.))),
                std::sqrt(quantile(variances, 0.3))};
    };
    set_scales();
    const double index = quantile(indices, 0.5);
    if (scales.noise > surely_flat * radius && index < largest_index_of_two_sheets)
    {
      for (std::size_t i = 0; i < queries.size(); ++i)
      {
        const Two_sheets sheets = two_sheets_of(shapes[i]);
        variances[i] *= sheets.noise;
        counts[i] *= sheets.larger_sheet;
      }
      set_scales();
      break;
    }
    if (scales.noise < largest_deviation_of_sheet(quantile(counts, 0.5)) * radius
        && (scales.noise < flat * radius || index > least_index_of_one_sheet))
    {
      const Sheet_in_ball sheet = sheet_of_deviations(scales.noise / radius);
      scales = {scales.spacing * std::sqrt(sheet.share_of_points), sheet.noise * radius};
      break;
    }
  }
  return scales;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALES_H
