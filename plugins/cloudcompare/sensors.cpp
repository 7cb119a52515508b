// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sensors.h"

#include <ccHObjectCaster.h>
#include <ccPointCloud.h>
#include <ccSensor.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace l0_cloudcompare {
namespace {

std::vector<ccSensor*> sensors_of(const ccPointCloud& cloud)
{
  std::vector<ccSensor*> sensors;
  for (unsigned i = 0; i < cloud.getChildrenNumber(); ++i)
    if (ccSensor* sensor = ccHObjectCaster::ToSensor(cloud.getChild(i)))
      sensors.push_back(sensor);
  return sensors;
}

} // namespace

std::size_t number_of_sensors(const ccPointCloud& cloud)
{
  return cloud.gridCount() > 0 ? cloud.gridCount() : sensors_of(cloud).size();
}

std::vector<Place> viewpoints_of_grids(const ccPointCloud& cloud)
{
  if (cloud.gridCount() == 0)
    return {};
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<Place> viewpoints(cloud.size(), Place{unknown, unknown, unknown});
  for (std::size_t g = 0; g < cloud.gridCount(); ++g)
  {
    const auto& grid = *cloud.grid(g);
    const auto place = grid.sensorPosition.getTranslationAsVec3D();
    for (const int index : grid.indexes)
      if (index >= 0 && unsigned(index) < cloud.size())
        viewpoints[std::size_t(index)] = {place.x, place.y, place.z};
  }
  return viewpoints;
}

Place position_of_sensor(const ccPointCloud& cloud)
{
  const std::vector<ccSensor*> sensors = sensors_of(cloud);
  if (sensors.empty())
    throw std::invalid_argument("the cloud has no sensor and no scan grid");
  if (sensors.size() > 1)
    throw std::invalid_argument("the cloud has " + std::to_string(sensors.size())
                                + " sensors, and does not say which point is of which");
  CCVector3 center;
  if (!sensors.front()->getActiveAbsoluteCenter(center))
    throw std::invalid_argument("the sensor of the cloud has no position");
  return {center.x, center.y, center.z};
}

} // namespace l0_cloudcompare
