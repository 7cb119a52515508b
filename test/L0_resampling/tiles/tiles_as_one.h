// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_TEST_TILES_AS_ONE_H
#define L0_TEST_TILES_AS_ONE_H

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
#include <cstring>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <new>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

// Clouds, resampled as one and by tiles.

namespace test {

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

  /// Across the ribbon, so many points per unit of area.
  void add_strip(double x, double width, double density)
  {
    for (std::size_t i = 0; i < std::size_t(20 * width * density); ++i)
      add({uniform(x, x + width), uniform(0, 20), 0}, 0.1);
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

/// One of each kind.
struct Scenes
{
  Scene even, uneven, crowds, sheets;

  explicit Scenes(double length) : even(length), uneven(length), crowds(length), sheets(length)
  {
    uneven.add_density(length, 2);
    crowds.add_crowds(length);
    crowds.add_outliers(length);
    sheets.add_sheet(length);
  }
};

/// With strips so dense that blocks of cells of a radius of 4 have too many points.
inline Scene scene_of_strips(double length)
{
  Scene scene(length);
  for (double x = 20; x < length; x += 200)
    scene.add_strip(x, 10, 50);
  return scene;
}

/// So many samples a point.
inline std::size_t number_of_samples(const Scene& scene, double share)
{
  return std::size_t(share * double(scene.points().size()));
}

template <typename ConcurrencyTag>
using Tiles = CGAL::L0_resampling::Tiled_resampling<ConcurrencyTag>;

/// The position and the normal.
using Sample = std::array<double, 6>;

inline std::vector<Sample> sorted(std::vector<Sample> samples)
{
  std::sort(samples.begin(), samples.end());
  return samples;
}

/// With the largest coordinate of each normal positive.
inline std::vector<Sample> without_sides(std::vector<Sample> samples)
{
  const auto is_shorter = [](double a, double b) { return std::abs(a) < std::abs(b); };
  for (Sample& sample : samples)
    if (*std::max_element(sample.begin() + 3, sample.end(), is_shorter) < 0)
      std::transform(sample.begin() + 3, sample.end(), sample.begin() + 3, std::negate<double>());
  return sorted(std::move(samples));
}

template <typename ConcurrencyTag, typename NamedParameters>
std::vector<Sample> in_memory(const std::vector<Place>& points, const NamedParameters& np)
{
  std::vector<Kernel::Point_3> input;
  for (const Place& p : points)
    input.emplace_back(p[0], p[1], p[2]);
  std::vector<Oriented> output;
  CGAL::l0_resample_point_set<ConcurrencyTag>(input, std::back_inserter(output), np);
  std::vector<Sample> samples;
  for (const auto& [p, n] : output)
    samples.push_back({p.x(), p.y(), p.z(), n.x(), n.y(), n.z()});
  return sorted(std::move(samples));
}

/// A model of `L0ResamplingTileArchive`.
class Memory_archive
{
  std::vector<char> m_bytes;
  std::size_t m_position = 0;

public:
  template <typename T>
  void write(const T& value)
  {
    static_assert(CGAL::L0_resampling::Is_plain<T>::value || std::is_same<T, bool>::value,
                  "not all bytes mean something");
    const char* const bytes = reinterpret_cast<const char*>(&value);
    m_bytes.insert(m_bytes.end(), bytes, bytes + sizeof value);
  }
  template <typename T, typename Allocator>
  void write_all(const std::vector<T, Allocator>& values)
  {
    write(std::uint64_t(values.size()));
    for (const T& value : values)
      write(value);
  }
  template <typename T>
  T read()
  {
    T value;
    std::memcpy(&value, &m_bytes.at(m_position), sizeof value);
    m_position += sizeof value;
    return value;
  }
  template <typename T, typename Allocator>
  void read_all(std::vector<T, Allocator>& values)
  {
    values.resize(std::size_t(read<std::uint64_t>()));
    for (T& value : values)
      value = read<T>();
  }
  bool is_read() const { return m_position == m_bytes.size(); }
};

/// The value, as a program finds it that had stored it.
template <typename Value>
Value stored(const Value& value)
{
  Memory_archive archive;
  CGAL::L0_resampling::write_tile_value(archive, value);
  const Value read = CGAL::L0_resampling::read_tile_value<Value>(archive);
  CHECK(archive.is_read());
  return read;
}

/// The facts of a cloud of which memory holds so many points at a time.
template <typename NamedParameters>
CGAL::L0_resampling::internal::Facts_of_cloud facts_in_passes(const std::vector<Place>& points,
                                                              std::size_t points_at_a_time,
                                                              double halo,
                                                              const NamedParameters& np)
{
  namespace internal = CGAL::L0_resampling::internal;
  using Passes = internal::Facts_in_passes<CGAL::Parallel_if_available_tag, Points_in_memory>;
  const internal::Counted_cloud cloud(counts_of(points));
  const Points_in_memory source{points};
  internal::Memory_counter memory;
  const internal::Parameters parameters = internal::checked_parameters(np, points.size());
  const std::uint64_t bytes = points.size() * Passes::bytes_per_point_of_cloud
                              + points_at_a_time * Passes::bytes_per_point;
  double last_share = 0;
  const auto callback = [&](double share) {
    CHECK(share >= last_share && share <= 1);
    last_share = share;
    return true;
  };
  const internal::Facts_of_cloud facts =
    Passes(cloud, source, parameters, bytes, callback, memory).find(halo);
  CHECK(last_share > 0);
  CHECK(memory.peak() <= points_at_a_time * Passes::bytes_per_point);
  return facts;
}

/// \param points_of_tile at most, with its halo, unless a single block has more
/// \param halo in radii
/// \param orients_at_once if not, samples have the sides that their tiles have found
template <typename ConcurrencyTag, typename NamedParameters>
std::vector<Sample> by_tiles(const std::vector<Place>& points, std::size_t points_of_tile,
                             double halo, std::size_t& number_of_tiles, const NamedParameters& np,
                             bool finds_facts_at_once = true, bool orients_at_once = true)
{
  const bool is_on_device = std::is_same<ConcurrencyTag, CGAL::CUDA_tag>::value;
  const Points_in_memory source{points};
  Tiles<ConcurrencyTag> tiles(counts_of(points), np);
  if (finds_facts_at_once)
    tiles.find_facts(source, std::uint64_t(1) << 40);
  else
    tiles.set_facts(stored(facts_in_passes(points, points_of_tile, halo, np)));
  const double samples_per_point = double(tiles.number_of_samples()) / double(points.size());
  std::uint64_t bytes = std::uint64_t(
    double(points_of_tile)
    * (double(tiles.bytes_per_point) + double(tiles.bytes_per_sample) * samples_per_point));
  for (bool is_cut = false; !is_cut;)
    try
    {
      tiles.make_tiles(bytes, halo);
      is_cut = true;
    }
    catch (const std::bad_alloc&) // the largest block and what is around it are more
    {
      bytes += bytes / 4;
    }
  tiles.choose_how_to_orient(orients_at_once ? std::uint64_t(1) << 40 : 0);
  number_of_tiles = tiles.tiles().size();
  CHECK(tiles.has_all_facts() == finds_facts_at_once);
  if (!finds_facts_at_once)
  {
    using Tiling = Tiles<ConcurrencyTag>;
    typename Tiling::Neighbor_counts neighbors;
    for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
      neighbors += stored(tiles.find_neighbors_of_tile(tile, source)).counts;
    tiles.set_medians(stored(neighbors.medians()));
    std::vector<typename Tiling::Points> found;
    std::vector<typename Tiling::Disks> disks;
    for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
    {
      found.push_back(stored(tiles.find_points_of_tile(tile, source)));
      disks.push_back(found.back().disks);
    }
    tiles.set_disks(stored(Tiling::add_up_disks(disks)));
    std::vector<typename Tiling::Share> shares;
    for (typename Tiling::Points& of_tile : found)
      shares.push_back(stored(tiles.share_of_tile(of_tile)));
    tiles.set_shares(std::move(shares));
  }
  std::vector<CGAL::L0_resampling::Tile_result> results;
  std::vector<CGAL::L0_resampling::Unoriented_samples> unoriented;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    const CGAL::L0_resampling::Tile_result& result = results.emplace_back(
      tiles.resample_tile(tile, source));
    unoriented.push_back(stored(result.unoriented));
    const std::uint64_t of_known_points = result.report.number_of_input_points
                                          * sizeof(CGAL::L0_resampling::internal::Point_in_cloud);
    const std::uint64_t peak = result.report.peak_bytes + of_known_points;
    if (result.report.device == "cpu" && !CHECK(peak <= bytes))
      std::cerr << "  a tile takes " << peak << " bytes of " << bytes << std::endl;
  }
  std::vector<std::vector<signed char>> signs;
  if (tiles.orients_at_once())
  {
    CGAL::L0_resampling::Report report;
    signs = tiles.sides(std::move(unoriented), report);
    // of the counted arrays, and of the signs
    const std::uint64_t peak = report.peak_bytes + tiles.number_of_samples(),
                        bound = tiles.number_of_samples() * tiles.bytes_per_sample_of_sides;
    if (!is_on_device && !CHECK(peak <= bound))
      std::cerr << "  sides take " << peak << " bytes of " << bound << std::endl;
  }
  std::vector<Sample> samples;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
    for (const CGAL::L0_resampling::Tile_sample& sample : results[tile].samples)
    {
      const Place& p = sample.position;
      const double sign = signs.empty() ? 1 : signs[tile][sample.tree];
      const Eigen::Vector3f normal(sample.normal.data());
      Vector n = normal.cast<double>();
      if (!is_on_device) // which gives unit vectors of single precision
        n /= std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      n *= sign;
      samples.push_back({p[0], p[1], p[2], n[0], n[1], n[2]});
    }
  return sorted(std::move(samples));
}

/// How many of the samples are not the same ones.
inline std::size_t number_of_different(const std::vector<Sample>& a, const std::vector<Sample>& b)
{
  std::vector<Sample> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return (std::max)(a.size(), b.size()) - common.size();
}

/// How far the samples that are not the same ones are from each other at most, by any coordinate of
/// their positions and normals.
inline double maximum_difference(const std::vector<Sample>& a, const std::vector<Sample>& b)
{
  std::vector<Sample> of_a, of_b;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(of_a));
  std::set_difference(b.begin(), b.end(), a.begin(), a.end(), std::back_inserter(of_b));
  double largest = 0;
  for (const Sample& sample : of_a)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Sample& other : of_b)
    {
      double difference = 0;
      for (std::size_t k = 0; k < sample.size(); ++k)
        difference = (std::max)(difference, std::abs(sample[k] - other[k]));
      least = (std::min)(least, difference);
    }
    largest = (std::max)(largest, least);
  }
  return largest;
}

} // namespace test

#endif // L0_TEST_TILES_AS_ONE_H
