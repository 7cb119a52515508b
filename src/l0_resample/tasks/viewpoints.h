// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_VIEWPOINTS_H
#define L0_RESAMPLE_VIEWPOINTS_H

#include "basis/Point_cloud.h"

#include <string>
#include <vector>

namespace l0_tool {

/// Reads viewpoints as `read_points()` reads points: from the format that the extension says, or
/// else from a text, whose columns need no names.
/// \param warnings gets what there is to say of the file
/// \throws Failure with INPUT_REFUSED where it is something else, or one of them is not finite
std::vector<Point> read_viewpoints(const std::string& path, bool has_decimal_commas,
                                   std::vector<std::string>& warnings);

/// The viewpoint of each point.
/// \param property of the points that says which viewpoint it is, counted from 0
/// \param name of the input, for messages
/// \throws Failure with INPUT_REFUSED if there is no such property, or no such viewpoint
std::vector<Point> viewpoints_of_points(const Point_cloud& cloud, const std::string& property,
                                        const std::vector<Point>& viewpoints,
                                        const std::string& name);

/*!
The viewpoint that sees each point best: of those from which no other surface hides it, the one that
has the largest solid angle of what is around the point, as most rays of a scanner there hit it. If
all are hidden, all count. Points take what most of those around them have.
\param noise standard deviation of the points, a length
\param path of the file with the viewpoints, for messages
\throws Failure with INPUT_REFUSED if there is none, and with the status of an interrupt
*/
std::vector<Point> best_viewpoints(const Point_cloud& cloud, const std::vector<Point>& viewpoints,
                                   double noise, const std::string& path);

} // namespace l0_tool

#endif // L0_RESAMPLE_VIEWPOINTS_H
