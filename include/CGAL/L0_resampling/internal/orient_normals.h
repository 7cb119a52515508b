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
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// `orientation_agreement()` of two samples, see there.
inline double agreement_of_samples(const Vector& p, const Vector& n, const Vector& other_p, const Vector& other_n, double spacing)
{
  const Vector to_other = other_p - p;
  return orientation_agreement(n.dot(other_n), n.dot(to_other), -other_n.dot(to_other), spacing * spacing);
}

/// Two samples near each other, and `orientation_agreement()` of them.
struct Edge { float agreement; Index i, k; };

/// Sorts by how sure the edges are, in steps of 1/1024, which is all that a spanning forest of noisy normals needs.
inline void sort_by_decreasing_agreement(Buffer<Edge>& edges)
{
  const std::size_t number_of_steps = 1024;
  const auto step = [&](const Edge& e) { return std::size_t((1 - (std::min)(std::abs(e.agreement), 1.f)) * (number_of_steps - 1)); };
  std::vector<std::size_t> places(number_of_steps + 1, 0);
  for (const Edge& e : edges)
    ++places[step(e) + 1];
  std::partial_sum(places.begin(), places.end(), places.begin());
  Buffer<Edge> sorted(edges.size(), Edge(), edges.get_allocator());
  for (const Edge& e : edges)
    sorted[places[step(e)]++] = e;
  edges.swap(sorted);
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

/// The sum of the agreements of all edges between two sets, each read for the sets' representatives.
struct Vote { Index a, b; double agreement, total; };

/// Puts the votes of the edges between different sets together, a vote for each pair of sets that touch; drops the edges within one.
inline void count_votes(Buffer<Edge>& edges, Signed_union_find& sets, Buffer<Vote>& votes)
{
  votes.clear();
  std::size_t number_of_edges = 0;
  for (const Edge& e : edges)
  {
    const auto [root_i, sign_i] = sets.find(e.i);
    const auto [root_k, sign_k] = sets.find(e.k);
    if (root_i == root_k)
      continue;
    edges[number_of_edges++] = e;
    votes.push_back({(std::min)(root_i, root_k), (std::max)(root_i, root_k), double(sign_i * sign_k) * e.agreement, std::abs(e.agreement)});
  }
  edges.resize(number_of_edges);
  // stable, so that sums of the same votes are bitwise the same
  std::stable_sort(votes.begin(), votes.end(), [](const Vote& v, const Vote& w) { return std::tie(v.a, v.b) < std::tie(w.a, w.b); });
  std::size_t number_of_pairs = 0;
  for (const Vote& v : votes)
    if (number_of_pairs > 0 && votes[number_of_pairs - 1].a == v.a && votes[number_of_pairs - 1].b == v.b)
    {
      votes[number_of_pairs - 1].agreement += v.agreement;
      votes[number_of_pairs - 1].total += v.total;
    }
    else
      votes[number_of_pairs++] = v;
  votes.resize(number_of_pairs);
}

/// Joins sets that touch by majority: round by round, each set with the neighbor that their edges are most of one mind about.
/// \param sure the share of the votes, in [0, 1], that the winning side has to be ahead by
inline void join_by_votes(double sure, Buffer<Edge>& edges, Signed_union_find& sets)
{
  Buffer<Vote> votes(edges.get_allocator());
  Buffer<std::size_t> strongest(sets.size(), 0, edges.get_allocator());
  for (;;)
  {
    count_votes(edges, sets, votes);
    votes.erase(std::remove_if(votes.begin(), votes.end(),
                               [&](const Vote& v) { return std::abs(v.agreement) < sure * v.total; }), votes.end());
    if (votes.empty())
      return;
    std::stable_sort(votes.begin(), votes.end(), [](const Vote& v, const Vote& w) { return std::abs(v.agreement) > std::abs(w.agreement); });
    const std::size_t none = votes.size();
    for (const Vote& v : votes)
      strongest[v.a] = strongest[v.b] = none;
    for (std::size_t n = 0; n < votes.size(); ++n)
      for (const Index set : {votes[n].a, votes[n].b})
        strongest[set] = (std::min)(strongest[set], n);
    for (std::size_t n = 0; n < votes.size(); ++n)
      if (strongest[votes[n].a] == n || strongest[votes[n].b] == n)
        sets.join(votes[n].a, votes[n].b, votes[n].agreement < 0 ? -1 : 1);
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
  const Nearest_samples nearest = find_nearest_samples<ConcurrencyTag>(positions, number_of_neighbors, spacing * std::sqrt(double(number_of_neighbors) / 2), progress);

  Buffer<Edge> edges(positions.get_allocator());
  edges.reserve(nearest.number_of_pairs());
  for (Index i = 0; i < m; ++i)
    for (const Index* k = nearest.begin(i); k != nearest.end(i); ++k)
      if (i < *k || !nearest.contains(*k, i))
        edges.push_back({float(agreement_of_samples(positions[i], normal(i), positions[*k], normal(*k), spacing)), i, *k});
  sort_by_decreasing_agreement(edges);

  Signed_union_find sets(m, positions.get_allocator());
  for (const Edge& edge : edges)
    if (std::abs(edge.agreement) >= beyond_doubt)
      sets.join(edge.i, edge.k, edge.agreement < 0 ? -1 : 1);
  join_by_votes(clear_majority, edges, sets);
  Buffer<Index> sure_set_sizes(m, 0, positions.get_allocator());
  for (Index i = 0; i < m; ++i)
    sure_set_sizes[i] = sets.size_of_set(sets.find(i).first);
  join_by_votes(0, edges, sets);

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
