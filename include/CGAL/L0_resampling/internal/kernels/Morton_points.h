// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MORTON_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_MORTON_POINTS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Cubic cells whose places on the three axes are interleaved to one number, the Morton code: the
/// points of a cell of any level, each twice as wide as the one before, follow each other in the
/// order of the codes.
struct Morton_cells
{
  static constexpr int number_of_levels = 21;
  static constexpr double places_per_axis = 1 << number_of_levels;

  double size; ///< of the cells of level 0; the origin is in the middle of all

  /// \param extent of the points around the origin; what lies further off than half of it shares
  /// the outermost cells
  CGAL_L0_HOST_DEVICE static Morton_cells of_extent(double extent)
  {
    return {extent / places_per_axis};
  }

  CGAL_L0_HOST_DEVICE std::int64_t place(double coordinate) const
  {
    const double place = std::floor(coordinate / size) + places_per_axis / 2;
    return place < 0 ? 0 : std::int64_t(place < places_per_axis ? place : places_per_axis - 1);
  }

  /// Puts two zeros between the bits of a place.
  CGAL_L0_HOST_DEVICE static std::uint64_t spread(std::uint64_t x)
  {
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }

  /// The inverse of `spread()`; other bits do not matter.
  CGAL_L0_HOST_DEVICE static std::uint64_t gather(std::uint64_t x)
  {
    x &= 0x1249249249249249;
    x = (x | x >> 2) & 0x10c30c30c30c30c3;
    x = (x | x >> 4) & 0x100f00f00f00f00f;
    x = (x | x >> 8) & 0x1f0000ff0000ff;
    x = (x | x >> 16) & 0x1f00000000ffff;
    return (x | x >> 32) & 0x1fffff;
  }

  /// The middle of a cell of level 0, on an axis.
  CGAL_L0_HOST_DEVICE double middle(std::uint64_t code, int axis) const
  {
    return (double(gather(code >> axis)) - places_per_axis / 2 + 0.5) * size;
  }

  CGAL_L0_HOST_DEVICE static std::uint64_t code(std::int64_t x, std::int64_t y, std::int64_t z)
  {
    return spread(std::uint64_t(x)) | spread(std::uint64_t(y)) << 1 | spread(std::uint64_t(z)) << 2;
  }

  /// \param xyz of a point
  CGAL_L0_HOST_DEVICE std::uint64_t code(const double* xyz) const
  {
    return code(place(xyz[0]), place(xyz[1]), place(xyz[2]));
  }
};

/// The cells in which the places of a cloud are told apart.
/// \param extent of the points, outliers left out
inline Morton_cells cells_of_places(double extent) { return Morton_cells::of_extent(4 * extent); }

/// Every `stride`-th of the points of a range.
struct Strided_range
{
  std::uint64_t begin, end, stride;
};

/// A thread that looks at the points of a ball alone. On the device a `Warp` shares the work.
struct One_thread
{
  static constexpr int number_of_threads = 1;

  CGAL_L0_HOST_DEVICE int lane() const { return 0; }

  /// Calls `f(range)` with the range of each thread, where it is not empty, one after the other.
  template <typename F>
  CGAL_L0_HOST_DEVICE void for_each_range(const Strided_range& own, const F& f) const
  {
    f(own);
  }

  /// Over the values of all threads.
  CGAL_L0_HOST_DEVICE double sum(double value) const { return value; }
  CGAL_L0_HOST_DEVICE double least(double value) const { return value; }
  CGAL_L0_HOST_DEVICE bool all(bool value) const { return value; }

  /// At most `capacity` numbers, ascending.
  template <typename T, int capacity>
  class Sorted_numbers
  {
    T m_values[capacity];
    int m_size = 0;

  public:
    CGAL_L0_HOST_DEVICE explicit Sorted_numbers(const One_thread&) {}

    CGAL_L0_HOST_DEVICE int size() const { return m_size; }
    CGAL_L0_HOST_DEVICE T operator[](int rank) const { return m_values[rank]; }

    /// Adds a number of each thread where `is_there`, unless all are taken.
    CGAL_L0_HOST_DEVICE void add_if_room(T value, bool is_there)
    {
      if (is_there && m_size < capacity)
        insert(value, m_size++);
    }

    /// The same; if all are taken, the largest goes.
    CGAL_L0_HOST_DEVICE void add_if_small(T value, bool is_there)
    {
      if (!is_there || (m_size == capacity && !(value < m_values[capacity - 1])))
        return;
      m_size += m_size < capacity;
      insert(value, m_size - 1);
    }

  private:
    CGAL_L0_HOST_DEVICE void insert(T value, int place)
    {
      for (; place > 0 && value < m_values[place - 1]; --place)
        m_values[place] = m_values[place - 1];
      m_values[place] = value;
    }
  };
};

/// Places in the order of their Morton codes, in which balls of all radii are looked for. Points
/// that share a cell of level 0 have one place, its middle.
struct Morton_points
{
  Morton_cells cells;
  std::uint64_t size;
  const std::uint64_t* codes; ///< ascending, all different
  const double* xyz;          ///< of the places, interleaved

  CGAL_L0_HOST_DEVICE double squared_distance(const double* p, std::uint64_t i) const
  {
    const double dx = xyz[3 * i] - p[0], dy = xyz[3 * i + 1] - p[1], dz = xyz[3 * i + 2] - p[2];
    return dx * dx + dy * dy + dz * dz;
  }

  /// The first point whose code is not less.
  CGAL_L0_HOST_DEVICE std::uint64_t lower_bound(std::uint64_t code) const
  {
    std::uint64_t first = 0;
    for (std::uint64_t count = size; count > 0;)
    {
      const std::uint64_t half = count / 2;
      const bool is_before = codes[first + half] < code;
      first = is_before ? first + half + 1 : first;
      count = is_before ? count - half - 1 : half;
    }
    return first;
  }

  /// The first point from `first` on whose code is not less: found in few steps if it is near.
  CGAL_L0_HOST_DEVICE std::uint64_t lower_bound_from(std::uint64_t first, std::uint64_t code) const
  {
    std::uint64_t step = 1;
    for (; first + step <= size && codes[first + step - 1] < code; step *= 2)
      first += step;
    for (; step > 0; step /= 2)
      if (first + step <= size && codes[first + step - 1] < code)
        first += step;
    return first;
  }

  /*!
  Calls `f(i, squared_distance, is_inside)` for points around p: those closer to it than the radius
  are inside, and all of them are among them, but that of a cell of more than `most_of_cell` points
  one in so many is looked at.

  \param team the threads that share the ball, all of which call this: `f` is called by all at
  once, for a point of each, in the order of the points
  \returns whether all points of the ball were looked at
  */
  template <typename Team, typename F>
  CGAL_L0_HOST_DEVICE bool visit_ball(const Team& team, const double* p, double radius,
                                      std::uint64_t most_of_cell, const F& f) const
  {
    int level = 0;
    for (double width = cells.size; width < radius && level + 1 < Morton_cells::number_of_levels;
         width *= 2)
      ++level;
    std::int64_t low[3], count[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = cells.place(p[axis] - radius) >> level;
      count[axis] = (cells.place(p[axis] + radius) >> level) - low[axis] + 1;
    }
    const std::int64_t number_of_cells = count[0] * count[1] * count[2];
    bool are_all_looked_at = true;
    for (std::int64_t first = 0; first < number_of_cells; first += Team::number_of_threads)
    {
      Strided_range own = {0, 0, 1};
      const std::int64_t cell = first + team.lane();
      if (cell < number_of_cells)
      {
        const std::uint64_t code = Morton_cells::code(low[0] + cell % count[0],
                                                      low[1] + cell / count[0] % count[1],
                                                      low[2] + cell / (count[0] * count[1]));
        own.begin = lower_bound(code << 3 * level);
        own.end = lower_bound_from(own.begin, (code + 1) << 3 * level);
        own.stride = (own.end - own.begin) / most_of_cell + 1;
        are_all_looked_at = are_all_looked_at && own.stride == 1;
      }
      team.for_each_range(own, [&](const Strided_range& range) {
        const std::uint64_t step = range.stride * Team::number_of_threads;
        for (std::uint64_t i = range.begin; i < range.end; i += step)
        {
          const std::uint64_t k = i + range.stride * std::uint64_t(team.lane());
          const double d = k < range.end ? squared_distance(p, k) : 0;
          f(k, d, k < range.end && d < radius * radius);
        }
      });
    }
    return team.all(are_all_looked_at);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MORTON_POINTS_H
