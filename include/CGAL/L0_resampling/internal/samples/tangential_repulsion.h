// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TANGENTIAL_REPULSION_H
#define CGAL_L0_RESAMPLING_INTERNAL_TANGENTIAL_REPULSION_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/lanes.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/push_of_pair.h>
#include <CGAL/L0_resampling/internal/samples/Samples.h>
#include <CGAL/L0_resampling/internal/search/Neighborhoods.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Spreads the samples: each moves away from its self neighbors within its tangent plane, the more the
nearer they are, \f$ \Delta_i = \mu (I - n_i n_i^T) \sum_k \theta(d_{ik}) (p_i - p_k) \f$. On an
even set the pushes cancel. Near an edge or a border nobody pushes back from outside, so that the
part of a push that goes there is left out.

Where the samples have spreading radii of their own, distances are read relative to the mean of a
pair's two. Then the pushes cancel, to first order of the gradient, on a set whose density is the
inverse square of those radii.

\param places where the samples were when their neighbors were found
\param range of the pairs, there; pushes end softly at it (`share_in_ball()`), so that no
rounding decides whether one is felt
\param spacing of an even set of that many samples, a length
\param radius of the fit, at scale 1: no sample is pushed out of its reach
*/
template <typename ConcurrencyTag, typename FT>
void repel_tangentially(const Neighborhoods& neighbors, const Buffer<Vector>& places,
                        const Range_of_pairs& range, double spacing, double radius,
                        std::size_t number_of_steps, Samples<FT>& samples)
{
  using Local_vector = Eigen::Matrix<FT, 3, 1>;
  using Numbers = Lanes<FT, false>;
  const Repulsion repulsion(spacing, radius);
  const FT squared_bandwidth = FT(repulsion.squared_bandwidth), strength = FT(repulsion.strength);
  const bool is_even = samples.spreading_radii.empty();
  const FT spreading_radius = FT(self_neighbor_radius_per_spacing * spacing);
  const Scales_view scale_of = view_of_scales(samples.scales);
  const std::size_t samples_per_block = 1024;
  Buffer<Vector> moved = copy_of(samples.positions);
  for (std::size_t step = 0; step < number_of_steps; ++step)
  {
    for_each_block<ConcurrencyTag>(
      samples.positions.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
        const std::size_t first_pair = neighbors.offsets[begin],
                          size = padded_to_lanes(neighbors.offsets[end] - first_pair);
        Buffer<Local_vector> differences(size);
        const auto find_differences_of = [&](const Buffer<Vector>& positions) {
          Aligned_vector<FT> squared_distances(size, FT(0));
          for (std::size_t i = begin; i < end; ++i)
            for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
            {
              const Vector d = positions[i] - positions[neighbors.indices[e]];
              differences[e - first_pair] = d.cast<FT>();
              squared_distances[e - first_pair] = differences[e - first_pair].squaredNorm();
            }
          return squared_distances;
        };
        // anew in each step: kept, they would be as many numbers as there are pairs
        Aligned_vector<FT> shares = find_differences_of(places);
        for (std::size_t k = 0; k < size && is_even; k += Numbers::size)
          share_in_ball(Numbers::load(&shares[k]), FT(square(range.radius))).store(&shares[k]);
        Aligned_vector<FT> squared_distances = find_differences_of(samples.positions);
        for (std::size_t i = begin; i < end && !is_even; ++i)
          for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
          {
            const Index k = neighbors.indices[e];
            const std::size_t pair = e - first_pair;
            squared_distances[pair] *= squared_stretch_of_pair(
              spreading_radius, FT(samples.spreading_radii[i] + samples.spreading_radii[k]));
            shares[pair] = share_in_ball(shares[pair], FT(range.squared(i, k)));
          }
        Aligned_vector<FT> strengths(size);
        for (std::size_t k = 0; k < size; k += Numbers::size)
          strength_of_push(strength, Numbers::load(&shares[k]),
                           Numbers::load(&squared_distances[k]), squared_bandwidth)
            .store(&strengths[k]);
        for (std::size_t i = begin; i < end; ++i)
        {
          Local_vector push = Local_vector::Zero();
          for (std::size_t e = neighbors.offsets[i] - first_pair;
               e < neighbors.offsets[i + 1] - first_pair; ++e)
            push += strengths[e] * differences[e];
          push -= samples.normals[i].dot(push) * samples.normals[i];
          const Local_vector& outward = samples.outward_directions[i];
          push -= (std::max)(outward.dot(push), FT(0)) * outward;
          const FT length = push.norm(),
                   maximum_step = FT(Repulsion(is_even ? spacing
                                                       : samples.spreading_radii[i]
                                                           / self_neighbor_radius_per_spacing,
                                               radius * double(scale_of[i]))
                                       .maximum_step);
          if (length > maximum_step)
            push *= maximum_step / length;
          moved[i] = samples.positions[i] + push.template cast<double>();
        }
      });
    samples.positions.swap(moved);
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TANGENTIAL_REPULSION_H
