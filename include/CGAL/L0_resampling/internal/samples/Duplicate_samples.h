// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DUPLICATE_SAMPLES_H
#define CGAL_L0_RESAMPLING_INTERNAL_DUPLICATE_SAMPLES_H

#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Samples that start close to a crowd of others and are not worked on: each keeps its place
/// relative to a sample that is, its leader.
struct Duplicate_samples
{
  Buffer<Index>
    leaders; ///< for each follower, where its leader stands in the first order of samples
  Buffer<Vector> offsets;           ///< from the leader to the follower, at the start
  Buffer<Index> sources;            ///< the point that each follower starts from
  Buffer<Index> numbers_of_samples; ///< for each leader, itself included; none without followers

  explicit Duplicate_samples(const Counting_allocator<Vector>& allocator)
    : leaders(allocator), offsets(allocator), sources(allocator), numbers_of_samples(allocator)
  {}

  bool is_empty() const { return leaders.empty(); }

  /// Appends the followers to the positions of their leaders.
  /// \param start_indices where each leader stood in the first order of samples
  void append_positions(const Buffer<Index>& start_indices, Buffer<Vector>& positions) const
  {
    append(start_indices, positions, [&](std::size_t k, std::size_t leader) -> Vector {
      return positions[leader] + offsets[k];
    });
  }

  /// Appends to each array, of one value for each leader, the same for each follower.
  template <typename T>
  void append_values(const Buffer<Index>& start_indices, Buffer<T>& values) const
  {
    append(start_indices, values,
           [&](std::size_t, std::size_t leader) -> T { return values[leader]; });
  }

private:
  template <typename T, typename F>
  void append(const Buffer<Index>& start_indices, Buffer<T>& values, const F& value_of) const
  {
    if (is_empty() || values.empty())
      return;
    Buffer<Index> places = filled_buffer(start_indices.size(), Index(0), leaders.get_allocator());
    for_each_in_order(start_indices.size(),
                      [&](std::size_t i) { places[start_indices[i]] = Index(i); });
    values.reserve(start_indices.size() + leaders.size());
    for_each_in_order(leaders.size(),
                      [&](std::size_t k) { values.push_back(value_of(k, places[leaders[k]])); });
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DUPLICATE_SAMPLES_H
