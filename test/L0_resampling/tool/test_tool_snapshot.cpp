// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The pictures of l0_resample, on what must be seen in them.

#include "test_support.h"
#include "tool/test_tool_shapes.h"
#include "tool/test_tool_support.h"

#include "basis/Sample_of_surface.h"
#include "pictures/Camera.h"
#include "pictures/render_snapshot.h"
#include "pictures/Image.h"
#include "pictures/views_around.h"

#include <png.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

const std::array<double, 3> from_above = {0, 0, 1};

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

bool is_gray(const Image& image)
{
  return std::all_of(image.pixels.begin(), image.pixels.end(), [](const Color& color) {
    return std::abs(color[0] - color[1]) < 1e-6f && std::abs(color[1] - color[2]) < 1e-6f;
  });
}

Image colored_by_normals(const std::vector<Oriented_point>& points,
                         const std::array<double, 3>& view)
{
  return render_snapshot(cloud_of(points), points, view, {}, Snapshot_colors::NORMALS);
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

  // A circle of 720 pixels in the middle of its half, white around it and without a hole
  std::size_t wrong = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width / 2; ++x)
    {
      const double radius = std::hypot(x + 0.5 - 400, y + 0.5 - 400);
      wrong += radius < 357 ? is_white(image.at(x, y)) : radius > 368 && !is_white(image.at(x, y));
    }
  CHECK(wrong == 0);

  // gray, lit from the upper left of the eye
  CHECK(is_gray(image));
  CHECK(patch_around(image, 250, 250, 40).color[0]
        > 1.5f * patch_around(image, 550, 550, 40).color[0]);
}

// (n + 1) / 2: blue in the middle, more red to the right, more green upwards
void test_colors_of_normals()
{
  const Image image = colored_by_normals(sphere(4000), from_above);
  const Patch middle = patch_around(image, 400, 400, 60);
  CHECK(middle.color[2] > 2 * middle.color[0] && middle.color[2] > 2 * middle.color[1]);
  CHECK(patch_around(image, 600, 400, 20).color[0]
        > 2 * patch_around(image, 200, 400, 20).color[0]);
  CHECK(patch_around(image, 400, 200, 20).color[1]
        > 2 * patch_around(image, 400, 600, 20).color[1]);
}

// A normal of the wrong sign is seen, the one of the face before it is not covered.
void test_turned_away()
{
  std::vector<Oriented_point> points = sphere(4000);
  for (Oriented_point& point : points)
    if (point.first.x() < 0)
      point.second = -point.second;
  const Image image = render_snapshot(cloud_of(points), points, from_above);
  const Patch left = patch_around(image, 250, 400, 60), right = patch_around(image, 550, 400, 60);
  CHECK(left.color[2] > 2 * left.color[0] && left.white_share == 0);
  CHECK(std::abs(right.color[2] - right.color[0]) < 1e-6f && right.white_share == 0);
}

void test_feature_confidences()
{
  const std::vector<Oriented_point> points = sphere(4000);
  std::vector<float> confidences;
  for (const Oriented_point& point : points)
    confidences.push_back(point.first.x() > 0 ? 1.f : 0.f);
  const Image image = render_snapshot(cloud_of(points), points, from_above, confidences);
  const Patch left = patch_around(image, 1050, 400, 60), right = patch_around(image, 1350, 400, 60);
  CHECK(left.color[0] == left.color[1] && right.color[1] == 0 && right.color[0] > 0.1f);
}

/// How far a place of the picture lies outside of the silhouette of that cube, in pixels; negative
/// inside. The silhouette is bounded by two edges along each axis.
double distance_to_silhouette(const Camera& camera, double x, double y)
{
  const Projected_point middle = camera.project(CGAL::ORIGIN);
  const std::array<Projected_point, 3> ends = {
    camera.project(Point(1, 0, 0)), camera.project(Point(0, 1, 0)), camera.project(Point(0, 0, 1))};
  double distance = std::numeric_limits<double>::lowest();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double along_x = ends[k].x - middle.x, along_y = ends[k].y - middle.y;
    const auto from_axis = [&](double px, double py) {
      return std::abs(along_x * (py - middle.y) - along_y * (px - middle.x))
             / std::hypot(along_x, along_y);
    };
    const Projected_point &a = ends[(k + 1) % 3], &b = ends[(k + 2) % 3];
    distance = (std::max)(distance, from_axis(x, y) - from_axis(a.x, a.y) - from_axis(b.x, b.y));
  }
  return distance;
}

// At no edge there is a crack, and no disc stands out: the picture is the silhouette.
void test_cube()
{
  for (const std::array<double, 3>& view :
       {std::array<double, 3>{0.6, 0.55, 1}, {1, 0.2, 0.3}, {-1, 2, -0.7}})
    for (const int n : {12, 40})
    {
      const std::vector<Oriented_point> points = cube(n);
      std::vector<Point> positions;
      for (const Oriented_point& point : points)
        positions.push_back(point.first);
      const Image image = render_snapshot(cloud_of(points), points, view);
      Camera camera(Vector(view[0], view[1], view[2]), 800, 800);
      camera.fit({&positions, &positions});
      std::size_t cracks = 0, outside = 0;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width / 2; ++x)
        {
          const double distance = distance_to_silhouette(camera, x + 0.5, y + 0.5);
          cracks += distance < -1.5 && is_white(image.at(x, y));
          outside += distance > 1.5 && !is_white(image.at(x, y));
        }
      CHECK(cracks == 0);
      CHECK(outside == 0);
      CHECK(is_gray(image)); // of the faces that are turned away, nothing is seen
    }
}

// Dots have gaps, and the back, which is blue, shows in none of them.
void test_dots()
{
  const Image image = render_snapshot({}, sphere(4000), from_above, {}, Snapshot_colors::SHADED,
                                      true);
  const Patch middle = patch_around(image, 1200, 400, 200);
  CHECK(middle.white_share > 0.1 && middle.white_share < 0.7);
  CHECK(std::abs(middle.color[2] - middle.color[0]) < 1e-6f);
}

// The normal of a corner is none of its faces: there are lines in place of its disc.
void test_points_on_lines()
{
  std::vector<Oriented_point> points;
  for (int x = -30; x <= 30; ++x)
    for (int y = -30; y <= 30; ++y)
      points.push_back({Point(x, y, 0), Vector(0, 0, 1)});
  const auto drawn = [&](const std::vector<std::vector<Point>>& lines) {
    return render_snapshot({}, points, from_above, {}, Snapshot_colors::NORMALS, false, lines);
  };
  const Image plain = drawn({});
  points.push_back({Point(0.5, 0.5, 1), Vector(0.8, 0, 0.6)});
  const std::vector<Point> line = {points.back().first, points.front().first};
  const auto is_as_plain = [&](const Image& image) { // beside the line, which goes down to the left
    for (int y = 388; y < 400; ++y)
      for (int x = 1210; x < 1218; ++x)
        if (image.at(x, y) != plain.at(x, y))
          return false;
    return true;
  };
  CHECK(!is_as_plain(drawn({})));
  CHECK(is_as_plain(drawn({line})));
}

// Where points lie farther apart, discs are larger.
void test_uneven_spacing()
{
  std::vector<Oriented_point> points;
  for (double x = -30; x < 30; x += x < 0 ? 1 : 2.2)
    for (double y = -30; y < 30; y += x < 0 ? 1 : 2.2)
      points.emplace_back(Point(x, y, 0), Vector(0, 0, 1));
  const Image image = render_snapshot(cloud_of(points), points, from_above);
  CHECK(patch_around(image, 400, 400, 300).white_share == 0);
}

// Neither runs nor threads change a picture.
void test_determinism()
{
  const std::vector<Oriented_point> points = sphere(110000);
  Point_cloud input = cloud_of(points);
  input.normals.clear();
  const Image image = render_snapshot(input, points, {});
  CHECK(patch_around(image, 400, 400, 250).white_share == 0);
  for (const std::size_t threads : {1, 3})
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(render_snapshot(input, points, {}).pixels == image.pixels);
  }
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
        == 0);
}

// The input without normals has those of planes through points nearby.
void test_input_without_normals()
{
  Point_cloud input = cloud_of(sphere(4000));
  input.normals.clear();
  for (const Snapshot_colors colors : {Snapshot_colors::SHADED, Snapshot_colors::NORMALS})
  {
    const Image image = render_snapshot(input, {}, from_above, {}, colors);
    CHECK(is_gray(image));
    CHECK(patch_around(image, 400, 400, 240).white_share == 0);
    CHECK(patch_around(image, 250, 250, 40).color[0]
          > 1.5f * patch_around(image, 550, 550, 40).color[0]);
  }
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
  const Scratch_folder folder;
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

// Of a hall that is seen from within, no back of a wall hides the inside, on either half.
void test_look_into_a_hall()
{
  Known_sides known;
  known.viewpoints = {Point(0, 0, 0)};
  for (const bool has_normals : {false, true})
  {
    Point_cloud input = cloud_of(hall(-1));
    if (!has_normals)
      input.normals.clear();
    const View view = choose_view(hall(-1), known);
    const Image cut = render_snapshot(input, hall(-1), {view}, known.viewpoints, {}, {},
                                      Snapshot_colors::SHADED);
    CHECK(is_gray(cut));
    CHECK(patch_around(cut, 400, 400, 100).white_share < 0.01);
    CHECK(patch_around(cut, 1200, 400, 100).white_share < 0.01);
    View whole = view;
    whole.is_cut_open = false;
    CHECK(!is_gray(render_snapshot(input, hall(-1), {whole}, known.viewpoints, {}, {},
                                   Snapshot_colors::SHADED)));
  }
}

bool are_close(const Vector& a, const Vector& b) { return (a - b).squared_length() < 1e-24; }

/// What one view hides is seen in the others, whatever is up.
void test_views_around()
{
  using l0_tool::views_around;

  View view;
  view.towards_eye = Vector(3, 0, 4);
  view.up = Vector(0, 0, 7);
  CHECK(views_around(view, 1).size() == 1);
  const std::vector<View> views = views_around(view, 4);
  CHECK(views.size() == 4);
  CHECK(views[0].towards_eye == view.towards_eye && views[0].up == view.up);
  CHECK(are_close(views[1].towards_eye, Vector(-0.6, 0, 0.8)));
  CHECK(are_close(views[1].up, Vector(0, 0, 1)));
  CHECK(are_close(views[2].towards_eye, Vector(0, 0, 1)));
  CHECK(are_close(views[3].towards_eye, Vector(0, 0, -1)));
  CHECK(are_close(views[2].up, Vector(-0.6, 0, 0)) && views[3].up == views[2].up);

  // An eye that looks along what is up sees the back from the other end.
  view.towards_eye = Vector(0, 0, 1e200);
  const std::vector<View> along = views_around(view, 3);
  CHECK(are_close(along[1].towards_eye, Vector(0, 0, -1)));
  CHECK(are_close(along[2].towards_eye, Vector(0, 1, 0)));
}

// A row for each view, the first of which is as it is alone: of a sphere that is turned inside out
// on one half, one side is blue, the other one is not.
void test_rows()
{
  std::vector<Oriented_point> points = sphere(4000);
  for (Oriented_point& point : points)
    if (point.first.x() < 0)
      point.second = -point.second;
  View view;
  view.towards_eye = Vector(1, 0, 0);
  const auto draw = [&](int number) {
    return render_snapshot(cloud_of(points), points, l0_tool::views_around(view, number), {}, {},
                           {}, Snapshot_colors::SHADED);
  };
  const Image one = draw(1), rows = draw(4);
  CHECK(rows.width == 1600 && rows.height == 3200);
  CHECK(std::equal(one.pixels.begin(), one.pixels.end(), rows.pixels.begin()));
  const auto is_blue = [&](int x, int y) {
    const Patch patch = patch_around(rows, x, y, 60);
    CHECK(patch.white_share == 0);
    return patch.color[2] > 2 * patch.color[0];
  };
  for (const int left : {0, 800}) // of input and result
  {
    CHECK(!is_blue(left + 400, 400));
    CHECK(is_blue(left + 400, 1200));
    for (const int middle : {2000, 2800}) // the first eye is at the bottom
      CHECK(is_blue(left + 400, middle - 150) && !is_blue(left + 400, middle + 150));
  }
}

/// Black on what is drawn of the result, but not through it.
void test_lines()
{
  const std::vector<Oriented_point> points = sphere(4000);
  const auto number_of_black = [&](double z) {
    const Image image = render_snapshot(cloud_of(points), points, from_above, {},
                                        Snapshot_colors::SHADED, false,
                                        {{Point(-0.3, 0, z), Point(0.3, 0, z)}});
    std::size_t number = 0;
    for (const l0_tool::Color& color : image.pixels)
      number += std::size_t(color[0] < 0.02f && color[1] < 0.02f && color[2] < 0.02f);
    return number;
  };
  CHECK(number_of_black(1) > 100);
  CHECK(number_of_black(-1) == 0);
}

} // namespace

int main()
{
  test_sphere();
  test_colors_of_normals();
  test_turned_away();
  test_feature_confidences();
  test_cube();
  test_dots();
  test_points_on_lines();
  test_uneven_spacing();
  test_determinism();
  test_hidden_points();
  test_look_into_a_hall();
  test_views_around();
  test_rows();
  test_lines();
  test_invariance();
  test_input_without_normals();
  test_degenerate();
  test_spacing();
  test_png();
  return test::result();
}
