// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_KEEP_ONE_OF_EACH_H
#define CGAL_L0_RESAMPLING_INTERNAL_KEEP_ONE_OF_EACH_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Sorts the values by their keys, and keeps one of those that have the same key.
template <typename T, typename Allocator, typename KeyOf>
void keep_one_of_each(const KeyOf& key_of, std::vector<T, Allocator>& values)
{
  std::sort(values.begin(), values.end(),
            [&](const T& a, const T& b) { return key_of(a) < key_of(b); });
  values.erase(std::unique(values.begin(), values.end(),
                           [&](const T& a, const T& b) { return key_of(a) == key_of(b); }),
               values.end());
}

/// The same for values that are keys.
template <typename T, typename Allocator>
void keep_one_of_each(std::vector<T, Allocator>& values)
{
  keep_one_of_each([](const T& value) { return value; }, values);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_KEEP_ONE_OF_EACH_H
