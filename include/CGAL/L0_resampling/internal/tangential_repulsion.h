// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TANGENTIAL_REPULSION_H
#define CGAL_L0_RESAMPLING_INTERNAL_TANGENTIAL_REPULSION_H

#include <CGAL/L0_resampling/internal/Neighborhoods.h>
#include <CGAL/L0_resampling/internal/Samples.h>
#include <CGAL/L0_resampling/internal/weights.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Spreads the samples: each moves away from its self neighbors within its tangent plane, the more the nearer they are,
\f$ \Delta_i = \mu (I - n_i n_i^T) \sum_k \theta(d_{ik}) (p_i - p_k) \f$. On an even set the pushes cancel. Near an edge or a border nobody
pushes back from outside, so that the part of a push that goes there is left out.

\param spacing of an even set of that many samples, a length
*/
template <typename ConcurrencyTag>
void repel_tangentially(const Neighborhoods& neighbors, double spacing, std::size_t number_of_steps, Samples& samples)
{
  // Chosen by the evenness they reach; see the ablation table of the benchmark.
  const double squared_bandwidth = 0.8 * spacing * spacing, strength = 0.7, maximum_step = 0.3 * spacing;
  const std::size_t samples_per_block = 2048;
  Buffer<Vector> moved(samples.positions);
  for (std::size_t step = 0; step < number_of_steps; ++step)
  {
    for_each_block<ConcurrencyTag>(samples.positions.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        Vector push = Vector::Zero();
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
        {
          const Vector difference = samples.positions[i] - samples.positions[neighbors.indices[e]];
          push += (strength * gaussian_weight(difference.squaredNorm(), squared_bandwidth)) * difference;
        }
        push -= samples.normals[i].dot(push) * samples.normals[i];
        const Vector& outward = samples.outward_directions[i];
        push -= (std::max)(outward.dot(push), 0.) * outward;
        const double length = push.norm();
        moved[i] = samples.positions[i] + (length > maximum_step ? maximum_step / length : 1.) * push;
      }
    });
    samples.positions.swap(moved);
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TANGENTIAL_REPULSION_H
