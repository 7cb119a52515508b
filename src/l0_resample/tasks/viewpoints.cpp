// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/viewpoints.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "basis/signals.h"
#include "files/Input_file.h"

#include <CGAL/L0_resampling/internal/search/nearest_input_points.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

namespace l0_tool {

std::vector<Point> read_viewpoints(const std::string& path)
{
  Input_file file(path);
  std::vector<Point> viewpoints;
  while (const std::optional<std::string_view> line = file.read_line()) {
    if (is_empty_or_comment(*line))
      continue;
    const auto [x, y, z] = parse_coordinates(
      *line, Separator::BLANKS, [&](const std::string& reason) { file.refuse(reason); });
    viewpoints.emplace_back(x, y, z);
  }
  return viewpoints;
}

std::vector<Point> viewpoints_of_points(const Point_cloud& cloud, const std::string& property,
                                        const std::vector<Point>& viewpoints,
                                        const std::string& name)
{
  const std::vector<Property>& properties = cloud.properties.properties();
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const Property& p) { return p.name == property; });
  if (found == properties.end())
    throw Failure(INPUT_REFUSED, name
                                   + ": --view-property is given, but the points have no property "
                                   + printable(property));
  std::vector<Point> result;
  result.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const double view = cloud.properties.value(i, *found);
    // before the conversion, which is undefined for other numbers
    if (!(view >= 0 && view < double(viewpoints.size())) || double(std::size_t(view)) != view) {
      std::ostringstream message;
      message << name << ": the property " << printable(property) << " of point " << i << " is "
              << view << ", but --viewpoints has " << viewpoints.size() << ", counted from 0";
      throw Failure(INPUT_REFUSED, message.str());
    }
    result.push_back(viewpoints[std::size_t(view)]);
  }
  return result;
}

std::vector<Point> nearest_viewpoints(const Point_cloud& cloud,
                                      const std::vector<Point>& viewpoints, const std::string& path)
{
  namespace internal = CGAL::L0_resampling::internal;
  using CGAL::L0_resampling::Index;
  using Tag = CGAL::Parallel_if_available_tag;
  if (viewpoints.empty())
    throw Failure(INPUT_REFUSED, path + ": the file has no viewpoint");
  internal::Buffer<internal::Vector> places;
  internal::Buffer<Index> ranks;
  for (const Point& viewpoint : viewpoints) {
    ranks.push_back(Index(places.size()));
    places.push_back(internal::Vector(viewpoint.x(), viewpoint.y(), viewpoint.z()));
  }
  internal::Buffer<std::array<double, 3>> positions;
  positions.reserve(cloud.points.size());
  for (const Point& point : cloud.points)
    positions.push_back({point.x(), point.y(), point.z()});

  internal::Near_points near;
  near.count = 1;
  CGAL::L0_resampling::Report unwanted_report;
  internal::Memory_counter memory;
  internal::Progress progress([](double) { return !is_interrupted(); }, unwanted_report, memory);
  try {
    const internal::Point_tree_3 tree(Tag(), std::move(places), std::move(ranks));
    internal::nearest_input_points<Tag>(tree, positions, progress, near);
  } catch (const internal::Interrupted&) {
    throw_if_interrupted();
  }
  std::vector<Point> result;
  result.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    result.push_back(viewpoints[near.nearest(i)]);
  return result;
}

} // namespace l0_tool
