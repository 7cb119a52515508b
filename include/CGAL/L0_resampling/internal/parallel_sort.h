// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H
#define CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H

#include <CGAL/tags.h>

#include <algorithm>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Sorts by an order without ties, so that the result does not depend on the number of threads.
template <typename ConcurrencyTag, typename Iterator, typename Less>
void sort(Iterator begin, Iterator end, const Less& less)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    return tbb::parallel_sort(begin, end, less);
#endif
  std::sort(begin, end, less);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H
