// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The reader of PLY: all types of numbers in either byte order, and all orders of properties.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
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
                                 "-.6 1 2 7 7 2 3 .8 0\r\n-1 +1.5 0 -2e3 .5 0 0\r\n3 0 1 0\r\n",
                                 with_normals());
  CHECK(cloud.points == (std::vector<Point>{Point(1, 2, 3), Point(1.5, -2000, .5)}));
  CHECK(cloud.normals == (std::vector<Vector>{Vector(.8, 0, -.6), Vector(0, 0, -1)}));

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

// Names as other programs give them, and types that PLY has not
void test_ply_of_others()
{
  const std::vector<Point> one = {Point(1, 2, 3)};
  const std::vector<Vector> down = {Vector(0, 0, -1)};
  for (const char* names :
       {"X Y Z nx ny nz", "x y z normal_x normal_y normal_z", "x y z NormalX NormalY NormalZ",
        "x y z Nx Ny Nz", "x y z scalar_Nx scalar_Ny scalar_Nz",
        "X Y Z scalar_nx scalar_ny scalar_nz"})
  {
    std::string header = "element vertex 1\n";
    std::istringstream words(names);
    for (std::string name; words >> name;)
      header += "property float " + name + "\n";
    header += "property uchar Red\nproperty uchar Green\nproperty uchar Blue\n";
    const Point_cloud cloud = read(".ply", ply_header("ascii", header) + "1 2 3 0 0 -1 9 8 7\n",
                                   with_everything());
    CHECK(cloud.points == one && cloud.normals == down && cloud.warnings.empty());
    CHECK(cloud.properties.properties().size() == 3);
    CHECK(cloud.properties.properties()[2].name == "blue");
  }
  // x goes before X, and a red alone is no color
  const Point_cloud both = read(".ply",
                                ply_header("ascii", "element vertex 1\n" + float_xyz
                                                      + "property float X\nproperty int R\n")
                                  + "1 2 3 4 5\n",
                                with_everything());
  CHECK(both.points == one && both.properties.properties()[0].name == "X");
  CHECK(both.properties.properties()[1].name == "R");

  for (const bool big : {false, true})
  {
    const std::string header =
      "element vertex 2\nproperty bool inlier\n" + float_xyz
      + "property int64 id\nproperty list uint64 int64 all\nproperty uint64 time\n"
        "property uchar kind\n";
    std::string body;
    for (const std::uint8_t kind : {3, 4})
      body += bytes_of(std::uint8_t(1), big) + bytes_of(1.f, big) + bytes_of(2.f, big)
              + bytes_of(3.f, big) + bytes_of(std::int64_t(-1), big)
              + bytes_of(std::uint64_t(kind - 3), big)
              + (kind == 4 ? bytes_of(std::int64_t(7), big) : "") + bytes_of(std::uint64_t(5), big)
              + bytes_of(kind, big);
    const Point_cloud cloud =
      read(".ply", ply_header(big ? "binary_big_endian" : "binary_little_endian", header) + body,
           with_everything());
    CHECK(cloud.points == (std::vector<Point>{one[0], one[0]}) && cloud.warnings.size() == 2);
    CHECK(cloud.warnings[0].find("'inlier' is left out: numbers of type 'bool'")
          != std::string::npos);
    CHECK(cloud.properties.properties().size() == 3
          && cloud.properties.value(1, *cloud.properties.find("kind")) == 4
          && cloud.properties.value(1, *cloud.properties.find("id")) == -1
          && cloud.properties.value(1, *cloud.properties.find("time")) == 5);
    CHECK(read(".ply", ply_header("ascii", header)
                         + "true 1 2 3 -1 1 9 5 3\nfalse 1 2 3 18446744073709551615 0 5 4\n")
            .points.size()
          == 2);
  }
  // Types of C, of one of which the size is not known
  const std::string of_c = "property uint8_t red\nproperty int64_t id\nproperty INT16_T level\n";
  const Point_cloud c =
    read(".ply",
         ply_header("binary_little_endian", "element vertex 1\n" + float_xyz + of_c)
           + bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(3.f, false)
           + bytes_of(std::uint8_t(7), false) + bytes_of(std::int64_t(9), false)
           + bytes_of(std::int16_t(-5), false),
         with_everything());
  CHECK(c.points == one && c.properties.value(0, *c.properties.find("red")) == 7);
  CHECK(c.properties.value(0, *c.properties.find("level")) == -5 && c.warnings.empty());
  CHECK(c.properties.value(0, *c.properties.find("id")) == 9);
  CHECK(refusal(".ply", ply_header("binary_little_endian",
                                   "element vertex 1\n" + float_xyz + "property long id\n"))
          .says("'long' is not a type of PLY"));
  for (const std::string type : {"bool", "half"})
    CHECK(refusal(".ply", ply_header("ascii", "element vertex 1\nproperty " + type
                                                + " x\nproperty int y\nproperty int z\n")
                            + "1 2 3\n")
            .says("the property x is of type '" + type + "'"));

  const std::string text = ply_header("ascii", "element vertex 1\n" + float_xyz) + "1 2 3\n";
  CHECK(read(".ply", "ply \t\n" + text.substr(4)).points == one);
  CHECK(read(".ply", "PLY\n" + text.substr(4)).points == one);
  for (const char* name : {"Vertex", "vertices", "point", "Points"})
    CHECK(read(".ply",
               ply_header("ascii", "element " + std::string(name) + " 1\n" + float_xyz) + "1 2 3\n")
            .points
          == one);
  // Before others that may hold points comes the one that has the name
  CHECK(read(".ply",
             ply_header("ascii", "element point 1\n" + float_xyz + "element vertex 1\n" + float_xyz)
               + "4 5 6\n1 2 3\n")
          .points
        == one);

  // Lines that end with CR alone, before numbers in bytes too
  std::string old_lines = ply_header("binary_little_endian", "element vertex 1\n" + float_xyz);
  std::replace(old_lines.begin(), old_lines.end(), '\n', '\r');
  CHECK(read(".ply", old_lines + bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(3.f, false))
          .points
        == one);

  // Texts hold any type, and numbers that are not written as those of their type
  const std::string mixed = "element vertex 1\n" + float_xyz
                            + "property string name\nproperty Float32 q\nproperty int label\n"
                              "property uchar kind\nproperty float none\n";
  const Point_cloud odd = read(
    ".ply", ply_header("ascii", mixed) + "1 2 3 abc 1e-60 -7.0 2.0 -1.#IND\n", with_everything());
  CHECK(odd.points == one && odd.warnings.size() == 1);
  CHECK(odd.warnings[0].find("'name' is left out: numbers of type 'string'") != std::string::npos);
  const auto value = [&](std::size_t k) {
    return odd.properties.value(0, odd.properties.properties()[k]);
  };
  CHECK(value(0) == 0 && value(1) == -7 && value(2) == 2 && std::isnan(value(3)));
  for (const char* kind : {"2.5", "256.0", "-1.0", "1e9", "nan"})
    CHECK(refusal(".ply", ply_header("ascii", mixed) + "1 2 3 abc 1 7 " + kind + " 0\n",
                  with_everything())
            .says("is not a number of the type of 'kind'"));
  CHECK(refusal(".ply", ply_header("binary_big_endian", mixed))
          .says("'string' is not a type of PLY; one of its size, such as int or int64, can take"));
  CHECK(refusal(".ply", ply_header("ascii", "element vertex 1\n" + float_xyz
                                              + "property list uchar string names\n"))
          .says("'string' is not a type"));
  CHECK(read(".ply", text + "\n").warnings.empty());
  CHECK(read(".ply", text + "\r\n \n").warnings.empty());
  CHECK(read(".ply", text + "\n4 5 6\n").warnings.size() == 1);
}

// Bytes and numbers of other lengths are no normals, in either byte order.
void test_normals_of_ply_that_are_none()
{
  for (const bool big : {false, true})
    for (const bool are_bytes : {false, true})
    {
      const std::string type = are_bytes ? "uchar" : "float";
      std::string header = "element vertex 20\n" + float_xyz, body;
      for (const char* name : {"nx", "ny", "nz"})
        header += "property " + type + " " + name + "\n";
      for (int i = 0; i < 20; ++i)
      {
        for (int k = 0; k < 3; ++k)
          body += bytes_of(float(i), big);
        for (const int channel : {255, 128, i})
          body += are_bytes ? bytes_of(std::uint8_t(channel), big) : bytes_of(float(channel), big);
      }
      const Point_cloud cloud =
        read(".ply", ply_header(big ? "binary_big_endian" : "binary_little_endian", header) + body,
             with_everything());
      CHECK(cloud.points.size() == 20 && cloud.normals.empty() && !cloud.file_has_normals);
      CHECK(cloud.warnings.size() == 1
            && cloud.warnings[0].find("they are no unit vectors") != std::string::npos);
      CHECK(cloud.properties.properties().empty());
    }
}

// The camera of a file is the viewpoint, as that of PCD is.
void test_camera_of_ply()
{
  const std::string vertices = "element vertex 2\n" + float_xyz,
                    faces = "element face 1\nproperty list uchar int v\n";
  const auto camera = [](int count, const std::string& last) {
    return "element camera " + std::to_string(count)
           + "\nproperty float view_px\nproperty float view_py\nproperty float " + last
           + "\nproperty int viewportx\n";
  };
  const std::string points = "1 2 3\n4 5 6\n", triangle = "3 0 1 0\n", place = "7 -8 9 640\n";
  const auto read_ascii = [](const std::string& elements, const std::string& rows) {
    return read(".ply", ply_header("ascii", elements) + rows, with_everything());
  };
  const std::array<double, 3> expected = {7, -8, 9};
  for (const Point_cloud& cloud :
       {read_ascii(vertices + camera(1, "view_pz"), points + place),
        read_ascii(camera(1, "view_pz") + vertices, place + points),
        read_ascii(vertices + faces + camera(1, "view_pz"), points + triangle + place)})
  {
    CHECK(cloud.viewpoint == expected && cloud.points.size() == 2);
    CHECK(cloud.points[1] == Point(4, 5, 6));
  }
  CHECK(read_ascii(vertices + camera(1, "view_pz"), points + place).warnings.empty());
  CHECK(!read_ascii(vertices + camera(1, "view_pz"), points + "0 0 0 640\n").viewpoint);
  for (const char* nowhere : {"nan 0 1 640\n", "1 inf 1 640\n", "1 0 -inf 640\n"})
  {
    const Point_cloud cloud = read_ascii(vertices + camera(1, "view_pz"), points + nowhere);
    CHECK(!cloud.viewpoint && cloud.warnings.size() == 1);
    CHECK(cloud.warnings[0].find("camera is not finite, so it is not used") != std::string::npos);
  }
  CHECK(!read_ascii(vertices + camera(1, "view_pz"), points + "0 1e-9 0 640\n").viewpoint);
  CHECK(!read_ascii(vertices + camera(2, "view_pz"), points + place + place).viewpoint);
  CHECK(!read_ascii(vertices + camera(1, "view_xz"), points + place).viewpoint);
  const std::string binary = ply_header("binary_big_endian", vertices + camera(1, "view_pz"));
  std::string body;
  for (const float number : {1.f, 2.f, 3.f, 4.f, 5.f, 6.f, 7.f, -8.f, 9.f})
    body += bytes_of(number, true);
  CHECK(read(".ply", binary + body + "size").viewpoint == expected);

  const std::string wide = "element camera 1\nproperty int64 view_px\nproperty int64 view_py\n"
                           "property uint64 view_pz\n";
  CHECK(read_ascii(vertices + wide, points + "7 -8 9\n").viewpoint == expected);
  CHECK(read(".ply", ply_header("binary_big_endian", vertices + wide) + body.substr(0, 24)
                       + bytes_of(std::int64_t(7), true) + bytes_of(std::int64_t(-8), true)
                       + bytes_of(std::uint64_t(9), true))
          .viewpoint
        == expected);
}

} // namespace

int main()
{
  test_ply();
  test_ply_of_others();
  test_normals_of_ply_that_are_none();
  test_camera_of_ply();
  return test::result();
}
