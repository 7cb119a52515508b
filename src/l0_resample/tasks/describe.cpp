// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/tasks.h"

#include "basis/messages.h"
#include "basis/parse_numbers.h"
#include "tasks/resample.h"

#include <CGAL/Bbox_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

namespace l0_tool {
namespace {

std::string in_digits(long double number)
{
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6Lg", number);
  return digits;
}

std::string in_digits(double x, double y, double z)
{
  return in_digits(x) + "," + in_digits(y) + "," + in_digits(z);
}

std::string line(std::string name, const std::string& text)
{
  constexpr std::size_t column = 17;
  name += ":";
  name.resize(column, ' ');
  return name + text + "\n";
}

CGAL::Bbox_3 box_of(const std::vector<Point>& points)
{
  CGAL::Bbox_3 box;
  for (const Point& point : points)
    box += point.bbox();
  return box;
}

/// Finite, also where `double` does not hold it.
long double diagonal_of(const CGAL::Bbox_3& box)
{
  using Long = long double;
  return std::hypot(Long(box.xmax()) - box.xmin(), Long(box.ymax()) - box.ymin(),
                    Long(box.zmax()) - box.zmin());
}

std::string extent_of(const CGAL::Bbox_3& box)
{
  return "from " + in_digits(box.xmin(), box.ymin(), box.zmin()) + " to "
         + in_digits(box.xmax(), box.ymax(), box.zmax()) + ", diagonal "
         + in_digits(diagonal_of(box));
}

std::string names_of(const Property_table& table)
{
  std::string names;
  for (const Property& property : table.properties())
    names += (names.empty() ? "" : ", ") + on_one_line(property.name);
  return names.empty() ? "none" : names;
}

std::string las_version(const Las_origin& las)
{
  return "1." + std::to_string(las.minor_version) + ", point format "
         + std::to_string(las.point_format) + ", scale "
         + in_digits(las.scale[0], las.scale[1], las.scale[2]) + ", "
         + (las.coordinate_system.empty() ? "no" : "with a") + " coordinate system";
}

} // namespace

std::string describe(const Point_cloud& cloud, const Options& options)
{
  const std::size_t size = cloud.points.size();
  std::string text = line("file", on_one_line(options.input_name()) + ", "
                                    + extension_of(options.input_format).substr(1));
  text += line("points", std::to_string(size)
                           + (cloud.number_of_dropped_points == 0
                                ? ""
                                : ", and " + std::to_string(cloud.number_of_dropped_points)
                                    + " that are not finite"));
  const CGAL::Bbox_3 box = box_of(cloud.points);
  if (size > 0)
    text += line("extent", extent_of(box));
  text += line("normals", cloud.file_has_normals ? "yes" : "no");
  if (cloud.las)
    text += line("LAS", las_version(*cloud.las));
  if (!cloud.degrees.empty())
    text += line("degrees", "x and y are longitude and latitude, as " + cloud.degrees);
  text += line("properties", names_of(cloud.properties));
  text += line("viewpoint",
               cloud.viewpoint
                 ? in_digits((*cloud.viewpoint)[0], (*cloud.viewpoint)[1], (*cloud.viewpoint)[2])
                 : "not told");
  if (size == 0)
    return text;
  if (diagonal_of(box) == 0)
    return text + line("spacing", "all points are at one place");

  Options by_default = options;
  by_default.method = CGAL::L0_resampling::Method::DEFAULT;
  by_default.neighbor_radius.reset();
  const CGAL::L0_resampling::Report scales = estimate_scales(cloud, by_default);
  text += line("spacing", in_digits(scales.estimated_spacing));
  text += line("noise", in_digits(scales.estimated_noise));
  text += line("method", name_of(options.method));
  const bool is_default = options.method == by_default.method && !options.neighbor_radius;
  const CGAL::L0_resampling::Report radii = is_default ? scales : estimate_scales(cloud, options);
  text += line("neighbor radius",
               in_digits(radii.neighbor_radius)
                 + (radii.least_neighbor_radius < radii.largest_neighbor_radius
                      ? ", from " + in_digits(radii.least_neighbor_radius) + " to "
                          + in_digits(radii.largest_neighbor_radius) + " around points"
                      : ""));
  return text + line("points to write", std::to_string(number_of_output_points(options, size)));
}

} // namespace l0_tool
