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

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

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
  constexpr int of_reference = 0, of_plane = 5, of_quadric = 11; // places of their values
  const auto make_visitor = [&]() {
    return [&, normals = Local_normals<Local>(), values = Gathered_values<Local, 17>()](
             Search_grid_3::Range queries, Local_points<Local>& candidates,
             const Vector& origin) mutable {
      normals.gather(candidates, sample_normals);
      values.gather(candidates, [&](Index k, Local(&own)[17]) {
        const auto put = [&](const Surface_of_disks& s, Local* to) {
          to[0] = s.height;
          to[1] = s.slope_u;
          to[2] = s.slope_v;
          to[3] = s.height_variance;
          to[4] = s.slope_variance;
        };
        const Surface_of_disks& reference = references[k];
        put(reference, own + of_reference);
        put(surfaces[k].plane, own + of_plane);
        put(surfaces[k].quadric, own + of_quadric);
        own[of_plane + 5] = reference.is_determined() && surfaces[k].plane.is_determined();
        own[of_quadric + 5] = reference.is_determined() && surfaces[k].quadric.is_determined();
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
            const auto add = [&](int of_surface, Differences_from_reference<L>& sums) {
              const auto difference = [&](int a) {
                return values.load(of_surface + a, k) - values.load(of_reference + a, k);
              };
              sums.add(weight * values.load(of_surface + 5, k), difference(0), difference(1),
                       difference(2), (-difference(3)).max(0), (-difference(4)).max(0));
            };
            add(of_plane, plane);
            add(of_quadric, quadric);
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
