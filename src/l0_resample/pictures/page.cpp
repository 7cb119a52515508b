// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/page.h"

#include "basis/Number_type.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string_view>

namespace l0_tool {

extern const char* const text_of_page; // of page.html, by CMake

namespace {

constexpr std::size_t maximum_number_shown = 150000;

std::string base64(std::string_view bytes)
{
  static constexpr char digits[] =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return k < bytes.size() ? std::uint32_t(static_cast<unsigned char>(bytes[k])) : 0U;
    };
    const std::uint32_t bits = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// What the script of the page reads by its name.
void add_data(std::string_view type, const std::string& name, const std::string& content,
              std::string& page)
{
  page.append("<script type=\"").append(type).append("\" id=\"").append(name).append("\">");
  for (const char c : content)
    if (c == '<') // so that nothing ends the script
      page += "\\u003c";
    else
      page += c;
  page += "</script>\n";
}

/// Evenly from first to last, of as many as a page shows.
std::vector<std::size_t> shown_of(std::size_t size)
{
  std::vector<std::size_t> shown((std::min)(size, maximum_number_shown));
  for (std::size_t i = 0; i < shown.size(); ++i)
    shown[i] = std::size_t(double(i) * double(size) / double(shown.size()));
  return shown;
}

template <typename Value_of>
void add_numbers(const std::string& name, const std::vector<std::size_t>& shown,
                 const Value_of& value_of, std::string& page)
{
  std::string bytes;
  for (const std::size_t i : shown)
    append_little_endian<std::uint32_t>(float(value_of(i)), bytes);
  add_data("text/plain", name, base64(bytes), page);
}

/// A ball that holds what is drawn becomes that of radius 1 about the origin.
struct Ball
{
  std::array<double, 3> center = {0, 0, 0};
  double radius = 1;

  template <typename Range, typename Point_of>
  Ball(const Range& range, const Point_of& point_of)
  {
    if (range.empty())
      return;
    CGAL::Bbox_3 box;
    for (const auto& element : range)
      box += point_of(element).bbox();
    double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      center[std::size_t(axis)] = box.min(axis) / 2 + box.max(axis) / 2;
      const double half = box.max(axis) / 2 - box.min(axis) / 2;
      square += half * half;
    }
    if (square > 0 && std::isfinite(square))
      radius = std::sqrt(square);
  }
};

template <typename Point_of, typename Normal_of>
void add_cloud(const std::string& name, const std::vector<std::size_t>& shown, const Ball& ball,
               const Point_of& point_of, const Normal_of& normal_of, bool has_normals,
               std::string& page)
{
  std::string coordinates, normals;
  for (const std::size_t i : shown) {
    const Point& point = point_of(i);
    for (int axis = 0; axis < 3; ++axis)
      append_little_endian<std::uint32_t>(
        float((point[axis] - ball.center[std::size_t(axis)]) / ball.radius), coordinates);
    if (!has_normals)
      continue;
    const Vector& normal = normal_of(i);
    const double length = std::sqrt(normal.squared_length());
    for (int axis = 0; axis < 3; ++axis)
      normals += char(length > 0 && std::isfinite(length) ? std::lround(127 * normal[axis] / length)
                                                          : 0L);
  }
  add_data("text/plain", name + "_points", base64(coordinates), page);
  add_data("text/plain", name + "_normals", base64(normals), page);
}

/// The title of a column; a confidence has limits, whatever the values are.
std::string description_of(const std::string& column)
{
  std::string title = column;
  std::replace(title.begin(), title.end(), '_', ' ');
  if (column == "side_confidence")
    return "{\"title\": \"" + title + "\", \"limits\": [0.5, 1]}";
  if (column == "feature_confidence")
    return "{\"title\": \"" + title + "\", \"limits\": [0, 1]}";
  return "{\"title\": \"" + title + "\"}";
}

std::string facts_of(const View& view, const std::vector<Result_column>& columns)
{
  std::ostringstream text;
  const auto write = [&](const char* name, const Vector& v) {
    text << '"' << name << "\": [" << v.x() << ", " << v.y() << ", " << v.z() << "], ";
  };
  text << "{";
  write("towards_eye", view.towards_eye);
  write("up", view.up);
  text << "\"values\": [";
  for (std::size_t i = 0; i < columns.size(); ++i)
    text << (i == 0 ? "" : ", ") << description_of(columns[i].name);
  text << "]}";
  return text.str();
}

} // namespace

std::string page_of(const Point_cloud& input, const Resampled_points& result, const View& view,
                    const std::vector<float>& distances, const std::string& report)
{
  std::string data;
  add_data("application/json", "run", report, data);
  add_data("application/json", "page", facts_of(view, result.columns), data);

  const auto result_point = [&](std::size_t i) -> const Point& { return result.points[i].first; };
  const auto result_normal = [&](std::size_t i) -> const Vector& {
    return result.points[i].second;
  };
  const auto input_point = [&](std::size_t i) -> const Point& { return input.points[i]; };
  const auto input_normal = [&](std::size_t i) -> const Vector& { return input.normals[i]; };
  const Ball ball(result.points, [](const Oriented_point& point) { return point.first; });
  const bool has_normals = !input.normals.empty();

  std::vector<std::size_t> shown = shown_of(input.points.size());
  shown.erase(std::remove_if(shown.begin(), shown.end(),
                             [&](std::size_t i) {
                               return std::binary_search(result.outliers.begin(),
                                                         result.outliers.end(), i);
                             }),
              shown.end());
  add_cloud("input", shown, ball, input_point, input_normal, has_normals, data);

  std::vector<std::size_t> left_out = shown_of(result.outliers.size());
  add_numbers(
    "left_out_distances", left_out, [&](std::size_t i) { return distances[i]; }, data);
  for (std::size_t& i : left_out)
    i = result.outliers[i];
  add_cloud("left_out", left_out, ball, input_point, input_normal, has_normals, data);

  shown = shown_of(result.points.size());
  add_cloud("result", shown, ball, result_point, result_normal, true, data);
  for (std::size_t k = 0; k < result.columns.size(); ++k)
    add_numbers(
      "values_" + std::to_string(k), shown,
      [&](std::size_t i) { return result.columns[k].values[i]; }, data);

  static constexpr std::string_view place = "<!-- data -->\n";
  std::string page = text_of_page;
  page.replace(page.find(place), place.size(), data);
  return page;
}

} // namespace l0_tool
