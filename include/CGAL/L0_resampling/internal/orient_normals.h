// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H

#include <CGAL/L0_resampling/internal/nearest_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
How far two samples agree about the side their normals point to: positive if the signs fit, negative if one has to turn; the
absolute value, in [0, 1], is how sure that is.

It is the mean of two rules for a patch of surface between the samples. On a flat one the normals are equal, so \f$ n_i^T n_k \f$
decides (Hoppe et al. 1992). On one that bends like an arc, each is the mirror image of the other in the plane halfway between the
samples, so \f$ n_i^T n_k - 2 (e^T n_i)(e^T n_k) \f$ decides, e the unit vector from one to the other; that holds across sharp edges of
any angle, where the first rule says nothing. Opposite samples of the two sheets of a thin plate make the rules contradict each other. Those that are
further apart than the sheets do not: a plate has to be thicker than about two spacings for its sheets to be told apart.

\param spacing of the samples: below it, the direction from one to the other is noise, and what the second rule adds fades out
*/
inline double orientation_agreement(const Vector& p, const Vector& n, const Vector& other_p, const Vector& other_n, double spacing)
{
  const Vector e = other_p - p;
  const double squared_length = e.squaredNorm(), damped_squared_length = squared_length + 0.25 * spacing * spacing;
  if (!(damped_squared_length > 0 && std::isfinite(damped_squared_length)))
    return n.dot(other_n);
  return n.dot(other_n) - e.dot(n) / damped_squared_length * e.dot(other_n);
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

  /// Number of samples in the set that `root` represents.
  Index size_of_set(Index root) const { return m_sizes[root]; }
};

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
Turns the normals of the samples to one side: consistent along a maximum spanning forest of the graph of nearest neighbors, by how sure
`orientation_agreement()` is, and outwards for each tree as a whole, in the sense of the divergence theorem:
\f$ \sum n_i^T (p_i - \bar p) > 0 \f$. Works on indices; no sample changes its place.

\param positions, normals unit vectors of any sign in, consistent out
\param number_of_neighbors of the graph, at least 1
\param spacing of the samples, roughly: more than a 1000th of it, and not so much that it spans the cloud
\returns the share of the samples that reach the largest part of their tree over sure edges only
*/
template <typename ConcurrencyTag>
double orient_normals(const Buffer<Vector>& positions, std::size_t number_of_neighbors, double spacing, Progress& progress,
                      Buffer<Vector>& normals)
{
  const double sure = 0.25;
  const std::size_t m = positions.size();
  const Nearest_samples nearest = find_nearest_samples<ConcurrencyTag>(positions, number_of_neighbors, spacing * std::sqrt(double(number_of_neighbors) / 2), progress);

  Buffer<Edge> edges(positions.get_allocator());
  edges.reserve(nearest.number_of_pairs());
  for (Index i = 0; i < m; ++i)
    for (const Index* k = nearest.begin(i); k != nearest.end(i); ++k)
      if (i < *k || !nearest.contains(*k, i))
        edges.push_back({float(orientation_agreement(positions[i], normals[i], positions[*k], normals[*k], spacing)), i, *k});
  sort_by_decreasing_agreement(edges);

  Signed_union_find sets(m, positions.get_allocator());
  auto edge = edges.begin();
  for (; edge != edges.end() && std::abs(edge->agreement) >= sure; ++edge)
    sets.join(edge->i, edge->k, edge->agreement < 0 ? -1 : 1);
  Buffer<Index> sure_set_sizes(m, 0, positions.get_allocator());
  for (Index i = 0; i < m; ++i)
    sure_set_sizes[i] = sets.size_of_set(sets.find(i).first);
  for (; edge != edges.end(); ++edge)
    sets.join(edge->i, edge->k, edge->agreement < 0 ? -1 : 1);

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
    tree.flux += sign * normals[i].dot(from_center);
    tree.largest_flux += from_center.norm();
    tree.normal_sum += sign * normals[i];
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
