// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Creases of a cloud in tiles are those of all of it in memory, to the bit.

#include "promise_support.h"
#include "tiles/Results_in_memory.h"
#include "tiles/points_in_memory.h"

#include <CGAL/IO/read_points.h>
#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/L0_resampling/internal/creases/find_creases_impl.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace internal = CGAL::L0_resampling::internal;
namespace params = CGAL::parameters;
using CGAL::L0_resampling::Tile_sample;
using test::Place;
using test::Vector;
using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Crease = CGAL::L0_resampling::Crease<Kernel>;
using Corner = CGAL::L0_resampling::Crease_corner<Kernel>;

namespace {

/// Samples of a part with edges, before creases are looked for.
struct Samples
{
  internal::Buffer<Vector> positions;
  internal::Buffer<Eigen::Vector3f> normals;
  double spacing = 0;

  explicit Samples(const std::string& name)
  {
    Points points;
    CHECK(CGAL::IO::read_points(L0_TEST_DATA "/" + name + ".ply", std::back_inserter(points)));
    test::Pairs<Kernel> pairs;
    CGAL::L0_resampling::Report report;
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
      points, std::back_inserter(pairs), params::resampling_report(&report));
    for (const auto& [position, normal] : pairs)
    {
      positions.push_back(test::as_vector(position));
      normals.push_back(test::as_vector(normal).cast<float>());
    }
    spacing = report.sample_spacing;
  }

  Tile_sample operator[](std::size_t i) const
  {
    const Vector& p = positions[i];
    const Eigen::Vector3f& n = normals[i];
    return {{p[0], p[1], p[2]}, {n[0], n[1], n[2]}, 0};
  }
};

/// So many tiles along each axis.
std::vector<std::vector<std::size_t>> boxes(const Samples& samples, std::size_t per_axis)
{
  Eigen::AlignedBox3d box;
  for (const Vector& p : samples.positions)
    box.extend(p);
  std::vector<std::vector<std::size_t>> tiles(per_axis * per_axis * per_axis);
  for (std::size_t i = 0; i < samples.positions.size(); ++i)
  {
    const Vector place = (samples.positions[i] - box.min()).cwiseQuotient(box.sizes());
    std::size_t tile = 0;
    for (int axis = 0; axis < 3; ++axis)
      tile = tile * per_axis
             + (std::min)(std::size_t(place[axis] * double(per_axis)), per_axis - 1);
    tiles[tile].push_back(i);
  }
  return tiles;
}

/// Anywhere, in any order; one is empty.
std::vector<std::vector<std::size_t>> parts_anywhere(const Samples& samples)
{
  std::mt19937 generator(1);
  std::vector<std::size_t> order(samples.positions.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::shuffle(order.begin(), order.end(), generator);
  std::vector<std::vector<std::size_t>> tiles(5);
  for (std::size_t k = 0; k < order.size(); ++k)
    tiles[k % 4].push_back(order[k]);
  return tiles;
}

/// \param tiles the numbers of their samples
void check_tiles(const Samples& samples, const internal::Placed_creases& expected,
                 const std::vector<std::vector<std::size_t>>& tiles)
{
  CGAL::L0_resampling::Report report;
  internal::Memory_counter memory;
  internal::Progress progress(nullptr, report, memory);
  const auto take_samples_of = [&](std::size_t tile, std::vector<Tile_sample>& of_tile) {
    of_tile.clear();
    for (const std::size_t i : tiles[tile])
      of_tile.push_back(samples[i]);
  };
  const internal::Creases_of_tiles found =
    internal::find_creases_of_tiles<CGAL::Parallel_if_available_tag>(
      tiles.size(), samples.spacing, internal::Samples_of_tiles(take_samples_of), progress, memory);
  std::vector<std::size_t> numbers; // as there are no tiles
  for (const std::vector<std::size_t>& tile : tiles)
    numbers.insert(numbers.end(), tile.begin(), tile.end());

  const internal::Placed_creases& placed = found.placed;
  CHECK(placed.creases.size() == expected.creases.size());
  CHECK(placed.corners.size() == expected.corners.size());
  CHECK(placed.moved.size() == expected.moved.size());
  for (std::size_t c = 0; c < (std::min)(placed.creases.size(), expected.creases.size()); ++c)
  {
    const internal::Placed_crease &a = placed.creases[c], &b = expected.creases[c];
    CHECK(a.samples.size() == b.samples.size() && a.confidence == b.confidence);
    CHECK(a.is_closed == b.is_closed && a.is_convex == b.is_convex);
    for (std::size_t k = 0; k < (std::min)(a.samples.size(), b.samples.size()); ++k)
      CHECK(numbers[a.samples[k]] == b.samples[k]
            && a.vertices[k].position == b.vertices[k].position
            && a.vertices[k].tangent == b.vertices[k].tangent
            && a.vertices[k].normals == b.vertices[k].normals
            && a.vertices[k].angle == b.vertices[k].angle);
  }
  for (std::size_t k = 0; k < (std::min)(placed.corners.size(), expected.corners.size()); ++k)
    CHECK(numbers[placed.corners[k].sample] == expected.corners[k].sample
          && placed.corners[k].normals == expected.corners[k].normals);
  std::size_t number_of_moved = 0;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile)
    found.for_each_moved(tile, [&](const internal::Sample_beside_crease& moved, std::size_t place) {
      const std::size_t number = tiles[tile][place];
      const auto same = std::find_if(expected.moved.begin(), expected.moved.end(),
                                     [&](const internal::Sample_beside_crease& sample) {
                                       return sample.number == number;
                                     });
      CHECK(same != expected.moved.end() && moved.position == same->position
            && moved.normal == same->normal);
      ++number_of_moved;
    });
  CHECK(number_of_moved == expected.moved.size());
}

void test_any_tiles(const std::string& name)
{
  const Samples samples(name);
  CGAL::L0_resampling::Report report;
  internal::Memory_counter memory;
  internal::Progress progress(nullptr, report, memory);
  internal::Buffer<Vector> positions(samples.positions);
  internal::Buffer<Eigen::Vector3f> normals(samples.normals);
  const internal::Placed_creases expected =
    internal::find_creases<CGAL::Sequential_tag>(samples.spacing, progress, positions, normals);
  CHECK(!expected.creases.empty() && !expected.corners.empty());
  for (const std::size_t per_axis : {1, 2, 3})
    check_tiles(samples, expected, boxes(samples, per_axis));
  check_tiles(samples, expected, parts_anywhere(samples));
}

/// Along the x-axis, with a square section.
std::vector<Place> beam(double length, double side)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> along(0, length), across(0, side);
  std::normal_distribution<double> noise(0, 0.03);
  const double ends = side * side, sides = 4 * side * length;
  std::bernoulli_distribution is_at_end(2 * ends / (2 * ends + sides));
  std::vector<Place> points;
  for (std::size_t i = 0; i < std::size_t(2 * (2 * ends + sides)); ++i)
  {
    Place p = {along(generator), across(generator), across(generator)};
    const std::size_t number = i % 4;
    if (is_at_end(generator))
      p[0] = number < 2 ? 0 : length;
    else
      p[1 + number / 2] = number % 2 == 0 ? 0 : side;
    for (double& coordinate : p)
      coordinate += noise(generator);
    points.push_back(p);
  }
  return points;
}

/// A crease or a corner, by the places of its points.
using Line = std::vector<Place>;

template <typename PlaceOf>
std::multiset<Line> lines_of(const std::vector<Crease>& creases, const std::vector<Corner>& corners,
                             const PlaceOf& place_of)
{
  std::multiset<Line> lines;
  for (const Crease& crease : creases)
  {
    Line line;
    for (std::size_t k = 0; k < crease.points.size(); ++k)
    {
      line.push_back(place_of(crease.points[k]));
      const Kernel::Vector_3& t = crease.tangents[k];
      line.push_back({t.x(), t.y(), t.z()});
      line.push_back({crease.angles[k], crease.confidence, double(crease.is_convex)});
    }
    lines.insert(line);
  }
  for (const Corner& corner : corners)
    lines.insert({place_of(corner.point)});
  return lines;
}

/// Lines go on from tile to tile, and the number of points is exact.
void test_whole_call()
{
  const std::vector<Place> points = beam(480, 10);
  const std::size_t n = points.size(), m = n / 2;
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  const auto np = params::number_of_output_points(m)
                  | params::crease_output_iterator(std::back_inserter(creases))
                  | params::corner_output_iterator(std::back_inserter(corners));

  Points input;
  for (const Place& p : points)
    input.emplace_back(p[0], p[1], p[2]);
  test::Pairs<Kernel> output;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(input, std::back_inserter(output),
                                                               np);
  CHECK(creases.size() == 12 && corners.size() == 8);
  std::multiset<Place> expected_points;
  for (const auto& [p, normal] : output)
    expected_points.insert({p.x(), p.y(), p.z()});
  const std::multiset<Line> expected = lines_of(creases, corners, [&](std::size_t i) {
    const Kernel::Point_3& p = output[i].first;
    return Place{p.x(), p.y(), p.z()};
  });

  creases.clear();
  corners.clear();
  using Tag = CGAL::Parallel_if_available_tag;
  using Tiles = CGAL::L0_resampling::Tiled_resampling<Tag>;
  test::Results_in_memory sink;
  const std::uint64_t memory = (n * (Tiles::bytes_per_point + sizeof(Tiles::Point_facts))
                                + m * Tiles::bytes_per_sample)
                               * 8 / 10;
  CGAL::l0_resample_tiles<Tag>(test::Points_in_memory(points), sink, memory, np);
  CHECK(sink.finished.size() >= 2);
  std::vector<Place> found_points;
  for (const auto& [tile, samples] : sink.finished)
    for (const Tile_sample& sample : samples)
      found_points.push_back(sample.position);
  CHECK(found_points.size() == m);
  CHECK(lines_of(creases, corners, [&](std::size_t i) { return found_points.at(i); }) == expected);
  CHECK(std::multiset<Place>(found_points.begin(), found_points.end()) == expected_points);
}

} // namespace

int main()
{
  test_any_tiles("bracket_noisy");
  test_any_tiles("staircase_noisy");
  test_whole_call();
  return test::result();
}
