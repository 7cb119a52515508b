// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_WORKING_FRAME_H
#define CGAL_L0_RESAMPLING_INTERNAL_WORKING_FRAME_H

#include <CGAL/L0_resampling/internal/core/Orientation_hints.h>
#include <CGAL/L0_resampling/internal/core/select_nth.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Calls `f(axis, coordinates)` for each of the three axes, with the coordinates of the points to
/// do with as it likes.
template <typename ConcurrencyTag, typename F>
void for_each_axis_of(const Buffer<Vector>& points, const F& f)
{
  for_each_block<ConcurrencyTag>(3, 1, [&](std::size_t axis, std::size_t) {
    Buffer<double> coordinates(points.get_allocator());
    coordinates.reserve(points.size());
    for_each_in_order(points.size(),
                      [&](std::size_t i) { coordinates.push_back(points[i][Eigen::Index(axis)]); });
    f(int(axis), coordinates);
  });
}

/// Where the working frame lies in the coordinates of the input.
struct Place_of_frame
{
  int exponent;  ///< coordinates are multiplied by 2 to the power of this
  Vector origin; ///< after that
};

/*!
The frame that all stages work in: its origin is a point of the cloud, its unit is the radius.

Scaling by a power of two and moving the origin are exact wherever the result needs no more digits
than the coordinates had, so that a cloud and its copy at UTM coordinates are the same cloud here.
The division by the radius is rounded once. A cloud that is scaled by any factor is therefore the
same cloud here up to the rounding of its coordinates, and the same bit by bit if the factor is a
power of two.
*/
class Working_frame
{
  // the exponent brings the largest coordinate below 1, so that no difference overflows
  Place_of_frame m_place = {0, Vector::Zero()};
  double m_unit = 1; // a length after that scaling

public:
  /// Moves `points` into a frame in which the median of each coordinate is 0 and no coordinate
  /// exceeds 2.
  template <typename ConcurrencyTag>
  void enter(Buffer<Vector>& points)
  {
    double largest = 0;
    for_each_in_order(points.size(), [&](std::size_t i) {
      largest = (std::max)(largest, points[i].cwiseAbs().maxCoeff());
    });
    m_place.exponent = exponent_of(largest);

    scale<ConcurrencyTag>(m_place.exponent, points);
    // a median is a coordinate of the cloud: differences to it are exact nearby, and outliers do
    // not move it
    for_each_axis_of<ConcurrencyTag>(points, [&](int axis, Buffer<double>& coordinates) {
      const auto middle = coordinates.begin() + std::ptrdiff_t(coordinates.size() / 2);
      select_nth(coordinates.begin(), middle, coordinates.end());
      m_place.origin[axis] = *middle;
    });
    move_to_origin<ConcurrencyTag>(points);
  }

  /// Moves `points` into the frame of a larger cloud.
  template <typename ConcurrencyTag>
  void enter(Buffer<Vector>& points, const Place_of_frame& place)
  {
    m_place = place;
    scale<ConcurrencyTag>(m_place.exponent, points);
    move_to_origin<ConcurrencyTag>(points);
  }

  /// That of a frame for coordinates none of which is larger.
  static int exponent_of(double largest) { return largest > 0 ? -std::ilogb(largest) - 1 : 0; }

  const Place_of_frame& place() const { return m_place; }

  /// Makes `unit`, a length in the frame, the unit of the frame and of `points`.
  template <typename ConcurrencyTag>
  void set_unit(double unit, Buffer<Vector>& points)
  {
    m_unit *= unit;
    divide<ConcurrencyTag>(unit, points);
  }

  /// A point in the coordinates of the input, in the frame; one that lies too far off for finite
  /// coordinates is brought nearer.
  Vector point_in_frame(const Vector& point) const
  {
    const Vector p = (scaled(point, m_place.exponent) - m_place.origin) / m_unit;
    double coordinates[3] = {p.x(), p.y(), p.z()};
    bring_nearer(coordinates, point.data());
    return Eigen::Map<const Vector>(coordinates);
  }

  /// Before `set_unit()`: a length of the input times 2 to the power of this is one in the frame.
  int exponent() const { return m_place.exponent; }

  /// A length in the frame, in the unit of the input; the largest number for longer ones.
  double length_of_input(double length) const
  {
    return (std::min)(std::ldexp(length * m_unit, -m_place.exponent),
                      (std::numeric_limits<double>::max)());
  }

  /// A point in the frame, in the coordinates of the input.
  Vector leave(const Vector& point) const
  {
    return scaled(point * m_unit + m_place.origin, -m_place.exponent);
  }

  /// Divides all coordinates by `length`. Quotients are rounded correctly, so that multiples of it
  /// become whole numbers.
  template <typename ConcurrencyTag>
  static void divide(double length, Buffer<Vector>& points)
  {
    for_each_block<ConcurrencyTag>(
      points.size(), points_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          points[i] = points[i].unaryExpr([&](double x) { return x / length; });
      });
  }

private:
  static constexpr std::size_t points_per_block = 4096;

  template <typename ConcurrencyTag>
  void move_to_origin(Buffer<Vector>& points) const
  {
    for_each_block<ConcurrencyTag>(points.size(), points_per_block,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       points[i] -= m_place.origin;
                                   });
  }

  template <typename ConcurrencyTag>
  static void scale(int exponent, Buffer<Vector>& points)
  {
    const double factor = std::ldexp(1., exponent); // once for all of them
    for_each_block<ConcurrencyTag>(points.size(), points_per_block,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       points[i] = scaled(points[i], exponent, factor);
                                   });
  }

  static Vector scaled(const Vector& v, int exponent)
  {
    return scaled(v, exponent, std::ldexp(1., exponent));
  }

  static Vector scaled(const Vector& v, int exponent, double factor)
  {
    if (std::isnormal(factor))
      return factor * v;
    return {std::ldexp(v[0], exponent), std::ldexp(v[1], exponent), std::ldexp(v[2], exponent)};
  }
};

/// The bounding box of points, outliers left out: on each axis, what lies further from the middle
/// nine tenths of the points than those are wide, on the widest axis, does not count.
class Box_without_outliers
{
  Vector m_low, m_high;
  double m_reach;
  Vector m_box_low, m_box_high;

  bool is_in_reach(double coordinate, int axis) const
  {
    return m_reach == 0
           || (coordinate >= m_low[axis] - m_reach && coordinate <= m_high[axis] + m_reach);
  }

public:
  /// \param low, high of the middle nine tenths, on each axis
  Box_without_outliers(const Vector& low, const Vector& high)
    : m_low(low), m_high(high), m_reach((high - low).maxCoeff()), m_box_low(low), m_box_high(high)
  {}

  bool is_in_reach(const Vector& p) const
  {
    return is_in_reach(p[0], 0) && is_in_reach(p[1], 1) && is_in_reach(p[2], 2);
  }

  void add(const Vector& p)
  {
    for (int axis = 0; axis < 3; ++axis)
      if (is_in_reach(p[axis], axis))
      {
        m_box_low[axis] = (std::min)(m_box_low[axis], p[axis]);
        m_box_high[axis] = (std::max)(m_box_high[axis], p[axis]);
      }
  }

  double diagonal() const { return (m_box_high - m_box_low).norm(); }
};

/// The diagonal of `Box_without_outliers`. A cloud without outliers has its plain diagonal.
template <typename ConcurrencyTag>
double robust_diagonal(const Buffer<Vector>& points)
{
  Vector low, high;
  for_each_axis_of<ConcurrencyTag>(points, [&](int axis, Buffer<double>& coordinates) {
    const std::size_t margin = points.size() / 20;
    const auto first = coordinates.begin() + std::ptrdiff_t(margin);
    const auto last = coordinates.end() - 1 - std::ptrdiff_t(margin);
    select_nth(coordinates.begin(), first, coordinates.end());
    low[axis] = *first;
    select_nth(first, last, coordinates.end());
    high[axis] = *last;
  });

  Box_without_outliers box(low, high);
  for_each_in_order(points.size(), [&](std::size_t i) { box.add(points[i]); });
  return box.diagonal();
}

/// How far the points reach on each axis.
inline Vector plain_extent(const Buffer<Vector>& points)
{
  Vector low = points.front(), high = points.front();
  for_each_in_order(points.size(), [&](std::size_t i) {
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  });
  return high - low;
}

/// The diagonal of the bounding box of the points.
inline double box_diagonal(const Buffer<Vector>& points) { return plain_extent(points).norm(); }

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_WORKING_FRAME_H
