// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_FIELD_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_FIELD_H

#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/orientation/Field_of_sets.h>
#include <CGAL/L0_resampling/internal/orientation/dipoles_of_sets.h>
#include <CGAL/L0_resampling/internal/orientation/orientation_votes.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A sample that stands for those around it.
struct Dipole
{
  Vector position, normal;
};

/// The sets of the field, of those that have dipoles: the larger ones of the trees that they stand
/// for.
/// \param sets by their roots
/// \returns their roots, ascending
inline std::vector<Index> sets_of_field(const Signed_union_find& trees,
                                        const std::vector<Dipoles_of_set>& sets)
{
  const std::size_t fewest = fewest_dipoles_of_a_set(trees.size(), sets.size());
  struct Dipoles_of_tree
  {
    std::size_t of_large_sets = 0, count = 0;
  };
  std::map<Index, Dipoles_of_tree> dipoles_of_trees;
  for (const Dipoles_of_set& set : sets)
  {
    Dipoles_of_tree& tree = dipoles_of_trees[trees.find(set.root).first];
    tree.count += set.count;
    tree.of_large_sets += set.count >= fewest ? set.count : 0;
  }
  std::vector<Index> result;
  for (const Dipoles_of_set& set : sets)
    if (const Dipoles_of_tree& tree = dipoles_of_trees[trees.find(set.root).first];
        set.count >= fewest && stand_for_tree(tree.of_large_sets, tree.count))
      result.push_back(set.root);
  return result;
}

/*!
Joins the larger ones of connected sets if their field asks to turn some of them
against the others. At an edge between two faces few samples vote, all of them next to the edge,
where noise and smoothing leave the least to see; the faces as a whole know better. Their field is
that of dipoles along the normals (after Metzer et al., Orienting point clouds with dipole
propagation, 2021).

\param trees what the votes make of the sets
\param spacing of the samples
\returns whether any was turned; if not, nothing was joined
*/
template <typename ConcurrencyTag, typename T>
bool join_by_field(const Signed_union_find& trees, const Buffer<Vector>& positions,
                   const Buffer<Eigen::Matrix<T, 3, 1>>& normals, double spacing, Voting& voting)
{
  Signed_union_find& sets = voting.sets;
  const std::vector<Index> samples = samples_of_dipoles(positions.size());
  Field_of_sets field;
  field.roots = sets_of_field(trees, dipoles_of_sets(samples, sets));
  const std::size_t number_of_sets = field.roots.size();
  if (number_of_sets < 2)
    return false;
  const auto place_of = [&](Index root) {
    return std::size_t(std::lower_bound(field.roots.begin(), field.roots.end(), root)
                       - field.roots.begin());
  };
  const auto is_in_field = [&](Index root) {
    return std::binary_search(field.roots.begin(), field.roots.end(), root);
  };

  for (Index root : field.roots)
  {
    const auto [tree, sign] = trees.find(root);
    field.trees.push_back(tree);
    field.signs.push_back(sign);
  }

  // Sets of different trees, parts of a scene, do not know of each other.
  std::vector<std::vector<Dipole>> dipoles(number_of_sets);
  for (Index i : samples)
    if (const auto [root, sign] = sets.find(i); is_in_field(root))
      dipoles[place_of(root)].push_back(
        {positions[i], double(sign) * normals[i].template cast<double>()});
  const double area = spacing * spacing * double(positions.size()) / double(samples.size());
  const double squared_core = squared_core_of_dipole(area);
  field.agreements.assign(number_of_sets * number_of_sets, 0);
  for_each_block<ConcurrencyTag>(number_of_sets, 1, [&](std::size_t a, std::size_t) {
    for (std::size_t b = 0; b < a; ++b)
      if (field.trees[a] == field.trees[b])
      {
        double sum = 0;
        for (const Dipole& dipole : dipoles[a])
          for (const Dipole& other : dipoles[b])
          {
            const Vector d = other.position - dipole.position;
            sum += dipole_agreement(dipole.normal.dot(other.normal),
                                    dipole.normal.dot(d) * other.normal.dot(d), d.squaredNorm(),
                                    squared_core);
          }
        field.agreements[a * number_of_sets + b] = field.agreements[b * number_of_sets + a] =
          sum * area * area / spacing;
      }
  });
  for_each_in_order(voting.votes.size(), [&](std::size_t n) {
    const Vote& v = voting.votes[n];
    if (is_in_field(v.a) && is_in_field(v.b))
    {
      const std::size_t a = place_of(v.a), b = place_of(v.b);
      field.agreements[a * number_of_sets + b] += v.agreement;
      field.agreements[b * number_of_sets + a] += v.agreement;
    }
  });

  if (!field.turn_what_disagrees())
    return false;
  for (std::size_t b = 0; b < number_of_sets; ++b)
  {
    const std::size_t a = std::size_t(
      std::find(field.trees.begin(), field.trees.end(), field.trees[b]) - field.trees.begin());
    sets.join(field.roots[a], field.roots[b], field.signs[a] * field.signs[b]);
  }
  pass_votes_on<ConcurrencyTag>(voting);
  return true;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_FIELD_H
