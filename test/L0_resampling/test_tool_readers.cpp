// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers and writers of l0_resample: every format gives the points that are in the file.

#include "test_support.h"
#include "test_tool_gzip.h"
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

Point_cloud read(const std::string& extension, const std::string& bytes,
                 const Read_options& options = {})
{
  return tool_test::read(scratch, extension, bytes, options);
}

Failure_seen refusal(const std::string& extension, const std::string& bytes,
                     const Read_options& options = {})
{
  return failure_of([&]() { read(extension, bytes, options); });
}

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

void test_off()
{
  CHECK(read(".off", "OFF\n# corners\n2 1 0\n\n0 0 .5 255 0 0\n 1 2 3\n3 0 1 1\n").points
        == (std::vector<Point>{Point(0, 0, .5), Point(1, 2, 3)}));
  CHECK(read(".OFF", "OFF 1 0 0 # on one line\n1 2 3").points
        == std::vector<Point>{Point(1, 2, 3)});
  CHECK(read(".off", "STCNOFF\n1 0 0\n1 2 3 4 5 6 7 8 9\n", with_normals()).normals
        == std::vector<Vector>{Vector(4, 5, 6)});
  CHECK(read(".off", "OFF\n1 0 0\n1 2 3 4 5 6\n", with_normals()).normals.empty());
}

void test_xyz()
{
  CHECK(read(".xyz", "# x y z\n1 2 3\n\n\t-1e1\t+0.5 3 \r\n4 5 6").points
        == (std::vector<Point>{Point(1, 2, 3), Point(-10, .5, 3), Point(4, 5, 6)}));
  CHECK(read(".pwn", "2\n1 2 3 0 0 1\n7 8 9 .6 -.8 0\n", with_normals()).normals
        == (std::vector<Vector>{Vector(0, 0, 1), Vector(.6, -.8, 0)}));
  CHECK(read(".xyz", "1 2 3 a\n1 2 3 b\n", with_normals()).normals.empty());
  CHECK(read(".xyz", "1\n1 2 3\n4 5 6\n").warnings.size() == 1);
  CHECK(read(".xyz", "0\n").points.empty());
  CHECK(refusal(".xyz", "").says("line 1: the file has no points"));
  CHECK(refusal(".xyz", "# x y z\n\n").status == INPUT_REFUSED);
}

void test_csv()
{
  Read_options everything = with_normals();
  everything.with_properties = true;
  const std::vector<Point> two = {Point(1, 2, 3), Point(-10, .5, 4)};
  const auto names_of = [](const Point_cloud& cloud) {
    std::string names;
    for (const Property& property : cloud.properties.properties())
      names += property.name + " ";
    return names;
  };
  const auto value = [](const Point_cloud& cloud, std::size_t i, std::size_t property) {
    return cloud.properties.value(i, cloud.properties.properties()[property]);
  };

  // Separators, quotes, blanks, an order of columns, lines that are empty or comments
  for (const char* text :
       {"x,y,z\n1,2,3\n-1e1,+.5,4\n", "# made by a program\n# X;Y;Z\n\n1; 2;3\n# half\n-10;0.5;4",
        "//X\tY\tZ\r\n1\t2\t3\r\n-10\t.5\t4\r\n", "x  y z\n 1 2  3 \n-10 .5 4\n",
        "\xef\xbb\xbf\"z\", \"x\" ,y\n\"3\",1,2\n4,\"-10\",0.5\n",
        "Points:0,Points:1,Points:2\n1,2,3\n-10,.5,4\n"})
  {
    CHECK(read(".csv", text).points == two);
    CHECK(read(".CSV", text, everything).warnings.empty());
  }

  // Normals, a color, a missing value, an empty name, a text and a name that is there twice
  const std::string table =
    "X,Normal_X,Normal_Y,Normal_Z,Y,Z,R,G,B,\"Scalar \"\"f\"\"\",class,,n,n\n"
    "1,0,0,1,2,3,255,0,7,0.5,\"a, b\",8,4,5\n"
    "-10,0,1,0,.5,4,1,2,3,,c,8,6,7\n";
  const Point_cloud cloud = read(".csv", table, everything);
  CHECK(cloud.points == two);
  CHECK(cloud.normals == (std::vector<Vector>{Vector(0, 0, 1), Vector(0, 1, 0)}));
  CHECK(names_of(cloud) == "red green blue Scalar___f__ n ");
  CHECK(cloud.properties.properties()[0].type == Number_type::UINT8 && value(cloud, 0, 0) == 255);
  CHECK(value(cloud, 0, 3) == .5 && std::isnan(value(cloud, 1, 3)) && value(cloud, 1, 4) == 6);
  CHECK(cloud.warnings.size() == 2);
  CHECK(cloud.warnings[0].find("'n' is left out: another one has that name") != std::string::npos);
  CHECK(cloud.warnings[1].find("'class' is left out: 'a, b' is not a") != std::string::npos);
  CHECK(read(".csv", table).warnings.empty());
  const Point_cloud no_color = read(".csv", "x,y,z,r,nx\n1,2,3,4,5\n", everything);
  CHECK(names_of(no_color) == "r " && no_color.normals.empty() && no_color.warnings.size() == 1);
  CHECK(read(".csv", "x,y,z\n").points.empty());

  Read_options options;
  options.drop_non_finite = true;
  CHECK(read(".csv", "x,y,z\n1,2,3\n4,,6\n-10,.5,4\n", options).points == two);
  CHECK(read(".csv", "x,y,z\n1,2,3\n4,,6\n-10,.5,4\n", options).number_of_dropped_points == 1);

  // Names from the command line, with a header or without
  options = {};
  options.columns = {"z", "-", "y", "x"};
  const std::string rows = "3;a;2;1\n4;b;.5;-10\n";
  CHECK(read(".csv", rows, options).points == two);
  CHECK(read(".csv", "# x;y;z;w\n" + rows, options).points == two);
  CHECK(read(".csv", "height;id;north;east\n" + rows, options).points == two);
}

void test_obj()
{
  Read_options everything = with_normals();
  everything.with_properties = true;
  const std::vector<Point> two = {Point(1, 2, 3), Point(-10, .5, 4)};
  const std::vector<Vector> normals = {Vector(0, 0, 1), Vector(0, 2, 0)};
  const Point_cloud cloud =
    read(".obj",
         "# a mesh\r\nmtllib a.mtl\no part\nv 1 2 3\nvt 0 0\n\nv  -1e1\t+.5 4 1\n"
         "vn 0 0 1\nvn 0 2 0\nvp 1 2\nf 1//1 2//2 1//1\n",
         everything);
  CHECK(cloud.points == two && cloud.normals == normals && cloud.file_has_normals);
  CHECK(cloud.warnings.empty() && cloud.properties.properties().empty());
  CHECK(read(".obj", "vn 0 0 1\nv 1 2 3\nvn 0 2 0\nv -10 .5 4").normals.empty());
  CHECK(read(".obj", "vn 0 0 1\nv 1 2 3\nvn 0 2 0\nv -10 .5 4", with_normals()).normals == normals);

  const Point_cloud fewer = read(".obj", "v 1 2 3\nv -10 .5 4\nvn 0 0 1\n", everything);
  CHECK(fewer.points == two && fewer.normals.empty() && !fewer.file_has_normals);
  CHECK(fewer.warnings.size() == 1
        && fewer.warnings[0].find("the 1 normals are left out, as there are 2 points")
             != std::string::npos);
  CHECK(read(".obj", "v 1 2 3\nv -10 .5 4\nvn 0 0 1\n").warnings.empty());

  // Normals stay with their points where others are dropped
  everything.drop_non_finite = true;
  const Point_cloud dropped = read(".obj",
                                   "v nan 0 0\nv 1 2 3\nv 0 inf 0\nv -10 .5 4\nvn 1 0 0\n"
                                   "vn 0 0 1\nvn 3 0 0\nvn 0 2 0\n",
                                   everything);
  CHECK(dropped.points == two && dropped.normals == normals);
  CHECK(dropped.number_of_dropped_points == 2);

  const Point_cloud colored = read(".obj", "v 1 2 3 .5 0 1\nv -10 .5 4 1 0 .25 1\n", everything);
  CHECK(colored.points == two && colored.properties.properties().size() == 3);
  const auto channel = [&](std::size_t i, std::size_t k) {
    return colored.properties.value(i, colored.properties.properties()[k]);
  };
  CHECK(colored.properties.properties()[0].name == "red");
  CHECK(channel(0, 0) == .5 && channel(0, 2) == 1 && channel(1, 0) == 0 && channel(1, 1) == .25);

  Read_options options = with_normals();
  options.max_memory = 3 * sizeof(Point);
  CHECK(read(".obj", "v 1 2 3\nvn 0 0 1\nvn 0 2 0\n", options).points.size() == 1);
  CHECK(refusal(".obj", "v 1 2 3\nvn 0 0 1\nvn 0 2 0\nvn 1 0 0\n", options).status
        == RUN_TIME_FAILURE);
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
  }
  CHECK(!format_of("scan.gz") && !format_of("scan.txt.gz") && format_of("a.gz.ply"));
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

std::string repeated(int times, const std::string& line)
{
  std::string text;
  for (int i = 0; i < times; ++i)
    text += line;
  return text;
}

// Vectors of a text are normals if nearly all of them have unit length.
void test_vectors_of_xyz()
{
  const std::string unit = "1 2 3 0 .6 -.8\n", nearly = "1 2 3 .58 .58 .58\n",
                    zero = "1 2 3 0 0 0\n";
  const std::string short_one = "1 2 3 0 0 .98\n", color = "1 2 3 200 100 0\n",
                    none = "1 2 3 nan 0 1\n";
  const auto are_normals = [](const std::string& text) {
    const Point_cloud cloud = read(".xyz", text, with_normals());
    const bool are = !cloud.normals.empty();
    CHECK(cloud.normals.size() == (are ? cloud.points.size() : 0));
    CHECK(cloud.warnings.size() == (are ? 0 : 1));
    CHECK(are || cloud.warnings.front().find("--columns") != std::string::npos);
    return are;
  };
  CHECK(are_normals(repeated(19, unit) + color));
  CHECK(are_normals(repeated(18, nearly) + repeated(100, zero) + unit + none));
  CHECK(!are_normals(repeated(18, unit) + color));
  CHECK(!are_normals(repeated(18, unit) + short_one));
  CHECK(!are_normals(repeated(18, unit) + none));
  CHECK(!are_normals(zero));

  Read_options options = with_normals();
  options.columns = {"x", "y", "z", "nx", "ny", "nz"};
  CHECK(read(".xyz", color, options).normals == std::vector<Vector>{Vector(200, 100, 0)});
}

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
    for (const float number : {0.f, -1.f, float(k), 9.f})
      body += bytes_of(number, false);
  }
  const Point_cloud cloud = read(".pcd", header + body, with_normals());
  CHECK(cloud.points == (std::vector<Point>{Point(1, 2, 3), Point(1, 2, 4)}));
  CHECK(cloud.normals == (std::vector<Vector>{Vector(0, -1, 0), Vector(0, -1, 1)}));
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
    return read(".pcd", file.replace(file.find(line), line.size(), words)).viewpoint;
  };
  CHECK(viewpoint_of("VIEWPOINT 1 -2.5 3e1 1 0 0 0") == (std::array<double, 3>{1, -2.5, 30}));
  CHECK(viewpoint_of("VIEWPOINT 0 0 1") == (std::array<double, 3>{0, 0, 1})); // of version 0.6
  for (const char* nowhere : {"VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT", "VIEWPOINT 1 2", "#",
                              "VIEWPOINT 1 2,5 3 1 0 0 0", "VIEWPOINT nan 0 1 1 0 0 0"})
    CHECK(!viewpoint_of(nowhere));
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
  test_ply();
  test_off();
  test_xyz();
  test_vectors_of_xyz();
  test_csv();
  test_obj();
  test_gzip();
  test_pcd();
  test_compressed_pcd();
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
  test_precision_of_pcd();
  test_options();
  return test::result();
}
