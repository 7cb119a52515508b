// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_GATHERED_VALUES_H
#define CGAL_L0_RESAMPLING_INTERNAL_GATHERED_VALUES_H

#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Numbers that belong to some candidates, padded as they are, one array each.
template <typename T, int n>
struct Gathered_values
{
  Aligned_vector<T> of[n];

  /// \param values called with the index of a candidate, and with an array for its n numbers
  template <typename F>
  void gather(const Local_points<T>& candidates, const F& values)
  {
    for (Aligned_vector<T>& array : of)
      array.assign(candidates.padded_size(), T(0));
    for (std::size_t k = 0; k < candidates.indices.size(); ++k)
    {
      T own[n];
      values(candidates.indices[k], own);
      for (int a = 0; a < n; ++a)
        of[a][k] = own[a];
    }
  }

  Lanes<T> load(int a, std::size_t k) const { return Lanes<T>::load(&of[a][k]); }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_GATHERED_VALUES_H
