// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What holds for all formats that l0_resample reads and writes: what was written is read again,
// also compressed, and within the limits of points and memory.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include "formats/write_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

// What the writer writes, the reader reads, bit by bit; also numbers that few decimal digits would
// spoil.
void test_round_trip(File_format format, const std::string& extension)
{
  std::mt19937_64 random(7);
  std::vector<Oriented_point> points = {{Point(0.1, -0.0, 1. / 3), Vector(1, 0, 0)},
                                        {Point(256075.1, 3935300.5, 1e-300), Vector(0, 0, -1)},
                                        {Point((std::numeric_limits<double>::max)(),
                                               (std::numeric_limits<double>::lowest)(),
                                               (std::numeric_limits<double>::min)()),
                                         Vector(std::sqrt(.5), std::sqrt(.5), 0)}};
  std::normal_distribution<double> gauss;
  for (int i = 0; i < 20000; ++i) // more than the buffers of reader and writer hold
  {
    const Vector normal(gauss(random), gauss(random), gauss(random));
    points.push_back({Point(gauss(random), gauss(random), gauss(random)),
                      normal / std::sqrt(normal.squared_length())});
  }

  const std::string path = scratch.file("round_trip" + extension);
  write_points(path, format, points);
  CHECK(std::filesystem::file_size(path) <= maximum_file_size(format, points.size()));

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

// What gzip has compressed is read as what it stands for, in every format.
void test_gzip()
{
  std::string floats;
  for (int i = 0; i < 9; ++i)
    floats += bytes_of(float(i), false);
  std::string columns;
  for (const float number : {0.f, 3.f, 6.f, 1.f, 4.f, 7.f, 2.f, 5.f, 8.f})
    columns += bytes_of(number, false);
  const std::vector<Point> three = {Point(0, 1, 2), Point(3, 4, 5), Point(6, 7, 8)};
  const std::string rows = "0 1 2\n3 4 5\n6 7 8\n";
  for (const auto& [extension, bytes] : std::vector<std::pair<std::string, std::string>>{
         {".xyz", rows},
         {".off", "OFF\n3 0 0\n" + rows},
         {".csv", "x y z\n" + rows},
         {".obj", "v 0 1 2\nv 3 4 5\nv 6 7 8\n"},
         {".ply", ply_header("ascii", "element vertex 3\n" + float_xyz) + rows},
         {".ply", ply_header("binary_little_endian", "element vertex 3\n" + float_xyz) + floats},
         {".pcd", pcd_header("", "4 4 4", "F F F", "3", "binary") + floats},
         {".pcd", pcd_header("", "4 4 4", "F F F", "3", "binary_compressed")
                    + pcd_block(36, "\x1f" + columns.substr(0, 32) + "\x03" + columns.substr(32))},
         {".npy", npy_file(npy_header("<f4", "(3, 3)"), floats)}})
  {
    CHECK(read(extension + ".gz", gzip(bytes)).points == three);
    CHECK(read(extension, gzip(bytes)).points == three);   // without the name
    CHECK(read(extension + ".GZ", bytes).points == three); // the name alone
    const std::size_t half = bytes.size() / 2;             // as pigz and cat make it
    CHECK(read(extension, gzip(bytes.substr(0, half)) + gzip(bytes.substr(half))).points == three);
    // The mark that Windows puts before texts, of which the headers of PLY and PCD are one
    const std::string marked = "\xef\xbb\xbf" + bytes;
    if (extension == ".npy")
      CHECK(refusal(extension, marked).status == INPUT_REFUSED);
    else
      CHECK(read(extension, marked).points == three
            && read(extension, gzip(marked)).points == three);
  }
  CHECK(!format_of("scan.gz") && !format_of("scan.doc.gz") && format_of("scan.txt.gz")
        && format_of("a.gz.ply"));
  CHECK(!reason_against_output("scan.ply.gz", File_format::PLY).empty());
  CHECK(failure_of([]() {
          write_points(scratch.file("scan.ply.gz"), File_format::PLY,
                       std::vector<Oriented_point>());
        }).status
        == OUTPUT_NOT_WRITTEN);

  // Files of one byte and of two are read as before
  CHECK(refusal(".xyz", "a").says("a point needs 3 numbers, found 1"));
  CHECK(refusal(".xyz", "ab").says("a point needs 3 numbers, found 1"));

  // More than all buffers hold; the progress is that in the compressed file
  std::string big;
  for (int i = 0; i < 100000; ++i)
    big += std::to_string(i) + " " + std::to_string(i * 7919 % 100000) + " 3\n";
  const std::string path = scratch.file("big.xyz.gz");
  write_bytes(path, gzip(big));
  double last = 0;
  std::size_t backwards = 0;
  const Point_cloud cloud = read_points(path, File_format::XYZ, {}, [&](double share) {
    backwards += share < last || share > 1;
    last = share;
  });
  CHECK(cloud.points.size() == 100000 && cloud.points.back() == Point(99999, 92081, 3));
  CHECK(backwards == 0 && last > 0.5);
}

// Coordinates and normals may be integers of 64 bits in all formats that have these.
void test_wide_coordinates()
{
  const std::vector<std::string> names = {"x", "y", "z", "nx", "ny", "nz"};
  const auto clouds_of = [&](const std::vector<std::int64_t>& row) {
    std::string text, little, big, ply = "element vertex 1\n";
    for (std::size_t k = 0; k < row.size(); ++k)
    {
      text += std::to_string(row[k]) + (k + 1 < row.size() ? " " : "\n");
      little += bytes_of(row[k], false);
      big += bytes_of(row[k], true);
      ply += "property int64 " + names[k] + "\n";
    }
    const auto pcd = [](const std::string& data) {
      return pcd_header(" nx ny nz", "8 8 8 8 8 8", "I I I I I I", "1", data);
    };
    const std::string compressed = pcd_block(
      std::uint32_t(little.size()), char(23) + little.substr(0, 24) + char(23) + little.substr(24));
    std::vector<Point_cloud> clouds;
    for (const auto& [extension, bytes] :
         {std::pair(".ply", ply_header("ascii", ply) + text),
          std::pair(".ply", ply_header("binary_little_endian", ply) + little),
          std::pair(".ply", ply_header("binary_big_endian", ply) + big),
          std::pair(".pcd", pcd("ascii") + text), std::pair(".pcd", pcd("binary") + little),
          std::pair(".pcd", pcd("binary_compressed") + compressed),
          std::pair(".pcd", "VERSION .7\nFIELDS xyz normal\nSIZE 8 8\nTYPE I I\nCOUNT 3 3\n"
                            "POINTS 1\nDATA binary\n"
                              + little),
          std::pair(".npy", npy_file(npy_header("<i8", "(1, 6)"), little)),
          std::pair(".npy", npy_file(npy_header(">i8", "(1, 6)"), big))})
      clouds.push_back(read(extension, bytes, with_everything()));
    return clouds;
  };
  constexpr std::int64_t limit = std::int64_t(1) << 53;
  for (const Point_cloud& cloud : clouds_of({1 - limit, limit - 1, limit, 0, -1, 0}))
  {
    CHECK(cloud.points == (std::vector<Point>{Point(1. - limit, limit - 1., limit)}));
    CHECK(cloud.normals == std::vector<Vector>{Vector(0, -1, 0)} && cloud.warnings.empty());
    CHECK(cloud.coordinate_type == Number_type::FLOAT64 && cloud.properties.properties().empty());
  }
  for (const Point_cloud& cloud : clouds_of({-10 * limit - 1, 5, 10 * limit + 1, 0, 0, 1}))
  {
    CHECK(cloud.points == (std::vector<Point>{Point(-10. * limit, 5, 10. * limit)}));
    CHECK(cloud.warnings.size() == 2);
    CHECK(cloud.warnings[0].find("numbers of 'x' are rounded") != std::string::npos);
    CHECK(cloud.warnings[1].find("numbers of 'z' are rounded") != std::string::npos);
  }
  // Some of them alone, and without a sign
  const Point_cloud mixed = read(
    ".ply", ply_header("binary_little_endian", "element vertex 1\nproperty float x\n"
                                               "property uint64 y\nproperty float z\n")
              + bytes_of(1.f, false) + bytes_of(~std::uint64_t(0), false) + bytes_of(3.f, false));
  CHECK(mixed.points == (std::vector<Point>{Point(1, 18446744073709551616., 3)}));
  CHECK(mixed.warnings.size() == 1 && mixed.coordinate_type == Number_type::FLOAT64);
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
  for (const auto& [extension, bytes] :
       {std::pair<const char*, const char*>{".xyz", "1 2 3\n4 5 6\n7 8 9\n"},
        {".off", "OFF\n3 0 0\n1 2 3\n4 5 6\n7 8 9\n"}})
  {
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
  test_round_trip(File_format::XYZ, ".xyzn");
  test_round_trip(File_format::PCD, ".pcd"); // its numbers need double precision
  test_round_trip(File_format::NPY, ".npy");
  test_gzip();
  test_wide_coordinates();
  test_options();
  return test::result();
}
