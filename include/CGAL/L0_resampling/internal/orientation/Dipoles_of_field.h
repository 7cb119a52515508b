// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DIPOLES_OF_FIELD_H
#define CGAL_L0_RESAMPLING_INTERNAL_DIPOLES_OF_FIELD_H

#include <CGAL/L0_resampling/internal/core/Signed_union_find.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/orientation/Dipole_lanes.h>
#include <CGAL/L0_resampling/internal/orientation/Field_of_sets.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The dipoles of the sets of a field, in the order of the sets. Their normals have the length of
/// the share of its area that each stands for.
struct Dipoles_of_field
{
  Dipole_lanes lanes;              // a group for each set
  std::vector<std::size_t> places, // of the dipoles
    begins{0};                     // number of dipoles before those of each set, and of all
  double area;                     // that a dipole usually stands for
};

/// \param samples that are dipoles
template <typename ConcurrencyTag, typename T>
Dipoles_of_field dipoles_of_field(const std::vector<Index>& samples, const Signed_union_find& sets,
                                  const Buffer<Vector>& positions,
                                  const Buffer<Eigen::Matrix<T, 3, 1>>& normals, double area,
                                  const Field_of_sets& field)
{
  std::vector<std::vector<Index>> samples_of_sets(field.roots.size());
  for (Index i : samples)
    if (const Index root = sets.find(i).first; field.has(root))
      samples_of_sets[field.place_of(root)].push_back(i);
  Dipoles_of_field result;
  result.area = area;
  for (std::size_t a = 0; a < field.roots.size(); ++a)
  {
    result.lanes.begin_group(positions[field.trees[a]]);
    for (Index i : samples_of_sets[a])
      result.places.push_back(result.lanes.add(
        positions[i], double(sets.find(i).second) * normals[i].template cast<double>()));
    result.begins.push_back(result.places.size());
  }
  result.lanes.fill_up();

  const float squared_core = float(squared_core_of_dipole(area));
  std::vector<double> shares(result.places.size(), 1);
  for_each_block<ConcurrencyTag>(field.roots.size(), 1, [&](std::size_t a, std::size_t) {
    if (field.is_alone(a))
      return;
    for (std::size_t i = result.begins[a]; i < result.begins[a + 1]; ++i)
    {
      Dipole_lanes::L crowding;
      result.lanes.for_each_pair(
        result.places[i], result.lanes.groups()[a], [&](const Dipole_lanes::Pairs& pairs) {
          crowding += crowding_of_dipole(pairs.cosine, pairs.squared_distance, squared_core);
        });
      shares[i] = share_of_dipole(double(crowding.sum()));
    }
  });
  for (std::size_t i = 0; i < shares.size(); ++i)
    result.lanes.scale_normal(result.places[i], shares[i]);
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DIPOLES_OF_FIELD_H
