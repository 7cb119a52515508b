// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_WINDING_NUMBERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_WINDING_NUMBERS_H

#include <CGAL/L0_resampling/internal/core/Signed_union_find.h>
#include <CGAL/L0_resampling/internal/core/lanes.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/kernels/side_confidence.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
What the dipoles of each tree say of each other's sides: the winding number of the others at the
place of each, and how far they agree. Trees do not know of each other.

Dipoles stand one tree after the other, each tree filled up with dipoles without a normal to whole
lanes. They are in single precision, relative to the first one of their tree, so that of a part far
away digits are left.
*/
class Dipoles_of_trees
{
  std::vector<Aligned_vector<float>> m_coordinates{6}; // of positions and normals

  struct Tree
  {
    std::size_t begin, end; // of its dipoles; filled up
  };
  std::vector<Tree> m_trees;
  std::vector<std::size_t> m_tree_of_dipole, m_place_of_dipole;

public:
  /// \param samples that are dipoles
  /// \param trees of the samples
  template <typename T>
  Dipoles_of_trees(const std::vector<Index>& samples, const Signed_union_find& trees,
                   const Buffer<Vector>& positions, const Buffer<Eigen::Matrix<T, 3, 1>>& normals)
    : m_tree_of_dipole(samples.size()), m_place_of_dipole(samples.size())
  {
    std::vector<std::pair<Index, std::size_t>> roots_and_dipoles;
    for (std::size_t k = 0; k < samples.size(); ++k)
      roots_and_dipoles.push_back({trees.find(samples[k]).first, k});
    std::sort(roots_and_dipoles.begin(), roots_and_dipoles.end());
    Vector origin = Vector::Zero();
    for (std::size_t n = 0; n < samples.size(); ++n)
    {
      const auto [root, k] = roots_and_dipoles[n];
      if (n == 0 || roots_and_dipoles[n - 1].first != root)
      {
        begin_tree();
        origin = positions[samples[k]];
      }
      m_tree_of_dipole[k] = m_trees.size() - 1;
      m_place_of_dipole[k] = m_coordinates[0].size();
      const Index i = samples[k];
      const float sign = float(trees.find(i).second);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const Eigen::Index a = Eigen::Index(axis);
        m_coordinates[axis].push_back(float(positions[i][a] - origin[a]));
        m_coordinates[3 + axis].push_back(sign * float(normals[i][a]));
      }
    }
    end_tree();
  }

  /// \param k the dipole
  /// \param area that a dipole stands for
  Side_evidence evidence_of(std::size_t k, double area) const
  {
    using L = Lanes<float>;
    const double squared_core_of_dipoles = squared_core_of_dipole(area);
    const float squared_core = float(squared_core_of_dipoles),
                least_squared_distance = float(
                  least_squared_distance_of_evidence(squared_core_of_dipoles));
    const std::size_t place = m_place_of_dipole[k];
    const auto [begin, end] = m_trees[m_tree_of_dipole[k]];
    const auto own = [&](std::size_t c) { return m_coordinates[c][place]; };
    L winding, agreement, total;
    for (std::size_t other = begin; other < end; other += L::size)
    {
      const auto at = [&](std::size_t c) { return L::load(&m_coordinates[c][other]); };
      const L x = at(0) - own(0), y = at(1) - own(1), z = at(2) - own(2);
      const L nx = at(3), ny = at(4), nz = at(5);
      const L height = nx * x + ny * y + nz * z, own_height = x * own(3) + y * own(4) + z * own(5),
              cosine = nx * own(3) + ny * own(4) + nz * own(5);
      const L squared_distance = x * x + y * y + z * z;
      const L of_pair =
        where_less(-squared_distance, -least_squared_distance,
                   dipole_agreement(cosine, height * own_height, squared_distance, squared_core));
      winding += winding_number_of_dipole(height, squared_distance, squared_core);
      agreement += of_pair;
      total += abs(of_pair);
    }
    const double all = double(total.sum());
    return {double(winding.sum()) * area, all > 0 ? double(agreement.sum()) / all : 0};
  }

private:
  void end_tree()
  {
    while (m_coordinates[0].size() % Lanes<float>::size != 0)
      for (auto& values : m_coordinates)
        values.push_back(0);
    if (!m_trees.empty())
      m_trees.back().end = m_coordinates[0].size();
  }
  void begin_tree()
  {
    end_tree();
    m_trees.push_back({m_coordinates[0].size(), 0});
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_WINDING_NUMBERS_H
