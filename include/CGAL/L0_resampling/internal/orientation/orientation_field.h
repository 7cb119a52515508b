// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_FIELD_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_FIELD_H

#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/orientation/Dipoles_of_field.h>
#include <CGAL/L0_resampling/internal/orientation/Field_of_sets.h>
#include <CGAL/L0_resampling/internal/orientation/Windings_of_sets.h>
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

/// The sets of the field, of those that have dipoles: the larger ones of the trees that they stand
/// for.
/// \param sets by their roots
/// \returns their roots, ascending
inline std::vector<Index> sets_of_field(const Signed_union_find& trees,
                                        const std::vector<Dipoles_of_set>& sets)
{
  const std::size_t fewest = minimum_number_of_dipoles_of_a_set(trees.size(), sets.size());
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

/// Sets the agreements of the sets of a field to those of their dipoles, if they are of one tree:
/// those of different trees, parts of a scene, do not know of each other.
/// \param spacing of the samples
/// \returns the winding numbers of the sets
template <typename ConcurrencyTag>
Windings_of_sets add_dipoles(const Dipoles_of_field& dipoles, double spacing, Field_of_sets& field)
{
  using L = Dipole_lanes::L;
  const std::size_t number_of_sets = field.roots.size();
  Windings_of_sets windings(dipoles.begins);
  const float squared_core = float(squared_core_of_dipole(dipoles.area));
  // squares of large distances are no numbers of single precision; so far away nothing is known
  const auto number_or_nothing = [](const L& lanes) {
    const double sum = double(lanes.sum());
    return std::isfinite(sum) ? sum : 0;
  };
  for_each_block<ConcurrencyTag>(number_of_sets, 1, [&](std::size_t a, std::size_t) {
    if (field.is_alone(a))
      return;
    for (std::size_t b = 0; b < number_of_sets; ++b)
      if (field.trees[a] == field.trees[b])
      {
        double agreement = 0; // of two sets, once
        for (std::size_t i = dipoles.begins[a]; i < dipoles.begins[a + 1]; ++i)
        {
          L winding, of_pairs;
          dipoles.lanes.for_each_pair(
            dipoles.places[i], dipoles.lanes.groups()[b], [&](const Dipole_lanes::Pairs& pairs) {
              winding += winding_number_of_dipole(pairs.height_over_others, pairs.squared_distance,
                                                  squared_core);
              if (b < a)
                of_pairs += dipole_agreement(pairs.cosine,
                                             pairs.height_over_others * pairs.height_over_own,
                                             pairs.squared_distance, squared_core);
            });
          const double of_set = winding_number_of_set(number_or_nothing(winding) * dipoles.area);
          windings.at(b, i) = float(of_set);
          agreement += number_or_nothing(of_pairs);
        }
        if (b < a)
          field.agreements[a * number_of_sets + b] = field.agreements[b * number_of_sets + a] =
            agreement * dipoles.area * dipoles.area / spacing;
      }
  });
  return windings;
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
  for (Index root : field.roots)
  {
    const auto [tree, sign] = trees.find(root);
    field.trees.push_back(tree);
    field.signs.push_back(sign);
  }

  field.agreements.assign(number_of_sets * number_of_sets, 0);
  field.unary_terms.assign(number_of_sets, 0);
  const double samples_per_dipole = double(positions.size()) / double(samples.size());
  const Windings_of_sets windings = add_dipoles<ConcurrencyTag>(
    dipoles_of_field<ConcurrencyTag>(samples, sets, positions, normals,
                                     spacing * spacing * samples_per_dipole, field),
    spacing, field);
  for_each_in_order(voting.votes.size(), [&](std::size_t n) {
    const Vote& v = voting.votes[n];
    if (field.has(v.a) && field.has(v.b))
    {
      const std::size_t a = field.place_of(v.a), b = field.place_of(v.b);
      field.agreements[a * number_of_sets + b] += v.agreement;
      field.agreements[b * number_of_sets + a] += v.agreement;
    }
  });

  bool is_turned = field.flip_disagreeing_sets();
  windings.add_to<ConcurrencyTag>(field, samples_per_dipole);
  is_turned = field.flip_disagreeing_sets() || is_turned;
  if (!is_turned)
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
