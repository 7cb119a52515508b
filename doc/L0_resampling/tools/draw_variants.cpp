// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws results of several parameters beside each other, for the figures of the manual:
//
//   draw_variants INPUT.ply OUTPUT.png TOWARDS_EYE BOX VARIANT...
//
// TOWARDS_EYE is x,y,z and BOX x0,y0,z0,x1,y1,z1: only what lies in it is drawn. A variant is
// `input`, or `default`, or names and values such as `method=1,normal_weight=5`, with the names of
// the named parameters and the number of a Method. A radius is read in units of its default.
// Besides, `viewpoint_z=5` is a viewpoint on the z-axis, `up=1` says that points were seen from
// there, `hints=3` are hints up of which every third is wrong, `features=1` draws the feature
// confidences in place of the normals, `creases=1` draws creases, `dots=1` draws points as dots, so
// that one sees how they lie, and `cut=1` resamples only what lies in BOX, which then has a border.

#include "files/file_formats.h"
#include "formats/read_points.h"
#include "pictures/render_snapshot.h"
#include "pictures/Image.h"

#include <CGAL/l0_resample_point_set.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace parameters = CGAL::parameters;
using CGAL::L0_resampling::Method;
using l0_tool::Image;
using l0_tool::Oriented_point;
using l0_tool::Point;
using l0_tool::Point_cloud;

std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
    parts.push_back(part);
  return parts;
}

template <std::size_t N>
std::array<double, N> numbers(const std::string& text)
{
  const std::vector<std::string> parts = split(text);
  if (parts.size() != N)
    throw std::invalid_argument(text + " is not a list of " + std::to_string(N) + " numbers");
  std::array<double, N> result;
  for (std::size_t i = 0; i < N; ++i)
    result[i] = std::stod(parts[i]);
  return result;
}

using Values = std::map<std::string, double>;

Values values_of_variant(const std::string& variant)
{
  Values values;
  if (variant == "default")
    return values;
  for (const std::string& part : split(variant))
  {
    const std::size_t sign = part.find('=');
    if (sign == std::string::npos)
      throw std::invalid_argument(part + " is not NAME=VALUE");
    values[part.substr(0, sign)] = std::stod(part.substr(sign + 1));
  }
  return values;
}

/// Takes a value off the list, so that what is left at the end is a misspelled name.
double take(Values& values, const std::string& name, double default_value)
{
  const auto found = values.find(name);
  if (found == values.end())
    return default_value;
  const double value = found->second;
  values.erase(found);
  return value;
}

struct Result
{
  std::vector<Oriented_point> points;
  std::vector<float> feature_confidences; // none where normals are to be drawn
  std::vector<std::vector<Point>> lines;  // its creases, if they are to be drawn
};

Result resample(const std::vector<Point>& points, Values values)
{
  const Method method = Method(int(take(values, "method", double(Method::DEFAULT))));
  const auto defaults = CGAL::L0_resampling::internal::checked_parameters(
    parameters::resampling_method(method), points.size());

  // The radii that the points ask for are known after a call only.
  CGAL::L0_resampling::Report report;
  Result result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result.points),
    parameters::resampling_method(method).resampling_report(&report));
  result.points.clear();
  const double radius = take(values, "neighbor_radius", 1) * report.neighbor_radius;
  const double filter_radius = take(values, "normal_filter_radius", 1) * radius
                               * report.normal_filter_radius / report.neighbor_radius;
  const double share = take(values, "select_percentage", 50) / 100;
  std::optional<Point> viewpoint;
  if (const double z = take(values, "viewpoint_z", 0); z != 0)
    viewpoint = Point(0, 0, z);
  const bool is_seen_from_above = take(values, "up", 0) != 0;
  const std::size_t wrong_hint = std::size_t(take(values, "hints", 0));
  const bool draws_features = take(values, "features", 0) != 0;
  std::vector<float> confidences;
  std::vector<l0_tool::Crease> creases;
  const bool draws_creases = take(values, "creases", 0) != 0;

  const std::size_t number = std::size_t(share * double(points.size()));
  confidences.resize(number);
  const auto np =
    parameters::resampling_method(method)
      .neighbor_radius(radius)
      .normal_filter_radius(filter_radius)
      .sharpness_angle(take(values, "sharpness_angle", defaults.sharpness_angle))
      .number_of_normal_filter_iterations(
        std::size_t(take(values, "number_of_normal_filter_iterations",
                         double(defaults.number_of_normal_filter_iterations))))
      .normal_weight(take(values, "normal_weight", defaults.normal_weight))
      .regularization_weight(take(values, "regularization_weight", defaults.regularization_weight))
      .initial_penalty(take(values, "initial_penalty", defaults.initial_penalty))
      .maximum_penalty(take(values, "maximum_penalty", defaults.maximum_penalty))
      .penalty_growth(take(values, "penalty_growth", defaults.penalty_growth))
      .number_of_orientation_neighbors(
        std::size_t(take(values, "number_of_orientation_neighbors",
                         double(defaults.number_of_orientation_neighbors))))
      .random_seed(std::size_t(take(values, "random_seed", 0)))
      .keep_density(take(values, "keep_density", 0) != 0)
      .drop_outliers(take(values, "drop_outliers", double(defaults.outlier_sensitivity > 0)) != 0)
      .viewpoint(viewpoint)
      .feature_confidence_map(CGAL::make_property_map(confidences))
      .crease_output_iterator(draws_creases ? std::make_optional(std::back_inserter(creases))
                                            : std::nullopt)
      .number_of_output_points(number);
  if (!values.empty())
    throw std::invalid_argument(values.begin()->first + " is not a named parameter");
  using Vector = CGAL::Kernel_traits<Point>::Kernel::Vector_3;
  std::vector<std::pair<Point, Vector>> with_hints;
  for (std::size_t i = 0; i < points.size(); ++i)
    with_hints.emplace_back(points[i],
                            Vector(0, 0, wrong_hint > 0 && i % wrong_hint == 0 ? -1 : 1));
  const auto call = [&](const auto& all) {
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
      with_hints, std::back_inserter(result.points),
      all.point_map(CGAL::First_of_pair_property_map<std::pair<Point, Vector>>()));
  };
  if (is_seen_from_above)
    call(np.up_direction(Vector(0, 0, 1)));
  else if (wrong_hint > 0)
    call(np.orientation_hint_map(CGAL::Second_of_pair_property_map<std::pair<Point, Vector>>()));
  else
    call(np);
  if (draws_features)
    result.feature_confidences = confidences;
  result.lines = l0_tool::lines_of_creases(creases, result.points);
  return result;
}

bool lies_in(const Point& p, const std::array<double, 6>& box)
{
  for (int axis = 0; axis < 3; ++axis)
    if (!(p[axis] >= box[std::size_t(axis)] && p[axis] <= box[std::size_t(axis) + 3]))
      return false;
  return true;
}

/// The panel of the result, at half its size: what render_snapshot() draws beside the input.
void copy_panel(const Image& snapshot, int panel, int place, Image& picture)
{
  const int width = snapshot.width / 2;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < width / 2; ++x)
      for (std::size_t channel = 0; channel < 3; ++channel)
      {
        float sum = 0;
        for (int dy : {0, 1})
          for (int dx : {0, 1})
            sum += snapshot.at(panel * width + 2 * x + dx, 2 * y + dy)[channel];
        picture.at(place * width / 2 + x, y)[channel] = sum / 4;
      }
}

/// Leaves out the rows at the top and the bottom that are white all along, but for a few.
Image without_white_rows(const Image& picture)
{
  const auto is_white = [&](int y) {
    for (int x = 0; x < picture.width; ++x)
      if (picture.at(x, y) != l0_tool::Color{1, 1, 1})
        return false;
    return true;
  };
  int begin = 0, end = picture.height;
  while (begin < end && is_white(begin))
    ++begin;
  while (begin < end && is_white(end - 1))
    --end;
  const int margin = 10;
  begin = (std::max)(begin - margin, 0);
  end = (std::min)(end + margin, picture.height);
  Image result(picture.width, end - begin, {1, 1, 1});
  for (int y = begin; y < end; ++y)
    for (int x = 0; x < picture.width; ++x)
      result.at(x, y - begin) = picture.at(x, y);
  return result;
}

void draw(int argc, char** argv)
{
  if (argc < 6)
    throw std::invalid_argument("expected INPUT.ply OUTPUT.png TOWARDS_EYE BOX VARIANT...");
  const Point_cloud cloud = l0_tool::read_points(argv[1], l0_tool::File_format::PLY, {});
  const std::array<double, 3> towards_eye = numbers<3>(argv[3]);
  const std::array<double, 6> box = numbers<6>(argv[4]);
  Point_cloud visible_cloud;
  for (const Point& p : cloud.points)
    if (lies_in(p, box))
      visible_cloud.points.push_back(p);

  Image picture(0, 0, {1, 1, 1});
  for (int v = 5; v < argc; ++v)
  {
    const bool is_input = std::string(argv[v]) == "input";
    Result visible_result;
    bool as_dots = false;
    if (!is_input)
    {
      Values values = values_of_variant(argv[v]);
      as_dots = take(values, "dots", 0) != 0;
      const bool is_cut = take(values, "cut", 0) != 0;
      const Result result = resample(is_cut ? visible_cloud.points : cloud.points, values);
      for (std::size_t i = 0; i < result.points.size(); ++i)
        if (is_cut || lies_in(result.points[i].first, box))
        {
          visible_result.points.push_back(result.points[i]);
          if (!result.feature_confidences.empty())
            visible_result.feature_confidences.push_back(result.feature_confidences[i]);
        }
      visible_result.lines = result.lines;
    }
    const Image snapshot = l0_tool::render_snapshot(visible_cloud, visible_result.points,
                                                    towards_eye, visible_result.feature_confidences,
                                                    l0_tool::Snapshot_colors::SHADED, as_dots,
                                                    visible_result.lines);
    if (v == 5)
      picture = Image((argc - 5) * snapshot.width / 4, snapshot.height / 2, {1, 1, 1});
    copy_panel(snapshot, is_input ? 0 : 1, v - 5, picture);
  }
  l0_tool::write_png(argv[2], without_white_rows(picture));
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    draw(argc, argv);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "draw_variants: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
