// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DIPOLES_OF_SETS_H
#define CGAL_L0_RESAMPLING_INTERNAL_DIPOLES_OF_SETS_H

#include <CGAL/L0_resampling/internal/core/Signed_union_find.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The samples that stand for those around them, as dipoles along their normals.
inline std::vector<Index> samples_of_dipoles(std::size_t number_of_samples)
{
  const std::size_t number_of_dipoles = (std::min)(number_of_samples,
                                                   std::size_t(maximum_number_of_dipoles));
  std::vector<Index> samples;
  for (std::size_t k = 0; k < number_of_dipoles; ++k)
    samples.push_back(Index(sample_of_dipole(k, number_of_samples, number_of_dipoles)));
  return samples;
}

struct Dipoles_of_set
{
  Index root;
  std::size_t count;
};

/// The sets that have dipoles, by their roots.
/// \param samples that are dipoles
inline std::vector<Dipoles_of_set> dipoles_of_sets(const std::vector<Index>& samples,
                                                   const Signed_union_find& sets)
{
  std::vector<Index> roots;
  for (Index i : samples)
    roots.push_back(sets.find(i).first);
  std::sort(roots.begin(), roots.end());
  std::vector<Dipoles_of_set> result;
  for (Index root : roots)
    if (!result.empty() && result.back().root == root)
      ++result.back().count;
    else
      result.push_back({root, 1});
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DIPOLES_OF_SETS_H
