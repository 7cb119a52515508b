// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SELECT_NTH_H
#define CGAL_L0_RESAMPLING_INTERNAL_SELECT_NTH_H

#include <CGAL/L0_resampling/internal/core/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// As `std::nth_element()`, for numbers, but in steps between which the watcher of the loops of
/// this thread looks: of ten million numbers the whole takes longer than a caller shall wait.
template <typename Iterator>
void select_nth(Iterator first, Iterator nth, Iterator last)
{
  using Number = typename std::iterator_traits<Iterator>::value_type;
  const std::ptrdiff_t few = std::ptrdiff_t(1) << 20, number_of_probes = 1023;
  while (last - first > few)
  {
    // the probe of the same rank splits off nearly everything on the wrong side
    std::vector<Number> probes;
    const std::ptrdiff_t stride = (last - first) / number_of_probes;
    for (std::ptrdiff_t k = 0; k < number_of_probes; ++k)
      probes.push_back(*(first + k * stride));
    const auto probe = probes.begin()
                       + std::ptrdiff_t(double(nth - first) / double(last - first)
                                        * double(number_of_probes));
    std::nth_element(probes.begin(), probe, probes.end());
    const Number pivot = *probe;
    const Iterator equal = std::partition(first, last, [=](Number x) { return x < pivot; });
    poll_for_cancellation();
    if (nth < equal)
    {
      last = equal;
      continue;
    }
    const Iterator greater = std::partition(equal, last, [=](Number x) { return !(pivot < x); });
    poll_for_cancellation();
    if (nth < greater)
      return;
    first = greater;
  }
  std::nth_element(first, nth, last);
}

/// The middle one of the values, the upper of two.
template <typename T>
T median_of(Buffer<T> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  select_nth(values.begin(), middle, values.end());
  return *middle;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SELECT_NTH_H
