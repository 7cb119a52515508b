// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H

#include <CGAL/L0_resampling/internal/Orientation_hints.h>
#include <CGAL/L0_resampling/internal/nearest_samples.h>
#include <CGAL/L0_resampling/internal/orientation_agreement.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Two samples near each other, and `orientation_agreement()` of them.
struct Edge { float agreement; Index i, k; };

/// The edges of the graph of nearest neighbors, each once.
template <typename ConcurrencyTag, typename T>
Buffer<Edge> rated_edges(const Buffer<Vector>& positions, const Buffer<Eigen::Matrix<T, 3, 1>>& normals, std::size_t number_of_neighbors,
                         double spacing, Progress& progress)
{
  const double radius_of_that_many = spacing * std::sqrt(double(number_of_neighbors) / 2);
  const Nearest_samples nearest = find_nearest_samples<ConcurrencyTag>(positions, number_of_neighbors, radius_of_that_many, progress);
  const T squared_spacing = T(spacing * spacing);
  const auto append_edges_of = [&](Index i, Buffer<Edge>& edges) {
    for (const Index* other = nearest.begin(i); other != nearest.end(i); ++other)
    {
      const Index k = *other;
      if (k < i && nearest.contains(k, i))
        continue;
      const Eigen::Matrix<T, 3, 1> to_other = (positions[k] - positions[i]).template cast<T>();
      const T agreement =
        orientation_agreement(normals[i].dot(normals[k]), normals[i].dot(to_other), -normals[k].dot(to_other), squared_spacing);
      edges.push_back({float(agreement), i, k});
    }
  };
  const std::size_t samples_per_block = 4096, m = positions.size();
  const Counting_allocator<Edge> allocator = positions.get_allocator();
  std::vector<Buffer<Edge>> blocks((m + samples_per_block - 1) / samples_per_block, Buffer<Edge>(allocator));
  for_each_block<ConcurrencyTag>(m, samples_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      append_edges_of(Index(i), blocks[begin / samples_per_block]);
  });
  Buffer<Edge> edges(allocator);
  edges.reserve(std::accumulate(blocks.begin(), blocks.end(), std::size_t(0), [](std::size_t n, const Buffer<Edge>& b) { return n + b.size(); }));
  for (Buffer<Edge>& block : blocks)
  {
    edges.insert(edges.end(), block.begin(), block.end());
    release(block);
  }
  return edges;
}

/// The edges beyond doubt, sorted by how sure they are, in steps of 1/1024, which is all that a spanning forest of noisy normals needs.
inline Buffer<Edge> sure_edges(const Buffer<Edge>& edges)
{
  const std::size_t number_of_steps = 1024;
  const auto is_sure = [](const Edge& e) { return std::abs(e.agreement) >= beyond_doubt; };
  const auto step = [&](const Edge& e) { return std::size_t((1 - (std::min)(std::abs(e.agreement), 1.f)) * (number_of_steps - 1)); };
  std::vector<std::size_t> places(number_of_steps + 1, 0);
  for (const Edge& e : edges)
    if (is_sure(e))
      ++places[step(e) + 1];
  std::partial_sum(places.begin(), places.end(), places.begin());
  Buffer<Edge> sorted(places.back(), Edge(), edges.get_allocator());
  for (const Edge& e : edges)
    if (is_sure(e))
      sorted[places[step(e)]++] = e;
  return sorted;
}

/// Sets of samples whose normals are fixed relative to each other: union-find, where each sample knows whether it is turned
/// against its parent.
class Signed_union_find
{
  Buffer<Index> m_parents;
  Buffer<signed char> m_signs;   // of a sample relative to its parent
  Buffer<Index> m_sizes;

public:
  Signed_union_find(std::size_t size, const Counting_allocator<Index>& allocator)
    : m_parents(size, 0, allocator), m_signs(size, 1, allocator), m_sizes(size, 1, allocator)
  {
    for (std::size_t i = 0; i < size; ++i)
      m_parents[i] = Index(i);
  }

  /// The set's representative, and the sign of `i` relative to it.
  std::pair<Index, int> find(Index i)
  {
    Index root = i;
    int sign = 1;
    while (m_parents[root] != root)
    {
      sign *= m_signs[root];
      root = m_parents[root];
    }
    // path compression: hang everything on the way below the root
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

  /// Joins the sets of `i` and `k` so that the two have the relative sign `sign`, if they are not in one set yet.
  void join(Index i, Index k, int sign)
  {
    auto [root_i, sign_i] = find(i);
    auto [root_k, sign_k] = find(k);
    if (root_i == root_k)
      return;
    if (m_sizes[root_i] < m_sizes[root_k])
      std::swap(root_i, root_k);
    m_parents[root_k] = root_i;
    m_signs[root_k] = static_cast<signed char>(sign * sign_i * sign_k);
    m_sizes[root_i] += m_sizes[root_k];
  }

  std::size_t size() const { return m_parents.size(); }

  /// Number of samples in the set that `root` represents.
  Index size_of_set(Index root) const { return m_sizes[root]; }
};

/// The sum of the agreements of edges between two samples or, read for their representatives, between two sets.
struct Vote { Index a, b; double agreement, total; };

/// The votes between the sets as they are now: one for each pair that touches, in the order of the pairs.
inline void add_up_votes(Buffer<Vote>& votes, Signed_union_find& sets)
{
  std::size_t size = 0;
  for (const Vote& v : votes)
  {
    const auto [root_a, sign_a] = sets.find(v.a);
    const auto [root_b, sign_b] = sets.find(v.b);
    if (root_a != root_b)
      votes[size++] = {(std::min)(root_a, root_b), (std::max)(root_a, root_b), sign_a * sign_b * v.agreement, v.total};
  }
  votes.resize(size);
  sort_by_key<Sequential_tag>(votes.begin(), votes.end(), [](const Vote& v) { return (std::uint64_t(v.a) << 32) | v.b; },
                              [](const Vote& v, const Vote& w) { return v.agreement < w.agreement; });
  size = 0;
  for (const Vote& v : votes)
    if (size > 0 && votes[size - 1].a == v.a && votes[size - 1].b == v.b)
    {
      votes[size - 1].agreement += v.agreement;
      votes[size - 1].total += v.total;
    }
    else
      votes[size++] = v;
  votes.resize(size);
}

/// Joins sets that touch by majority: round by round, each set with the neighbor that their votes are most of one mind about.
/// \param sure the share of the votes, in [0, 1], that the winning side has to be ahead by
inline void join_by_votes(double sure, Buffer<Vote>& votes, Signed_union_find& sets)
{
  const std::size_t none = (std::numeric_limits<std::size_t>::max)();
  Buffer<std::size_t> strongest(sets.size(), none, votes.get_allocator());   // the vote of each set that it joins by
  const auto is_stronger = [&](std::size_t v, std::size_t w) {
    const double a = std::abs(votes[v].agreement), b = std::abs(votes[w].agreement);
    return a != b ? a > b : v < w;
  };
  for (bool is_joined = true; is_joined;)
  {
    is_joined = false;
    add_up_votes(votes, sets);
    for (const Vote& v : votes)
      strongest[v.a] = strongest[v.b] = none;
    for (std::size_t n = 0; n < votes.size(); ++n)
      if (std::abs(votes[n].agreement) >= sure * votes[n].total)
        for (const Index set : {votes[n].a, votes[n].b})
          if (strongest[set] == none || is_stronger(n, strongest[set]))
            strongest[set] = n;
    for (std::size_t n = 0; n < votes.size(); ++n)
      if (strongest[votes[n].a] == n || strongest[votes[n].b] == n)
      {
        sets.join(votes[n].a, votes[n].b, votes[n].agreement < 0 ? -1 : 1);
        is_joined = true;
      }
  }
}

/// The hints of samples that have none.
inline Vector no_hint(Index) { return Vector::Zero(); }

/// Whether the normals of a tree point inwards as a whole. A flat tree has no inside: its normals shall point up its steepest axis.
inline bool is_turned_inwards(double flux, double largest_flux, const Vector& normal_sum)
{
  const double rounding = 1e-9;
  if (std::abs(flux) > rounding * largest_flux)
    return flux < 0;
  Eigen::Index axis;
  normal_sum.cwiseAbs().maxCoeff(&axis);
  return normal_sum[axis] < 0;
}

/// How sure the sides are that `orient_normals()` has chosen, as shares of the samples.
struct Orientation
{
  double oriented_share;   ///< joined to the largest part of their tree by edges beyond doubt and clear majorities only
  double hinted_share;     ///< of trees whose side is that of the hints
};

/*!
Turns the normals of the samples to one side. Over the edges of the graph of nearest neighbors where `orientation_agreement()` is beyond
doubt, sets of samples grow as the maximum spanning forest of Hoppe et al. does. Where sets touch, across a sharp edge or through noise, one edge
may well err, and would turn a whole face; there, all edges between two sets vote. Then the sets that hang together are turned
as a whole: to the side of the hints where these are clear, else outwards, in the sense of the divergence theorem: \f$ \sum n_i^T (p_i - \bar p) > 0 \f$. Works on indices; no sample changes its
place.

\param positions, normals unit vectors of any sign in, consistent out
\param number_of_neighbors of the graph, at least 1
\param spacing of the samples, roughly: more than a 1000th of it, and not so much that it spans the cloud
\param hint_of called with the index of a sample, gives a vector to the side its normal shall be on, of the length that it counts; may be zero
*/
template <typename ConcurrencyTag, typename T, typename HintOf>
Orientation orient_normals(const Buffer<Vector>& positions, std::size_t number_of_neighbors, double spacing, const HintOf& hint_of,
                           Progress& progress, Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  const auto normal = [&](Index i) -> Vector { return normals[i].template cast<double>(); };
  const std::size_t m = positions.size();
  Signed_union_find sets(m, positions.get_allocator());
  Buffer<Vote> votes(positions.get_allocator());
  {
    const Buffer<Edge> edges = rated_edges<ConcurrencyTag>(positions, normals, number_of_neighbors, spacing, progress);
    for (const Edge& edge : sure_edges(edges))
      sets.join(edge.i, edge.k, edge.agreement < 0 ? -1 : 1);
    for (const Edge& edge : edges)
      if (sets.find(edge.i).first != sets.find(edge.k).first)
        votes.push_back({edge.i, edge.k, edge.agreement, std::abs(edge.agreement)});
  }
  join_by_votes(clear_majority, votes, sets);
  Buffer<Index> sure_set_sizes(m, 0, positions.get_allocator());
  for (Index i = 0; i < m; ++i)
    sure_set_sizes[i] = sets.size_of_set(sets.find(i).first);
  join_by_votes(0, votes, sets);

  struct Tree
  {
    Vector center = Vector::Zero();
    Vector normal_sum = Vector::Zero();
    double flux = 0, largest_flux = 0;   // of the divergence theorem, and if all normals pointed away from the center
    Hint_votes votes;
    Index largest_sure_set = 0;
  };
  Buffer<Tree> trees(m, Tree(), positions.get_allocator());   // that of a sample stands at its root
  for (Index i = 0; i < m; ++i)
  {
    const Index root = sets.find(i).first;
    trees[root].center += positions[i] / double(sets.size_of_set(root));
    trees[root].largest_sure_set = (std::max)(trees[root].largest_sure_set, sure_set_sizes[i]);
  }
  std::size_t number_of_oriented = 0;
  for (Index i = 0; i < m; ++i)
  {
    const auto [root, sign] = sets.find(i);
    Tree& tree = trees[root];
    const Vector from_center = positions[i] - tree.center;
    tree.flux += sign * normal(i).dot(from_center);
    tree.largest_flux += from_center.norm();
    tree.normal_sum += sign * normal(i);
    tree.votes.add(sign * normal(i), hint_of(i));
    number_of_oriented += sets.size_of_set(root) > 1 && sure_set_sizes[i] == tree.largest_sure_set;
  }
  std::size_t number_of_hinted = 0;
  for (Index i = 0; i < m; ++i)
  {
    const auto [root, sign] = sets.find(i);
    const Tree& tree = trees[root];
    const bool is_hinted = tree.votes.are_clear();
    const bool is_turned = is_hinted ? tree.votes.say_turn() : is_turned_inwards(tree.flux, tree.largest_flux, tree.normal_sum);
    number_of_hinted += is_hinted;
    if (is_turned != (sign < 0))
      normals[i] = -normals[i];
  }
  return {double(number_of_oriented) / double(m), double(number_of_hinted) / double(m)};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H
