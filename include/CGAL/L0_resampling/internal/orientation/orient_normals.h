// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H

#include <CGAL/L0_resampling/internal/core/Orientation_hints.h>
#include <CGAL/L0_resampling/internal/kernels/height_tolerance.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/kernels/side_confidence.h>
#include <CGAL/L0_resampling/internal/orientation/orientation_field.h>
#include <CGAL/L0_resampling/internal/orientation/orientation_votes.h>
#include <CGAL/L0_resampling/internal/orientation/spanning_forest.h>
#include <CGAL/L0_resampling/internal/orientation/turn_outvoted.h>
#include <CGAL/L0_resampling/internal/orientation/winding_numbers.h>
#include <CGAL/L0_resampling/internal/search/nearest_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// `squared_height_tolerance()` of each point.
template <typename ConcurrencyTag, typename T>
Buffer<T> squared_height_tolerances(const Buffer<Vector>& positions,
                                    const Buffer<Eigen::Matrix<T, 3, 1>>& normals,
                                    const Nearest_samples& nearest, double spacing,
                                    double noise_of_heights)
{
  const std::size_t points_per_task = 4096;
  Buffer<T> tolerances(positions.size(), T(0), Counting_allocator<T>(positions.get_allocator()));
  for_each_block<ConcurrencyTag>(
    positions.size(), points_per_task, [&](std::size_t begin, std::size_t end) {
      std::vector<T> squared_distances, heights;
      for (Index i = Index(begin); i < end; ++i)
      {
        squared_distances.clear();
        heights.clear();
        for (const Index* other = nearest.begin(i); other != nearest.end_of_first(i); ++other)
        {
          const Eigen::Matrix<T, 3, 1> d = (positions[*other] - positions[i]).template cast<T>();
          squared_distances.push_back(d.squaredNorm());
          heights.push_back(std::abs(normals[i].dot(d)));
        }
        tolerances[i] = squared_height_tolerance(
          unsigned(heights.size()), [&](unsigned k) { return squared_distances[k]; },
          [&](unsigned k) { return heights[k]; }, T(spacing * spacing),
          T(noise_of_heights * noise_of_heights));
      }
    });
  return tolerances;
}

/// The edges of the graph of nearest neighbors, the first ones of `nearest`, each once.
/// \param squared_tolerances of the heights of each sample; none if all are the squared spacing
template <typename ConcurrencyTag, typename T>
Buffer<Edge> rated_edges(const Buffer<Vector>& positions,
                         const Buffer<Eigen::Matrix<T, 3, 1>>& normals,
                         const Nearest_samples& nearest, double spacing,
                         const Buffer<T>& squared_tolerances)
{
  const auto squared_tolerance_of = [&](Index i, Index k) {
    return squared_tolerances.empty() ? T(spacing * spacing)
                                      : (std::max)(squared_tolerances[i], squared_tolerances[k]);
  };
  const auto for_each_edge_of = [&](Index i, const auto& f) {
    for (const Index* other = nearest.begin(i); other != nearest.end_of_first(i); ++other)
      if (*other >= i || !nearest.is_one_of_first(*other, i))
        f(*other);
  };
  // counted first, as there is no more of anything at any other time
  const std::size_t samples_per_block = 4096, m = positions.size();
  std::vector<std::size_t> begins(m / samples_per_block + 2, 0);
  for_each_block<ConcurrencyTag>(m, samples_per_block, [&](std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (Index i = Index(begin); i < end; ++i)
      for_each_edge_of(i, [&](Index) { ++count; });
    begins[begin / samples_per_block + 1] = count;
  });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  Buffer<Edge> edges(begins.back(), Counting_allocator<Edge>(positions.get_allocator()));
  for_each_block<ConcurrencyTag>(m, samples_per_block, [&](std::size_t begin, std::size_t end) {
    std::size_t e = begins[begin / samples_per_block];
    for (Index i = Index(begin); i < end; ++i)
      for_each_edge_of(i, [&](Index k) {
        const Eigen::Matrix<T, 3, 1> to_other = (positions[k] - positions[i]).template cast<T>();
        const T agreement =
          orientation_agreement(normals[i].dot(normals[k]), normals[i].dot(to_other),
                                -normals[k].dot(to_other), squared_tolerance_of(i, k));
        edges[e++] = {float(agreement), i, k};
      });
  });
  return edges;
}

/// What the caller says of the sides that normals point to.
struct Side_hints
{
  /// A unit vector on the side that the normal of a sample, given by its index, shall point to; or
  /// zero for none. Of one type, so that the stage is compiled once.
  std::function<Vector(Index)> direction_of = [](Index) -> Vector { return Vector::Zero(); };
  bool are_viewpoints = false; ///< whether it is the direction to what the sample was seen from

  /// Of the angle between a normal and the direction to what the sample was seen from, if known.
  std::optional<double> viewpoint_cosine(Index i, const Vector& normal) const
  {
    const Vector direction = are_viewpoints ? direction_of(i) : Vector::Zero();
    return direction.isZero(0) ? std::nullopt : std::optional<double>(normal.dot(direction));
  }
  int certain_side_of(Index i, const Vector& normal) const
  {
    return certain_side(viewpoint_cosine(i, normal).value_or(0));
  }
};

/// The samples whose viewpoints leave no doubt are one set, with the sides that face these.
template <typename NormalOf>
Signed_union_find sets_of_viewpoints(std::size_t number_of_samples, const Side_hints& hints,
                                     const NormalOf& normal,
                                     const Counting_allocator<Index>& allocator)
{
  Signed_union_find sets(number_of_samples, allocator);
  Index first = 0;
  int first_side = 0;
  if (hints.are_viewpoints)
    for_each_in_order(number_of_samples, [&](std::size_t place) {
      const Index i = Index(place);
      const int side = hints.certain_side_of(i, normal(i));
      if (side != 0 && first_side == 0)
      {
        first = i;
        first_side = side;
      }
      else if (side != 0)
        sets.join(first, i, first_side * side);
    });
  return sets;
}

/// Whether the normals of a tree point inwards as a whole. A flat tree has no inside: its normals
/// shall point up its steepest axis.
inline bool is_turned_inwards(double flux, double maximum_flux, const Vector& normal_sum)
{
  const double rounding = 1e-9;
  if (std::abs(flux) > rounding * maximum_flux)
    return flux < 0;
  Eigen::Index axis;
  normal_sum.cwiseAbs().maxCoeff(&axis);
  return normal_sum[axis] < 0;
}

/// What the dipoles say of each other's sides.
/// \param trees of the samples
template <typename ConcurrencyTag, typename T>
std::vector<Side_evidence> evidence_of_dipoles(const std::vector<Index>& samples,
                                               const Signed_union_find& trees,
                                               const Buffer<Vector>& positions,
                                               const Buffer<Eigen::Matrix<T, 3, 1>>& normals,
                                               double spacing)
{
  const Dipoles_of_trees dipoles(samples, trees, positions, normals);
  const double area = spacing * spacing * double(positions.size()) / double(samples.size());
  std::vector<Side_evidence> evidence(samples.size());
  for_each_block<ConcurrencyTag>(samples.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      evidence[k] = dipoles.evidence_of(k, area);
  });
  return evidence;
}

/// A connected component of the sets of samples, which is turned as a whole.
struct Tree
{
  Vector center = Vector::Zero();
  Vector normal_sum = Vector::Zero();
  double flux = 0,
         maximum_flux =
           0; // of the divergence theorem, and if all normals pointed away from the center
  Side_votes votes;
  std::size_t size = 0;
  Index maximum_sure_size = 0;
  double sum_of_winding_numbers = 0;
  Index number_of_dipoles = 0;
  double sum_of_confidences = 0; // of the dipoles within the tree

  double mean_winding_number() const
  {
    return number_of_dipoles > 0 ? sum_of_winding_numbers / number_of_dipoles : 0;
  }
  double confidence_of_dipoles() const
  {
    return number_of_dipoles > 0 ? sum_of_confidences / number_of_dipoles : guessed_confidence;
  }

  /// Whether its normals are on the wrong side: that of the hints, if these are clear; else
  /// inwards, by the flux through it, unless the winding numbers say otherwise.
  bool is_to_be_turned() const
  {
    if (votes.are_clear())
      return votes.say_turn();
    return is_turned_by_windings(is_turned_inwards(flux, maximum_flux, normal_sum),
                                 mean_winding_number());
  }

  /// As it is turned.
  double confidence() const
  {
    return votes.are_clear() ? confidence_of_hints(votes)
                             : confidence_of_tree(std::abs(mean_winding_number()),
                                                  normal_sum.norm() / double(size));
  }
};

/// The trees of samples, found by their roots.
class Trees
{
  Buffer<Index> m_numbers; // of the samples that are roots
  Buffer<Tree> m_trees;

public:
  explicit Trees(const Signed_union_find& sets, const Counting_allocator<Tree>& allocator)
    : m_numbers(sets.size(), allocator), m_trees(allocator)
  {
    Index number = 0;
    for_each_in_order(sets.size(), [&](std::size_t i) {
      m_numbers[i] = number;
      number += sets.find(Index(i)).first == i;
    });
    fill_buffer(number, Tree(), m_trees);
  }

  Tree& operator[](Index root) { return m_trees[m_numbers[root]]; }
  const Tree& operator[](Index root) const { return m_trees[m_numbers[root]]; }
};

/// The sums over the trees.
/// \param sure_set_sizes of each sample: the size of its set once all that is sure was joined
/// \param number_of_oriented out: samples that are joined to the largest part of their tree
template <typename T>
Trees trees_of_samples(const Signed_union_find& sets, const Buffer<Index>& sure_set_sizes,
                       const Buffer<Vector>& positions,
                       const Buffer<Eigen::Matrix<T, 3, 1>>& normals, const Side_hints& hints,
                       std::size_t& number_of_oriented)
{
  const std::size_t m = positions.size();
  Trees trees(sets, positions.get_allocator());
  for_each_in_order(m, [&](std::size_t i) {
    const Index root = sets.find(Index(i)).first;
    Tree& tree = trees[root];
    tree.center += positions[i] / double(sets.size_of_set(root));
    tree.maximum_sure_size = (std::max)(tree.maximum_sure_size, sure_set_sizes[i]);
  });
  number_of_oriented = 0;
  for_each_in_order(m, [&](std::size_t place) {
    const Index i = Index(place);
    const auto [root, sign] = sets.find(i);
    Tree& tree = trees[root];
    const Vector from_center = positions[i] - tree.center,
                 normal = sign * normals[i].template cast<double>();
    tree.flux += normal.dot(from_center);
    tree.maximum_flux += from_center.norm();
    tree.normal_sum += normal;
    ++tree.size;
    const double vote = normal.dot(hints.direction_of(i));
    tree.votes.sum += vote;
    tree.votes.total += std::abs(vote);
    tree.votes.certain_sum += hints.certain_side_of(i, normal);
    number_of_oriented += sets.size_of_set(root) > 1 && sure_set_sizes[i] == tree.maximum_sure_size;
  });
  return trees;
}

/// How sure it is that the dipoles have the sides that their trees have, once these are turned.
/// \param samples that are dipoles
/// \param trees in and out: what their dipoles say of them
template <typename ConcurrencyTag, typename T>
std::vector<double> confidences_of_dipoles(const std::vector<Index>& samples,
                                           const Signed_union_find& sets,
                                           const Buffer<Vector>& positions,
                                           const Buffer<Eigen::Matrix<T, 3, 1>>& normals,
                                           double spacing, Trees& trees)
{
  const std::vector<Side_evidence> evidence =
    evidence_of_dipoles<ConcurrencyTag>(samples, sets, positions, normals, spacing);
  const auto tree_of = [&](std::size_t k) -> Tree& { return trees[sets.find(samples[k]).first]; };
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    tree_of(k).sum_of_winding_numbers += evidence[k].winding_number;
    ++tree_of(k).number_of_dipoles;
  }
  std::vector<double> confidences(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    Tree& tree = tree_of(k);
    const double sign = tree.is_to_be_turned() ? -1 : 1;
    confidences[k] =
      confidence_within_tree({sign * evidence[k].winding_number, evidence[k].agreement},
                             sign * tree.mean_winding_number());
    tree.sum_of_confidences += confidences[k];
  }
  return confidences;
}

/// How sure the sides are that `orient_normals()` has chosen, as shares of the samples.
struct Orientation
{
  double
    /// joined to the largest part of their tree by viewpoints, by edges beyond doubt, by the field
    /// and by clear majorities only
    oriented_share;
  double hinted_share;       ///< of trees whose side is that of the hints
  Buffer<float> confidences; ///< how sure it is that a sample is on the right side, in [0, 1]
  Signed_union_find trees;   ///< the samples of a tree have sides relative to each other

  double right_side_share() const
  {
    double sum = 0;
    for (const float confidence : confidences)
      sum += double(confidence);
    return sum / double(confidences.size());
  }
};

/*!
Turns the normals of the samples to one side. Those whose viewpoints leave no doubt face them, and
are one set from the start. Over the edges of the graph of nearest neighbors where
`orientation_agreement()` is beyond doubt, sets of samples grow as the maximum spanning forest of
Hoppe et al. does, until most samples are in large sets. Where these touch, within a face, across a
sharp edge or through noise, one edge may well err, and would turn a whole face; there, all edges
between two sets vote. Then the connected components of the sets are turned as a whole: to the side
of the hints where these are clear, else outwards, in the sense of the divergence theorem,
\f$ \sum n_i^T (p_i - \bar p) > 0 \f$, unless their winding numbers contradict it. Works on
indices; no sample changes its place.

\param positions, normals unit vectors of any sign in, consistent out
\param number_of_neighbors of the graph, at least 1
\param spacing of the samples, roughly: more than a 1000th of it, and not so much that it spans the
cloud
\param noise_of_heights of points as they were measured, not of samples: heights within it tell
nothing of a fold, as those within the spacing; where the points around are sparser or noisier, no
heights within what they have. At last such points are turned where the normals around outvote
theirs.
\param mean_normals out, of points as they were measured: the direction of the normals around each,
which tells the side of those that it stands for; null if there are none
*/
template <typename ConcurrencyTag, typename T>
Orientation orient_normals(const Buffer<Vector>& positions, std::size_t number_of_neighbors,
                           double spacing, const Side_hints& hints, Progress& progress,
                           Buffer<Eigen::Matrix<T, 3, 1>>& normals,
                           const std::optional<double>& noise_of_heights = std::nullopt,
                           Buffer<Eigen::Matrix<T, 3, 1>>* mean_normals = nullptr)
{
  const auto normal = [&](Index i) -> Vector { return normals[i].template cast<double>(); };
  const std::size_t m = positions.size();
  const std::size_t number_of_voters = noise_of_heights ? voters_per_neighbor * number_of_neighbors
                                                        : number_of_neighbors;
  const double radius_of_that_many = spacing * std::sqrt(double(number_of_voters) / 2);
  Nearest_samples nearest = find_nearest_samples<ConcurrencyTag>(
    positions, number_of_neighbors, number_of_voters, radius_of_that_many, progress);
  Buffer<T> squared_tolerances{Counting_allocator<T>(positions.get_allocator())};
  if (noise_of_heights)
    squared_tolerances = squared_height_tolerances<ConcurrencyTag>(positions, normals, nearest,
                                                                   spacing, *noise_of_heights);
  Voting faces = [&] {
    Buffer<Edge> edges = rated_edges<ConcurrencyTag>(positions, normals, nearest, spacing,
                                                     squared_tolerances);
    if (!noise_of_heights)
      nearest.release();
    Signed_union_find sets = grow_forest<ConcurrencyTag>(
      sets_of_viewpoints(m, hints, normal, positions.get_allocator()), edges);
    Buffer<Vote> votes = votes_of_edges<ConcurrencyTag>(edges, sets);
    return Voting{std::move(sets), std::move(votes)};
  }();
  const auto joined_by_votes = [](double sure, const Voting& before) {
    Voting voting{before.sets, copy_of(before.votes)};
    join_by_votes<ConcurrencyTag>(sure, voting);
    return voting;
  };
  Voting parts = joined_by_votes(clear_majority, faces), all = joined_by_votes(0, parts);
  if (join_by_field<ConcurrencyTag>(all.sets, positions, normals, spacing, faces))
  {
    parts = joined_by_votes(clear_majority, faces);
    all = joined_by_votes(0, parts);
  }
  Buffer<Index> sure_set_sizes = filled_buffer(m, Index(0), positions.get_allocator());
  for_each_in_order(m, [&](std::size_t i) {
    sure_set_sizes[i] = parts.sets.size_of_set(parts.sets.find(Index(i)).first);
  });
  if (join_by_field<ConcurrencyTag>(all.sets, positions, normals, spacing, parts))
    all = joined_by_votes(0, parts);
  const Signed_union_find& sets = all.sets;
  Buffer<Eigen::Matrix<T, 3, 1>> sums(normals.get_allocator());
  if (noise_of_heights)
  {
    const auto is_in_doubt = [&](Index i) { return hints.certain_side_of(i, normal(i)) == 0; };
    sums = turn_outvoted<ConcurrencyTag>(positions, nearest, sets, squared_tolerances, is_in_doubt,
                                         normals);
    nearest.release();
  }

  std::size_t number_of_oriented = 0;
  Trees trees = trees_of_samples(sets, sure_set_sizes, positions, normals, hints,
                                 number_of_oriented);
  const std::vector<Index> dipoles = samples_of_dipoles(m);
  const std::vector<double> confidences_within_trees =
    confidences_of_dipoles<ConcurrencyTag>(dipoles, sets, positions, normals, spacing, trees);

  Orientation result{double(number_of_oriented) / double(m), 0,
                     filled_buffer(m, 0.f, Counting_allocator<float>(positions.get_allocator())),
                     Signed_union_find(0, positions.get_allocator())};
  const std::size_t samples_per_task = 4096;
  const auto number_of_hinted =
    block_sum<ConcurrencyTag>(m, samples_per_task, [&](std::size_t begin, std::size_t end) {
      std::size_t number = 0;
      for (Index i = Index(begin); i < end; ++i)
      {
        const auto [root, sign] = sets.find(i);
        const Tree& tree = trees[root];
        number += tree.votes.are_clear();
        if (tree.is_to_be_turned() != (sign < 0))
          normals[i] = -normals[i];
        if (mean_normals && tree.is_to_be_turned())
          sums[i] = -sums[i];
        const std::size_t k = dipole_of_sample(i, m, dipoles.size());
        const double within_tree = sets.find(dipoles[k]).first == root
                                     ? confidences_within_trees[k]
                                     : tree.confidence_of_dipoles();
        const std::optional<double> cosine = hints.viewpoint_cosine(i, normal(i));
        result.confidences[i] = float(cosine ? confidence_of_viewpoint(*cosine)
                                             : confidence_of_side(tree.confidence(), within_tree));
      }
      return number;
    });
  if (mean_normals)
    *mean_normals = std::move(sums);
  result.hinted_share = double(number_of_hinted) / double(m);
  result.trees = std::move(all.sets);
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENT_NORMALS_H
