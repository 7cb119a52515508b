// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H
#define CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H

#include <CGAL/tags.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Sorts by a key, a `std::uint64_t`, and values of equal keys by `less`, an order without ties, so that the result does not depend on the
/// number of threads.
template <typename ConcurrencyTag, typename Iterator, typename Key, typename Less>
void sort_by_key(Iterator begin, Iterator end, const Key& key, const Less& less)
{
  using Value = typename std::iterator_traits<Iterator>::value_type;
#ifdef CGAL_LINKED_WITH_TBB
  if (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    return tbb::parallel_sort(begin, end, [&](const Value& a, const Value& b) { return key(a) != key(b) ? key(a) < key(b) : less(a, b); });
#endif
  boost::sort::spreadsort::integer_sort(begin, end, [&](const Value& a, unsigned shift) -> std::uint64_t { return key(a) >> shift; },
                                        [&](const Value& a, const Value& b) { return key(a) < key(b); });
  for (Iterator first = begin, last = begin; first != end; first = last)
  {
    last = std::find_if(first, end, [&](const Value& a) { return key(a) != key(*first); });
    std::sort(first, last, less);
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H
