// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The generator of endless scenes: its blocks, its truth and its density.

#include "failure_count.h"

#include "../../../benchmark/L0_resampling/scanner/Scene_stream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

using namespace L0_benchmark;

namespace {

std::vector<Streamed_point> points_of(const Scene_stream& stream, std::uint64_t first,
                                      std::uint64_t last)
{
  std::vector<Streamed_point> points;
  stream.for_each(first, last, [&](const Streamed_point& point) { points.push_back(point); });
  return points;
}

std::vector<Streamed_point> all_points(const Streaming& streaming)
{
  const Scene_stream stream(streaming);
  return points_of(stream, 0, stream.size());
}

/// 50000 points, or so many, of 16 cells.
Streaming small_scan(std::uint64_t number_of_points = 50000)
{
  Streaming streaming;
  streaming.number_of_points = number_of_points;
  streaming.density = double(number_of_points) / (15 * Scene_cell::width * Scene_cell::width);
  return streaming;
}

/// The bits of all numbers.
std::uint64_t fingerprint(const std::vector<Streamed_point>& points)
{
  std::uint64_t hash = 14695981039346656037u; // FNV-1a
  const auto add = [&](double number) {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof(bits));
    hash = (hash ^ bits) * 1099511628211u;
  };
  for (const Streamed_point& point : points)
  {
    for (int i = 0; i < 3; ++i)
    {
      add(point.position[i]);
      add(point.exact.point[i]);
      add(point.exact.normal[i]);
    }
    add(double(point.kind));
    add(double(point.view));
  }
  return hash;
}

// Blocks in any order are the points of the whole scan, each once, in their order.
void test_blocks_make_up_the_scan()
{
  for (const std::uint64_t size : {1u, 63u, 64u, 50021u})
  {
    const Scene_stream stream(small_scan(size));
    const std::vector<Streamed_point> whole = points_of(stream, 0, size);
    check(whole.size() == size, "the scan has " + std::to_string(whole.size()) + " points");
    constexpr std::uint64_t number_of_blocks = 64;
    std::map<std::uint64_t, std::vector<Streamed_point>> blocks;
    for (std::uint64_t i = 0; i < number_of_blocks; ++i)
    {
      const std::uint64_t block = (i * 37 + 11) % number_of_blocks;
      const Scene_stream alone(small_scan(size));
      blocks[block] = points_of(alone, alone.first_of_block(block, number_of_blocks),
                                alone.first_of_block(block + 1, number_of_blocks));
      const std::uint64_t share = size / number_of_blocks;
      check(blocks[block].size() == share || blocks[block].size() == share + 1,
            "a block has " + std::to_string(blocks[block].size()) + " points");
    }
    std::vector<Streamed_point> together;
    for (const auto& [block, points] : blocks)
      together.insert(together.end(), points.begin(), points.end());
    check(together.size() == size && fingerprint(together) == fingerprint(whole),
          "the blocks are not the scan of " + std::to_string(size) + " points");
  }
}

// Equal options give equal bits, here and on other machines.
void test_determinism()
{
  Streaming streaming = small_scan(20000);
  const std::uint64_t hash = fingerprint(all_points(streaming));
  check(hash == 17223833561577412276u, "the fingerprint is " + std::to_string(hash));
  streaming.seed = 2;
  check(hash != fingerprint(all_points(streaming)), "the seed is unused");
}

// What the rays met lies on the scene, and the truth finds it with its normal.
void test_truth_of_points()
{
  const Streaming streaming = small_scan();
  const Scene_stream stream(streaming);
  Nearest_in_scene nearest(stream.scene());
  std::map<Surface_kind, int> kinds;
  int number_of_other_normals = 0, number_from_behind = 0;
  for (const Streamed_point& point : points_of(stream, 0, stream.size()))
  {
    ++kinds[point.kind];
    if (point.kind == Surface_kind::OUTLIER)
      continue;
    const auto truth = nearest(point.exact.point);
    if (!truth)
    {
      check(false, "the truth does not know a point");
      continue;
    }
    check(CGAL::squared_distance(truth->point, point.exact.point) < 1e-14, "an exact point is off");
    number_of_other_normals += truth->normal * point.exact.normal < 1 - 1e-9;
    const Point_3 station = stream.scene().station(point.view).position;
    number_from_behind += (station - point.exact.point) * point.exact.normal <= 0;
    const double distance = 96; // more than from any point to the nearest scanner
    const double error = std::sqrt(CGAL::squared_distance(point.position, point.exact.point));
    check(error < 6 * streaming.range_noise * (1 + distance / 50) + 1e-4, "the noise is too large");
  }
  check(number_of_other_normals <= 5, "normals differ"); // on edges two are right
  check(number_from_behind < 0.05 * double(stream.size()),
        std::to_string(number_from_behind) + " points were seen from behind");
  check(kinds[Surface_kind::OUTLIER] > 50 && kinds[Surface_kind::OUTLIER] < 150,
        "not 0.2 % of the points are outliers");
  for (const Surface_kind kind : {Surface_kind::GROUND, Surface_kind::TREE, Surface_kind::BUILDING,
                                  Surface_kind::WALL, Surface_kind::POLE})
    check(kinds[kind] > 30, "there is hardly a point of class " + std::to_string(int(kind)));
}

// No point of a dense scan is nearer to a place than the truth says, and one is almost as near.
void test_truth_of_places()
{
  Streaming streaming;
  streaming.number_of_points = 200000;
  streaming.density = 200; // in a single cell
  streaming.outlier_share = 0;
  const Scene_stream stream(streaming);
  Nearest_in_scene nearest(stream.scene());
  const std::vector<Streamed_point> points = points_of(stream, 0, stream.size());
  Counter_random random(5, 0, 0);
  int number_of_gaps = 0;
  constexpr int number_of_places = 200;
  for (int i = 0; i < number_of_places; ++i)
  {
    const Point_3& start = points[std::size_t(random.uniform() * 200000)].exact.point;
    const Point_3 place = start
                          + 0.4 * Vector_3(random.normal(), random.normal(), random.normal()) / 3;
    double least = 1e9;
    for (const Streamed_point& point : points)
      least = (std::min)(least, CGAL::squared_distance(place, point.exact.point));
    const auto truth = nearest(place);
    const double distance = truth ? std::sqrt(CGAL::squared_distance(place, truth->point)) : 1e9;
    check(distance < std::sqrt(least) + 1e-9, "a point is nearer than the truth");
    number_of_gaps += std::sqrt(least) > distance + 0.1;
  }
  check(number_of_gaps <= number_of_places / 20, "the truth is nearer than all points");
  check(!nearest(Point_3(16, 16, 40)), "something is near a place in the sky");
  const Scene_cell cell = stream.scene().cell(0, 0);
  for (const Scene_cell::Footprint& footprint : cell.footprints())
    if ((std::min)(footprint.half_width, footprint.half_depth) > 2)
      check(!nearest(on_ground(footprint.x, footprint.y)), "something is near a place in a house");
}

// As dense on one side of a border of cells as on the other; less dense far from scanners.
void test_density()
{
  const Streaming streaming = small_scan(2000000);
  const Scene_stream stream(streaming);
  const std::vector<Streamed_point> points = points_of(stream, 0, stream.size());
  double below = 0, above = 0, near = 0, far = 0;
  std::vector<double> at_border(16, 0);
  constexpr double strip = 1;
  for (const Streamed_point& point : points)
    if (point.kind == Surface_kind::GROUND)
    {
      const Point_3& p = point.exact.point;
      const double x = p.x() / Scene_cell::width,
                   in_cell = p.x() - Scene_cell::width * std::floor(x);
      // the second border, along which there are four cells
      if (std::floor(x) == 1 && in_cell > Scene_cell::width - strip)
        ++below, ++at_border[std::size_t(p.y() / Scene_cell::width) * 2];
      if (std::floor(x) == 2 && in_cell < strip)
        ++above, ++at_border[std::size_t(p.y() / Scene_cell::width) * 2 + 1];
      double distance = 1e9;
      for (std::uint32_t k = 0; k + 1 < stream.scene().number_of_stations(); ++k)
        distance = (std::min)(distance, plan_distance(p, stream.scene().station(k).position));
      near += distance < 5;
      far += distance > 28 && distance < 32;
    }
  check(std::abs(below / above - 1) < 0.03,
        "density has a seam: " + std::to_string(below) + " and " + std::to_string(above));
  for (std::size_t i = 0; i < 8; i += 2)
    check(std::abs(at_border[i] / at_border[i + 1] - 1) < 0.08,
          "density has a seam at a cell: " + std::to_string(at_border[i]) + " and "
            + std::to_string(at_border[i + 1]));
  const double ratio = (near / (5 * 5)) / (far / (32 * 32 - 28 * 28)); // of four stations both
  check(ratio > 3.5 && ratio < 9, "near scanners it is " + std::to_string(ratio) + " times denser");
}

// A block of a scan of 10^10 points comes as fast as one of a small scan.
void test_large_scan()
{
  Streaming streaming;
  streaming.number_of_points = 10000000000;
  const Scene_stream stream(streaming);
  constexpr std::uint64_t number_of_blocks = 10000000;
  const double side = Scene_cell::width * double(stream.scene().number_of_columns());
  for (const std::uint64_t block : {std::uint64_t(0), number_of_blocks / 3, number_of_blocks - 1})
  {
    const std::vector<Streamed_point> points =
      points_of(stream, stream.first_of_block(block, number_of_blocks),
                stream.first_of_block(block + 1, number_of_blocks));
    check(points.size() == 1000, "a block has " + std::to_string(points.size()) + " points");
    for (const Streamed_point& point : points)
      check(point.position.x() > -1 && point.position.x() < side + 1 && point.position.y() > -1
              && point.position.y() < side + 1 && point.view < stream.scene().number_of_stations(),
            "a point is outside of the scene");
    check(CGAL::squared_distance(points.front().position, points.back().position) < 2500,
          "a block of 1000 points is not in one place");
  }
}

void test_refusals()
{
  const auto check_refused = [](const Streaming& streaming, int line = __builtin_LINE()) {
    try
    {
      const Scene_stream stream(streaming);
    }
    catch (const std::invalid_argument&)
    {
      return;
    }
    check(false, "nothing was thrown", line);
  };
  for (const std::uint64_t size : {std::uint64_t(0), std::uint64_t(1000000000001)})
  {
    Streaming streaming;
    streaming.number_of_points = size;
    check_refused(streaming);
  }
  for (double Streaming::*number :
       {&Streaming::density, &Streaming::range_noise, &Streaming::outlier_share})
  {
    Streaming streaming;
    streaming.*number = -1;
    check_refused(streaming);
  }
  Streaming streaming;
  streaming.density = 1e-7;
  check_refused(streaming);
}

} // namespace

int main()
{
  test_blocks_make_up_the_scan();
  test_determinism();
  test_truth_of_points();
  test_truth_of_places();
  test_density();
  test_large_scan();
  test_refusals();
  return number_of_failures == 0 ? 0 : 1;
}
