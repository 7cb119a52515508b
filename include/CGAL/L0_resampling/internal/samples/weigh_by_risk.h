// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_WEIGH_BY_RISK_H
#define CGAL_L0_RESAMPLING_INTERNAL_WEIGH_BY_RISK_H

#include <CGAL/L0_resampling/internal/kernels/risk_of_surface.h>
#include <CGAL/L0_resampling/internal/samples/fit_disks.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The `differences()` of plane and quadric of a sample.
using Values_of_differences = std::array<Local, 6>;

/*!
Adds the surfaces of one scale to the mean of each sample, by their risk: their variance, and their
bias against the reference, averaged over the samples around that are of the same face.

\param grid, positions, normals of the samples
\param references a quadric at each sample
\param radius_of of the samples that the bias is averaged over
*/
template <typename ConcurrencyTag, typename Radius>
void weigh_by_risk(const Search_grid_3& grid, const Buffer<Vector>& positions,
                   const Buffer<Local_vector>& sample_normals,
                   const Buffer<Surface_of_disks>& references,
                   const Buffer<Surfaces_of_scale>& surfaces, const Radius& radius_of, int reach,
                   Progress& progress, Buffer<Mean_surface>& means)
{
  using L = Lanes<Local>;
  constexpr int of_plane = 0, of_quadric = 3; // places of their values
  Buffer<Values_of_differences> all_differences(positions.size(), positions.get_allocator());
  for_each_block<ConcurrencyTag>(positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const auto plane = differences(surfaces[i].plane, references[i]),
                 quadric = differences(surfaces[i].quadric, references[i]);
      all_differences[i] = {plane.weight,   plane.heights,   plane.slopes,
                            quadric.weight, quadric.heights, quadric.slopes};
    }
  });
  const auto make_visitor = [&]() {
    return [&, normals = Local_normals<Local>(), values = Gathered_values<Local, 6>()](
             Search_grid_3::Range queries, Local_points<Local>& candidates,
             const Vector& origin) mutable {
      normals.gather(candidates, sample_normals);
      values.gather(candidates, [&](Index k, Local(&own)[6]) {
        std::copy(all_differences[k].begin(), all_differences[k].end(), own);
      });
      for (Index i = queries.first; i < queries.second; ++i)
      {
        if (!references[i].is_determined())
          continue;
        const Eigen::Matrix<Local, 3, 1> center = (positions[i] - origin).template cast<Local>(),
                                         normal = sample_normals[i];
        const Local squared_radius = Local(square(radius_of(i)));
        Differences_from_reference<L> plane, quadric;
        candidates.for_each_run_in_ball(
          center, squared_radius, [&](std::size_t k, const L& squared_distance) {
            const L cosine = L::load(&normals.x[k]) * normal[0] + L::load(&normals.y[k]) * normal[1]
                             + L::load(&normals.z[k]) * normal[2];
            const L weight = weight_of_difference(squared_distance, squared_radius, cosine);
            const auto differences_at = [&](int of_surface) {
              return Differences_from_reference<L>{values.load(of_surface, k),
                                                   values.load(of_surface + 1, k),
                                                   values.load(of_surface + 2, k)};
            };
            plane.add(weight, differences_at(of_plane));
            quadric.add(weight, differences_at(of_quadric));
          });
        const auto add_to_mean = [&](const Surface_of_disks& surface,
                                     const Differences_from_reference<L>& sums) {
          const Differences_from_reference<Local> d = {sums.weight.sum(), sums.heights.sum(),
                                                       sums.slopes.sum()};
          if (surface.is_determined() && d.weight > 0)
            means[i].add(surface, risk_of_surface(surface, references[i], d));
        };
        add_to_mean(surfaces[i].plane, plane);
        add_to_mean(surfaces[i].quadric, quadric);
      }
    };
  };
  for_each_cell<Local, ConcurrencyTag>(grid, positions, grid, positions, reach, progress,
                                       make_visitor);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_WEIGH_BY_RISK_H
