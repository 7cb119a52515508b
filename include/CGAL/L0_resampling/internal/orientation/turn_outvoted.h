// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TURN_OUTVOTED_H
#define CGAL_L0_RESAMPLING_INTERNAL_TURN_OUTVOTED_H

#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/orientation/orientation_votes.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Turns each normal whose edges vote against the side that it has: it was joined by one of them.
/// \param edges between the samples, as the normals are
/// \param sets all that edges join is in one set
/// \param may_turn called with the index of a sample
template <typename T, typename F>
void turn_outvoted(const Buffer<Edge>& edges, const Signed_union_find& sets, const F& may_turn,
                   Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  const std::size_t m = normals.size();
  Buffer<signed char> signs(m, 1, normals.get_allocator());
  for_each_in_order(m, [&](std::size_t i) {
    signs[i] = static_cast<signed char>(sets.find(Index(i)).second);
  });
  for (int sweep = 0; sweep < sweeps_over_outvoted; ++sweep)
  {
    Buffer<float> votes(m, 0.f, normals.get_allocator());
    for_each_in_order(edges.size(), [&](std::size_t n) {
      const Edge& e = edges[n];
      const float vote = float(signs[e.i] * signs[e.k]) * e.agreement;
      votes[e.i] += vote;
      votes[e.k] += vote;
    });
    for_each_in_order(m, [&](std::size_t i) {
      if (votes[i] < 0 && may_turn(Index(i)))
      {
        signs[i] = static_cast<signed char>(-signs[i]);
        normals[i] = -normals[i];
      }
    });
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TURN_OUTVOTED_H
