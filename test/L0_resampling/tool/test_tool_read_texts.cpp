// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers of OFF, XYZ, CSV and OBJ: what stands in a text is read, whatever separates it.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

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

void test_csv()
{
  const Read_options everything = with_everything();
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
  Read_options everything = with_everything();
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

} // namespace

int main()
{
  test_off();
  test_xyz();
  test_vectors_of_xyz();
  test_csv();
  test_obj();
  return test::result();
}
