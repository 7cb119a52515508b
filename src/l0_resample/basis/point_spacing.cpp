// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/point_spacing.h"

#include "basis/Sample_of_surface.h"

#include <algorithm>

namespace l0_tool {

double point_spacing(const std::vector<Point>& points)
{
  return point_spacing(points.size(), [&](std::size_t i) -> const Point& { return points[i]; });
}

double point_spacing(std::size_t size, const std::function<const Point&(std::size_t)>& point)
{
  constexpr std::size_t queries = 2000, neighbors = 6;
  if (size < 2)
    return 0;
  const Sample_of_surface sample(size, point);
  const std::size_t step = (sample.points().size() + queries - 1) / queries;
  std::vector<double> spacings;
  for (std::size_t i = 0; i < sample.points().size(); i += step)
    spacings.push_back(sample.spacing(sample.nearest(sample.points()[i], neighbors + 1)));
  return median(std::move(spacings));
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace l0_tool
