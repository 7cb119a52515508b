// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is written as LAS: scales that move no point far, and properties where they are read again.

#include "test_support.h"
#include "tool/test_tool_las.h"

#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using namespace l0_tool;
using namespace tool_test;

/// Random points of a square with a side of `side`, on average 1 from the next.
Point_cloud random_square(double side, const Vector& shift)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, side);
  Point_cloud cloud;
  for (int i = 0; i < int(side * side); ++i)
    cloud.points.push_back(Point(coordinate(random), coordinate(random), 0) + shift);
  return cloud;
}

double maximum_move(const Point_cloud& cloud, const std::string& bytes)
{
  const Point_cloud found = read_las(bytes);
  CHECK(found.points.size() == cloud.points.size());
  double largest = 0;
  for (std::size_t i = 0; i < found.points.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      largest = (std::max)(largest, std::abs(found.points[i][axis] - cloud.points[i][axis]));
  return largest;
}

// Roundings are small beside the spacing of points, wherever these are and of whatever size.
void test_scales()
{
  const Vector utm(637012.34, 5849028.33, 120);
  Point_cloud square = random_square(60, utm);
  std::string bytes = written(square);
  CHECK(double_at(bytes, 131) == 0.001); // the largest power of ten below 2/1000 of a spacing
  CHECK(maximum_move(square, bytes) <= 1e-3 * 0.51);
  CHECK(std::abs(double_at(bytes, 155) - 637042) <= 1 && double_at(bytes, 163) == 5849058);

  for (const double factor : {1e-280, 1e-20, 3e-3, 1e20, 1e280})
  {
    Point_cloud scaled = square;
    for (std::size_t i = 0; i < square.points.size(); ++i)
      scaled.points[i] = CGAL::ORIGIN
                         + factor * (square.points[i] - Point(637012.34, 5849028.33, 0));
    CHECK(maximum_move(scaled, written(scaled)) <= factor * 1e-3);
  }

  // The scale of the input, where it is fine enough, per axis
  square.las = Las_origin();
  square.las->scale = {0.00025, 0.01, 0.0001};
  bytes = written(square);
  CHECK(double_at(bytes, 131) == 0.00025 && double_at(bytes, 139) == 0.001
        && double_at(bytes, 147) == 0.0001);
  CHECK(maximum_move(square, bytes) <= 1e-3 * 0.51);
  square.las->scale = {1e-9, 1e-9, 1e-9}; // too fine for 32 bits
  bytes = written(square);
  CHECK(double_at(bytes, 131) == 1e-7 && maximum_move(square, bytes) <= 1e-7);

  // An outlier takes what 32 bits can give
  square.las.reset();
  square.points.emplace_back(1e12, 0, 0);
  CHECK(maximum_move(square, written(square)) <= 1e12 / 4e8);
  // One place, and no spacing that says what is small
  Point_cloud place;
  place.points = {Point(0.1, 1e9 / 3, -1e-9)};
  CHECK(maximum_move(place, written(place)) == 0);
  place.points.assign(20, place.points[0]);
  CHECK(maximum_move(place, written(place)) == 0);
  place.points.insert(place.points.end(), 20, Point(7, 7, 7));
  CHECK(maximum_move(place, written(place)) <= 1e9 / 2e8);
  place.points = {Point(-1.7e308, 0, 1e-320), Point(1.7e308, 1e-320, 0)};
  CHECK(std::isfinite(maximum_move(place, written(place))));
  CHECK(read_las(written(Point_cloud())).points.empty());

  place.points = {Point(0, std::nan(""), 0)};
  const Failure_seen seen = failure_of([&]() { written(place); });
  CHECK(seen.status == OUTPUT_NOT_WRITTEN && seen.says("LAS cannot hold a coordinate"));
}

// What has no place in a field becomes extra bytes, and all of it is read again.
void test_properties_of_others()
{
  const std::string elements = "element vertex 2\n" + float_xyz
                               + "property float nx\nproperty float ny\nproperty float nz\n"
                                 "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                                 "property uchar alpha\nproperty float intensity\n"
                                 "property int classification\nproperty ushort return_number\n"
                                 "property double quality\nproperty ushort nir\n"
                                 "property uchar a_name_that_is_longer_than_32_bytes\n"
                                 "property float NormalX\nproperty int quality\n";
  const Point_cloud cloud = tool_test::read(
    ".ply",
    ply_header("ascii", elements)
      + "1 2 3 0 0 1 255 0 9 8 0.25 255 16 0.1 77 1 5 1\n4 5 6 1 0 0 1 2 3 4 1 0 1 0.2 78 2 6 1\n",
    everything());
  const std::string bytes = written(cloud,
                                    {"a_name_that_is_longer_than_32_bytes", "NormalX", "quality"});
  CHECK(integer_at(bytes, 24, 2) == 0x0401 && integer_at(bytes, 104, 1) == 8);
  CHECK(integer_at(bytes, 6, 2) == 16 && bytes.substr(58, 11) == "l0_resample");
  CHECK(integer_at(bytes, 90, 4) == 0); // no day
  CHECK(integer_at(bytes, 105, 2) == 38 + 3 * 4 + 1 + 4 + 2 + 8);
  const Point_cloud found = read_las(bytes);
  CHECK(found.normals == cloud.normals);
  std::map<std::string, double> all = values(found, 0);
  CHECK(all["red"] == 65535 && all["green"] == 0 && all["blue"] == 9 * 257 && all["alpha"] == 8);
  CHECK(all["intensity"] == 0.25); // not whole
  CHECK(all["classification"] == 255);
  CHECK(all["return_number"] == 16); // beyond four bits
  CHECK(all["number_of_returns"] == 1);
  CHECK(all["quality"] == 0.1 && all["nir"] == 77);
  CHECK(values(found, 1)["intensity"] == 1);

  // As many as a record can describe
  Point_cloud many;
  many.points = {Point(1, 2, 3)};
  for (int k = 0; k < 400; ++k)
    many.properties.add_property("p" + std::to_string(k), Number_type::FLOAT64);
  many.properties.append(std::vector<char>(many.properties.row_size()).data());
  std::vector<std::string> rest;
  for (int k = 341; k < 400; ++k)
    rest.push_back("p" + std::to_string(k));
  CHECK(read_las(written(many, rest)).properties.properties().size() == 12 + 341);
}

// Oriented points, as the result of a run.
void test_result()
{
  Resampled_points result;
  for (int i = 0; i < 100; ++i)
    result.points.emplace_back(Point(i % 10 + 0.1234567, i / 10, 0), Vector(0, 0, 1));
  result.las = Las_origin();
  result.las->point_format = 3;
  result.las->scale = {0.01, 0.01, 0.01};
  const std::string path = scratch.file("result.las");
  setenv("SOURCE_DATE_EPOCH", "1709164800", 1); // 2024-02-29
  CHECK(write_points(path, File_format::LAS, result).empty());
  unsetenv("SOURCE_DATE_EPOCH");
  const std::string bytes = read_bytes(path);
  CHECK(integer_at(bytes, 90, 2) == 60 && integer_at(bytes, 92, 2) == 2024);
  CHECK(integer_at(bytes, 24, 2) == 0x0201 && integer_at(bytes, 104, 1) == 0);
  CHECK(integer_at(bytes, 107, 4) == 100 && integer_at(bytes, 111, 4) == 100); // first returns
  CHECK(double_at(bytes, 131) == 0.001);                                       // which 0.01 is not
  const Point_cloud cloud = read_las(bytes);
  CHECK(cloud.normals == std::vector<Vector>(100, Vector(0, 0, 1)));
  double largest = 0;
  for (std::size_t i = 0; i < 100; ++i)
    largest = (std::max)(largest, std::abs(cloud.points[i].x() - result.points[i].first.x()));
  CHECK(largest > 0 && largest <= 1e-3);
  // The box of the header is that of the points as they are rounded
  CHECK(double_at(bytes, 187) == cloud.points[0].x() && double_at(bytes, 203) == 0);
  write_points(path, File_format::LAS, result);
  CHECK(read_bytes(path).substr(94) == bytes.substr(94)
        && integer_at(read_bytes(path), 90, 4) == 0);

  CHECK(failure_of([&]() {
          write_points(scratch.file("result.laz"), File_format::LAS, result);
        }).says("LAZ is not written"));
}

} // namespace

int main()
{
  test_scales();
  test_properties_of_others();
  test_result();
  return test::result();
}
