// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reader and writer of PCD: fields of all types, compressed columns, viewpoints, and the precision
// of what is written.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include "formats/write_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

void test_pcd()
{
  // As PCL writes it: padding, a packed color, normals after other fields
  std::string header = pcd_header(" _ rgb normal_x normal_y normal_z curvature",
                                  "4 4 4 1 4 4 4 4 4", "F F F U U F F F F", "2", "binary");
  header.insert(header.find("WIDTH"), "COUNT 1 1 1 4 1 1 1 1 1\n");
  std::string body;
  for (int k = 0; k < 2; ++k)
  {
    for (const float number : {1.f, 2.f, 3.f + float(k)})
      body += bytes_of(number, false);
    body += "pad." + bytes_of(std::uint32_t(0xff00ff), false);
    for (const float number : {0.f, float(k) - 1, float(k), 9.f})
      body += bytes_of(number, false);
  }
  const Point_cloud cloud = read(".pcd", header + body, with_normals());
  CHECK(cloud.points == (std::vector<Point>{Point(1, 2, 3), Point(1, 2, 4)}));
  CHECK(cloud.normals == (std::vector<Vector>{Vector(0, -1, 0), Vector(0, 0, 1)}));
  CHECK(cloud.warnings.empty());
  CHECK(read(".pcd", header + body + "more").warnings.size() == 1);

  // every type, in either order of the fields
  const std::string mixed = "VERSION .7\nFIELDS z y x i j\nSIZE 8 2 1 8 8\nTYPE F I U I U\nCOUNT 1 "
                            "1 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
                            "DATA binary\n"
                            + bytes_of(0.1, false) + bytes_of(std::int16_t(-300), false)
                            + bytes_of(std::uint8_t(200), false);
  CHECK(read(".pcd", mixed + std::string(16, 'i')).points
        == std::vector<Point>{Point(200, -300, 0.1)});

  // ASCII, CR LF, an organized cloud with an empty place
  std::string text = pcd_header(" label", "4 4 4 4", "F F F U", "2", "ascii")
                     + "1 2 3 4294967295\n\nnan nan nan 0\n";
  text.replace(text.find("WIDTH 2\nHEIGHT 1"), 16, "WIDTH 1\nHEIGHT 2");
  Read_options options;
  options.drop_non_finite = true;
  CHECK(read(".PCD", text, options).points == std::vector<Point>{Point(1, 2, 3)});
  CHECK(read(".pcd", text, options).number_of_dropped_points == 1);
  CHECK(refusal(".pcd", text)
          .says("as an organized cloud has it where nothing was measured; "
                "--drop-non-finite leaves such points out"));
  CHECK(!refusal(".pcd", pcd_header("", "4 4 4", "F F F", "1", "ascii") + "1 nan 3\n")
           .says("organized"));
  std::string windows;
  for (const char c : text)
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  CHECK(read(".pcd", windows, options).points == std::vector<Point>{Point(1, 2, 3)});
  const std::string one_normal_coordinate =
    pcd_header(" normal_x", "4 4 4 4", "F F F F", "1", "ascii") + "1 2 3 4\n";
  CHECK(read(".pcd", one_normal_coordinate, with_normals()).normals.empty());
  CHECK(read(".pcd", pcd_header("", "4 4 4", "F F F", "0", "binary")).points.empty());

  const auto viewpoint_of = [](const std::string& words) {
    std::string file = pcd_header("", "4 4 4", "F F F", "0", "ascii");
    const std::string line = "VIEWPOINT 0 0 0 1 0 0 0";
    const Point_cloud cloud = read(".pcd", file.replace(file.find(line), line.size(), words));
    const bool is_understood = words == line || words == "#" || cloud.viewpoint;
    CHECK(cloud.warnings.size() == (is_understood ? 0 : 1));
    return cloud.viewpoint;
  };
  CHECK(viewpoint_of("VIEWPOINT 1 -2.5 3e1 1 0 0 0") == (std::array<double, 3>{1, -2.5, 30}));
  CHECK(viewpoint_of("VIEWPOINT 0 0 1") == (std::array<double, 3>{0, 0, 1})); // of version 0.6
  for (const char* nowhere :
       {"VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT", "VIEWPOINT 1 2", "#", "VIEWPOINT 1 2,5 3 1 0 0 0",
        "VIEWPOINT 3,2.5,1.5 1 0 0 0", "VIEWPOINT nan 0 1 1 0 0 0", "VIEWPOINT 0 -inf 1 1 0 0 0"})
    CHECK(!viewpoint_of(nowhere));
}

// The type B of PCL, and others that are not kept, are no obstacle to the other fields.
void test_other_types()
{
  Read_options options;
  options.with_properties = true;
  const std::string rows = bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(3.f, false) + "\1"
                           + bytes_of(std::int64_t(-9), false) + "\7";
  const auto file = [](const char* data) {
    return pcd_header(" inlier time label", "4 4 4 1 8 1", "F F F B I U", "1", data);
  };
  for (const std::string& text :
       {file("ascii") + "1 2 3 true -9 7\n", file("binary") + rows,
        file("binary_compressed") + pcd_block(rows.size(), char(rows.size() - 1) + rows)})
  {
    const Point_cloud cloud = read(".pcd", text, options);
    CHECK(cloud.points == std::vector<Point>{Point(1, 2, 3)});
    CHECK(cloud.properties.properties().size() == 2);
    CHECK(cloud.properties.value(0, *cloud.properties.find("label")) == 7);
    CHECK(cloud.properties.value(0, *cloud.properties.find("time")) == -9);
    CHECK(cloud.warnings.size() == 1);
    CHECK(cloud.warnings[0].find("'inlier' is left out: type 'B' of 1 bytes") != std::string::npos);
  }
  CHECK(refusal(".pcd", pcd_header("", "1 4 4", "B F F", "1", "ascii") + "1 2 3\n")
          .says("the field x is of type 'B' of 1 bytes"));
}

std::string from_hexadecimal(const std::string& digits)
{
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes += char(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

// The columns of 40 points, as LibLZF 3.6 compresses them: i % 5, i / 2 and 0 in single precision,
// and a color whose channels are i % 3.
const std::string compressed_columns = from_hexadecimal(
  "010000400001803f2005004020022003008020034000e083130000209f408f00c0200740a7002020a340ab0060"
  "200740af0090200700a0200300b0200300c0200300d0200300e0200300f0200304004100000820030010200300"
  "182003002020030028200300302003003820030040200300482003005020030058200300602003006820030070"
  "200300782003008020030084200300882003008c2003009020030094200300982003009c2003e0980008070101"
  "01070202020720a9e0860b010007");

void test_compressed_pcd()
{
  Read_options options;
  options.with_properties = true;
  const std::string header = pcd_header(" rgba", "4 4 4 4", "F F F U", "40", "binary_compressed");
  const std::string file = header + pcd_block(640, compressed_columns);
  const Point_cloud cloud = read(".pcd", file, options);
  CHECK(cloud.warnings.empty());
  CHECK(cloud.points.size() == 40 && cloud.properties.properties().size() == 4);
  for (int i = 0; i < 40; ++i)
  {
    CHECK(cloud.points[std::size_t(i)] == Point(i % 5, i / 2., 0));
    for (const Property& channel : cloud.properties.properties())
      CHECK(cloud.properties.value(std::size_t(i), channel)
            == (channel.name == "alpha" ? 7 : i % 3));
  }
  CHECK(read(".pcd", file + "more").warnings.size() == 1);

  // A field of two values, and padding, which PCL names in the header but leaves out of the data
  std::string padded = pcd_header(" _ i _", "1 1 1 1 2 1", "U U U U I U", "2", "binary_compressed");
  padded.insert(padded.find("WIDTH"), "COUNT 1 1 1 9 2 1\n");
  const std::string values = {1, 2, 3, 4, 5, 6, 7, 0, 8, 0, 9, 0, 10, 0};
  const std::string padding(18, 'p');
  for (const std::string& columns :
       {values, values.substr(0, 6) + padding + values.substr(6) + "pp"})
  {
    std::string literals;
    for (std::size_t i = 0; i < columns.size(); i += 32)
      literals += char((std::min)(columns.size() - i, std::size_t(32)) - 1) + columns.substr(i, 32);
    const Point_cloud points =
      read(".pcd", padded + pcd_block(std::uint32_t(columns.size()), literals), options);
    CHECK(points.points == (std::vector<Point>{Point(1, 3, 5), Point(2, 4, 6)}));
    CHECK(points.warnings.empty());
    std::vector<double> numbers;
    for (std::size_t i = 0; i < 2; ++i)
      for (const Property& property : points.properties.properties())
        numbers.push_back(points.properties.value(i, property));
    CHECK(numbers == (std::vector<double>{7, 8, 9, 10}));
  }
  CHECK(read(".pcd", pcd_header("", "4 4 4", "F F F", "0", "binary_compressed") + pcd_block(0, ""))
          .points.empty());

  // While points are read, the decompressed data take memory too
  options = {};
  options.max_memory = 40 * sizeof(Point) + 640;
  CHECK(read(".pcd", file, options).points.size() == 40);
  --options.max_memory;
  CHECK(refusal(".pcd", file, options).status == RUN_TIME_FAILURE);
}

// What other programs write, and PCL reads.
void test_pcd_of_others()
{
  const std::vector<Point> one = {Point(1, 2, 3)};
  const std::string fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n";
  for (const char* numbers : {"WIDTH 1\nHEIGHT 1\nPOINTS 1\n", "POINTS 1\n", "WIDTH 1\nHEIGHT 1\n",
                              "WIDTH 1\n", "HEIGHT 1\nPOINTS 1\n"})
    CHECK(read(".pcd", "# .PCD v.5\n" + fields + numbers + "DATA ascii\n1 2 3\n").points == one);
  CHECK(read(".pcd", "COLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n").points
        == one);

  // Fields without values, in binary, text and compressed columns
  const std::string padded = "VERSION .7\nFIELDS x y _ z _ i\nSIZE 1 1 1 1 4 1\nTYPE U U U U U U\n"
                             "COUNT 1 1 0 1 0 1\nPOINTS 1\nDATA ";
  Read_options options;
  options.with_properties = true;
  for (const std::string& file : {padded + "binary\n" + "\1\2\3\4", padded + "ascii\n1 2 3 4\n",
                                  padded + "binary_compressed\n" + pcd_block(4, "\3\1\2\3\4")})
  {
    const Point_cloud cloud = read(".pcd", file, options);
    CHECK(cloud.points == one && cloud.warnings.empty());
    CHECK(cloud.properties.properties().size() == 1
          && cloud.properties.value(0, cloud.properties.properties()[0]) == 4);
  }

  // Names as elsewhere
  const Point_cloud named =
    read(".pcd",
         "VERSION .7\nFIELDS X Y Z NX NY NZ R G B\nSIZE 4 4 4 4 4 4 1 1 1\nTYPE F F F F F F U U "
         "U\nPOINTS 1\nDATA ascii\n1 2 3 0 -1 0 255 9 0\n",
         with_everything());
  CHECK(named.points == one && named.normals == std::vector<Vector>{Vector(0, -1, 0)});
  CHECK(named.properties.properties().size() == 3);
  CHECK(named.properties.properties()[0].name == "red");

  // One field for a point, a normal and a color, in text, in bytes, and in columns
  const std::string in_one = "VERSION .7\nFIELDS xyz Normal i rgb\nSIZE 1 1 1 1\nTYPE U I U U\n"
                             "COUNT 3 3 1 3\nPOINTS 2\nDATA ";
  const std::string rows = {1, 2, 3, 0, '\xff', 0, 9, 7, 8, 6, 4, 5, 6, 0, 0, 1, 3, 1, 0, 2},
                    columns = {1, 2, 3, 4, 5, 6, 0, '\xff', 0, 0, 0, 1, 9, 3, 7, 8, 6, 1, 0, 2};
  for (const std::string& file :
       {in_one + "ASCII\n1 2 3 0 -1 0 9 7 8 6\n4 5 6 0 0 1 3 1 0 2\n", in_one + "binary\n" + rows,
        in_one + "binary_compressed\n" + pcd_block(20, char(19) + columns)})
  {
    const Point_cloud cloud = read(".pcd", file, with_everything());
    CHECK(cloud.points == (std::vector<Point>{Point(1, 2, 3), Point(4, 5, 6)}));
    CHECK(cloud.normals == (std::vector<Vector>{Vector(0, -1, 0), Vector(0, 0, 1)}));
    CHECK(cloud.warnings.empty() && cloud.properties.properties().size() == 4);
    CHECK(cloud.properties.properties()[3].name == "blue");
    CHECK(cloud.properties.value(1, cloud.properties.properties()[0]) == 3);
    CHECK(cloud.properties.value(1, cloud.properties.properties()[3]) == 2);
  }

  // A kind of data in other letters, and a whole number with a point
  const Point_cloud odd =
    read(".pcd",
         "VERSION .7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE f f f u\nPOINTS 1\nDATA Ascii\n"
         "1 2 3 7.0\n",
         with_everything());
  CHECK(odd.points == one && odd.properties.value(0, odd.properties.properties()[0]) == 7);

  // Empty lines at the end are nothing that is left out
  const std::string text = pcd_header("", "4 4 4", "F F F", "1", "ascii") + "1 2 3\n";
  CHECK(read(".pcd", text + "\n \r\n").warnings.empty());
  CHECK(read(".pcd", text + "\n4 5 6\n").warnings.size() == 1);
}

// A viewpoint that differs from the origin by rounding tells nothing either.
void test_rounded_viewpoint()
{
  const auto viewpoint_of = [](const std::string& place, const std::string& points) {
    return read(".pcd", "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nVIEWPOINT " + place
                          + " 1 0 0 0\nPOINTS 2\nDATA ascii\n" + points)
      .viewpoint;
  };
  for (const char* place : {"-1.45519e-11 0 0", "0 0 0", "-0 1e-300 0", "0 9e-7 0"})
    CHECK(!viewpoint_of(place, "1 0 0\n0 0 0\n"));
  CHECK(viewpoint_of("0 2e-6 0", "1 0 0\n0 0 0\n"));
  CHECK(viewpoint_of("-1.45519e-11 0 0", "1e-11 0 0\n0 0 0\n")); // of a thing that is as small
  // Where coordinates are large, so is their rounding; a place among the points is one
  for (const char* place : {"1e-3 -2e-3 0", "0 0 4.9"})
    CHECK(!viewpoint_of(place, "500000 5e6 100\n500020 5000010 90\n"));
  CHECK(viewpoint_of("500010 5e6 100", "500000 5e6 100\n500020 5000010 90\n"));
  CHECK(!viewpoint_of("0 -5e-4 0", "-1000 0 0\n-999 0 0\n"));
  CHECK(viewpoint_of("0 -5e-3 0", "-1000 0 0\n-999 0 0\n"));
}

// What is written has the viewpoint, bit by bit, and the origin where nobody knows one.
void test_written_viewpoint()
{
  const std::string path = scratch.file("viewpoint.pcd");
  const double largest = (std::numeric_limits<double>::max)();
  for (const std::optional<std::array<double, 3>>& viewpoint :
       {std::optional<std::array<double, 3>>(), std::make_optional(std::array{1., -2.5, 1. / 3}),
        std::make_optional(std::array{-largest, -largest, -2.2250738585072014e-308})})
  {
    Point_cloud cloud;
    cloud.points = {Point(1, 2, 3)};
    cloud.viewpoint = viewpoint;
    Resampled_points result;
    result.points = {{Point(1, 2, 3), Vector(0, 0, 1)}};
    result.viewpoint = viewpoint;
    const std::function<void()> writers[] = {
      [&]() { write_point_cloud(path, File_format::PCD, cloud); },
      [&]() { write_points(path, File_format::PCD, result); }};
    for (const auto& write : writers)
    {
      write();
      CHECK(std::filesystem::file_size(path) <= maximum_file_size(File_format::PCD, 1));
      CHECK(read_points(path, File_format::PCD, {}).viewpoint == viewpoint);
      CHECK((read_bytes(path).find("VIEWPOINT 0 0 0 1 0 0 0\n") != std::string::npos)
            == !viewpoint);
    }
  }
}

// PCD holds single precision where that is enough.
void test_precision_of_pcd()
{
  const std::string path = scratch.file("precision.pcd");
  std::vector<Oriented_point> points;
  for (int k = 0; k < 100; ++k)
    points.push_back({Point(k / 99., k / 7., 0.1 * k), Vector(0.6, 0, 0.8)});
  const double diagonal = std::sqrt((points.back().first - points.front().first).squared_length());
  for (const double offset : {0., 100., 1e6})
  {
    std::vector<Oriented_point> moved = points;
    for (Oriented_point& point : moved)
      point.first = point.first + offset * Vector(1, -1, 1);
    write_points(path, File_format::PCD, moved);
    const bool is_single = read_bytes(path).find("SIZE 4 4 4 4 4 4\n") != std::string::npos;
    CHECK(is_single == (offset < 1e6));
    const Point_cloud cloud = read_points(path, File_format::PCD, with_normals());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      CHECK(std::sqrt((cloud.points[i] - moved[i].first).squared_length())
            <= (is_single ? 2e-6 * diagonal : 0));
      CHECK(std::sqrt((cloud.normals[i] - moved[i].second).squared_length()) <= 1e-6);
    }
  }
  write_points(path, File_format::PCD, std::vector<Oriented_point>());
  CHECK(read_points(path, File_format::PCD, {}).points.empty());
}

} // namespace

int main()
{
  test_pcd();
  test_other_types();
  test_compressed_pcd();
  test_pcd_of_others();
  test_rounded_viewpoint();
  test_written_viewpoint();
  test_precision_of_pcd();
  return test::result();
}
