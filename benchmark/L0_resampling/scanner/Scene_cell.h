// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SCENE_CELL_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SCENE_CELL_H

#include "Counter_random.h"
#include "Surface.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace L0_benchmark {

/// One square of an endless scene, 32 m wide, and what stands in it. Nothing that stands in a cell
/// reaches into another one, and between them there are streets.
class Scene_cell
{
public:
  static constexpr double width = 32;

  /// \param column,row of the cell, from 0
  Scene_cell(std::uint64_t seed, std::uint32_t column, std::uint32_t row)
    : m_x(width * column), m_y(width * row)
  {
    Counter_random random(seed, generator_of(column, row, Purpose::CONTENT), 0);
    const auto between = [&](double low, double high) {
      return low + (high - low) * random.uniform();
    };
    const double house_x = between(10.5, 12), house_y = between(11, 13);
    if (random.uniform() < 0.7)
      add_box(Surface_kind::BUILDING, house_x, house_y, between(8, 12), between(7, 10),
              between(4, 9), between(-8, 8));
    else
      add_carport(house_x, house_y, between(5, 7), between(5, 8));
    add_box(Surface_kind::WALL, between(15, 17), between(23, 25), between(6, 9),
            between(0.06, 0.24), between(1.8, 2.5), between(-5, 5));
    add_box(Surface_kind::WALL, between(22, 22.5), between(6, 8), 0.025, between(3, 5), 2,
            between(-3, 3));
    add_pole(between(21, 22), between(2, 3), between(0.05, 0.15), between(3, 6));
    add_pole(between(29, 30), between(16, 18), between(0.05, 0.15), between(3, 6));
    add_tree(between(25, 26), between(13, 15), between(0.2, 0.5), between(2, 4), between(1, 2));
    add_tree(between(25.5, 26.5), between(24, 26), between(0.2, 0.5), between(2, 4), between(1, 2));
    add_tree(between(4.5, 5.5), between(25, 27), between(0.2, 0.5), between(2, 4), between(1, 2));
  }

  double x() const { return m_x; }
  double y() const { return m_y; }
  const std::vector<Surface>& surfaces() const { return m_surfaces; }

  /// Ground that a solid stands on.
  struct Footprint
  {
    double x, y;
    Rotation turn;
    double half_width, half_depth; ///< a disc has the radius, and no turn
    bool is_disc;

    double area() const { return (is_disc ? 3.14159265358979324 : 4.) * half_width * half_depth; }

    bool covers(double at_x, double at_y) const
    {
      const double dx = at_x - x, dy = at_y - y;
      if (is_disc)
        return dx * dx + dy * dy < half_width * half_width;
      return std::abs(turn.cosine * dx + turn.sine * dy) < half_width
             && std::abs(turn.cosine * dy - turn.sine * dx) < half_depth;
    }
  };

  const std::vector<Footprint>& footprints() const { return m_footprints; }

  bool is_covered(double x, double y) const
  {
    for (const Footprint& footprint : m_footprints)
      if (footprint.covers(x, y))
        return true;
    return false;
  }

  /// What the generators of a cell are for.
  enum class Purpose
  {
    CONTENT,
    POINTS,
    STATION
  };

  /// The `view` of `Counter_random`.
  static std::uint64_t generator_of(std::uint32_t column, std::uint32_t row, Purpose purpose)
  {
    return ((std::uint64_t(row) << 30) + column) * 4 + std::uint64_t(purpose);
  }

private:
  static constexpr double in_ground =
    1.6; ///< solids start so much below the ground at their center

  Point_3 place(double x, double y, double above) const
  {
    return on_ground(m_x + x, m_y + y, above);
  }

  /// Four sides and the top.
  void add_box(Surface_kind kind, double x, double y, double size_x, double size_y, double height,
               double degrees)
  {
    const Rotation turn = Rotation::of_degrees(degrees);
    const Vector_3 along(turn.cosine * size_x, turn.sine * size_x, 0);
    const Vector_3 across(-turn.sine * size_y, turn.cosine * size_y, 0);
    const Vector_3 up(0, 0, height + in_ground);
    const Point_3 corner = place(x, y, -in_ground) - 0.5 * (along + across);
    const Point_3 opposite = corner + along + across;
    m_surfaces.push_back(Surface::rectangle(kind, corner, along, up));
    m_surfaces.push_back(Surface::rectangle(kind, corner + along, across, up));
    m_surfaces.push_back(Surface::rectangle(kind, opposite, -along, up));
    m_surfaces.push_back(Surface::rectangle(kind, opposite - along, -across, up));
    m_surfaces.push_back(Surface::rectangle(kind, corner + up, along, across));
    m_footprints.push_back({m_x + x, m_y + y, turn, size_x / 2, size_y / 2, false});
  }

  /// A ridged roof of two sheets without thickness, whose upper side is seen, on four poles.
  void add_carport(double x, double y, double size_x, double size_y)
  {
    const double eaves = 2.3, ridge = 1.5;
    const Vector_3 half(size_x / 2, 0, ridge), mirrored(size_x / 2, 0, -ridge), depth(0, size_y, 0);
    const Point_3 corner = place(x, y, eaves) - Vector_3(size_x / 2, size_y / 2, 0);
    m_surfaces.push_back(Surface::rectangle(Surface_kind::BUILDING, corner, half, depth));
    m_surfaces.push_back(
      Surface::rectangle(Surface_kind::BUILDING, corner + half, mirrored, depth));
    for (int i = 0; i < 4; ++i)
      add_pole(x + (i % 2 ? 1 : -1) * (0.5 * size_x - 0.1),
               y + (i / 2 ? 1 : -1) * (0.5 * size_y - 0.1), 0.1, eaves - 0.2);
  }

  void add_pole(double x, double y, double diameter, double height)
  {
    m_surfaces.push_back(Surface::cylinder(Surface_kind::POLE, place(x, y, -in_ground),
                                           diameter / 2, height + in_ground));
    m_footprints.push_back({m_x + x, m_y + y, {1, 0}, diameter / 2, diameter / 2, true});
  }

  /// A trunk up to its crown, which is a sphere.
  void add_tree(double x, double y, double diameter, double height, double radius)
  {
    m_surfaces.push_back(Surface::cylinder(Surface_kind::TREE, place(x, y, -in_ground),
                                           diameter / 2, height + in_ground));
    m_surfaces.push_back(Surface::sphere(Surface_kind::TREE, place(x, y, height + radius), radius));
    m_footprints.push_back({m_x + x, m_y + y, {1, 0}, diameter / 2, diameter / 2, true});
  }

  double m_x, m_y; ///< of the corner
  std::vector<Surface> m_surfaces;
  std::vector<Footprint> m_footprints;
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SCENE_CELL_H
