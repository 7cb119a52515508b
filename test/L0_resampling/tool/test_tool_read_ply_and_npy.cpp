// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers of PLY and NPY: all types of numbers in either byte order, and all orders of columns.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

template <typename T>
void test_ply_type(const std::string& name)
{
  for (const bool big : {false, true})
  {
    const std::string header =
      ply_header(big ? "binary_big_endian" : "binary_little_endian",
                 "element vertex 2\nproperty uchar flag\nproperty " + name + " x\nproperty " + name
                   + " y\nproperty list ushort int id\nproperty " + name + " z\n");
    std::string body;
    for (int k = 0; k < 2; ++k)
    {
      body += bytes_of(std::uint8_t(9), big) + bytes_of(T(k + 1), big) + bytes_of(T(100), big);
      body += bytes_of(std::uint16_t(k), big); // an empty list and one of length 1
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
  const Point_cloud cloud = read(".ply",
                                 "ply\r\nformat ascii 1.0\r\nelement camera 2\r\nproperty float "
                                 "f\r\nelement vertex 2\r\nproperty double nz\r\n"
                                 "property double x\r\nproperty list uchar int id\r\nproperty "
                                 "double y\r\nproperty double z\r\nproperty double "
                                 "nx\r\n"
                                 "property double ny\r\nelement face 1\r\nproperty list uchar int "
                                 "v\r\nend_header\r\n50\r\n60\r\n"
                                 "6 1 2 7 7 2 3 4 5\r\n-6 +1.5 0 -2e3 .5 -4 -5\r\n3 0 1 0\r\n",
                                 with_normals());
  CHECK(cloud.points == (std::vector<Point>{Point(1, 2, 3), Point(1.5, -2000, .5)}));
  CHECK(cloud.normals == (std::vector<Vector>{Vector(4, 5, 6), Vector(-4, -5, -6)}));

  // The same before binary vertices
  const std::string bytes =
    ply_header("binary_little_endian",
               "element strip 2\nproperty list uint short v\nproperty char c\nelement vertex 1\n"
                 + float_xyz)
    + bytes_of(std::uint32_t(3), false) + "aabbcc" + "c" + bytes_of(std::uint32_t(0), false) + "c"
    + bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(3.f, false);
  CHECK(read(".ply", bytes).points == std::vector<Point>{Point(1, 2, 3)});
  CHECK(read(".ply", bytes + "more").warnings.size() == 1);

  CHECK(read(".ply", ply_header("ascii", "element vertex 0\n" + float_xyz)).points.empty());
  // two of three normal coordinates are no normals
  CHECK(read(".ply",
             ply_header("ascii",
                        "element vertex 1\n" + float_xyz + "property float nx\nproperty float ny\n")
               + "1 2 3 4 5\n",
             with_normals())
          .normals.empty());
}

void test_npy()
{
  for (const bool big : {false, true})
  {
    const std::string order = big ? ">" : "<";
    std::string singles, doubles;
    for (int k = 0; k < 6; ++k)
    {
      singles += bytes_of(float(k) / 3, big);
      doubles += bytes_of(double(k) / 3, big);
    }
    const auto single = [](int k) { return double(float(k) / 3); };
    CHECK(read(".npy", npy_file(npy_header(order + "f4", "(2, 3)"), singles)).points
          == (std::vector<Point>{Point(0, single(1), single(2)), Point(1, single(4), single(5))}));
    CHECK(read(".npy", npy_file(npy_header(order + "f8", "(2,3)"), doubles), with_normals())
            .normals.empty());
    const Point_cloud cloud = read(".npy", npy_file(npy_header(order + "f8", "(1, 6)"), doubles),
                                   with_normals());
    CHECK(cloud.points == std::vector<Point>{Point(0, 1. / 3, 2. / 3)});
    CHECK(cloud.normals == std::vector<Vector>{Vector(1, 4. / 3, 5. / 3)});
    CHECK(read(".npy", npy_file(npy_header(order + "f8", "(1, 3)"), doubles)).warnings.size() == 1);
  }
  // another order of the names, no comma at the end, a long header of version 2
  const std::string header = "{'shape':(0,3),'fortran_order':False,'descr':'<f4'}"
                             + std::string(100, ' ') + "\n";
  CHECK(read(".npy", npy_file(header)).points.empty());
  const std::string version_2 = std::string("\x93NUMPY\x02\x00", 8)
                                + bytes_of(std::uint32_t(header.size()), false) + header;
  CHECK(read(".npy", version_2).points.empty());
}

template <typename T>
void test_npy_integers(const std::string& type)
{
  for (const std::string& order :
       sizeof(T) == 1 ? std::vector<std::string>{"|", "<"} : std::vector<std::string>{"<", ">"})
  {
    const T lowest = (std::numeric_limits<T>::min)(), highest = (std::numeric_limits<T>::max)();
    std::string body;
    for (const T number : {T(1), lowest, highest})
      body += bytes_of(number, order == ">");
    const Point_cloud cloud = read(".npy", npy_file(npy_header(order + type, "(1, 3)"), body));
    CHECK(cloud.points == std::vector<Point>{Point(1, double(lowest), double(highest))});
    CHECK((cloud.coordinate_type == Number_type::FLOAT32) == (sizeof(T) <= 2));
  }
}

// Column by column, as numpy.save() writes the transpose of an array
void test_npy_in_the_order_of_fortran()
{
  const auto header = [](const std::string& shape) {
    return "{'descr': '<f8', 'fortran_order': True, 'shape': " + shape + ", }\n";
  };
  std::string doubles;
  for (int k = 0; k < 12; ++k)
    doubles += bytes_of(double(k), false);
  const std::string points = npy_file(header("(4, 3)"), doubles);
  CHECK(read(".npy", points).points
        == (std::vector<Point>{Point(0, 4, 8), Point(1, 5, 9), Point(2, 6, 10), Point(3, 7, 11)}));
  const Point_cloud cloud = read(".npy", npy_file(header("(2, 6)"), doubles), with_normals());
  CHECK(cloud.points == (std::vector<Point>{Point(0, 2, 4), Point(1, 3, 5)}));
  CHECK(cloud.normals == (std::vector<Vector>{Vector(6, 8, 10), Vector(7, 9, 11)}));
  CHECK(read(".npy", npy_file(header("(0, 3)"))).points.empty());
  CHECK(read(".npy", points + "more").warnings.size() == 1);

  const std::size_t n = 20000; // more than a block of the file
  std::string many;
  for (std::size_t k = 0; k < 3 * n; ++k)
    many += bytes_of(double(k), false);
  const Point_cloud large = read(".npy", npy_file(header("(20000, 3)"), many));
  CHECK(large.points.size() == n && large.points.back() == Point(n - 1, 2 * n - 1, 3 * n - 1));

  // The columns take memory too
  Read_options options;
  options.max_memory = 4 * sizeof(Point) + 96;
  CHECK(read(".npy", points, options).points.size() == 4);
  --options.max_memory;
  CHECK(refusal(".npy", points, options).status == RUN_TIME_FAILURE);
}

} // namespace

int main()
{
  test_ply();
  test_npy();
  test_npy_integers<std::int8_t>("i1");
  test_npy_integers<std::uint8_t>("u1");
  test_npy_integers<std::int16_t>("i2");
  test_npy_integers<std::uint16_t>("u2");
  test_npy_integers<std::int32_t>("i4");
  test_npy_integers<std::uint32_t>("u4");
  test_npy_integers<std::int64_t>("i8");
  test_npy_integers<std::uint64_t>("u8");
  test_npy_in_the_order_of_fortran();
  return test::result();
}
