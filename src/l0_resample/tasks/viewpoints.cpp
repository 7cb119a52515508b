// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/viewpoints.h"

#include "basis/Failure.h"
#include "basis/Sample_of_surface.h"
#include "basis/parse_numbers.h"
#include "basis/signals.h"
#include "files/file_formats.h"
#include "formats/read_points.h"
#include "pictures/surroundings_of_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <utility>

namespace l0_tool {
namespace {

/*!
How far away the nearest surface is in each direction from a place, on the faces of a cube around
it. Each point stands for a square of its spacing to all sides, so that what is behind a surface
does not show between its points.
*/
class Depth_map
{
  static constexpr int size = 256; // of a face, so that pixels have a third of a degree
  Point m_place;
  std::vector<float> m_distances;

  /// Where a vector goes through the face that is across an axis, in pixels.
  struct Place_on_face
  {
    std::size_t first_pixel; // of the face
    double depth, column, row;

    Place_on_face(const Vector& v, int axis)
      : first_pixel(std::size_t(size) * size * (2 * axis + (v[axis] < 0))),
        depth(std::abs(v[axis])), column((v[(axis + 1) % 3] / depth + 1) * size / 2),
        row((v[(axis + 2) % 3] / depth + 1) * size / 2)
    {}
  };

public:
  static constexpr double pixel_angle = 2. / size; ///< at most

  explicit Depth_map(const Point& place)
    : m_place(place),
      m_distances(std::size_t(6) * size * size, std::numeric_limits<float>::infinity())
  {}

  const Point& place() const { return m_place; }

  void add(const Point& point, double spacing)
  {
    const Vector v = point - m_place;
    const double distance = std::sqrt(v.squared_length());
    if (!std::isfinite(distance))
      return;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(v[axis]) > spacing))
        continue; // it would cover all of the face, at its border
      const Place_on_face at(v, axis);
      const double reach = spacing / at.depth * size / 2;
      if (at.column + reach < 0 || at.column - reach >= size || at.row + reach < 0
          || at.row - reach >= size)
        continue;
      const auto first = [&](double x) { return int((std::max)(0., x - reach)); };
      const auto last = [&](double x) { return int((std::min)(size - 1., x + reach)); };
      for (int row = first(at.row); row <= last(at.row); ++row)
        for (int column = first(at.column); column <= last(at.column); ++column) {
          float& nearest = m_distances[at.first_pixel + std::size_t(row) * size + column];
          nearest = (std::min)(nearest, float(distance));
        }
    }
  }

  /// In the direction of a vector.
  double nearest_distance(const Vector& v) const
  {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(v[k]) > std::abs(v[axis]))
        axis = k;
    const Place_on_face at(v, axis);
    if (!std::isfinite(at.column) || !std::isfinite(at.row))
      return std::numeric_limits<double>::infinity();
    const auto pixel = [](double x) { return std::size_t((std::min)(size - 1., x)); };
    return m_distances[at.first_pixel + pixel(at.row) * size + pixel(at.column)];
  }
};

/// How a point is seen from a viewpoint.
struct View_of_point
{
  std::size_t view;
  bool is_hidden;
  double solid_angle; ///< of an area of 1 around it
};

View_of_point view_of(const Point& point, const Surroundings& around, const Depth_map& depths,
                      double noise, std::size_t view)
{
  constexpr double minimum_cosine = 0.1; // what is seen edge-on is known no better
  const Vector v = point - depths.place();
  const double distance = std::sqrt(v.squared_length());
  const double cosine = (std::max)(minimum_cosine, std::abs(around.normal * v) / distance);
  // A slanted surface, with the squares of its points and with its noise, does not hide itself.
  const double tangent = std::sqrt((std::max)(0., 1 - cosine * cosine)) / cosine;
  const double depth_of_surface = (2 * around.spacing + Depth_map::pixel_angle * distance) * tangent
                                  + 4 * noise / cosine;
  return {view, depths.nearest_distance(v) < distance - depth_of_surface,
          cosine / distance / distance};
}

bool is_better(const View_of_point& a, const View_of_point& b)
{
  return a.is_hidden != b.is_hidden ? b.is_hidden : a.solid_angle > b.solid_angle;
}

/// The view that most of the points around each one have, as stray points hide single ones of a
/// surface.
std::vector<std::size_t> usual_views(const std::vector<Point>& points,
                                     const std::vector<View_of_point>& views)
{
  constexpr std::size_t number_of_nearest = 12, block_size = 1024;
  const Sample_of_surface sample(points.size(),
                                 [&](std::size_t i) -> const Point& { return points[i]; });
  std::vector<std::size_t> result(points.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), block_size),
                    [&](const tbb::blocked_range<std::size_t>& block) {
                      std::vector<std::size_t> around;
                      for (std::size_t i = block.begin(); i < block.end(); ++i) {
                        around.clear();
                        for (const auto& [sample_index, squared_distance] :
                             sample.nearest(points[i], number_of_nearest))
                          around.push_back(views[sample.index_in_cloud(sample_index)].view);
                        const auto count = [&](std::size_t view) {
                          return std::count(around.begin(), around.end(), view);
                        };
                        result[i] = views[i].view;
                        for (const std::size_t view : around)
                          if (count(view) > count(result[i]))
                            result[i] = view;
                      }
                    });
  return result;
}

} // namespace

std::vector<Point> read_viewpoints(const std::string& path, bool has_decimal_commas,
                                   std::vector<std::string>& warnings)
{
  File_format format = format_of(path).value_or(File_format::XYZ);
  if (format == File_format::CSV)
    format = File_format::XYZ; // which reads the same, and needs no names
  Read_options options;
  options.has_decimal_commas = has_decimal_commas;
  options.drop_non_finite = true; // to say what is wrong, as each has its number
  options.needs_names_of_rest = true;
  options.how_to_name_columns = "a line before them, such as # id x y z, can name them";
  options.with_properties = format == File_format::XYZ || format == File_format::NPY; // to warn
  Point_cloud cloud = read_points(path, format, options);
  if (cloud.number_of_dropped_points > 0)
    throw Failure(INPUT_REFUSED, path + ": a viewpoint is not finite");
  warnings.insert(warnings.end(), cloud.warnings.begin(), cloud.warnings.end());
  return std::move(cloud.points);
}

std::vector<Point> viewpoints_of_points(const Point_cloud& cloud, const std::string& property,
                                        const std::vector<Point>& viewpoints,
                                        const std::string& name)
{
  const Property* const found = cloud.properties.find(property);
  if (!found)
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

std::vector<Point> best_viewpoints(const Point_cloud& cloud, const std::vector<Point>& viewpoints,
                                   double noise, const std::string& path)
{
  if (viewpoints.empty())
    throw Failure(INPUT_REFUSED, path + ": the file has no viewpoint");
  const std::vector<Point>& points = cloud.points;
  if (viewpoints.size() == 1)
    return std::vector<Point>(points.size(), viewpoints.front());

  const std::vector<Surroundings> surroundings = surroundings_of_points(points, cloud.normals);
  std::vector<View_of_point> best(points.size(), View_of_point{0, true, -1});
  for (std::size_t view = 0; view < viewpoints.size(); ++view) {
    Depth_map depths(viewpoints[view]);
    for (std::size_t i = 0; i < points.size(); ++i)
      depths.add(points[i], surroundings[i].spacing);
    throw_if_interrupted();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const View_of_point seen = view_of(points[i], surroundings[i], depths, noise, view);
      if (is_better(seen, best[i]))
        best[i] = seen;
    }
    throw_if_interrupted();
  }
  std::vector<Point> result;
  result.reserve(points.size());
  for (const std::size_t view : usual_views(points, best))
    result.push_back(viewpoints[view]);
  return result;
}

} // namespace l0_tool
