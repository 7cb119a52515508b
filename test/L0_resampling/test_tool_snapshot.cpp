// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The pictures of l0_resample, on what must be seen in them.

#include "test_support.h"
#include "test_tool_support.h"

#include "point_spacing.h"
#include "render_snapshot.h"
#include "write_png.h"

#include <png.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using namespace l0_tool;

const std::array<double, 3> from_above = {0, 0, 1};

/// Evenly spread on the unit sphere, from its north to its south pole on the z axis.
std::vector<Oriented_point> sphere(std::size_t n)
{
  std::vector<Oriented_point> points;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double z = 1 - (2 * double(i) + 1) / double(n),
                 angle = 2.399963229728653 * double(i); // the golden angle
    const Vector v(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle),
                   z);
    points.emplace_back(CGAL::ORIGIN + v, v);
  }
  return points;
}

Point_cloud cloud_of(const std::vector<Oriented_point>& points)
{
  Point_cloud cloud;
  for (const Oriented_point& point : points)
  {
    cloud.points.push_back(point.first);
    cloud.normals.push_back(point.second);
  }
  return cloud;
}

bool is_white(const Color& color) { return color[0] == 1 && color[1] == 1 && color[2] == 1; }

/// Mean color of what is drawn within `radius` pixels of a pixel, and how much of it is white.
struct Patch
{
  Color color = {0, 0, 0};
  double white_share = 0;
};

Patch patch_around(const Image& image, int x, int y, int radius)
{
  Patch patch;
  std::size_t n = 0, drawn = 0;
  for (int j = y - radius; j <= y + radius; ++j)
    for (int i = x - radius; i <= x + radius; ++i, ++n)
    {
      if (is_white(image.at(i, j)))
        continue;
      ++drawn;
      for (std::size_t k = 0; k < 3; ++k)
        patch.color[k] += image.at(i, j)[k];
    }
  for (float& channel : patch.color)
    channel /= float((std::max)(drawn, std::size_t(1)));
  patch.white_share = 1 - double(drawn) / double(n);
  return patch;
}

void test_sphere()
{
  const std::vector<Oriented_point> points = sphere(4000);
  const Image image = render_snapshot(cloud_of(points), points, from_above);
  CHECK(image.width == 1600 && image.height == 800);

  std::size_t different = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width / 2; ++x)
      different += image.at(x, y) != image.at(x + image.width / 2, y);
  CHECK(different == 0); // one camera and one rule for both sides

  // A circle of 720 pixels in the middle of its half, white around it
  CHECK(is_white(image.at(0, 0)) && is_white(image.at(400, 30)) && is_white(image.at(400, 770))
        && is_white(image.at(30, 400)));
  CHECK(patch_around(image, 400, 400, 60).white_share < 0.5);
  CHECK(patch_around(image, 400, 60, 15).white_share < 1);

  // (n + 1) / 2: blue in the middle, more red to the right, more green upwards
  const Patch middle = patch_around(image, 400, 400, 60);
  CHECK(middle.color[2] > 2 * middle.color[0] && middle.color[2] > 2 * middle.color[1]);
  CHECK(patch_around(image, 600, 400, 20).color[0]
        > 2 * patch_around(image, 200, 400, 20).color[0]);
  CHECK(patch_around(image, 400, 200, 20).color[1]
        > 2 * patch_around(image, 400, 600, 20).color[1]);
}

// What lies behind the surface shows in no gap of it: whatever its normals, the middle of the
// picture stays.
void test_hidden_points()
{
  std::vector<Oriented_point> points = sphere(4000);
  const Image before = render_snapshot(cloud_of(points), points, from_above);
  for (Oriented_point& point : points)
    if (point.first.z() < 0)
      point.second = Vector(0.6, 0, -0.8);
  const Image after = render_snapshot(cloud_of(points), points, from_above);
  for (Oriented_point& point : points)
    if (point.first.z() < 0)
      point.second = Vector(0.6, 0, 0.8);
  const Image turned = render_snapshot(cloud_of(points), points, from_above);

  std::size_t different = 0;
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width / 2; ++x)
      if (std::hypot(x - 400, y - 400) < 300)
        different += before.at(x, y) != after.at(x, y) || before.at(x, y) != turned.at(x, y);
  CHECK(different == 0);
}

// The unit of length and the origin do not show, nor does a point far away.
void test_invariance()
{
  const std::vector<Oriented_point> points = sphere(1000);
  const Image image = render_snapshot(cloud_of(points), points, {});
  for (const double scale : {std::ldexp(1, -40), std::ldexp(1, 40)})
  {
    std::vector<Oriented_point> scaled = points;
    for (Oriented_point& point : scaled)
      point.first = CGAL::ORIGIN + scale * (point.first - CGAL::ORIGIN);
    CHECK(render_snapshot(cloud_of(scaled), scaled, {}).pixels == image.pixels);
  }

  std::vector<Oriented_point> with_outlier = points;
  with_outlier.emplace_back(Point(1e9, -1e9, 1e9), Vector(0, 0, 1));
  CHECK(patch_around(render_snapshot(cloud_of(with_outlier), with_outlier, {}), 400, 400, 60)
          .white_share
        < 0.5);
}

void test_gray_input()
{
  Point_cloud input = cloud_of(sphere(4000));
  input.normals.clear();
  const Image image = render_snapshot(input, sphere(1000), from_above);
  std::size_t colored = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width / 2; ++x)
      colored += image.at(x, y)[0] != image.at(x, y)[1] || image.at(x, y)[1] != image.at(x, y)[2];
  CHECK(colored == 0);
  // lit from the upper left of the eye
  CHECK(patch_around(image, 300, 300, 40).color[0]
        > 1.3f * patch_around(image, 550, 550, 40).color[0]);
}

// No set of points is too small or too odd for a picture.
void test_degenerate()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::vector<Oriented_point>> sets = {
    {},
    {{Point(1, 2, 3), Vector(0, 0, 1)}},
    {{Point(1, 2, 3), Vector(0, 0, 1)}, {Point(1, 2, 3), Vector(0, 0, 0)}},
    {{Point(0, 0, 0), Vector(nan, 0, 1)},
     {Point(1, 0, 0), Vector(1, 0, 0)},
     {Point(3, 0, 0), Vector(0, 1, 0)}},
    {{Point(-1e308, 0, 0), Vector(0, 0, 1)}, {Point(1e308, 0, 0), Vector(0, 0, 1)}}};
  for (const std::vector<Oriented_point>& points : sets)
  {
    const Image image = render_snapshot(cloud_of(points), points, from_above);
    std::size_t wrong = 0;
    for (const Color& color : image.pixels)
      for (const float channel : color)
        wrong += !(channel >= 0 && channel <= 1);
    CHECK(wrong == 0);
  }
  for (const Vector& normal : {Vector(0, 0, 1), Vector(0, 0, 0), Vector(nan, 0, 1)})
  {
    const std::vector<Oriented_point> one = {{Point(1, 2, 3), normal}};
    CHECK(patch_around(render_snapshot(cloud_of(one), one, from_above), 400, 400, 2).white_share
          < 1);
  }
}

void test_spacing()
{
  std::vector<Point> grid;
  for (int x = 0; x < 400; ++x)
    for (int y = 0; y < 400; ++y)
      grid.emplace_back(x, y, 0);
  // The sixth nearest on a square grid: four at 1 and two at sqrt(2). Every second point, row by
  // row, makes columns.
  CHECK(std::abs(point_spacing(std::vector<Point>(grid.begin(), grid.begin() + 10000))
                 - (4 + 2 * std::sqrt(2.)) / 6)
        < 1e-9);
  CHECK(std::abs(point_spacing(grid) - 1) < 0.3);
  CHECK(point_spacing({}) == 0 && point_spacing({Point(1, 2, 3)}) == 0);
}

void test_png()
{
  Image image(2, 1, {1, 1, 1});
  image.at(1, 0) = {0, 0.2158605f, 1}; // the middle one is 128 of 255 in sRGB
  const tool_test::Scratch_folder folder;
  const std::string path = folder.file("two.png");
  write_png(path, image);

  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  CHECK(png_image_begin_read_from_file(&png, path.c_str()) != 0);
  png.format = PNG_FORMAT_RGB;
  std::vector<png_byte> bytes(PNG_IMAGE_SIZE(png));
  CHECK(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr) != 0);
  CHECK(bytes == (std::vector<png_byte>{255, 255, 255, 0, 128, 255}));
}

} // namespace

int main()
{
  test_sphere();
  test_hidden_points();
  test_invariance();
  test_gray_input();
  test_degenerate();
  test_spacing();
  test_png();
  return test::result();
}
