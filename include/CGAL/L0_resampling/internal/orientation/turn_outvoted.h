// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TURN_OUTVOTED_H
#define CGAL_L0_RESAMPLING_INTERNAL_TURN_OUTVOTED_H

#include <CGAL/L0_resampling/internal/core/Signed_union_find.h>
#include <CGAL/L0_resampling/internal/core/lanes.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/Sum_of_vectors.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>
#include <CGAL/L0_resampling/internal/search/nearest_samples.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The normals around a point, relative to its place, as many at once as there are lanes.
template <typename T>
class Normals_around
{
  using L = Lanes<T>;
  std::size_t m_size = 0;
  std::vector<Aligned_vector<T>> m_numbers{7}; // places, normals and tolerances

public:
  void clear(std::size_t maximum_size)
  {
    m_size = 0;
    for (auto& numbers : m_numbers)
      numbers.resize(maximum_size + std::size_t(L::size));
  }

  void add(const Eigen::Matrix<T, 3, 1>& place, const Eigen::Matrix<T, 3, 1>& normal,
           T squared_tolerance)
  {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      m_numbers[std::size_t(axis)][m_size] = place[axis];
      m_numbers[std::size_t(3 + axis)][m_size] = normal[axis];
    }
    m_numbers[6][m_size++] = (std::max)(squared_tolerance, (std::numeric_limits<T>::min)());
  }

  /// The sum of those that are on the sheet of the point.
  Eigen::Matrix<T, 3, 1> sum(const Eigen::Matrix<T, 3, 1>& own)
  {
    for (std::size_t k = m_size; k < m_size + std::size_t(L::size); ++k)
      for (std::size_t c = 0; c < m_numbers.size(); ++c)
        m_numbers[c][k] = T(c == 6);
    Sum_of_vectors<L> sum;
    for (std::size_t k = 0; k < m_size; k += std::size_t(L::size))
    {
      const auto at = [&](std::size_t c) { return L::load(&m_numbers[c][k]); };
      const L x = at(0), y = at(1), z = at(2), nx = at(3), ny = at(4), nz = at(5);
      const L height = x * own[0] + y * own[1] + z * own[2],
              other_height = x * nx + y * ny + z * nz;
      sum.add(nx, ny, nz, share_of_one_sheet(height * height + other_height * other_height, at(6)));
    }
    return {sum.x.sum(), sum.y.sum(), sum.z.sum()};
  }
};

/*!
Turns each normal that the normals around it outvote: it was joined to them by one edge or by a few.
In each sweep all votes are on the sides that normals have at its begin, so that the order of points
does not matter.

\param sets those of another do not vote
\param squared_tolerances of the heights of each point
\param may_turn called with the index of a point, at the same time for several
\returns of each point the sum of the normals around it that are on its sheet, with their signs in
its set, and of its own; of one that may not turn its own alone. It tells the side of other points
there.
*/
template <typename ConcurrencyTag, typename T, typename F>
Buffer<Eigen::Matrix<T, 3, 1>> turn_outvoted(const Buffer<Vector>& positions,
                                             const Nearest_samples& nearest,
                                             const Signed_union_find& sets,
                                             const Buffer<T>& squared_tolerances, const F& may_turn,
                                             Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  using Normal = Eigen::Matrix<T, 3, 1>;
  const std::size_t points_per_task = 2048, m = normals.size();
  const auto for_each_point = [&](const auto& f) {
    for_each_block<ConcurrencyTag>(m, points_per_task, [&](std::size_t begin, std::size_t end) {
      Normals_around<T> around;
      for (Index i = Index(begin); i < end; ++i)
        f(i, around);
    });
  };
  Buffer<signed char> signs(m, normals.get_allocator());
  Buffer<Index> roots(m, normals.get_allocator());
  for_each_point([&](Index i, auto&) {
    const auto [root, sign] = sets.find(i);
    roots[i] = root;
    signs[i] = static_cast<signed char>(sign);
  });
  Buffer<unsigned char> has_turned(m, 0, normals.get_allocator());
  Buffer<Normal> sums(m, Normal::Zero(), normals.get_allocator());
  const auto sum_around = [&](Index i, const Normal& own, Normals_around<T>& around) -> Normal {
    around.clear(std::size_t(nearest.end(i) - nearest.begin(i)));
    for (const Index* other = nearest.begin(i); other != nearest.end(i); ++other)
    {
      const Index k = *other;
      if (roots[k] != roots[i])
        continue;
      around.add((positions[k] - positions[i]).template cast<T>(), T(signs[k]) * normals[k],
                 (std::max)(squared_tolerances[i], squared_tolerances[k]));
    }
    const Normal sum = around.sum(own);
    if (!sum.allFinite()) // heights that cannot be squared
      return own;
    return sum + (sum.dot(own) < 0 ? -1 : 1) * own;
  };
  for (int sweep = 0; sweep < sweeps_over_outvoted; ++sweep)
  {
    for_each_point([&](Index i, Normals_around<T>& around) {
      const Normal own = T(signs[i]) * normals[i];
      if (!may_turn(i))
        sums[i] = own;
      else if (sweep == 0 || std::any_of(nearest.begin(i), nearest.end(i), [&](Index k) {
                 return has_turned[k] != 0;
               }))
        sums[i] = sum_around(i, own, around);
    });
    for_each_point([&](Index i, auto&) {
      has_turned[i] = T(signs[i]) * sums[i].dot(normals[i]) < 0;
      if (has_turned[i])
        normals[i] = -normals[i];
    });
  }
  return sums;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TURN_OUTVOTED_H
