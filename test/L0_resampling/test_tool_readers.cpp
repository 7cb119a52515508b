// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers and writers of l0_resample: every format gives the points that are in the file.

#include "test_support.h"
#include "test_tool_support.h"

#include "write_points.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace {

using namespace l0_tool;
using namespace tool_test;

const Scratch_folder scratch;

Point_cloud read(const std::string& extension, const std::string& bytes, const Read_options& options = {})
{
  return tool_test::read(scratch, extension, bytes, options);
}

Failure_seen refusal(const std::string& extension, const std::string& bytes, const Read_options& options = {})
{
  return failure_of([&]() { read(extension, bytes, options); });
}

// What the writer writes, the reader reads, bit by bit; also numbers that few decimal digits would spoil.
void test_round_trip(File_format format, const std::string& extension)
{
  std::mt19937_64 random(7);
  std::vector<Oriented_point> points = {
    {Point(0.1, -0.0, 1. / 3), Vector(1, 0, 0)},
    {Point(256075.1, 3935300.5, 1e-300), Vector(0, 0, -1)},
    {Point((std::numeric_limits<double>::max)(), (std::numeric_limits<double>::lowest)(),
           (std::numeric_limits<double>::min)()),
     Vector(std::sqrt(.5), std::sqrt(.5), 0)}};
  std::normal_distribution<double> gauss;
  for (int i = 0; i < 20000; ++i)   // more than the buffers of reader and writer hold
    points.push_back(
      {Point(gauss(random), gauss(random), gauss(random)), Vector(gauss(random), gauss(random), gauss(random))});

  const std::string path = scratch.file("round_trip" + extension);
  write_points(path, format, points);
  CHECK(std::filesystem::file_size(path) <= largest_file_size(format, points.size()));

  const Point_cloud cloud = read_points(path, format, with_normals());
  CHECK(cloud.points.size() == points.size());
  CHECK(cloud.normals.size() == points.size());
  CHECK(cloud.warnings.empty());
  std::size_t different = 0;
  for (std::size_t i = 0; i < (std::min)(points.size(), cloud.normals.size()); ++i)
    different += std::memcmp(&points[i].first, &cloud.points[i], sizeof(Point)) != 0
                 || std::memcmp(&points[i].second, &cloud.normals[i], sizeof(Vector)) != 0;
  CHECK(different == 0);
  CHECK(read_points(path, format, {}).normals.empty());
}

template <typename T>
void test_ply_type(const std::string& name)
{
  for (const bool big : {false, true}) {
    const std::string header = ply_header(big ? "binary_big_endian" : "binary_little_endian",
                                          "element vertex 2\nproperty uchar flag\nproperty " + name + " x\nproperty "
                                            + name + " y\nproperty list ushort int id\nproperty " + name + " z\n");
    std::string body;
    for (int k = 0; k < 2; ++k) {
      body += bytes_of(std::uint8_t(9), big) + bytes_of(T(k + 1), big) + bytes_of(T(100), big);
      body += bytes_of(std::uint16_t(k), big);                        // an empty list and one of length 1
      for (int i = 0; i < k; ++i)
        body += bytes_of(std::int32_t(-1), big);
      body += bytes_of(T(-7), big);
    }
    const Point_cloud cloud = read(".ply", header + body);
    CHECK(cloud.points.size() == 2);
    CHECK(cloud.points[0] == Point(1, 100, double(T(-7))));
    CHECK(cloud.points[1] == Point(2, 100, double(T(-7))));
    CHECK(cloud.warnings.empty());
  }
}

void test_ply()
{
  test_ply_type<std::int8_t>("char");
  test_ply_type<std::uint8_t>("uint8");
  test_ply_type<std::int16_t>("short");
  test_ply_type<std::uint16_t>("uint16");
  test_ply_type<std::int32_t>("int");
  test_ply_type<std::uint32_t>("uint32");
  test_ply_type<float>("float");
  test_ply_type<double>("float64");

  // ASCII, CR LF, elements before and after the vertices, normals between other properties
  const Point_cloud cloud =
    read(".ply",
         "ply\r\nformat ascii 1.0\r\nelement camera 2\r\nproperty float f\r\nelement vertex 2\r\nproperty double nz\r\n"
         "property double x\r\nproperty list uchar int id\r\nproperty double y\r\nproperty double z\r\nproperty double "
         "nx\r\n"
         "property double ny\r\nelement face 1\r\nproperty list uchar int v\r\nend_header\r\n50\r\n60\r\n"
         "6 1 2 7 7 2 3 4 5\r\n-6 +1.5 0 -2e3 .5 -4 -5\r\n3 0 1 0\r\n",
         with_normals());
  CHECK(cloud.points == (std::vector<Point>{Point(1, 2, 3), Point(1.5, -2000, .5)}));
  CHECK(cloud.normals == (std::vector<Vector>{Vector(4, 5, 6), Vector(-4, -5, -6)}));

  // The same before binary vertices
  const std::string bytes = ply_header("binary_little_endian",
    "element strip 2\nproperty list uint short v\nproperty char c\nelement vertex 1\n" + float_xyz)
    + bytes_of(std::uint32_t(3), false) + "aabbcc" + "c" + bytes_of(std::uint32_t(0), false) + "c"
    + bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(3.f, false);
  CHECK(read(".ply", bytes).points == std::vector<Point>{Point(1, 2, 3)});
  CHECK(read(".ply", bytes + "more").warnings.size() == 1);

  CHECK(read(".ply", ply_header("ascii", "element vertex 0\n" + float_xyz)).points.empty());
  // two of three normal coordinates are no normals
  CHECK(read(".ply",
             ply_header("ascii", "element vertex 1\n" + float_xyz + "property float nx\nproperty float ny\n")
               + "1 2 3 4 5\n",
             with_normals())
          .normals.empty());
}

void test_off()
{
  CHECK(read(".off", "OFF\n# corners\n2 1 0\n\n0 0 .5 255 0 0\n 1 2 3\n3 0 1 1\n").points
        == (std::vector<Point>{Point(0, 0, .5), Point(1, 2, 3)}));
  CHECK(read(".OFF", "OFF 1 0 0 # on one line\n1 2 3").points == std::vector<Point>{Point(1, 2, 3)});
  CHECK(read(".off", "STCNOFF\n1 0 0\n1 2 3 4 5 6 7 8 9\n", with_normals()).normals
        == std::vector<Vector>{Vector(4, 5, 6)});
  CHECK(read(".off", "OFF\n1 0 0\n1 2 3 4 5 6\n", with_normals()).normals.empty());
}

void test_xyz()
{
  CHECK(read(".xyz", "# x y z\n1 2 3\n\n\t-1e1\t+0.5 3 \r\n4 5 6").points
        == (std::vector<Point>{Point(1, 2, 3), Point(-10, .5, 3), Point(4, 5, 6)}));
  CHECK(read(".pwn", "2\n1 2 3 4 5 6\n7 8 9 1 2 3\n", with_normals()).normals
        == (std::vector<Vector>{Vector(4, 5, 6), Vector(1, 2, 3)}));
  CHECK(read(".xyz", "1 2 3 a\n1 2 3 b\n", with_normals()).normals.empty());
  CHECK(read(".xyz", "1\n1 2 3\n4 5 6\n").warnings.size() == 1);
  CHECK(read(".xyz", "").points.empty());
}

void test_options()
{
  Read_options options;
  options.drop_non_finite = true;
  const Point_cloud cloud = read(".xyz", "1 2 3\nnan 2 3\n4 5 6\n7 inf 9\n", options);
  CHECK(cloud.points == (std::vector<Point>{Point(1, 2, 3), Point(4, 5, 6)}));
  CHECK(cloud.number_of_dropped_points == 2);

  options = {};
  options.max_points = 2;
  CHECK(read(".xyz", "1 2 3\n4 5 6\n", options).points.size() == 2);
  for (const auto& [extension, bytes] : {std::pair<const char*, const char*>{".xyz", "1 2 3\n4 5 6\n7 8 9\n"},
                                         {".off", "OFF\n3 0 0\n1 2 3\n4 5 6\n7 8 9\n"}}) {
    const Failure_seen seen = refusal(extension, bytes, options);
    CHECK(seen.status == INPUT_REFUSED && seen.says("more than the 2 points"));
  }

  options = {};
  options.max_memory = 2 * sizeof(Point);
  CHECK(read(".xyz", "1 2 3\n4 5 6\n", options).points.size() == 2);
  CHECK(refusal(".xyz", "1 2 3\n4 5 6\n7 8 9\n", options).status == RUN_TIME_FAILURE);
  CHECK(refusal(".off", "OFF\n3 0 0\n1 2 3\n4 5 6\n7 8 9\n", options).status == RUN_TIME_FAILURE);

  double last = 0;
  std::string big;
  for (int i = 0; i < 100000; ++i)
    big += "1 2 3\n";
  const std::string path = scratch.file("big.xyz");
  write_bytes(path, big);
  std::size_t calls = 0, backwards = 0;
  read_points(path, File_format::XYZ, {}, [&](double share) {
    ++calls;
    backwards += share < last || share > 1;
    last = share;
  });
  CHECK(calls > 1 && backwards == 0 && last > 0.5);
}

} // namespace

int main()
{
  test_round_trip(File_format::PLY, ".ply");
  test_round_trip(File_format::OFF, ".off");
  test_round_trip(File_format::XYZ, ".xyz");
  test_ply();
  test_off();
  test_xyz();
  test_options();
  return test::result();
}
