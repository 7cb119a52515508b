// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_OUTPUT_ITERATORS_H
#define CGAL_L0_RESAMPLING_INTERNAL_OUTPUT_ITERATORS_H

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Whether `*out++ = value` is possible, for an `out` of the first type.
template <typename OutputIterator, typename Value, typename = void>
struct Takes : std::false_type
{};
template <typename OutputIterator, typename Value>
struct Takes<OutputIterator, Value, std::void_t<decltype(*std::declval<OutputIterator&>()++)>>
  : std::is_assignable<decltype(*std::declval<OutputIterator&>()++), Value>
{};
/// Boost's iterator says that it takes everything, so its function is asked.
template <typename Function, typename Value>
struct Takes<boost::iterators::function_output_iterator<Function>, Value>
  : std::is_invocable<Function&, Value>
{};

/// Whether the iterator takes pairs of a position and a normal, as that of
/// `edge_aware_upsample_point_set()` does.
template <typename Kernel, typename OutputIterator>
constexpr bool takes_pairs =
  Takes<OutputIterator, std::pair<typename Kernel::Point_3, typename Kernel::Vector_3>>::value;

/// Whether the iterator takes positions, as that of `wlop_simplify_and_regularize_point_set()`
/// does.
template <typename Kernel, typename OutputIterator>
constexpr bool takes_points = Takes<OutputIterator, typename Kernel::Point_3>::value;

/// Writes a result: pairs, or their positions to an iterator that does not take pairs.
/// \param pair_of called with the place of a point in the result
/// \param out ends behind the last one written
template <typename Kernel, typename OutputIterator, typename PairOf>
void write_result(std::size_t size, const PairOf& pair_of, OutputIterator& out)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    if constexpr (takes_pairs<Kernel, OutputIterator>)
      *out++ = pair_of(i);
    else
      *out++ = pair_of(i).first;
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_OUTPUT_ITERATORS_H
