// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_CLOUDCOMPARE_SENSORS_H
#define L0_CLOUDCOMPARE_SENSORS_H

#include <array>
#include <cstddef>
#include <vector>

class ccPointCloud;

namespace l0_cloudcompare {

/// A place in the local coordinates of a cloud.
using Place = std::array<double, 3>;

/// How many places are known that points of the cloud were seen from: scan grids, or else sensors.
std::size_t number_of_sensors(const ccPointCloud& cloud);

/// Where each point was seen from, by the scan grids that it is in: not finite if it is in none.
/// Empty for a cloud without grids.
std::vector<Place> viewpoints_of_grids(const ccPointCloud& cloud);

/// The position of the only sensor of a cloud.
/// \throws std::invalid_argument if there is none, or if there are several
Place position_of_sensor(const ccPointCloud& cloud);

} // namespace l0_cloudcompare

#endif // L0_CLOUDCOMPARE_SENSORS_H
