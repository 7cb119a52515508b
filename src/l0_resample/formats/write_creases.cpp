// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/write_creases.h"

#include "files/file_formats.h"

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

/// Appends words with a blank before each, but for the first of a line.
class Text
{
  std::string m_text;

public:
  Text& operator<<(std::string_view word)
  {
    if (!m_text.empty() && m_text.back() != '\n')
      m_text += ' ';
    m_text += word;
    return *this;
  }
  template <typename Number>
  Text& number(Number value)
  {
    char digits[32];
    return *this << std::string_view(
             digits,
             std::size_t(std::to_chars(digits, digits + sizeof digits, value).ptr - digits));
  }
  Text& place(const Point& p) { return number(p.x()).number(p.y()).number(p.z()); }
  Text& direction(const Vector& v) { return number(v.x()).number(v.y()).number(v.z()); }
  void end_line() { m_text += '\n'; }
  const std::string& str() const { return m_text; }
};

const char* side_of(const Crease& crease) { return crease.is_convex ? "convex" : "concave"; }

double mean_angle(const Crease& crease)
{
  double sum = 0;
  for (const double angle : crease.angles)
    sum += angle;
  return sum / double(crease.angles.size());
}

/// The points of the result that are on creases and corners, each once, in the order in which they
/// come there.
struct Vertices
{
  std::vector<std::size_t> points;
  std::unordered_map<std::size_t, std::size_t> numbers; // of points, from 0

  explicit Vertices(const Resampled_points& result)
  {
    for (const Crease& crease : result.creases)
      for (const std::size_t point : crease.points)
        add(point);
    for (const Crease_corner& corner : result.corners)
      add(corner.point);
  }

private:
  void add(std::size_t point)
  {
    if (numbers.emplace(point, points.size()).second)
      points.push_back(point);
  }
};

std::string as_obj(const Resampled_points& result)
{
  const Vertices vertices(result);
  Text text;
  for (const std::size_t point : vertices.points) {
    (text << "v").place(result.points[point].first);
    text.end_line();
  }
  const auto number = [&](std::size_t point) { return vertices.numbers.at(point) + 1; };
  for (const Crease& crease : result.creases) {
    (text << "#" << side_of(crease) << "angle").number(float(mean_angle(crease)));
    (text << "confidence").number(float(crease.confidence));
    text.end_line();
    text << "l";
    for (const std::size_t point : crease.points)
      text.number(number(point));
    if (crease.is_closed)
      text.number(number(crease.points.front()));
    text.end_line();
  }
  for (const Crease_corner& corner : result.corners) {
    (text << "p").number(number(corner.point));
    text.end_line();
  }
  return text.str();
}

std::string as_ply(const Resampled_points& result)
{
  const Vertices vertices(result);
  std::vector<char> are_corners(vertices.points.size(), 0);
  for (const Crease_corner& corner : result.corners)
    are_corners[vertices.numbers.at(corner.point)] = 1;
  std::size_t number_of_edges = 0;
  for (const Crease& crease : result.creases)
    number_of_edges += crease.points.size() - (crease.is_closed ? 0 : 1);

  Text text;
  const auto line = [&](std::string_view words) {
    text << words;
    text.end_line();
  };
  line("ply");
  line("format ascii 1.0");
  line("element vertex " + std::to_string(vertices.points.size()));
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    line(std::string("property double ") + name);
  line("property uchar corner");
  line("element edge " + std::to_string(number_of_edges));
  line("property int vertex1");
  line("property int vertex2");
  line("property int crease");
  line("property uchar convex");
  line("property float angle");
  line("property float confidence");
  line("end_header");
  for (std::size_t k = 0; k < vertices.points.size(); ++k) {
    const auto& [place, normal] = result.points[vertices.points[k]];
    text.place(place).direction(normal).number(int(are_corners[k]));
    text.end_line();
  }
  for (std::size_t c = 0; c < result.creases.size(); ++c) {
    const Crease& crease = result.creases[c];
    const std::size_t size = crease.points.size();
    for (std::size_t k = 0; k + (crease.is_closed ? 0 : 1) < size; ++k) {
      text.number(vertices.numbers.at(crease.points[k]))
        .number(vertices.numbers.at(crease.points[(k + 1) % size]))
        .number(c)
        .number(int(crease.is_convex))
        .number(float(crease.angles[k]))
        .number(float(crease.confidence));
      text.end_line();
    }
  }
  return text.str();
}

/// Of release 12, which every program that reads DXF knows: pairs of lines, a code and a value.
std::string as_dxf(const Resampled_points& result)
{
  Text text;
  const auto pair = [&](int code, std::string_view value) {
    text.number(code).end_line();
    text << value;
    text.end_line();
  };
  const auto place = [&](const Point& p) {
    for (int axis = 0; axis < 3; ++axis) {
      text.number(10 * (axis + 1)).end_line();
      text.number(p[axis]).end_line();
    }
  };
  pair(0, "SECTION");
  pair(2, "ENTITIES");
  for (const Crease& crease : result.creases) {
    const char* const layer = crease.is_convex ? "CONVEX_CREASES" : "CONCAVE_CREASES";
    pair(0, "POLYLINE");
    pair(8, layer);
    pair(66, "1"); // vertices follow
    place(CGAL::ORIGIN);
    pair(70, crease.is_closed ? "9" : "8"); // in space; closed
    for (const std::size_t point : crease.points) {
      pair(0, "VERTEX");
      pair(8, layer);
      place(result.points[point].first);
      pair(70, "32"); // of a polyline in space
    }
    pair(0, "SEQEND");
  }
  for (const Crease_corner& corner : result.corners) {
    pair(0, "POINT");
    pair(8, "CORNERS");
    place(result.points[corner.point].first);
  }
  pair(0, "ENDSEC");
  pair(0, "EOF");
  return text.str();
}

} // namespace

std::optional<Crease_format> crease_format_of(const std::string& path)
{
  const std::string extension = lower_extension(path);
  const std::pair<const char*, Crease_format> formats[] = {
    {".obj", Crease_format::OBJ}, {".ply", Crease_format::PLY}, {".dxf", Crease_format::DXF}};
  for (const auto& [name, format] : formats)
    if (extension == name)
      return format;
  return std::nullopt;
}

void write_creases(const std::string& path, Crease_format format, const Resampled_points& result)
{
  Output_file file(path);
  switch (format) {
  case Crease_format::OBJ: file.write(as_obj(result)); break;
  case Crease_format::PLY: file.write(as_ply(result)); break;
  case Crease_format::DXF: file.write(as_dxf(result)); break;
  }
  file.commit();
}

} // namespace l0_tool
