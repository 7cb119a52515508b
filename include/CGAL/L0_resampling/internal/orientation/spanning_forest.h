// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SPANNING_FOREST_H
#define CGAL_L0_RESAMPLING_INTERNAL_SPANNING_FOREST_H

#include <CGAL/L0_resampling/internal/orientation/dipoles_of_sets.h>
#include <CGAL/L0_resampling/internal/orientation/orientation_votes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The edges beyond doubt from one set to another, between the representatives of the sets.
template <typename ConcurrencyTag>
Buffer<Edge> sure_edges_between_sets(const Buffer<Edge>& edges, const Signed_union_find& sets)
{
  return append_by_blocks<ConcurrencyTag>(
    edges.size(), edges_per_block, edges.get_allocator(),
    [&](std::size_t begin, std::size_t end, Buffer<Edge>& sure_ones) {
      for (std::size_t e = begin; e < end; ++e)
      {
        if (!(std::abs(edges[e].agreement) >= float(beyond_doubt)))
          continue;
        const auto [root_i, sign_i] = sets.find(edges[e].i);
        const auto [root_k, sign_k] = sets.find(edges[e].k);
        if (root_i != root_k)
          sure_ones.push_back({float(sign_i * sign_k) * edges[e].agreement, root_i, root_k});
      }
    });
}

/// Whether large sets hold most of the samples, see `are_sets_large()`.
inline bool are_sets_large(const std::vector<Index>& samples_of_dipoles,
                           const Signed_union_find& sets)
{
  std::size_t dipoles_of_large_sets = 0;
  for (const Dipoles_of_set& set : dipoles_of_sets(samples_of_dipoles, sets))
    if (set.count >= dipoles_of_large_set)
      dipoles_of_large_sets += set.count;
  return are_sets_large(dipoles_of_large_sets, samples_of_dipoles.size());
}

/*!
Joins samples over the edges beyond doubt, by the rounds of Boruvka (1926): every set takes the
surest edge that leads out of it, the first one of those that are equally sure. If rounds went on
until no such edge is left, this would be the maximum spanning forest of Hoppe et al.; they end once
sets are large.

\param edges between the samples, which are sorted by place
\param sets what is joined from the start
\returns the sets that have grown
*/
template <typename ConcurrencyTag>
Signed_union_find grow_forest(const Buffer<Edge>& edges, Signed_union_find sets)
{
  const std::size_t number_of_samples = sets.size();
  const std::vector<Index> dipoles = samples_of_dipoles(number_of_samples);
  Buffer<Edge> outer = sure_edges_between_sets<ConcurrencyTag>(edges, sets);
  const std::size_t none = (std::numeric_limits<std::size_t>::max)();
  Buffer<std::size_t> surest = filled_buffer(number_of_samples, none,
                                             edges.get_allocator()); // edge of each set
  while (!outer.empty() && !are_sets_large(dipoles, sets))
  {
    for_each_in_order(outer.size(),
                      [&](std::size_t e) { surest[outer[e].i] = surest[outer[e].k] = none; });
    for_each_in_order(outer.size(), [&](std::size_t e) {
      for (const Index set : {outer[e].i, outer[e].k})
        if (surest[set] == none
            || step_of_agreement(outer[e].agreement)
                 < step_of_agreement(outer[surest[set]].agreement))
          surest[set] = e;
    });
    for_each_in_order(outer.size(), [&](std::size_t e) {
      if (surest[outer[e].i] == e || surest[outer[e].k] == e)
        sets.join(outer[e].i, outer[e].k, outer[e].agreement < 0 ? -1 : 1);
    });
    sets.compress();
    outer = sure_edges_between_sets<ConcurrencyTag>(outer, sets);
  }
  return sets;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SPANNING_FOREST_H
