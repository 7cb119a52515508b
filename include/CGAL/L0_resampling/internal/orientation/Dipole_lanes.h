// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DIPOLE_LANES_H
#define CGAL_L0_RESAMPLING_INTERNAL_DIPOLE_LANES_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/lanes.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Dipoles, one group after the other, each filled up with dipoles without a normal to whole lanes.
/// They are in single precision, relative to a place of their tree, so that of a part far away
/// digits are left.
class Dipole_lanes
{
public:
  using L = Lanes<float>;

  /// The places of a group, filled up.
  struct Group
  {
    std::size_t begin, end;
  };

  /// What a dipole and others are to each other: the heights of each over the other's plane, the
  /// cosine between their normals, and the squared distance.
  struct Pairs
  {
    L height_over_others, height_over_own, cosine, squared_distance;
  };

private:
  std::vector<Aligned_vector<float>> m_coordinates{6}; // of positions and normals
  std::vector<Group> m_groups;
  Vector m_origin = Vector::Zero();

public:
  /// The dipoles that are added next are another group.
  /// \param origin a place of their tree
  void begin_group(const Vector& origin)
  {
    fill_up();
    m_groups.push_back({size(), size()});
    m_origin = origin;
  }

  /// \returns its place
  std::size_t add(const Vector& position, const Vector& normal)
  {
    const std::size_t place = size();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Eigen::Index a = Eigen::Index(axis);
      m_coordinates[axis].push_back(float(position[a] - m_origin[a]));
      m_coordinates[3 + axis].push_back(float(normal[a]));
    }
    return place;
  }

  /// To be called after the last one was added.
  void fill_up()
  {
    while (size() % L::size != 0)
      for (auto& values : m_coordinates)
        values.push_back(0);
    if (!m_groups.empty())
      m_groups.back().end = size();
  }

  /// Makes the normal of a dipole longer or shorter.
  void scale_normal(std::size_t place, double factor)
  {
    for (std::size_t c = 3; c < 6; ++c)
      m_coordinates[c][place] *= float(factor);
  }

  const std::vector<Group>& groups() const { return m_groups; }

  /// Calls `f` with the `Pairs` of a dipole and those of a group, lanes of them at a time.
  /// \param place of the dipole
  template <typename F>
  void for_each_pair(std::size_t place, const Group& others, const F& f) const
  {
    const auto own = [&](std::size_t c) { return m_coordinates[c][place]; };
    for (std::size_t other = others.begin; other < others.end; other += L::size)
    {
      const auto at = [&](std::size_t c) { return L::load(&m_coordinates[c][other]); };
      const L x = at(0) - own(0), y = at(1) - own(1), z = at(2) - own(2);
      const L nx = at(3), ny = at(4), nz = at(5);
      f(Pairs{nx * x + ny * y + nz * z, x * own(3) + y * own(4) + z * own(5),
              nx * own(3) + ny * own(4) + nz * own(5), x * x + y * y + z * z});
    }
  }

private:
  std::size_t size() const { return m_coordinates[0].size(); }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DIPOLE_LANES_H
