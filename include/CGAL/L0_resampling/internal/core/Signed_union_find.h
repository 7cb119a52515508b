// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SIGNED_UNION_FIND_H
#define CGAL_L0_RESAMPLING_INTERNAL_SIGNED_UNION_FIND_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Sets of samples whose normals are fixed relative to each other: union-find, where each sample
/// knows whether it is turned against its parent.
class Signed_union_find
{
  Buffer<Index> m_parents;
  Buffer<signed char> m_signs; // of a sample relative to its parent
  Buffer<Index> m_sizes;

public:
  Signed_union_find(std::size_t size, const Counting_allocator<Index>& allocator)
    : m_parents(allocator), m_signs(filled_buffer(size, static_cast<signed char>(1), allocator)),
      m_sizes(filled_buffer(size, Index(1), allocator))
  {
    m_parents.reserve(size);
    for_each_in_order(size, [&](std::size_t i) { m_parents.push_back(Index(i)); });
  }

  Signed_union_find(const Signed_union_find& other)
    : m_parents(copy_of(other.m_parents)), m_signs(copy_of(other.m_signs)),
      m_sizes(copy_of(other.m_sizes))
  {}
  Signed_union_find(Signed_union_find&&) = default;
  Signed_union_find& operator=(Signed_union_find&&) = default;

  /// The set's representative, and the sign of `i` relative to it.
  std::pair<Index, int> find(Index i) const
  {
    Index root = i;
    int sign = 1;
    while (m_parents[root] != root)
    {
      sign *= m_signs[root];
      root = m_parents[root];
    }
    return {root, sign};
  }

  /// Also hangs everything on the way below the root, so that the next way is short.
  std::pair<Index, int> find_and_compress(Index i)
  {
    const auto [root, sign] = find(i);
    int remaining = sign;
    while (m_parents[i] != root && i != root)
    {
      const Index next = m_parents[i];
      const int own = m_signs[i];
      m_parents[i] = root;
      m_signs[i] = static_cast<signed char>(remaining);
      remaining *= own;
      i = next;
    }
    return {root, sign};
  }

  /// Joins the sets of `i` and `k` so that the two have the relative sign `sign`, if they are not
  /// in one set yet.
  void join(Index i, Index k, int sign)
  {
    auto [root_i, sign_i] = find_and_compress(i);
    auto [root_k, sign_k] = find_and_compress(k);
    if (root_i == root_k)
      return;
    if (m_sizes[root_i] < m_sizes[root_k])
      std::swap(root_i, root_k);
    m_parents[root_k] = root_i;
    m_signs[root_k] = static_cast<signed char>(sign * sign_i * sign_k);
    m_sizes[root_i] += m_sizes[root_k];
  }

  /// Makes each way as short as can be.
  void compress()
  {
    for_each_in_order(m_parents.size(), [&](std::size_t i) { find_and_compress(Index(i)); });
  }

  std::size_t size() const { return m_parents.size(); }

  /// Number of samples in the set that `root` represents.
  Index size_of_set(Index root) const { return m_sizes[root]; }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SIGNED_UNION_FIND_H
