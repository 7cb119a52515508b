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

#include <algorithm>
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
    const std::size_t size = candidates.indices.size(), padded_size = candidates.padded_size();
    T* to[n];
    for (int a = 0; a < n; ++a)
    {
      of[a].resize(padded_size);
      to[a] = of[a].data();
    }
    for (std::size_t k = 0; k < size; ++k)
    {
      T own[n];
      values(candidates.indices[k], own);
      for (int a = 0; a < n; ++a)
        to[a][k] = own[a];
    }
    for (T* array : to)
      std::fill(array + size, array + padded_size, T(0));
  }

  Lanes<T> load(int a, std::size_t k) const { return Lanes<T>::load(&of[a][k]); }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_GATHERED_VALUES_H
