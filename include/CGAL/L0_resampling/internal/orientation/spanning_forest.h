// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SPANNING_FOREST_H
#define CGAL_L0_RESAMPLING_INTERNAL_SPANNING_FOREST_H

#include <CGAL/L0_resampling/internal/orientation/dipoles_of_sets.h>
#include <CGAL/L0_resampling/internal/orientation/orientation_votes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Leaves the edges from one set to another only, in their order, between the representatives.
template <typename ConcurrencyTag>
void keep_edges_between_sets(const Signed_union_find& sets, Buffer<Edge>& edges)
{
  const auto between_sets = [&](const Edge& edge) -> std::optional<Edge> {
    const auto [root_i, sign_i] = sets.find(edge.i);
    const auto [root_k, sign_k] = sets.find(edge.k);
    if (root_i == root_k)
      return std::nullopt;
    return Edge{float(sign_i * sign_k) * edge.agreement, root_i, root_k};
  };
  keep_by_blocks<ConcurrencyTag>(edges_per_block, between_sets, edges);
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

\param sets what is joined from the start
\param edges in: between the samples, which are sorted by place; out: between the sets that have
grown
\returns these
*/
template <typename ConcurrencyTag>
Signed_union_find grow_forest(Signed_union_find sets, Buffer<Edge>& edges)
{
  const std::size_t number_of_samples = sets.size();
  const std::vector<Index> dipoles = samples_of_dipoles(number_of_samples);
  const std::size_t none = (std::numeric_limits<std::size_t>::max)();
  Buffer<std::size_t> surest = filled_buffer(number_of_samples, none,
                                             edges.get_allocator()); // edge of each set
  keep_edges_between_sets<ConcurrencyTag>(sets, edges);
  const auto for_each_sure_edge = [&](const auto& f) {
    for_each_in_order(edges.size(), [&](std::size_t e) {
      if (std::abs(edges[e].agreement) >= float(beyond_doubt))
        f(edges[e], e);
    });
  };
  for (bool is_joined = true; is_joined && !are_sets_large(dipoles, sets);)
  {
    is_joined = false;
    for_each_sure_edge(
      [&](const Edge& edge, std::size_t) { surest[edge.i] = surest[edge.k] = none; });
    for_each_sure_edge([&](const Edge& edge, std::size_t e) {
      for (const Index set : {edge.i, edge.k})
        if (surest[set] == none
            || step_of_agreement(edge.agreement) < step_of_agreement(edges[surest[set]].agreement))
          surest[set] = e;
    });
    for_each_sure_edge([&](const Edge& edge, std::size_t e) {
      if (surest[edge.i] == e || surest[edge.k] == e)
      {
        sets.join(edge.i, edge.k, edge.agreement < 0 ? -1 : 1);
        is_joined = true;
      }
    });
    sets.compress();
    keep_edges_between_sets<ConcurrencyTag>(sets, edges);
  }
  return sets;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SPANNING_FOREST_H
