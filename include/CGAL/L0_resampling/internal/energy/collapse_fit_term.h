// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_COLLAPSE_FIT_TERM_H
#define CGAL_L0_RESAMPLING_INTERNAL_COLLAPSE_FIT_TERM_H

#include <CGAL/L0_resampling/internal/kernels/Fit_of_neighbors.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <atomic>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Replaces the fit term of each sample by one weight and one point, which is exact:
\f$ \sum_{q_j \in M_{p_i}} \|p_i - q_j\|^2 / v_j = W_i \|p_i - c_i\|^2 + \mathrm{const} \f$ with
\f$ W_i = \sum 1/v_j \f$ and \f$ c_i \f$ the mean of the \f$ q_j \f$ weighted by \f$ 1/v_j \f$. The
millions of rows of the paper's \f$ A_f \f$ become three a sample.

A sample without an original neighbor is tied to where it is.

\param radius \f$ r_p \f$
\param numbers_of_samples how many samples each one stands for; empty if only for itself
\param fit_weights, fit_centroids out: \f$ W_i > 0 \f$ and \f$ c_i \f$
\returns the number of samples without an original neighbor
*/
template <typename ConcurrencyTag, typename T, typename FT>
std::size_t collapse_fit_term(const Search_grid_3& sample_grid, const Buffer<Vector>& samples,
                              const Search_grid_3& grid, const Buffer<Vector>& points,
                              const Buffer<T>& input_density_weights, double radius,
                              const Buffer<Index>& numbers_of_samples, Progress& progress,
                              Buffer<FT>& fit_weights, Buffer<Vector>& fit_centroids)
{
  const T squared_radius = T(radius * radius);
  std::atomic<std::size_t> number_of_lonely_samples{0};
  const auto make_visitor = [&]() {
    return [&, weights = Aligned_vector<T>()](Search_grid_3::Range queries,
                                              const Local_points<T>& candidates,
                                              const Vector& origin) mutable {
      using L = Lanes<T>;
      weights.assign(candidates.padded_size(), T(0));
      for (std::size_t k = 0; k < candidates.indices.size(); ++k)
        weights[k] = 1 / input_density_weights[candidates.indices[k]];

      for (Index i = queries.first; i < queries.second; ++i)
      {
        const Eigen::Matrix<T, 3, 1> center = (samples[i] - origin).template cast<T>();
        Fit_of_neighbors<L> lanes;
        for (std::size_t k = 0; k < candidates.padded_size(); k += L::size)
        {
          const L dx = L::load(&candidates.x[k]) - center[0];
          const L dy = L::load(&candidates.y[k]) - center[1];
          const L dz = L::load(&candidates.z[k]) - center[2];
          lanes.add(dx, dy, dz, dx * dx + dy * dy + dz * dz, squared_radius, L::load(&weights[k]));
        }
        const double weight = lanes.weight.sum();
        if (weight > 0)
        {
          fit_weights[i] = FT(weight);
          fit_centroids[i] =
            samples[i]
            + Vector(lanes.places.x.sum(), lanes.places.y.sum(), lanes.places.z.sum()) / weight;
        }
        else
        {
          fit_weights[i] = 1;
          fit_centroids[i] = samples[i];
          number_of_lonely_samples += numbers_of_samples.empty() ? 1 : numbers_of_samples[i];
        }
      }
    };
  };
  for_each_cell<T, ConcurrencyTag>(sample_grid, samples, grid, points,
                                   cells_in_reach(radius, grid.cell_size()), progress,
                                   make_visitor);
  return number_of_lonely_samples;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_COLLAPSE_FIT_TERM_H
