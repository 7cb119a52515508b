// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SCENE_STREAM_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SCENE_STREAM_H

#include "Endless_scene.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace L0_benchmark {

/// How an endless scene is scanned.
struct Streaming
{
  std::uint64_t number_of_points = 1000000;
  double density = 1000;        ///< points per square meter of the plan, on average
  double range_noise = 0.004;   ///< standard deviation along the ray, near the scanner, in meters
  double outlier_share = 0.002; ///< of the points
  std::uint64_t seed = 1;
};

/// A point of a scan, with its truth.
struct Streamed_point
{
  Point_3 position;    ///< with all errors, a multiple of `Scene_stream::resolution`
  Surface_point exact; ///< what the ray met; of an outlier its own place, and no normal
  Surface_kind kind;
  std::uint32_t view; ///< number of the station
};

/*!
The points of a scan of an endless scene, as a function of their index: any of them can be made
without the others. Points of neighboring indices are near each other, as cells follow each other in
Morton order. Their density falls with the distance from the nearest scanner, as seen from above.
The view of a point is the nearest scanner in front of its surface, or else the aircraft, which the
undersides of crowns, and some walls, still have behind them. Nothing hides what is behind it.
*/
class Scene_stream
{
public:
  static constexpr double resolution = 1e-4; ///< of coordinates, in meters

  /// Takes about 10 us for each cell of the scene.
  /// \throws std::invalid_argument as `scene_of()` does
  explicit Scene_stream(const Streaming& streaming)
    : m_streaming(streaming), m_scene(scene_of(streaming))
  {
    const std::uint32_t columns = m_scene.number_of_columns();
    std::uint64_t corner = 1;
    while (corner < columns)
      corner *= 2;
    m_cumulative.push_back(0);
    for (std::uint64_t code = 0; code < corner * corner; ++code) {
      const std::uint32_t column = every_other_bit(code), row = every_other_bit(code >> 1);
      if (column >= columns || row >= columns)
        continue;
      m_cells.push_back({column, row});
      // An integer, so that sums are exact
      m_cumulative.push_back(m_cumulative.back()
                             + std::uint64_t(0x1p16 * Cell_sampler(*this, column, row).expected()));
    }
  }

  /// The scene alone.
  /// \throws std::invalid_argument if a number is out of its range
  static Endless_scene scene_of(const Streaming& streaming)
  {
    if (streaming.number_of_points < 1 || streaming.number_of_points > 1000000000000)
      throw std::invalid_argument("the number of points must be from 1 to 10^12");
    if (!(streaming.density > 0))
      throw std::invalid_argument("the density must be above 0");
    if (!(streaming.range_noise >= 0 && streaming.range_noise < 1))
      throw std::invalid_argument("the noise must be in [0, 1) m");
    if (!(streaming.outlier_share >= 0 && streaming.outlier_share < 1))
      throw std::invalid_argument("the share of outliers must be in [0, 1)");
    const double side = std::sqrt(double(streaming.number_of_points) / streaming.density);
    const double columns = std::ceil(side / Scene_cell::width);
    if (!(columns <= Endless_scene::max_columns))
      throw std::invalid_argument("the density is too low for so many points");
    return {streaming.seed, (std::max)(std::uint32_t(columns), std::uint32_t(1))};
  }

  const Endless_scene& scene() const { return m_scene; }

  std::uint64_t size() const { return m_streaming.number_of_points; }

  /// The first point of a block, of which `number_of_blocks` make up the scan.
  std::uint64_t first_of_block(std::uint64_t block, std::uint64_t number_of_blocks) const
  {
    return share_of_points(block, number_of_blocks);
  }

  /// Calls `take` with the points from `first` to before `last`, in their order.
  template <class Take>
  void for_each(std::uint64_t first, std::uint64_t last, const Take& take) const
  {
    std::size_t cell = cell_of(first);
    for (std::uint64_t i = first; i < last; ++cell) {
      const std::uint64_t begin = first_of_cell(cell);
      const std::uint64_t end = (std::min)(first_of_cell(cell + 1), last);
      if (i >= end)
        continue;
      const Cell_sampler sampler(*this, m_cells[cell].column, m_cells[cell].row);
      for (; i < end; ++i)
        take(sampler.point(i - begin));
    }
  }

private:
  struct Cell_place
  {
    std::uint32_t column, row;
  };

  /// Draws the points of a cell.
  class Cell_sampler
  {
  public:
    Cell_sampler(const Scene_stream& stream, std::uint32_t column, std::uint32_t row)
      : m_streaming(stream.m_streaming), m_cell(stream.m_scene.cell(column, row)),
        m_around(stream.m_scene.stations_around(column, row)),
        m_aircraft(stream.m_scene.aircraft()),
        m_generator(Scene_cell::generator_of(column, row, Scene_cell::Purpose::POINTS))
    {
      for (int j = 0; j < squares; ++j)
        for (int i = 0; i < squares; ++i) {
          const double x = m_cell.x() + (i + 0.5) * square, y = m_cell.y() + (j + 0.5) * square;
          add(square * square, square * square, Point_3(x, y, 0), square);
        }
      for (const Surface& surface : m_cell.surfaces())
        add(surface.area(), surface.seen_area(), surface.center(), surface.extent());
      for (const Scene_cell::Footprint& footprint : m_cell.footprints())
        m_expected -= footprint.area() * density_at(Point_3(footprint.x, footprint.y, 0));
    }

    /// What the number of points of the cell is proportional to: the integral of the density over
    /// what is seen, up to some percent of it.
    double expected() const { return m_expected; }

    /// The point of that number, which depends on nothing else of the cell.
    Streamed_point point(std::uint64_t number) const
    {
      Counter_random random(m_streaming.seed, m_generator, number);
      if (random.uniform() < m_streaming.outlier_share) {
        const double x = m_cell.x() + Scene_cell::width * random.uniform();
        const double y = m_cell.y() + Scene_cell::width * random.uniform();
        const Point_3 place = on_lattice(on_ground(x, y, 12 * random.uniform() - 1));
        return {place, {place, CGAL::NULL_VECTOR}, Surface_kind::OUTLIER, nearest(place).number};
      }
      for (;;) {
        const double which = random.uniform() * m_bounds.back();
        const std::size_t part = std::size_t(
          std::upper_bound(m_bounds.begin(), m_bounds.end() - 1, which) - m_bounds.begin());
        const double u = random.uniform(), v = random.uniform(), chance = random.uniform();
        const Surface* const solid = part < squares * squares
                                       ? nullptr
                                       : &m_cell.surfaces()[part - squares * squares];
        Surface_point exact = solid ? solid->at(u, v) : in_square(part, u, v);
        const double distance = plan_distance(exact.point, nearest(exact.point).position);
        if (chance * m_largest[part] >= density(distance))
          continue;
        const double x = exact.point.x(), y = exact.point.y();
        if (solid ? solid->starts_in_ground() && exact.point.z() < height_of_ground(x, y)
                  : m_cell.is_covered(x, y))
          continue;
        if (!solid)
          exact = ground_at(x, y);
        const Scan_station& station = seen_from(exact);
        const double error = m_streaming.range_noise * (1 + distance / noise_range)
                             * random.normal();
        const Vector_3 ray = normalized(exact.point - station.position);
        return {on_lattice(exact.point + error * ray), exact,
                solid ? solid->kind() : Surface_kind::GROUND, station.number};
      }
    }

  private:
    /// The ground of a cell is drawn square by square.
    static constexpr int squares = 8;
    static constexpr double square = Scene_cell::width / squares;
    /// Where the density is half of what it is at the scanner, and where the noise is twice.
    static constexpr double density_range = 15, noise_range = 50;

    static double density(double distance)
    {
      return 1 / (1 + distance * distance / (density_range * density_range));
    }

    void add(double area, double seen_area, const Point_3& center, double extent)
    {
      const double distance = plan_distance(center, nearest(center).position);
      m_largest.push_back(density((std::max)(distance - extent, 0.)));
      m_bounds.push_back((m_bounds.empty() ? 0 : m_bounds.back()) + area * m_largest.back());
      m_expected += seen_area * density(distance);
    }

    double density_at(const Point_3& p) const
    {
      return density(plan_distance(p, nearest(p).position));
    }

    /// As seen from above.
    const Scan_station& nearest(const Point_3& p) const
    {
      const auto first = m_around.stations.begin();
      return *std::min_element(first, first + std::ptrdiff_t(m_around.number_of_candidates),
                               [&](const Scan_station& a, const Scan_station& b) {
                                 return plan_distance(p, a.position) < plan_distance(p, b.position);
                               });
    }

    /// The nearest one that is in front of the surface, or else the aircraft.
    const Scan_station& seen_from(const Surface_point& surface) const
    {
      const Scan_station* found = &m_aircraft;
      double least = std::numeric_limits<double>::infinity();
      for (const Scan_station& station : m_around.stations) {
        const double distance = plan_distance(surface.point, station.position);
        if (distance < least && (station.position - surface.point) * surface.normal > 0) {
          least = distance;
          found = &station;
        }
      }
      return *found;
    }

    /// A place on the map.
    Surface_point in_square(std::size_t number, double u, double v) const
    {
      return {Point_3(m_cell.x() + (double(number % squares) + u) * square,
                      m_cell.y() + (double(number / squares) + v) * square, 0),
              CGAL::NULL_VECTOR};
    }

    static Point_3 on_lattice(const Point_3& p)
    {
      const auto rounded = [](double coordinate) {
        return std::floor(coordinate / resolution + 0.5) * resolution;
      };
      return {rounded(p.x()), rounded(p.y()), rounded(p.z())};
    }

    const Streaming& m_streaming;
    Scene_cell m_cell;
    Endless_scene::Stations_around m_around;
    Scan_station m_aircraft;
    std::uint64_t m_generator;
    std::vector<double> m_largest; ///< the largest density of each part
    std::vector<double> m_bounds;  ///< sums of areas times these
    double m_expected = 0;
  };

  static std::uint32_t every_other_bit(std::uint64_t code)
  {
    std::uint32_t bits = 0;
    for (int i = 0; i < 32; ++i)
      bits |= std::uint32_t(code >> (2 * i) & 1) << i;
    return bits;
  }

  /// The whole part of size() times a fraction of at most 1.
  std::uint64_t share_of_points(std::uint64_t numerator, std::uint64_t denominator) const
  {
    using Wide = boost::multiprecision::uint128_t;
    return std::uint64_t(Wide(size()) * numerator / denominator);
  }

  std::uint64_t first_of_cell(std::size_t cell) const
  {
    return share_of_points(m_cumulative[cell], m_cumulative.back());
  }

  /// The cell of a point, or one without points before it.
  std::size_t cell_of(std::uint64_t point) const
  {
    std::size_t low = 0, high = m_cells.size();
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (first_of_cell(middle) <= point ? low : high) = middle;
    }
    return low;
  }

  Streaming m_streaming;
  Endless_scene m_scene;
  std::vector<Cell_place> m_cells;
  std::vector<std::uint64_t> m_cumulative; ///< of what is expected of the cells before each
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SCENE_STREAM_H
