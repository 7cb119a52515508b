// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "resample_points.h"

// Before the headers of Qt, whose macro emit() hides a function of TBB
#include <CGAL/l0_resample_point_set.h>

#include <boost/range/irange.hpp>

#include "sensors.h"

#include <ccPointCloud.h>

#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace l0_cloudcompare {
namespace {

using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

Point point_at(const Place& place) { return Point(place[0], place[1], place[2]); }

/// The positions of a cloud, by index.
struct Cloud_point_map
{
  using key_type = unsigned;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;

  const ccPointCloud* cloud;

  friend Point get(const Cloud_point_map& map, unsigned i)
  {
    const auto& p = *map.cloud->getPoint(i);
    return Point(p.x, p.y, p.z);
  }
};

/// The normals of a cloud, by index.
struct Cloud_normal_map
{
  using key_type = unsigned;
  using value_type = Vector;
  using reference = Vector;
  using category = boost::readable_property_map_tag;

  const ccPointCloud* cloud;

  friend Vector get(const Cloud_normal_map& map, unsigned i)
  {
    const auto& n = map.cloud->getPointNormal(i);
    return Vector(n.x, n.y, n.z);
  }
};

/// Viewpoints of points, by index.
struct Viewpoint_map
{
  using key_type = unsigned;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;

  const Place* viewpoints;

  friend Point get(const Viewpoint_map& map, unsigned i) { return point_at(map.viewpoints[i]); }
};

/// Keeps, for each point of the result, the index of the nearest point of the cloud. The number of
/// points is known once they are written.
struct Source_map
{
  using key_type = std::size_t;
  using value_type = unsigned;
  using reference = unsigned;
  using category = boost::writable_property_map_tag;

  std::vector<unsigned>* sources;

  friend void put(const Source_map& map, std::size_t key, unsigned source)
  {
    if (key >= map.sources->size())
      map.sources->resize(key + 1);
    (*map.sources)[key] = source;
  }
};

} // namespace

Resampled_points resample_points(const ccPointCloud& cloud, const Resample_options& options,
                                 const std::function<bool(double)>& callback)
{
  if (cloud.size() == 0)
    throw std::invalid_argument("the cloud has no points");
  std::optional<Point> viewpoint;
  std::vector<Place> viewpoints;
  std::optional<Vector> up;
  std::optional<Cloud_normal_map> hints;
  switch (options.sides)
  {
  case Sides::OUTWARDS: break;
  case Sides::SENSOR:
    viewpoints = viewpoints_of_grids(cloud);
    if (viewpoints.empty())
      viewpoint = point_at(position_of_sensor(cloud));
    break;
  case Sides::VIEWPOINT: {
    const auto& [x, y, z] = options.viewpoint;
    const CCVector3d local = cloud.toLocal3d(CCVector3d(x, y, z));
    viewpoint.emplace(local.x, local.y, local.z);
    break;
  }
  case Sides::UP: up.emplace(options.up[0], options.up[1], options.up[2]); break;
  case Sides::NORMALS:
    if (!cloud.hasNormals())
      throw std::invalid_argument("the cloud has no normals");
    hints = Cloud_normal_map{&cloud};
  }

  Resampled_points result;
  const auto np = CGAL::parameters::resampling_method(options.method)
                    .number_of_output_points(options.number_of_points)
                    .select_percentage(options.percentage)
                    .neighbor_radius(options.neighbor_radius)
                    .keep_density(options.keep_density)
                    .drop_outliers(options.method == CGAL::L0_resampling::Method::DEFAULT
                                   && !options.keep_outliers)
                    .viewpoint(viewpoint)
                    .viewpoint_map(viewpoints.empty()
                                     ? std::nullopt
                                     : std::make_optional(Viewpoint_map{viewpoints.data()}))
                    .up_direction(up)
                    .orientation_hint_map(hints)
                    .source_index_map(Source_map{&result.sources})
                    .callback(callback)
                    .resampling_report(&result.report)
                    .point_map(Cloud_point_map{&cloud});
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    boost::irange(0u, unsigned(cloud.size())), std::back_inserter(result.points), np);
  return result;
}

} // namespace l0_cloudcompare
