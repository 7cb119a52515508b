// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers of OFF and OBJ: what stands in a text is read, and normals are those of the faces.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  CHECK(read(".off", "STCNOFF\n1 0 0\n1 2 3 0 0 -1 7 8 9\n", with_normals()).normals
        == std::vector<Vector>{Vector(0, 0, -1)});
  CHECK(read(".off", "OFF\n1 0 0\n1 2 3 4 5 6\n", with_normals()).normals.empty());
  // As the meshes of ModelNet have it, and other programs
  for (const char* begin : {"OFF1 0 0\n", "off\n1 0 0\n", "OFF 1 0 0\n"})
    CHECK(read(".off", begin + std::string("1 2 3\n")).points
          == std::vector<Point>{Point(1, 2, 3)});
  CHECK(read(".off", "NCOFF\n1 0 0\n1 2 3 0 0 -1 7 8 9\n", with_normals()).normals
        == std::vector<Vector>{Vector(0, 0, -1)});
}

void test_obj()
{
  Read_options everything = with_everything();
  const std::vector<Point> two = {Point(1, 2, 3), Point(-10, .5, 4)};
  const std::vector<Vector> normals = {Vector(0, 0, 1), Vector(0, 1, 0)};
  const Point_cloud cloud =
    read(".obj",
         "# a mesh\r\nmtllib a.mtl\no part\nv 1 2 3\nvt 0 0\n\nv  -1e1\t+.5 4 1\n"
         "vn 0 0 1\nvn 0 1 0\nvp 1 2\nf 1//1 2//2 1//1\n",
         everything);
  CHECK(cloud.points == two && cloud.normals == normals && cloud.file_has_normals);
  CHECK(cloud.warnings.empty() && cloud.properties.properties().empty());
  CHECK(read(".obj", "vn 0 0 1\nv 1 2 3\nvn 0 2 0\nv -10 .5 4").normals.empty());
  CHECK(read(".obj", "vn 0 0 1\nv 1 2 3\nvn 0 1 0\nv -10 .5 4", with_normals()).normals == normals);

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
                                   "vn 0 0 1\nvn -1 0 0\nvn 0 1 0\n",
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

// Faces say which normal is that of which vertex, in all the ways that they have for it.
void test_normals_of_obj_faces()
{
  const auto normals_of = [](const std::string& text) {
    return read(".obj", text, with_normals()).normals;
  };
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
                    normals = "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\n";
  const std::vector<Vector> turned = {Vector(1, 0, 0), Vector(0, 0, 1), Vector(0, 1, 0)};
  CHECK(normals_of(vertices + normals + "f 1//3 2//1 3//2\n") == turned);
  CHECK(normals_of(vertices + normals + "f 1/7/3 2/8/1 3/9/2\n") == turned);
  CHECK(normals_of(vertices + normals + "f -3//-1 -2//-3 -1//-2\n") == turned);
  CHECK(normals_of(vertices + "f 1//3 2//1 3//2\n" + normals) == turned); // named before they come
  CHECK(normals_of(vertices + normals + "f 1//3 \\\n2//1 3//2\n") == turned);
  CHECK(normals_of("v 9 9 9\nvn 0 0 -1\n" + vertices + normals
                   + "f -3//-1 -2//-3 -1//-2\nf 1//1 1//1 1//1\n")
        == (std::vector<Vector>{Vector(0, 0, -1), turned[0], turned[1], turned[2]}));

  // Each normal of a vertex counts once, however many faces name it
  const double half = std::sqrt(.5);
  const std::vector<Vector> means = normals_of(
    vertices + normals + "f 1//1 2//1 3//1\nf 1//1 2//1 3//1\nf 1//2 2//1 3//1\n");
  CHECK(means.size() == 3 && std::abs(means[0].y() - half) < 1e-15
        && std::abs(means[0].z() - half) < 1e-15 && means[1] == Vector(0, 0, 1));

  // Corners that name what is not there give nothing, nor do opposite normals
  const Point_cloud wrong = read(
    ".obj", vertices + "vn 0 0 1\nvn 0 0 -1\n" + "f 1//1 2//7 9//1 2//-9 3//1 3//2 1//x 1//0\n",
    with_everything());
  CHECK(wrong.normals
        == (std::vector<Vector>{Vector(0, 0, 1), CGAL::NULL_VECTOR, CGAL::NULL_VECTOR}));
  CHECK(wrong.warnings.size() == 1
        && wrong.warnings[0].find("corners of faces are left out") != std::string::npos);
  CHECK(read(".obj", vertices + normals + "f 1//3 2//1 3//2\n").file_has_normals);

  // Many corners, which are put together while they are read
  std::string many = "vn 0 0 1\nvn 0 1 0\n";
  for (int i = 0; i < 40000; ++i)
    many += "v " + std::to_string(i) + " 0 0\n";
  for (int i = 1; i < 39999; ++i)
    many += "f " + std::to_string(i) + "//2 " + std::to_string(i + 1) + "//2 "
            + std::to_string(i + 2) + "//2\n";
  const std::vector<Vector> all = normals_of(many);
  CHECK(all.size() == 40000);
  CHECK(std::all_of(all.begin(), all.end(), [](const Vector& n) { return n == Vector(0, 1, 0); }));
}

} // namespace

int main()
{
  test_off();
  test_obj();
  test_normals_of_obj_faces();
  return test::result();
}
