// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From where pictures show what points are: which way is up, and on which side the eye is.

#include "test_support.h"
#include "tool/test_tool_shapes.h"

#include "pictures/View.h"

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

std::vector<Oriented_point> turned_about_z(std::vector<Oriented_point> points, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](const auto& v) {
    return std::decay_t<decltype(v)>(c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z());
  };
  for (Oriented_point& point : points)
    point = {turned(point.first), turned(point.second)};
  return points;
}

/// Turned about z, and without its wall at the largest x, if it is open.
std::vector<Oriented_point> turned_hall(double angle, bool is_open)
{
  std::vector<Oriented_point> points;
  for (const auto& [point, normal] : hall(1))
    if (!is_open || normal.x() <= 0.5)
      points.emplace_back(point, normal);
  return turned_about_z(std::move(points), angle);
}

// Of the two long sides one is chosen for a reason, so that roundings do not turn the picture.
void test_choice_of_side()
{
  for (const double angle : {-1e-3, -1e-9, 0., 1e-9, 1e-3})
  {
    CHECK(choose_view(turned_hall(angle, false), {}).towards_eye.x() > 0.5);
    CHECK(choose_view(turned_hall(angle, true), {}).towards_eye.x() < -0.5);
    const double quarter = std::acos(0.);
    CHECK(choose_view(turned_hall(angle + quarter, false), {}).towards_eye.y() < -0.5);
    CHECK(choose_view(turned_hall(angle + quarter, true), {}).towards_eye.y() < -0.5);
    CHECK(choose_view(turned_hall(angle - quarter, true), {}).towards_eye.y() > 0.5);
  }
}

// Where planes hold most points z is up, unless these stand on y; else y is. The eye looks across.
void test_choice_of_view()
{
  const View of_sphere = choose_view(sphere(4000), {});
  CHECK(of_sphere.up == Vector(0, 1, 0) && of_sphere.towards_eye == Vector(0.6, 0.55, 1));
  const View of_hall = choose_view(hall(1), {});
  CHECK(of_hall.up == Vector(0, 0, 1) && !of_hall.is_cut_open);
  CHECK(std::abs(of_hall.towards_eye.x()) > 1.5 * std::abs(of_hall.towards_eye.y()));
  CHECK(of_hall.towards_eye.z() > 0.2);

  Known_sides known;
  known.up = {0, 3, 0};
  CHECK(choose_view(hall(1), known).up == Vector(0, 1, 0));
  known = {};
  known.towards_eye = {-1, 2, 3};
  CHECK(choose_view(hall(1), known).towards_eye == Vector(-1, 2, 3));
  CHECK(choose_view({}, {}).towards_eye == View().towards_eye);

  // From the side of the viewpoint, or into what surrounds it
  known = {};
  known.viewpoints = {Point(0, 100, 0)};
  const View outside = choose_view(hall(1), known);
  CHECK(outside.towards_eye.y() > 0.8 && !outside.is_cut_open);
  // Along z: y points down for a camera in its own axes that looks along z, and up else
  std::vector<Oriented_point> before_camera;
  for (const auto& [point, normal] : hall(1))
    before_camera.emplace_back(point + Vector(0, 0, 9), normal);
  known.viewpoints = {Point(0, 0, 0)};
  CHECK(choose_view(before_camera, known).up == Vector(0, -1, 0));
  known.viewpoints = {Point(0, 0, 20)};
  CHECK(choose_view(before_camera, known).up == Vector(0, 1, 0));
  known.up = {0, 0, 1};
  CHECK(choose_view(before_camera, known).up == Vector(0, 0, 1));
  known.up.reset();
  // A tripod is lower than the middle of a facade, and has ground below it; what was seen from
  // beneath is shown from there.
  known.viewpoints = {Point(0, 2.2, -0.45)};
  const double lowest = choose_view(hall(1), known).towards_eye.z();
  known.viewpoints = {Point(1, 100, -60)};
  const View from_beneath = choose_view(hall(1), known);
  CHECK(lowest > 0.2 && from_beneath.up == Vector(0, 0, 1) && from_beneath.towards_eye.z() < -0.2);
  known.viewpoints = {Point(0.1, 0, 0), Point(0, -0.3, 0.1)};
  CHECK(choose_view(hall(-1), known).is_cut_open);
  known.viewpoints = {Point(0.1, 0, 0), Point(0, 100, 0)};
  CHECK(!choose_view(hall(-1), known).is_cut_open);
}

/// With z along y: what stood on a floor across z stands on one across y.
std::vector<Oriented_point> with_y_up(const std::vector<Oriented_point>& points)
{
  const auto turned = [](const auto& v) { return std::decay_t<decltype(v)>(v.x(), v.z(), -v.y()); };
  std::vector<Oriented_point> result;
  for (const auto& [point, normal] : points)
    result.emplace_back(turned(point), turned(normal));
  return result;
}

/// Points on the faces of a box whose normals are among those given.
std::vector<Oriented_point> faces_of_box(const Point& low, const Vector& size,
                                         const std::vector<Vector>& normals)
{
  std::vector<Oriented_point> points;
  for (const auto& [point, normal] : cube(30))
    for (const Vector& wanted : normals)
      if (normal * wanted > 0.9)
      {
        const Vector part = (point - Point(-1, -1, -1)) / 2;
        points.emplace_back(
          low + Vector(part.x() * size.x(), part.y() * size.y(), part.z() * size.z()), normal);
      }
  return points;
}

// Rooms and buildings stand on their floor, whichever of y and z is up.
void test_vertical()
{
  const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const Point origin(0, 0, 0);
  const Vector room(6, 4, 2.6);
  std::vector<Oriented_point> on_ground = faces_of_box(origin, {6, 4, 5}, {x, -x, y, -y, z});
  const std::vector<Oriented_point> ground = faces_of_box({-4, -4, 0}, {14, 12, 0}, {z}),
                                    facade = faces_of_box(origin, {20, 1, 12}, {-y}),
                                    ledge = faces_of_box({0, -0.5, 12}, {20, 1, 0.1}, {z, -z, -y});
  for (int k = 0; k < 3; ++k)
    on_ground.insert(on_ground.end(), ground.begin(), ground.end());
  std::vector<Oriented_point> front = facade;
  for (int k = 0; k < 3; ++k)
    front.insert(front.end(), facade.begin(), facade.end());
  front.insert(front.end(), ledge.begin(), ledge.end());

  // A house whose hip roof has its ridge along y
  std::vector<Oriented_point> house = faces_of_box(origin, {6, 16, 4}, {x, -x, y, -y});
  for (const double side : {-1., 1.})
    for (const auto& [point, normal] : faces_of_box({-3, 0, 0}, {6, 16, 0}, {z}))
      if (side * point.x() > 0)
        house.emplace_back(Point(point.x() + 3, point.y(), 7 - side * point.x()),
                           (z + side * x) / std::sqrt(2.));
  CHECK(choose_view(house, {}).up == z);
  CHECK(choose_view(turned_about_z(house, 0.4), {}).up == z);

  const std::vector<std::vector<Oriented_point>> scenes = {
    faces_of_box(origin, room, {x, -x, y, -y, z, -z}), // with floor and ceiling
    faces_of_box(origin, room, {x, -x, y, -y, -z}),    // with a floor
    on_ground,
  };
  for (const double angle : {0., 0.4, 1.})
    for (const std::vector<Oriented_point>& scene : scenes)
    {
      CHECK(choose_view(turned_about_z(scene, angle), {}).up == z);
      CHECK(choose_view(with_y_up(turned_about_z(scene, angle)), {}).up == y);
    }
  // A facade, and a building without ground, whose axes are those of the coordinates
  CHECK(choose_view(front, {}).up == z);
  CHECK(choose_view(faces_of_box(origin, {20, 10, 15}, {x, -x, y, -y, z}), {}).up == z);
}

/// A facade with ground before it, towards -y, and normals that point up and to one side of it.
std::vector<Oriented_point> facade_on_ground(double y_of_normals, double z_of_normals)
{
  std::vector<Oriented_point> points;
  for (const auto& [point, normal] : faces_of_box({0, 0, 0}, {20, 0, 12}, {{0, 1, 0}}))
    points.emplace_back(point, y_of_normals * normal);
  const std::vector<Oriented_point> ground = faces_of_box({0, -4, 0}, {20, 4, 0}, {{0, 0, 1}});
  for (std::size_t k = 0; k < ground.size(); k += 5)
    points.emplace_back(ground[k].first, z_of_normals * ground[k].second);
  return points;
}

// A facade is seen from the side where its ground is, whichever side its normals have.
void test_ground_before_facade()
{
  for (const double angle : {0., 0.4, 2., 4.})
    for (const double side : {-1., 1.})
    {
      std::vector<Oriented_point> facade = facade_on_ground(side, -side);
      const auto looks_at_front = [&](const Known_sides& known) {
        const Vector front(std::sin(angle), -std::cos(angle), 0);
        return choose_view(turned_about_z(facade, angle), known).towards_eye * front > 0.9;
      };
      CHECK(looks_at_front({}));
      Known_sides upright;
      upright.up = {0, 0, 1};
      CHECK(looks_at_front(upright));
      for (std::size_t k = 0; k < facade.size(); k += 2) // half of the normals on either side
        facade[k].second = -facade[k].second;
      CHECK(looks_at_front({}));
    }
}

} // namespace

int main()
{
  test_choice_of_side();
  test_choice_of_view();
  test_vertical();
  test_ground_before_facade();
  return test::result();
}
