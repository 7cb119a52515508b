// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIND_CORNERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIND_CORNERS_H

#include <CGAL/L0_resampling/internal/creases/Nearby_points.h>
#include <CGAL/L0_resampling/internal/creases/crease_points.h>

#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Where corner points agree: the modes of their density that have weight enough, no two within
/// 2.5 spacings.
inline std::vector<Corner_of_creases> find_corners(const std::vector<Corner_point>& points)
{
  const double reach_of_shift = 1.5, variance_of_shift = 0.3, radius = 0.8, apart = 2.5,
               minimum_weight = 4;
  const int number_of_shifts = 4;
  std::vector<Vector> positions;
  for (const Corner_point& point : points)
    positions.push_back(point.position);
  const Nearby_points nearby(positions, reach_of_shift);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    double weight = 0;
    nearby.for_each_near(positions[i], radius, [&](std::size_t k) { weight += points[k].weight; });
    order.push_back({-weight, i});
  }
  std::sort(order.begin(), order.end());

  std::vector<char> is_left(points.size(), 1);
  std::vector<Corner_of_creases> corners;
  for (const auto& [negative_weight, i] : order)
  {
    if (!is_left[i])
      continue;
    Vector corner = positions[i];
    for (int shift = 0; shift < number_of_shifts; ++shift)
    {
      Vector sum = Vector::Zero();
      double sum_of_weights = 0;
      nearby.for_each_near(corner, reach_of_shift, [&](std::size_t k) {
        const double weight =
          points[k].weight * std::exp(-(positions[k] - corner).squaredNorm() / variance_of_shift);
        sum += weight * positions[k];
        sum_of_weights += weight;
      });
      if (sum_of_weights > 0)
        corner = sum / sum_of_weights;
    }
    double weight = 0;
    nearby.for_each_near(corner, radius,
                         [&](std::size_t k) { weight += is_left[k] ? points[k].votes : 0; });
    nearby.for_each_near(corner, apart, [&](std::size_t k) { is_left[k] = 0; });
    if (weight >= minimum_weight)
      corners.push_back({corner, 0});
  }
  return corners;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIND_CORNERS_H
