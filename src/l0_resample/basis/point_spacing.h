// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_POINT_SPACING_H
#define L0_RESAMPLE_POINT_SPACING_H

#include "basis/Point_cloud.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace l0_tool {

/// Median over the points of the mean distance to their six nearest, a length; 0 for fewer than two
/// distinct points. Estimated from a part of a large cloud, as for a surface: half as many points
/// lie sqrt(2) as far apart.
double point_spacing(const std::vector<Point>& points);

/// Of `size` points.
double point_spacing(std::size_t size, const std::function<const Point&(std::size_t)>& point);

/// \param values at least one
double median(std::vector<double> values);

} // namespace l0_tool

#endif // L0_RESAMPLE_POINT_SPACING_H
