// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_WINDING_NUMBERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_WINDING_NUMBERS_H

#include <CGAL/L0_resampling/internal/core/Signed_union_find.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/kernels/side_confidence.h>
#include <CGAL/L0_resampling/internal/orientation/Dipole_lanes.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the dipoles of each tree say of each other's sides: the winding number of the others at the
/// place of each, and how far they agree. Trees do not know of each other.
class Dipoles_of_trees
{
  Dipole_lanes m_dipoles;
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
    for (std::size_t n = 0; n < samples.size(); ++n)
    {
      const auto [root, k] = roots_and_dipoles[n];
      const Index i = samples[k];
      if (n == 0 || roots_and_dipoles[n - 1].first != root)
        m_dipoles.begin_group(positions[i]);
      m_tree_of_dipole[k] = m_dipoles.groups().size() - 1;
      m_place_of_dipole[k] = m_dipoles.add(positions[i], double(trees.find(i).second)
                                                           * normals[i].template cast<double>());
    }
    m_dipoles.fill_up();
  }

  /// \param k the dipole
  /// \param area that a dipole stands for
  Side_evidence evidence_of(std::size_t k, double area) const
  {
    using L = Dipole_lanes::L;
    const double squared_core_of_dipoles = squared_core_of_dipole(area);
    const float squared_core = float(squared_core_of_dipoles),
                minimum_squared_distance = float(
                  minimum_squared_distance_of_evidence(squared_core_of_dipoles));
    L winding, agreement, total;
    m_dipoles.for_each_pair(
      m_place_of_dipole[k], m_dipoles.groups()[m_tree_of_dipole[k]],
      [&](const Dipole_lanes::Pairs& pairs) {
        const L of_pairs = where_less(
          -pairs.squared_distance, -minimum_squared_distance,
          dipole_agreement(pairs.cosine, pairs.height_over_others * pairs.height_over_own,
                           pairs.squared_distance, squared_core));
        winding += winding_number_of_dipole(pairs.height_over_others, pairs.squared_distance,
                                            squared_core);
        agreement += of_pairs;
        total += abs(of_pairs);
      });
    const double all = double(total.sum());
    return {double(winding.sum()) * area, all > 0 ? double(agreement.sum()) / all : 0};
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_WINDING_NUMBERS_H
