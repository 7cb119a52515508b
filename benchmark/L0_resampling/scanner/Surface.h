// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SURFACE_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SURFACE_H

#include "Rotation.h"
#include "scenes.h"

#include <algorithm>
#include <cmath>

namespace L0_benchmark {

/// What a point of an endless scene lies on, with the number that LAS has for the class; those from
/// 64 on are for users.
enum class Surface_kind
{
  GROUND = 2,
  TREE = 5,
  BUILDING = 6,
  OUTLIER = 7, ///< on nothing
  WALL = 64,   ///< free-standing and thin
  POLE = 65
};

/// A point of a surface, and the unit normal there.
struct Surface_point
{
  Point_3 point;
  Vector_3 normal;
};

inline Surface_point ground_at(double x, double y)
{
  const Hills hills(x, y);
  return {Point_3(x, y, hills.height()), hills.normal()};
}

/// The point of the ground nearest to `p`, which is less than 2 m from it: the foot on the tangent
/// plane, again and again. Curvatures are below 0.25 / m, so each step halves the error at least.
inline Surface_point nearest_ground(const Point_3& p)
{
  Surface_point foot = ground_at(p.x(), p.y());
  for (int i = 0; i < 40; ++i) {
    const Point_3 next = p - ((p - foot.point) * foot.normal) * foot.normal;
    const double step = std::abs(next.x() - foot.point.x()) + std::abs(next.y() - foot.point.y());
    foot = ground_at(next.x(), next.y());
    if (step < 1e-9)
      break;
  }
  return foot;
}

/// One smooth part of a solid that stands on the ground: a rectangle, an upright cylinder or a
/// sphere. What is below the ground does not count.
class Surface
{
public:
  /// \param along,up its sides, at a right angle; the normal is their cross product
  static Surface rectangle(Surface_kind kind, const Point_3& corner, const Vector_3& along,
                           const Vector_3& up)
  {
    Surface surface(kind, Shape::RECTANGLE, corner);
    surface.m_along = along;
    surface.m_up = up;
    surface.m_normal = normalized(CGAL::cross_product(along, up));
    surface.m_area = std::sqrt(along.squared_length() * up.squared_length());
    surface.m_center = corner + 0.5 * (along + up);
    surface.m_extent = 0.5 * std::sqrt((along + up).squared_length());
    return surface;
  }

  /// Without its ends.
  static Surface cylinder(Surface_kind kind, const Point_3& foot, double radius, double height)
  {
    Surface surface(kind, Shape::CYLINDER, foot);
    surface.m_radius = radius;
    surface.m_up = Vector_3(0, 0, height);
    surface.m_area = two_pi * radius * height;
    surface.m_center = foot + 0.5 * surface.m_up;
    surface.m_extent = radius + 0.5 * height;
    return surface;
  }

  static Surface sphere(Surface_kind kind, const Point_3& center, double radius)
  {
    Surface surface(kind, Shape::SPHERE, center);
    surface.m_radius = radius;
    surface.m_area = 2 * two_pi * radius * radius;
    surface.m_center = center;
    surface.m_extent = radius;
    return surface;
  }

  Surface_kind kind() const { return m_kind; }
  double area() const { return m_area; }

  /// Whether it is upright and has its lower end in the ground.
  bool starts_in_ground() const
  {
    return m_shape == Shape::CYLINDER
           || (m_shape == Shape::RECTANGLE && m_up.z() > 0 && m_along.z() == 0);
  }

  /// Without what is in the ground, where that is level.
  double seen_area() const
  {
    if (!starts_in_ground())
      return m_area;
    const double in_ground = height_of_ground(m_center.x(), m_center.y()) - m_origin.z();
    return m_area * (1 - (std::max)(in_ground, 0.) / m_up.z());
  }

  /// All of the surface is within `extent()` of `center()`.
  const Point_3& center() const { return m_center; }
  double extent() const { return m_extent; }

  /// The point with parameters in [0, 1), which are uniform in area.
  Surface_point at(double u, double v) const
  {
    if (m_shape == Shape::RECTANGLE)
      return {m_origin + u * m_along + v * m_up, m_normal};
    const Rotation around = Rotation::of_turns(u);
    if (m_shape == Shape::CYLINDER) {
      const Vector_3 outwards(around.cosine, around.sine, 0);
      return {m_origin + m_radius * outwards + v * m_up, outwards};
    }
    const double z = 2 * v - 1, across = std::sqrt(1 - z * z);
    const Vector_3 outwards(across * around.cosine, across * around.sine, z);
    return {m_origin + m_radius * outwards, outwards};
  }

  Surface_point nearest(const Point_3& p) const
  {
    const Vector_3 way = p - m_origin;
    if (m_shape == Shape::RECTANGLE) {
      const double u = share_of(way, m_along), v = share_of(way, m_up);
      return {above_ground(m_origin + u * m_along + v * m_up), m_normal};
    }
    if (m_shape == Shape::CYLINDER) {
      const Vector_3 outwards = direction(Vector_3(way.x(), way.y(), 0));
      const double v = share_of(way, m_up);
      return {above_ground(m_origin + m_radius * outwards + v * m_up), outwards};
    }
    const Vector_3 outwards = direction(way);
    return {m_origin + m_radius * outwards, outwards};
  }

private:
  static constexpr double two_pi = 6.28318530717958648;

  enum class Shape
  {
    RECTANGLE,
    CYLINDER,
    SPHERE
  };

  Surface(Surface_kind kind, Shape shape, const Point_3& origin)
    : m_kind(kind), m_shape(shape), m_origin(origin)
  {}

  static double share_of(const Vector_3& way, const Vector_3& side)
  {
    return (std::min)((std::max)(way * side / side.squared_length(), 0.), 1.);
  }

  /// Any one, where the way has no direction.
  static Vector_3 direction(const Vector_3& way)
  {
    return way.squared_length() > 0 ? normalized(way) : Vector_3(1, 0, 0);
  }

  static Point_3 above_ground(const Point_3& p)
  {
    return {p.x(), p.y(), (std::max)(p.z(), height_of_ground(p.x(), p.y()))};
  }

  Surface_kind m_kind;
  Shape m_shape;
  Point_3 m_origin, m_center;
  Vector_3 m_along = CGAL::NULL_VECTOR, m_up = CGAL::NULL_VECTOR, m_normal = CGAL::NULL_VECTOR;
  double m_radius = 0, m_area = 0, m_extent = 0;
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SURFACE_H
