// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A cloud that is resampled tile by tile gives the bits of a call for all of it, but for the sides.

#include "tiles/points_in_memory.h"

#include <CGAL/l0_resample_point_set.h>
#include <CGAL/l0_resample_tiles.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace test;
namespace internal = CGAL::L0_resampling::internal;
using CGAL::L0_resampling::Tile_counts;
using CGAL::L0_resampling::Tile_result;
using CGAL::L0_resampling::Tile_sample;
using Kernel = CGAL::Simple_cartesian<double>;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;

/// A long wavy ribbon far from the origin, about one point per unit of area.
class Scene
{
  std::mt19937 m_generator{5};
  std::vector<Place> m_points;

  double normal(double deviation)
  {
    return std::normal_distribution<double>(0, deviation)(m_generator);
  }
  double uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(m_generator);
  }

public:
  explicit Scene(double length)
  {
    for (std::size_t i = 0; i < std::size_t(20 * length); ++i)
      add({uniform(0, length), uniform(0, 20), 0}, 0.1);
  }

  void add(const Place& p, double noise)
  {
    const Place origin = {400000.25, 5600000.5, 120};
    const double x = p[0] + normal(noise), y = p[1] + normal(noise),
                 z = p[2] + 3 * std::sin(p[0] / 40) + normal(noise);
    // as coordinates are stored
    const auto rounded = [](double coordinate) { return std::round(coordinate * 1000) / 1000; };
    m_points.push_back({rounded(origin[0] + x), rounded(origin[1] + y), rounded(origin[2] + z)});
  }

  /// The density falls along the ribbon.
  void add_density(double length, double times)
  {
    for (std::size_t i = 0; i < std::size_t(20 * length * times); ++i)
      add({length * std::pow(uniform(0, 1), 2), uniform(0, 20), 0}, 0.1);
  }

  void add_crowds(double length)
  {
    for (double x = 7; x < length; x += 61)
    {
      const Place p = {x, 11, 0.1};
      for (int i = 0; i < 400; ++i)
        add({p[0], p[1], p[2]}, i % 2 == 0 ? 0 : 0.02);
    }
  }

  void add_outliers(double length)
  {
    for (int i = 0; i < int(length / 4); ++i)
      add({uniform(0, length), uniform(0, 20), uniform(-20, 20)}, 0);
  }

  /// A second sheet, close to the first.
  void add_sheet(double length)
  {
    for (std::size_t i = 0; i < std::size_t(20 * length); ++i)
      add({uniform(0, length), uniform(0, 20), 2.2}, 0.05);
  }

  const std::vector<Place>& points() const { return m_points; }
};

template <typename ConcurrencyTag>
using Tiles = CGAL::L0_resampling::Tiled_resampling<ConcurrencyTag>;

/// The position, and the normal with its largest coordinate positive.
using Unsigned_sample = std::array<double, 6>;

Unsigned_sample unsigned_sample(const Oriented& sample)
{
  const auto& [p, n] = sample;
  const double largest = std::abs(n.x()) > std::abs(n.y()) && std::abs(n.x()) > std::abs(n.z())
                           ? n.x()
                         : std::abs(n.y()) > std::abs(n.z()) ? n.y()
                                                             : n.z();
  const double sign = largest < 0 ? -1 : 1;
  return {p.x(), p.y(), p.z(), sign * n.x(), sign * n.y(), sign * n.z()};
}

std::vector<Unsigned_sample> sorted(std::vector<Unsigned_sample> samples)
{
  std::sort(samples.begin(), samples.end());
  return samples;
}

template <typename NamedParameters>
std::vector<Unsigned_sample> in_memory(const std::vector<Place>& points, const NamedParameters& np)
{
  std::vector<Kernel::Point_3> input;
  for (const Place& p : points)
    input.emplace_back(p[0], p[1], p[2]);
  std::vector<Oriented> output;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(input, std::back_inserter(output),
                                                               np);
  std::vector<Unsigned_sample> samples;
  for (const Oriented& sample : output)
    samples.push_back(unsigned_sample(sample));
  return sorted(std::move(samples));
}

/// \param points_of_tile at most, with its halo
/// \param halo in radii
template <typename ConcurrencyTag, typename NamedParameters>
std::vector<Unsigned_sample> by_tiles(const std::vector<Place>& points, std::size_t points_of_tile,
                                      double halo, std::size_t& number_of_tiles,
                                      const NamedParameters& np)
{
  const Points_in_memory source{points};
  Tile_counts counts;
  for (const Place& p : points)
    counts.add(p);
  Tiles<ConcurrencyTag> tiles(std::move(counts), np);
  tiles.find_facts(source, std::uint64_t(1) << 40);
  const double samples_per_point = double(tiles.number_of_samples()) / double(points.size());
  const std::uint64_t bytes = std::uint64_t(
    double(points_of_tile)
    * (double(tiles.bytes_per_point) + double(tiles.bytes_per_sample) * samples_per_point));
  tiles.make_tiles(bytes, halo);
  number_of_tiles = tiles.tiles().size();
  CHECK(tiles.has_all_facts());
  std::vector<Unsigned_sample> samples;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    const Tile_result result = tiles.resample_tile(tile, source);
    const std::uint64_t peak = result.report.peak_bytes
                               + result.report.number_of_input_points
                                   * sizeof(internal::Point_in_cloud);
    if (!CHECK(peak <= bytes))
      std::cerr << "  a tile takes " << peak << " bytes of " << bytes << std::endl;
    for (const Tile_sample& sample : result.samples)
    {
      const Place& p = sample.position;
      const Vector unit = Eigen::Vector3f(sample.normal.data()).cast<double>().normalized();
      samples.push_back(unsigned_sample(
        {Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(unit[0], unit[1], unit[2])}));
    }
  }
  return sorted(std::move(samples));
}

/// How many of the samples are not the same ones.
std::size_t number_of_different(const std::vector<Unsigned_sample>& a,
                                const std::vector<Unsigned_sample>& b)
{
  std::vector<Unsigned_sample> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return (std::max)(a.size(), b.size()) - common.size();
}

/// Samples that may differ, by the halo.
struct Largest_shares
{
  double with_wide_halo, with_practical_halo;
};

/// What decides whether all points are looked at for the facts is an upper bound.
void check_memory_of_facts(const std::vector<Place>& points, std::size_t number_of_samples)
{
  using Tag = CGAL::Parallel_if_available_tag;
  internal::Memory_counter memory;
  internal::Buffer<Vector> buffer(&memory);
  buffer.reserve(points.size());
  for (const Place& p : points)
    buffer.push_back(Vector(p.data()));
  CGAL::L0_resampling::Report report;
  internal::Progress progress(nullptr, report, memory);
  CGAL::L0_resampling::Block_chebyshev_solver_traits<float, Tag> solver;
  internal::Any_solver<float> any_solver(solver);
  const internal::Parameters parameters = internal::checked_parameters(
    CGAL::parameters::number_of_output_points(number_of_samples), points.size());
  std::vector<internal::Point_in_cloud> points_in_cloud;
  CHECK(internal::facts_of_points<Tag>(buffer, parameters, any_solver, progress, report,
                                       points_in_cloud)
          .area
        > 0.);
  const std::size_t bytes = memory.peak() + points_in_cloud.size() * sizeof points_in_cloud[0];
  const std::size_t bound = Tiles<Tag>::bytes_per_point_of_facts * points.size()
                            + Tiles<Tag>::bytes_per_sample_of_facts * number_of_samples;
  if (!CHECK(bytes <= bound))
    std::cerr << "  " << bytes << " bytes for " << points.size() << " points and "
              << number_of_samples << " samples" << std::endl;
}

/// \param share of the points that a tile and its halo have at most, unless it is the only one
/// \param largest which share of the samples may differ
template <typename ConcurrencyTag, typename NamedParameters>
void check(const std::string& name, const std::vector<Place>& points, double share,
           const Largest_shares& largest, std::size_t number_of_samples, const NamedParameters& np)
{
  const std::size_t n = points.size();
  const std::vector<Unsigned_sample> expected = in_memory(points, np);
  CHECK(expected.size() == number_of_samples);
  const double wide_halo = 40, practical_halo = Tiles<ConcurrencyTag>::halo_in_radii;
  std::size_t number_of_tiles = 0;
  const auto differences = [&](std::size_t points_of_tile, double halo) {
    const std::vector<Unsigned_sample> found = by_tiles<ConcurrencyTag>(points, points_of_tile,
                                                                        halo, number_of_tiles, np);
    CHECK(found.size() == number_of_samples);
    const std::size_t number = number_of_different(found, expected);
    std::cout << name << ": " << number_of_tiles << " tiles with halos of " << halo
              << " radii, samples that differ: " << number << " of " << number_of_samples
              << std::endl;
    return double(number) / double(number_of_samples);
  };
  const std::size_t points_of_tile = std::size_t(share * double(n));
  CHECK(differences(2 * n, practical_halo) == 0 && number_of_tiles == 1);
  CHECK(differences(points_of_tile, wide_halo) <= largest.with_wide_halo);
  CHECK(number_of_tiles >= 2);
  CHECK(differences(points_of_tile, practical_halo) <= largest.with_practical_halo);
  CHECK(number_of_tiles >= 2);
}

int main()
{
  using CGAL::parameters::keep_density;
  const double length = 1500;
  Scene even(length), uneven(length), crowds(length), sheets(length);
  uneven.add_density(length, 2);
  crowds.add_crowds(length);
  crowds.add_outliers(length);
  sheets.add_sheet(length);
  const auto number = [](const Scene& scene, double share) {
    return std::size_t(share * double(scene.points().size()));
  };
  std::size_t m = number(even, 0.5);
  check<CGAL::Sequential_tag>("even", even.points(), 0.5, {0, 0.001}, m,
                              CGAL::parameters::number_of_output_points(m));
  // where radii are larger, the halo is narrower for them
  m = number(uneven, 0.4);
  check<CGAL::Parallel_if_available_tag>("uneven", uneven.points(), 0.7, {0, 0.02}, m,
                                         CGAL::parameters::number_of_output_points(m));
  check<CGAL::Parallel_if_available_tag>("uneven, as dense as the input", uneven.points(), 0.7,
                                         {0, 0.02}, m,
                                         keep_density(true).number_of_output_points(m));
  m = number(crowds, 1.3); // a lone point is the start of several samples
  check<CGAL::Parallel_if_available_tag>("crowds and outliers", crowds.points(), 0.5, {0, 0.001}, m,
                                         CGAL::parameters::number_of_output_points(m));
  check<CGAL::Parallel_if_available_tag>(
    "more outliers", crowds.points(), 0.5, {0, 0.001}, m,
    CGAL::parameters::outlier_sensitivity(2).number_of_output_points(m));
  m = number(sheets, 0.3);
  check<CGAL::Parallel_if_available_tag>("two sheets", sheets.points(), 0.5, {0, 0.001}, m,
                                         CGAL::parameters::number_of_output_points(m));
  for (const Scene* scene : {&even, &uneven, &crowds})
    for (const double share : {0.01, 2.})
      check_memory_of_facts(scene->points(), number(*scene, share));
  return test::result();
}
