// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_WINDINGS_OF_SETS_H
#define CGAL_L0_RESAMPLING_INTERNAL_WINDINGS_OF_SETS_H

#include <CGAL/L0_resampling/internal/core/lanes.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/orientation/Field_of_sets.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
The winding numbers that the sets of a field have at its dipoles, each turned as it is by itself.
They know of the whole surface at once (after Xu et al., Globally consistent normal orientation for
point clouds by regularizing the winding-number field, 2023), where two neighboring faces, by their
dipoles and the votes at their edge, may well be wrong together.
*/
class Windings_of_sets
{
  using Set = Field_of_sets::Set;

  std::vector<std::size_t> m_begins; // of the dipoles of each set; and the end of all
  std::size_t m_row;                 // length of a row, of whole lanes
  Aligned_vector<float> m_values;    // a row for each set, of a number for each dipole

public:
  /// \param begins number of dipoles before those of each set, and of all
  explicit Windings_of_sets(std::vector<std::size_t> begins)
    : m_begins(std::move(begins)), m_row(padded_to_lanes(m_begins.back())),
      m_values((m_begins.size() - 1) * m_row, 0)
  {}

  /// Of a set at a dipole of its tree.
  float& at(Set set, std::size_t dipole) { return m_values[set * m_row + dipole]; }

  /// Adds to the agreements of sets, and of sets with their present signs.
  /// \param samples_per_dipole that each stands for
  template <typename ConcurrencyTag>
  void add_to(Field_of_sets& field, double samples_per_dipole) const
  {
    const std::size_t n = field.roots.size();
    std::map<Index, std::size_t> dipoles_of_trees;
    std::vector<double> sums(n);
    for (Set a = 0; a < n; ++a)
    {
      dipoles_of_trees[field.trees[a]] += m_begins[a + 1] - m_begins[a];
      sums[a] = sum_of(a);
    }
    for_each_block<ConcurrencyTag>(n, 1, [&](std::size_t a, std::size_t) {
      const double count = double(dipoles_of_trees.at(field.trees[a])),
                   weight = weight_of_windings(samples_per_dipole * count, count);
      for (Set b = 0; b < n; ++b)
        if (b != a && field.trees[b] == field.trees[a])
          field.agreements[a * n + b] +=
            weight * winding_agreement(sum_of_products(a, b), sums[a], sums[b], count);
      field.unary_terms[a] += weight * minimum_gain_of_windings / 2 * field.signs[a]
                              * double(m_begins[a + 1] - m_begins[a]);
    });
  }

private:
  const float* row(Set a) const { return m_values.data() + a * m_row; }

  double sum_of(Set a) const
  {
    using L = Lanes<float>;
    L sum;
    for (std::size_t i = 0; i < m_row; i += L::size)
      sum += L::load(row(a) + i);
    return double(sum.sum());
  }

  double sum_of_products(Set a, Set b) const
  {
    using L = Lanes<float>;
    L sum;
    for (std::size_t i = 0; i < m_row; i += L::size)
      sum += L::load(row(a) + i) * L::load(row(b) + i);
    return double(sum.sum());
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_WINDINGS_OF_SETS_H
