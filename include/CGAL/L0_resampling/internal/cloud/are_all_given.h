// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ARE_ALL_GIVEN_H
#define CGAL_L0_RESAMPLING_INTERNAL_ARE_ALL_GIVEN_H

#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Whether there is a normal for each point.
template <typename ConcurrencyTag>
bool are_all_given(const Buffer<Local_vector>& given_normals)
{
  const std::size_t block_size = 65536;
  const auto number_of_zeros = [&](std::size_t begin, std::size_t end) {
    return std::count_if(given_normals.begin() + std::ptrdiff_t(begin),
                         given_normals.begin() + std::ptrdiff_t(end),
                         [](const Local_vector& n) { return n.isZero(0); });
  };
  return !given_normals.empty()
         && block_sum<ConcurrencyTag>(given_normals.size(), block_size, number_of_zeros) == 0;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ARE_ALL_GIVEN_H
