// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_ENDLESS_SCENE_H
#define CGAL_L0_RESAMPLING_BENCHMARK_ENDLESS_SCENE_H

#include "Scene_cell.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace L0_benchmark {

/// Where a scanner was.
struct Scan_station
{
  std::uint32_t number;
  Point_3 position;
};

/// As seen from above.
inline double plan_distance(const Point_3& p, const Point_3& q)
{
  const double x = p.x() - q.x(), y = p.y() - q.y();
  return std::sqrt(x * x + y * y);
}

/*!
A scene of as many square cells as are wanted, with a scanner at a crossing of streets in each block
of three by three of them. All of it is a function of the seed and of the place: a larger scene is a
smaller one and more, but for the stations beyond the border of the latter.
*/
class Endless_scene
{
public:
  /// \param number_of_columns as many as rows, at most `max_columns`
  Endless_scene(std::uint64_t seed, std::uint32_t number_of_columns)
    : m_seed(seed), m_columns(number_of_columns), m_station_columns((number_of_columns + 2) / 3)
  {}

  static constexpr std::uint32_t max_columns = 65536;

  std::uint64_t seed() const { return m_seed; }
  std::uint32_t number_of_columns() const { return m_columns; }

  Scene_cell cell(std::uint32_t column, std::uint32_t row) const { return {m_seed, column, row}; }

  /// With the aircraft, which is the last one.
  std::uint32_t number_of_stations() const { return m_station_columns * m_station_columns + 1; }

  /// High above the middle: it sees roofs, and what no scanner on the ground is in front of.
  Scan_station aircraft() const
  {
    const double side = Scene_cell::width * m_columns;
    return {number_of_stations() - 1, Point_3(side / 2, side / 2, 1000 + side)};
  }

  /// \param number of the station, row by row
  Scan_station station(std::uint32_t number) const
  {
    if (number + 1 == number_of_stations())
      return aircraft();
    const std::uint32_t column = number % m_station_columns, row = number / m_station_columns;
    Counter_random random(m_seed,
                          Scene_cell::generator_of(column, row, Scene_cell::Purpose::STATION), 0);
    const auto crossing = [&](std::uint32_t block) {
      return Scene_cell::width * (3. * block + (random.uniform() < 0.5 ? 1 : 2));
    };
    const double x = crossing(column), y = crossing(row);
    return {number, on_ground(x, y, 1.8)};
  }

  /// All that are near a cell.
  struct Stations_around
  {
    std::vector<Scan_station> stations;
    std::size_t number_of_candidates; ///< the first ones: those nearest to some point of the cell
  };

  Stations_around stations_around(std::uint32_t column, std::uint32_t row) const
  {
    const auto first = [](std::uint32_t block) { return block == 0 ? 0 : block - 1; };
    const auto last = [&](std::uint32_t block) {
      return (std::min)(block + 1, m_station_columns - 1);
    };
    constexpr double width = Scene_cell::width;
    const Point_3 center((column + 0.5) * width, (row + 0.5) * width, 0);
    Stations_around around;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t j = first(row / 3); j <= last(row / 3); ++j)
      for (std::uint32_t i = first(column / 3); i <= last(column / 3); ++i) {
        around.stations.push_back(station(j * m_station_columns + i));
        least = (std::min)(least, plan_distance(center, around.stations.back().position));
      }
    const auto is_candidate = [&](const Scan_station& station) {
      return plan_distance(center, station.position) <= least + std::sqrt(2.) * width;
    };
    const auto others = std::stable_partition(around.stations.begin(), around.stations.end(),
                                              is_candidate);
    around.number_of_candidates = std::size_t(others - around.stations.begin());
    return around;
  }

private:
  std::uint64_t m_seed;
  std::uint32_t m_columns, m_station_columns;
};

/// Finds what of an endless scene is nearest to points, for metrics. Cells are made where they are
/// needed; points that follow each other should be near each other.
class Nearest_in_scene
{
public:
  /// Farther surfaces are not looked for: the ground has hills.
  static constexpr double reach = 1;

  explicit Nearest_in_scene(const Endless_scene& scene) : m_scene(scene) {}

  /// The nearest point within `reach` of what is seen of the scene, if there is one.
  std::optional<Surface_point> operator()(const Point_3& p)
  {
    std::optional<Surface_point> nearest;
    double least = reach * reach;
    const auto look_at = [&](const Surface_point& candidate) {
      const double distance = CGAL::squared_distance(p, candidate.point);
      if (distance < least) {
        least = distance;
        nearest = candidate;
      }
    };
    const auto column_at = [&](double coordinate) {
      const double last = double(m_scene.number_of_columns()) - 1;
      return std::uint32_t(
        (std::min)((std::max)(std::floor(coordinate / Scene_cell::width), 0.), last));
    };
    const bool is_near_ground = std::abs(p.z() - height_of_ground(p.x(), p.y())) < 2 * reach;
    const Surface_point ground = nearest_ground(p);
    bool is_seen = is_near_ground;
    for (std::uint32_t row = column_at(p.y() - reach); row <= column_at(p.y() + reach); ++row)
      for (std::uint32_t column = column_at(p.x() - reach); column <= column_at(p.x() + reach);
           ++column) {
        const Scene_cell& cell = cell_at(column, row);
        is_seen = is_seen && !cell.is_covered(ground.point.x(), ground.point.y());
        for (const Surface& surface : cell.surfaces()) {
          const double far = surface.extent() + reach;
          if (CGAL::squared_distance(p, surface.center()) < far * far)
            look_at(surface.nearest(p));
        }
      }
    if (is_seen)
      look_at(ground);
    return nearest;
  }

private:
  const Scene_cell& cell_at(std::uint32_t column, std::uint32_t row)
  {
    constexpr std::size_t maximum_number_of_cells = 1024; // 8 MB
    const std::uint64_t key = (std::uint64_t(row) << 32) + column;
    const auto found = m_cells.find(key);
    if (found != m_cells.end())
      return found->second;
    if (m_cells.size() >= maximum_number_of_cells)
      m_cells.clear();
    return m_cells.emplace(key, m_scene.cell(column, row)).first->second;
  }

  Endless_scene m_scene;
  std::unordered_map<std::uint64_t, Scene_cell> m_cells;
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_ENDLESS_SCENE_H
