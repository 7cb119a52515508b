// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_CLOUDCOMPARE_RESAMPLE_POINTS_H
#define L0_CLOUDCOMPARE_RESAMPLE_POINTS_H

#include "Resample_options.h"

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/Simple_cartesian.h>

#include <functional>
#include <utility>
#include <vector>

class ccPointCloud;

namespace l0_cloudcompare {

using Kernel = CGAL::Simple_cartesian<double>;

/// The result of a call of the library, in the local coordinates of the cloud.
struct Resampled_points
{
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> points; ///< with normals
  std::vector<unsigned> sources; ///< of each point, the nearest one of the cloud
  CGAL::L0_resampling::Report report;
};

/// Resamples a cloud, which is only read; may run beside the thread of the windows.
/// \param callback gets the progress in [0, 1] and cancels by returning `false`
/// \throws std::invalid_argument if the cloud is empty or lacks what `options.sides` asks for
/// \throws what `CGAL::l0_resample_point_set()` throws
Resampled_points resample_points(const ccPointCloud& cloud, const Resample_options& options,
                                 const std::function<bool(double)>& callback);

} // namespace l0_cloudcompare

#endif // L0_CLOUDCOMPARE_RESAMPLE_POINTS_H
