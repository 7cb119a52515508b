// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PAIR_TERMS_H
#define CGAL_L0_RESAMPLING_INTERNAL_PAIR_TERMS_H

#include <CGAL/L0_resampling/internal/core/lanes.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Density_in_ball.h>
#include <CGAL/L0_resampling/internal/kernels/Weight_of_pair.h>
#include <CGAL/L0_resampling/internal/kernels/shrinkage.h>
#include <CGAL/L0_resampling/internal/samples/Samples.h>
#include <CGAL/L0_resampling/internal/search/Neighborhoods.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// The terms of Eq. (7) that couple samples, computed pair by pair. Blocks of samples run at the
// same time; the pairs of one fit into the cache.
constexpr std::size_t samples_per_block = 256;

/// Line 4 of Algorithm 1: updates \f$ w_i \f$ of Eq. (5), and the weights \f$ a_{ik} \f$ of the
/// pairs in Eq. (7), `Weight_of_pair`.
/// \param mean_number_of_neighbors \f$ \eta_S \f$
/// \param squared_bandwidth \f$ \sigma_q^2 \f$
/// \param squared_radius \f$ r_p^2 \f$
/// \param squared_jump \f$ J^2 \f$, infinite in LOR and ALOR
/// \param range of the self neighbors, where the weights end; infinite in LOR and ALOR, whose pairs
/// stay
/// \param density_weights out: one number a sample, at least 1
/// \param pair_weights out: one number a pair
/// \param scales of the samples; lengths are those at scale 1
template <typename ConcurrencyTag, typename FT>
void update_weights(const Buffer<Vector>& samples, const Buffer<Eigen::Matrix<FT, 3, 1>>& normals,
                    const Neighborhoods& neighbors, double mean_number_of_neighbors,
                    double squared_bandwidth, double squared_radius, double squared_jump,
                    const Range_of_pairs& range, double regularization_weight,
                    Buffer<FT>& density_weights, Buffer<FT>& pair_weights)
{
  using Numbers = Lanes<FT, false>;
  const bool has_jumps = std::isfinite(squared_jump);
  const Weight_of_pair<FT> weight_of_pair = {FT(squared_radius), FT(squared_jump)};
  Buffer<FT> inverses(samples.size(), samples.get_allocator());
  for_each_block<ConcurrencyTag>(
    samples.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
      const std::size_t first_pair = neighbors.offsets[begin],
                        size = padded_to_lanes(neighbors.offsets[end] - first_pair);
      Aligned_vector<FT> squared_distances(size, FT(0)), squared_heights = squared_distances,
                                                         shares(size), thetas(size), weights(size);
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
        {
          const Index k = neighbors.indices[e];
          const std::size_t pair = e - first_pair;
          const Vector d = samples[i] - samples[k];
          squared_distances[pair] = FT(d.squaredNorm());
          if (!has_jumps)
            continue;
          const Eigen::Matrix<FT, 3, 1> local = d.cast<FT>();
          const FT height_i = normals[i].dot(local), height_k = normals[k].dot(local);
          squared_heights[pair] = squared_height_of_pair(height_i, height_k);
        }
      for (std::size_t k = 0; k < size; k += Numbers::size)
        share_in_ball(Numbers::load(&squared_distances[k]), FT(square(range.radius)))
          .store(&shares[k]);
      if (!range.is_one_for_all())
        for (std::size_t i = begin; i < end; ++i)
          for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
          {
            const Index k = neighbors.indices[e];
            const std::size_t pair = e - first_pair;
            const FT stretch = FT(1 / range.scales.squared_of_pair(i, k));
            shares[pair] = share_in_ball(squared_distances[pair], FT(range.squared(i, k)));
            squared_heights[pair] *= stretch;
            squared_distances[pair] *= stretch;
          }
      for (std::size_t k = 0; k < size; k += Numbers::size)
      {
        const Numbers share = Numbers::load(&shares[k]),
                      squared_distance = Numbers::load(&squared_distances[k]);
        (share * gaussian_weight(squared_distance, FT(squared_bandwidth))).store(&thetas[k]);
        weight_of_pair.by_place(share, squared_distance, Numbers::load(&squared_heights[k]))
          .store(&weights[k]);
      }
      for (std::size_t i = begin; i < end; ++i)
      {
        FT sum = 0; // one by one: in an order that depends on the place in the block it is another
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
          sum += thetas[e - first_pair];
        density_weights[i] = density_weight(sum, FT(mean_number_of_neighbors));
        inverses[i] = FT(regularization_weight) / density_weights[i];
      }
      std::copy_n(weights.data(), neighbors.offsets[end] - first_pair,
                  pair_weights.begin() + std::ptrdiff_t(first_pair));
    });
  for_each_block<ConcurrencyTag>(
    samples.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
          pair_weights[e] = weight_of_pair.by_density(pair_weights[e], inverses[i],
                                                      inverses[neighbors.indices[e]]);
    });
}

/// The upper triangle xx, xy, xz, yy, yz, zz of a symmetric matrix.
template <typename FT>
using Upper_triangle = Eigen::Matrix<FT, 6, 1>;

/// \f$ \sum_{k \in N_i} (n_i n_i^T + n_k n_k^T) \f$ for each sample.
template <typename ConcurrencyTag, typename FT>
void sum_normal_spreads(const Buffer<Eigen::Matrix<FT, 3, 1>>& normals,
                        const Neighborhoods& neighbors, Buffer<Upper_triangle<FT>>& spreads)
{
  const auto add_outer_product = [](FT factor, const Eigen::Matrix<FT, 3, 1>& n,
                                    Upper_triangle<FT>& sum) {
    sum += factor
           * Upper_triangle<FT>(n[0] * n[0], n[0] * n[1], n[0] * n[2], n[1] * n[1], n[1] * n[2],
                                n[2] * n[2]);
  };
  spreads.resize(normals.size());
  for_each_block<ConcurrencyTag>(
    normals.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        Upper_triangle<FT> sum = Upper_triangle<FT>::Zero();
        add_outer_product(FT(neighbors.offsets[i + 1] - neighbors.offsets[i]), normals[i], sum);
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
          add_outer_product(FT(1), normals[neighbors.indices[e]], sum);
        spreads[i] = sum;
      }
    });
}

/// The terms of Eq. (7), without the constant part of the first and without the weights of the last
/// two.
struct Energy_sums
{
  double fit = 0;                   ///< \f$ \sum W_i \|p_i - c_i\|^2 \f$
  double regularization = 0;        ///< \f$ \sum_{\{i,k\}} a_{ik} \|p_i - p_k\|^2 \f$
  double squared_normal_misfit = 0; ///< \f$ \sum (n_i^T(p_i - p_k) - \delta_{ik})^2 \f$
  std::size_t number_of_active_pairs = 0;
  double squared_right_hand_side = 0; ///< \f$ \sum \|g_i\|^2 \f$, of the linearization there

  Energy_sums& operator+=(const Energy_sums& other)
  {
    fit += other.fit;
    regularization += other.regularization;
    squared_normal_misfit += other.squared_normal_misfit;
    number_of_active_pairs += other.number_of_active_pairs;
    squared_right_hand_side += other.squared_right_hand_side;
    return *this;
  }
};

/*!
Solves Eq. (8) by Eq. (9) for every pair with the samples fixed, and linearizes Eq. (10) there: half
its negative gradient at the current positions,

\f[ g_i = W_i (c_i - p_i) - \sum_{k \in N_i} \left( a_{ik} d_{ik}
+ \beta (n_i^T d_{ik} - \delta_{ik}) n_i
          + \beta (n_k^T d_{ik} + \delta_{ki}) n_k \right), \qquad d_{ik} = p_i - p_k. \f]

Only differences of neighbors enter, so that neither the place of the cloud nor a far outlier costs
digits.

\param jumps by \f$ \sqrt{\lambda/\beta} \f$, as lengths at scale 1
\param range as of `update_weights()`; near it, as much of a jump is kept as the weights
there lack
\param right_hand_side out: \f$ g_i \f$, one vector a sample
\param normal_offsets out: \f$ \delta_{ik} \f$ for each pair if not empty, for solvers that want the
rows of Eq. (11)
*/
template <typename ConcurrencyTag, typename FT>
Energy_sums shrink_normal_offsets(const Samples<FT>& samples, const Neighborhoods& neighbors,
                                  const Buffer<FT>& pair_weights, FT penalty,
                                  const Shrunk_jumps<FT>& jumps, const Range_of_pairs& range,
                                  Buffer<Eigen::Matrix<FT, 3, 1>>& right_hand_side,
                                  Buffer<FT>& normal_offsets)
{
  using Local_vector = Eigen::Matrix<FT, 3, 1>;
  const bool is_scaled = range.scales.values != nullptr;
  return block_sum<ConcurrencyTag>(
    samples.positions.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
      Energy_sums sums;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Local_vector to_centroid =
          (samples.fit_centroids[i] - samples.positions[i]).template cast<FT>();
        sums.fit += samples.fit_weights[i] * to_centroid.squaredNorm();

        // Numbers rather than vectors: compilers put two of the three numbers of a vector in one
        // register, and take longer to get them there than to work with them.
        const Vector position = samples.positions[i];
        const Local_vector normal = samples.normals[i];
        FT pull_x = 0, pull_y = 0, pull_z = 0, misfit = 0, regularization = 0,
           squared_normal_misfit = 0;
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
        {
          const Index k = neighbors.indices[e];
          const Vector& other_position = samples.positions[k];
          const Local_vector& other_normal = samples.normals[k];
          const FT x = FT(position[0] - other_position[0]), y = FT(position[1] - other_position[1]),
                   z = FT(position[2] - other_position[2]);
          const FT distance_i = normal[0] * x + normal[1] * y + normal[2] * z;
          const FT distance_k = other_normal[0] * x + other_normal[1] * y + other_normal[2] * z;
          const FT squared_distance = x * x + y * y + z * z,
                   share = share_in_ball(squared_distance, FT(range.squared(i, k)));
          const FT scale = is_scaled ? std::sqrt(FT(range.scales.squared_of_pair(i, k))) : FT(1);
          const Jump_of_pair<FT> jump_i(distance_i, scale, share, jumps);
          // delta_ki is minus that of this one, as p_k - p_i is minus the difference
          const FT pull_k = Jump_of_pair<FT>(distance_k, scale, penalty * share, jumps).misfit;
          const FT weight = pair_weights[e];
          pull_x += weight * x + pull_k * other_normal[0];
          pull_y += weight * y + pull_k * other_normal[1];
          pull_z += weight * z + pull_k * other_normal[2];
          misfit += jump_i.misfit;
          if (!normal_offsets.empty())
            normal_offsets[e] = jump_i.offset + (1 - share) * (distance_i - jump_i.offset);

          regularization += weight * squared_distance;
          squared_normal_misfit += jump_i.misfit * jump_i.misfit;
          sums.number_of_active_pairs += jump_i.offset != 0;
        }
        const Local_vector g = samples.fit_weights[i] * to_centroid
                               - Local_vector(pull_x, pull_y, pull_z) - (penalty * misfit) * normal;
        sums.regularization += 0.5 * regularization; // each unordered pair comes twice
        sums.squared_normal_misfit += squared_normal_misfit;
        const Triple gradient = {double(g[0]), double(g[1]), double(g[2])};
        sums.squared_right_hand_side += dot(gradient, gradient);
        right_hand_side[i] = g;
      }
      return sums;
    });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PAIR_TERMS_H
