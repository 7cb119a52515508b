// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MATRIX_FREE_PRODUCT_H
#define CGAL_L0_RESAMPLING_INTERNAL_MATRIX_FREE_PRODUCT_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/kernels/block_factorization.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// The matrix H of `Quadratic_problem` by samples, for solvers that never form it.

/// D_i = (W_i + sum of a_ik) I + beta * sum of (n_i n_i^T + n_k n_k^T)
template <typename FT>
Block_factorization<FT> diagonal_block(const Quadratic_problem<FT>& problem, std::size_t i)
{
  FT weight = problem.fit_weights[Eigen::Index(i)];
  for (std::size_t e = problem.self_neighbors.offsets[i]; e < problem.self_neighbors.offsets[i + 1];
       ++e)
    weight += problem.pair_weights[Eigen::Index(e)];
  const FT* const spread = problem.normal_spreads.data() + 6 * i;
  const FT beta = problem.penalty;
  return factorize_block({weight + beta * spread[0], beta * spread[1], beta * spread[2],
                          weight + beta * spread[3], beta * spread[4], weight + beta * spread[5]});
}

/// A direction p_i is stored as p_i, 0, beta n_i n_i^T p_i, 0. The second half is all that its
/// neighbors need of n_i. Each half takes the room of four numbers, so that they fill vector
/// registers.
constexpr std::size_t numbers_of_direction = 8;

template <typename FT>
FT dot_of_three(const FT* a, const FT* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Fills in the second half.
template <typename FT>
void complete_direction(const Quadratic_problem<FT>& problem, std::size_t i, FT* direction)
{
  const FT* const normal = problem.sample_normals.data() + 3 * i;
  const FT s = problem.penalty * dot_of_three(normal, direction);
  for (std::size_t c = 0; c < 3; ++c)
    direction[4 + c] = s * normal[c];
}

/// product = sum of [a_ik I + beta (n_i n_i^T + n_k n_k^T)] p_k, so that (Hp)_i = D_i p_i -
/// product. For a neighbor, all that is stored is added, and its first half once more, times a_ik.
/// \param directions of all samples
template <typename FT>
void multiply_couplings(const Quadratic_problem<FT>& problem, const FT* directions, std::size_t i,
                        FT (&product)[3])
{
  using Four = Eigen::Array<FT, 4, 1>;
  using Eight = Eigen::Array<FT, 8, 1>;
  const FT* const pair_weights = problem.pair_weights.data();
  const Index* const indices = problem.self_neighbors.indices;
  Eight sum = Eight::Zero();        // of p_k and beta n_k n_k^T p_k
  Four weighted_sum = Four::Zero(); // of a_ik p_k
  for (std::size_t e = problem.self_neighbors.offsets[i]; e < problem.self_neighbors.offsets[i + 1];
       ++e)
  {
    const FT* const p = directions + numbers_of_direction * std::size_t(indices[e]);
    sum += Eigen::Map<const Eight>(p);
    weighted_sum += pair_weights[e] * Eigen::Map<const Four>(p);
  }
  const FT* const normal = problem.sample_normals.data() + 3 * i;
  const FT s = problem.penalty * dot_of_three(normal, sum.data());
  for (std::size_t c = 0; c < 3; ++c)
    product[c] = weighted_sum[Eigen::Index(c)] + sum[Eigen::Index(4 + c)] + s * normal[c];
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MATRIX_FREE_PRODUCT_H
