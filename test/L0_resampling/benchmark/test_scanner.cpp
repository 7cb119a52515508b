// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The generator of scans: its random numbers, its solids, and the errors of each scanner.

#include "failure_count.h"

#include "../../../benchmark/L0_resampling/quality/Ground_truth.h"
#include "../../../benchmark/L0_resampling/scanner/Scan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace L0_benchmark;

namespace {

void check_within(double value, double low, double high, int line = __builtin_LINE())
{
  const std::string range = std::to_string(low) + " to " + std::to_string(high);
  check(low <= value && value <= high, std::to_string(value) + " is not from " + range, line);
}

template <class Function>
void check_refused(Function function, int line = __builtin_LINE())
{
  try
  {
    function();
  }
  catch (const std::invalid_argument&)
  {
    return;
  }
  check(false, "nothing was thrown", line);
}

double length(const Vector_3& v) { return std::sqrt(v.squared_length()); }

double standard_deviation(const std::vector<double>& values)
{
  double sum = 0, squares = 0;
  for (double value : values)
  {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / double(values.size());
  return std::sqrt(squares / double(values.size()) - mean * mean);
}

double volume(const Triangle_mesh& mesh)
{
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle_3 triangle = mesh.triangle(t);
    sum += CGAL::volume(Point_3(0, 0, 0), triangle[0], triangle[1], triangle[2]);
  }
  return sum;
}

Scan scan_of(const Scene& scene, const std::string& kind, int columns, const Scanning& scanning)
{
  const double size = diagonal(bounding_box(scene.mesh));
  return make_scan(scene, make_scanner(kind, std::size_t(columns), size), scanning);
}

Scanning without_noise()
{
  Scanning scanning;
  scanning.noise_factor = 0;
  return scanning;
}

// The bits of all coordinates, as files have them.
std::uint64_t fingerprint(const Scan& scan)
{
  std::uint64_t hash = 14695981039346656037u; // FNV-1a
  for (const Scan_point& point : scan.points)
    for (int i = 0; i < 3; ++i)
    {
      const float coordinate = float(point.reported[i]);
      std::uint32_t bits;
      std::memcpy(&bits, &coordinate, sizeof(bits));
      hash = (hash ^ bits) * 1099511628211u;
    }
  return hash;
}

void test_random_numbers()
{
  std::vector<double> values;
  for (std::uint64_t ray = 0; ray < 20000; ++ray)
    values.push_back(Counter_random(1, 0, ray).normal());
  check_within(standard_deviation(values), 0.98, 1.02);
  Counter_random random(1, 2, 3), exchanged(1, 3, 2);
  check(random.uniform() != exchanged.uniform(), "view and ray are mixed up");
  Counter_random first(7, 0, 0), again(7, 0, 0);
  first.uniform();
  again.uniform();
  check(first.uniform() == again.uniform(), "the same generator gives other numbers");
}

void test_rotations()
{
  for (int i = -40; i <= 40; ++i)
  {
    const double degrees = 9.7 * i;
    const Rotation rotation = Rotation::of_degrees(degrees);
    check_within(rotation.cosine - std::cos(degrees * std::acos(-1.) / 180), -1e-14, 1e-14);
    check_within(rotation.sine - std::sin(degrees * std::acos(-1.) / 180), -1e-14, 1e-14);
  }
  const Vector_3 turned = Rotation::of_turns(0.25)(Vector_3(1, 0, 0), Vector_3(0, 0, 1));
  check(length(turned - Vector_3(0, 1, 0)) < 1e-15, "a quarter turn about z does not bring x to y");
}

void test_solids()
{
  Triangle_mesh box, house, trunk;
  add_box(box, {5, 6, 7}, Vector_3(1, 2, 3), 33);
  check_within(volume(box), 6 - 1e-9, 6 + 1e-9);
  add_gabled_house(house, {1, 2, 3}, Vector_3(4, 5, 6), 2, 70);
  check_within(volume(house), 140 - 1e-9, 140 + 1e-9); // 4 * 5 * 6, and 4 * 5 * 2 / 2
  add_trunk(trunk, {0, 0, 0}, {0.5, 0, 4}, 0.5, 0.5);
  check_within(volume(trunk), 0.99 * 0.7853982, 0.7853982); // a cylinder's, but for its 64 sides
}

// Equal options give equal bytes, here and on other machines.
void test_determinism()
{
  Scanning scanning;
  scanning.number_of_views = 2;
  scanning.registration_error = 0.2;
  const Scan first = scan_of(make_street(), "spinning", 60, scanning);
  const Scan again = scan_of(make_street(), "spinning", 60, scanning);
  check(fingerprint(first) == fingerprint(again), "two scans differ");
  check(first.points.size() == 3398 && fingerprint(first) == 13151096240197071110u,
        "the scan has " + std::to_string(first.points.size()) + " points, fingerprint "
          + std::to_string(fingerprint(first)));
  scanning.seed = 2;
  const Scan other = scan_of(make_street(), "spinning", 60, scanning);
  check(fingerprint(first) != fingerprint(other), "the seed is unused");
}

void test_exact_points_lie_on_the_scene()
{
  for (const std::string kind : {"spinning", "terrestrial", "range-camera"})
  {
    const Scene scene = make_street();
    const Scan scan = scan_of(scene, kind, 60, without_noise());
    const Ground_truth truth(scene.mesh);
    check(scan.points.size() > 500, kind + " sees little");
    for (const Scan_point& point : scan.points)
    {
      check(truth.distance(point.exact) < 1e-9, kind + ": an exact point is off the scene");
      check(length(point.reported - point.exact) < 1e-9, kind + ": an error without noise");
    }
  }
}

void test_rings_and_noise_along_the_ray()
{
  const Scene scene = make_street();
  const Scan scan = scan_of(scene, "spinning", 400, Scanning());
  const Scanner scanner = make_scanner("spinning", 400, 1);
  std::set<long> rings;
  std::vector<double> errors;
  for (const Scan_point& point : scan.points)
  {
    const Vector_3 ray = point.reported - scene.stations[0];
    const double degrees = degrees_per_radian * std::asin(ray.z() / length(ray));
    const double step = (scanner.highest - scanner.lowest) / double(scanner.rows - 1);
    const double ring = (degrees - scanner.lowest) / step;
    check(std::abs(ring - std::round(ring)) < 1e-6, "a point lies between the rings");
    rings.insert(std::lround(ring));
    const double error = length(ray) - length(point.exact - scene.stations[0]);
    if (std::abs(error) < 0.08) // not a mixed one
      errors.push_back(error);
  }
  check_within(double(rings.size()), 30, 32);
  check_within(standard_deviation(errors), 0.02, 0.028); // 0.02, and more at grazing angles
  check_within(1 - double(errors.size()) / double(scan.points.size()), 0.0001, 0.03);
}

void test_disparity_steps()
{
  const Scene scene = make_room();
  const Scan scan = scan_of(scene, "structured-light", 160, Scanning());
  const Scanner scanner = make_scanner("structured-light", 160, 1);
  const Vector_3 forward = Pose::aimed(scene.stations[0], scene.target).forward;
  std::vector<double> near, far;
  for (const Scan_point& point : scan.points)
  {
    const double depth = (point.reported - scene.stations[0]) * forward;
    const double steps = 1 / depth / scanner.inverse_step;
    check(std::abs(steps - std::round(steps)) < 1e-6, "a depth lies between two steps");
    const double exact = (point.exact - scene.stations[0]) * forward;
    if (std::abs(depth - exact) < 0.06)
      (exact < 1.2 ? near : far).push_back((depth - exact) / (exact * exact));
  }
  check(near.size() > 1000 && far.size() > 500, "the room has no near and far points");
  // Errors grow with the square of the depth: relative to it they are the same.
  check_within(standard_deviation(far) / standard_deviation(near), 0.7, 1.4);
  check_within(standard_deviation(near), 0.0015, 0.004);
}

void test_registration_is_rigid_and_as_large_as_asked()
{
  Scanning scanning = without_noise();
  scanning.number_of_views = 4;
  scanning.registration_error = 0.3;
  const Scene scene = make_street();
  const Scan scan = scan_of(scene, "terrestrial", 60, scanning);
  check(scan.viewpoints.size() == 4, "there is not one viewpoint a view");
  double sum = 0;
  for (std::size_t i = 1; i < scan.points.size(); ++i)
  {
    const Scan_point &a = scan.points[i - 1], &b = scan.points[i];
    sum += length(a.reported - a.exact);
    if (a.view == b.view)
    {
      const double change = length(a.reported - b.reported) - length(a.exact - b.exact);
      check(std::abs(change) < 1e-9, "a view is bent");
    }
  }
  const double mean = sum / double(scan.points.size());
  check_within(100 * mean / diagonal(bounding_box(scene.mesh)), 0.15, 0.45);
}

void test_shadow_of_the_projector()
{
  const Scene scene = make_room();
  const Scan camera = scan_of(scene, "structured-light", 120, without_noise());
  Scanner without_projector = make_scanner("structured-light", 120, 1);
  without_projector.baseline = 0;
  const Scan all = make_scan(scene, without_projector, without_noise());
  check_within(double(camera.points.size()) / double(all.points.size()), 0.8, 0.99);
}

void test_refusals()
{
  const Scene scene = make_room();
  Scanning scanning;
  for (std::size_t views : {0, 5})
  {
    scanning.number_of_views = views;
    check_refused([&] { scan_of(scene, "spinning", 60, scanning); });
  }
  scanning.number_of_views = 1;
  check_refused([&] { scan_of(scene, "sonar", 60, scanning); });
  check_refused([&] { scan_of(scene, "terrestrial", 1, scanning); });
  scanning.registration_error = -1;
  check_refused([&] { scan_of(scene, "spinning", 60, scanning); });
}

} // namespace

int main()
{
  test_random_numbers();
  test_rotations();
  test_solids();
  test_determinism();
  test_exact_points_lie_on_the_scene();
  test_rings_and_noise_along_the_ray();
  test_disparity_steps();
  test_registration_is_rigid_and_as_large_as_asked();
  test_shadow_of_the_projector();
  test_refusals();
  return number_of_failures == 0 ? 0 : 1;
}
