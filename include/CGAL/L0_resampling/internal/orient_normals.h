// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H

#include <CGAL/L0_resampling/internal/nearest_samples.h>
#include <CGAL/L0_resampling/internal/orientation_agreement.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Two samples near each other, and `orientation_agreement()` of them.
struct Edge { float agreement; Index i, k; };
constexpr std::size_t edges_per_block = 16384;

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
  return append_by_blocks<ConcurrencyTag>(positions.size(), 4096, Counting_allocator<Edge>(positions.get_allocator()),
                                          [&](std::size_t begin, std::size_t end, Buffer<Edge>& edges) {
    for (std::size_t i = begin; i < end; ++i)
      append_edges_of(Index(i), edges);
  });
}

/// The edges beyond doubt, sorted by how sure they are, in steps of 1/1024, which is all that a spanning forest of noisy normals needs.
template <typename ConcurrencyTag>
Buffer<Edge> sure_edges(const Buffer<Edge>& edges)
{
  Buffer<Edge> sure = append_by_blocks<ConcurrencyTag>(edges.size(), edges_per_block, edges.get_allocator(),
                                                       [&](std::size_t begin, std::size_t end, Buffer<Edge>& sure_ones) {
    for (std::size_t e = begin; e < end; ++e)
      if (std::abs(edges[e].agreement) >= beyond_doubt)
        sure_ones.push_back(edges[e]);
  });
  const std::size_t number_of_steps = 1024;
  const auto step = [&](const Edge& e) { return std::size_t((1 - (std::min)(std::abs(e.agreement), 1.f)) * (number_of_steps - 1)); };
  std::vector<std::size_t> places(number_of_steps + 1, 0);
  for (const Edge& e : sure)
    ++places[step(e) + 1];
  std::partial_sum(places.begin(), places.end(), places.begin());
  Buffer<Edge> sorted(sure.size(), Edge(), edges.get_allocator());
  for (const Edge& e : sure)
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

  /// Joins the sets of `i` and `k` so that the two have the relative sign `sign`, if they are not in one set yet.
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
    for (std::size_t i = 0; i < m_parents.size(); ++i)
      find_and_compress(Index(i));
  }

  std::size_t size() const { return m_parents.size(); }

  /// Number of samples in the set that `root` represents.
  Index size_of_set(Index root) const { return m_sizes[root]; }
};

/// The sum of the agreements of edges between two samples or, read for their representatives, between two sets.
struct Vote { Index a, b; double agreement, total; };

/// Adds up votes between the same two.
template <typename ConcurrencyTag>
void add_up_votes(Buffer<Vote>& votes)
{
  sort_by_key<ConcurrencyTag>(votes, [](const Vote& v) { return (std::uint64_t(v.a) << 32) | v.b; },
                              [](const Vote& v, const Vote& w) { return v.agreement != w.agreement ? v.agreement < w.agreement : v.total < w.total; });
  std::size_t size = 0;
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

/// The vote between the sets of two samples, or of two sets before they were joined to others; nothing if they are one set.
inline std::optional<Vote> vote_between_sets(const Signed_union_find& sets, const Vote& vote)
{
  const auto [root_a, sign_a] = sets.find(vote.a);
  const auto [root_b, sign_b] = sets.find(vote.b);
  if (root_a == root_b)
    return std::nullopt;
  return Vote{(std::min)(root_a, root_b), (std::max)(root_a, root_b), sign_a * sign_b * vote.agreement, vote.total};
}

/// The votes of the edges between sets: one for each pair of sets that touch, in the order of the pairs.
template <typename ConcurrencyTag>
Buffer<Vote> votes_of_edges(const Buffer<Edge>& edges, const Signed_union_find& sets)
{
  Buffer<Vote> votes = append_by_blocks<ConcurrencyTag>(edges.size(), edges_per_block, Counting_allocator<Vote>(edges.get_allocator()),
                                                        [&](std::size_t begin, std::size_t end, Buffer<Vote>& votes_of_block) {
    for (std::size_t e = begin; e < end; ++e)
      if (const auto vote = vote_between_sets(sets, {edges[e].i, edges[e].k, edges[e].agreement, std::abs(edges[e].agreement)}))
        votes_of_block.push_back(*vote);
    add_up_votes<Sequential_tag>(votes_of_block);
  });
  add_up_votes<ConcurrencyTag>(votes);
  return votes;
}

/// Joins sets that touch by majority: round by round, each set with the neighbor that their votes are most of one mind about.
/// \param votes of the sets as they are, added up; in the end those of the sets as they are then
/// \param sure the share of the votes, in [0, 1], that the winning side has to be ahead by
template <typename ConcurrencyTag>
void join_by_votes(double sure, Buffer<Vote>& votes, Signed_union_find& sets)
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
    sets.compress();
    std::size_t size = 0;
    for (const Vote& v : votes)
      if (const auto vote = vote_between_sets(sets, v))
        votes[size++] = *vote;
    votes.resize(size);
    add_up_votes<ConcurrencyTag>(votes);
  }
}

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

/*!
Turns the normals of the samples to one side. Over the edges of the graph of nearest neighbors where `orientation_agreement()` is beyond
doubt, sets of samples grow as the maximum spanning forest of Hoppe et al. does. Where sets touch, across a sharp edge or through noise, one edge
may well err, and would turn a whole face; there, all edges between two sets vote. Then the sets that hang together are turned
outwards as a whole, in the sense of the divergence theorem: \f$ \sum n_i^T (p_i - \bar p) > 0 \f$. Works on indices; no sample changes its
place.

\param positions, normals unit vectors of any sign in, consistent out
\param number_of_neighbors of the graph, at least 1
\param spacing of the samples, roughly: more than a 1000th of it, and not so much that it spans the cloud
\returns the share of the samples that are joined to the largest part of their tree by edges beyond doubt and clear majorities only
*/
template <typename ConcurrencyTag, typename T>
double orient_normals(const Buffer<Vector>& positions, std::size_t number_of_neighbors, double spacing, Progress& progress,
                      Buffer<Eigen::Matrix<T, 3, 1>>& normals)
{
  const auto normal = [&](Index i) -> Vector { return normals[i].template cast<double>(); };
  const std::size_t m = positions.size();
  Signed_union_find sets(m, positions.get_allocator());
  Buffer<Vote> votes(positions.get_allocator());
  {
    const Buffer<Edge> edges = rated_edges<ConcurrencyTag>(positions, normals, number_of_neighbors, spacing, progress);
    for (const Edge& edge : sure_edges<ConcurrencyTag>(edges))
      sets.join(edge.i, edge.k, edge.agreement < 0 ? -1 : 1);
    sets.compress();
    votes = votes_of_edges<ConcurrencyTag>(edges, sets);
  }
  join_by_votes<ConcurrencyTag>(clear_majority, votes, sets);
  Buffer<Index> sure_set_sizes(m, 0, positions.get_allocator());
  for (Index i = 0; i < m; ++i)
    sure_set_sizes[i] = sets.size_of_set(sets.find(i).first);
  join_by_votes<ConcurrencyTag>(0, votes, sets);

  struct Tree
  {
    Vector center = Vector::Zero();
    Vector normal_sum = Vector::Zero();
    double flux = 0, largest_flux = 0;   // of the divergence theorem, and if all normals pointed away from the center
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
    number_of_oriented += sets.size_of_set(root) > 1 && sure_set_sizes[i] == tree.largest_sure_set;
  }
  for (Index i = 0; i < m; ++i)
  {
    const auto [root, sign] = sets.find(i);
    if (is_turned_inwards(trees[root].flux, trees[root].largest_flux, trees[root].normal_sum) != (sign < 0))
      normals[i] = -normals[i];
  }
  return double(number_of_oriented) / double(m);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H
