// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_QUADRATIC_PROBLEM_H
#define CGAL_L0_RESAMPLING_QUADRATIC_PROBLEM_H

#include <CGAL/license/L0_resampling.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {

namespace internal {
class Memory_counter;
}

/// Index of a point or a sample. Halves the memory of neighbor lists; larger sets are refused.
using Index = std::uint32_t;

/// 3 x m matrix, one point or vector per column, so xyz interleaved in memory.
template <typename FT>
using Matrix_3X = Eigen::Matrix<FT, 3, Eigen::Dynamic>;

/// \ingroup PkgL0ResamplingRef Lists of indices in compressed rows: list `i` is
/// `indices[offsets[i]]` to `indices[offsets[i+1] - 1]`, ascending.
struct Neighborhoods_view
{
  std::size_t size = 0;                 ///< number of lists m
  const std::size_t* offsets = nullptr; ///< m + 1 entries, the first 0
  const Index* indices = nullptr;       ///< offsets[m] entries
};

/*!
\ingroup PkgL0ResamplingRef

What the rows of Eq. (11) need beyond the collapsed form of `Quadratic_problem`; only solvers that
declare `needs_explicit_rows` get it. With \f$ o_i \f$ the current positions and \f$ x_i \f$ the
displacements from them, the rows say

- \f$ x_i = q_j - o_i \f$, weight \f$ 1/v_j \f$, for each fit row of sample i (three rows);
- \f$ x_i - x_k = -(o_i - o_k) \f$, weight \f$ a_{ik} \f$, for each unordered pair of self neighbors
(three rows);
- \f$ n_i^T (x_i - x_k) = \delta_{ik} - n_i^T (o_i - o_k) \f$, weight \f$ \beta \f$, for each
ordered pair (one row).

\tparam FT `float` or `double`
*/
template <typename FT>
struct Explicit_rows
{
  const std::size_t* fit_offsets =
    nullptr; ///< m + 1 entries: the fit rows of sample i are `[fit_offsets[i], fit_offsets[i+1])`
  const FT* fit_positions =
    nullptr; ///< xyz of \f$ q_j \f$, or of a merged point of \f$ \hat{M}_{p_i} \f$
  const FT* fit_weights = nullptr; ///< \f$ 1/v_j \f$, or the sum over the merged points
  const FT* normal_offsets =
    nullptr; ///< \f$ \delta_{ik} \f$, one for each entry of `self_neighbors.indices`
  const FT* origins = nullptr; ///< xyz of \f$ o_i \f$, m points
};

/*!
\ingroup PkgL0ResamplingRef

Eq. (10), the quadratic step of Algorithm 1, as views of arrays that the caller keeps alive. The
unknowns \f$ x_i \f$ are the displacements of the samples from their current positions \f$ o_i \f$,
which keeps every number as small as the neighborhoods are, wherever the cloud lies and however far
away an outlier is. With \f$ W_i = \sum_j 1/v_j \f$, \f$ c_i \f$ the centroid of \f$ M_{p_i} \f$
weighted by \f$ 1/v_j \f$, \f$ a_{ik} = \alpha \bar\theta_{ik} (1/w_i + 1/w_k) \f$ and
\f$ d_{ik} = (o_i + x_i) - (o_k + x_k) \f$, each unordered pair counted once in the second sum,

\f[ E(x) = \sum_i W_i \|o_i + x_i - c_i\|^2 + \sum_{\{i,k\}} a_{ik} \|d_{ik}\|^2
         + \beta \sum_i \sum_{k \in N_i} (n_i^T d_{ik} - \delta_{ik})^2 + \mathrm{const}. \f]

The fit term is exact: \f$ \sum_j \|p - q_j\|^2 / v_j = W \|p - c\|^2 + \mathrm{const} \f$. The
minimizer solves \f$ Hx = g \f$, a sparse symmetric positive definite system of 3 x 3 blocks,
\f$ H = A^T A \f$ and \f$ g = A^T b \f$ in Eq. (11):

\f[ (Hx)_i = W_i x_i + \sum_{k \in N_i} [a_{ik} I + \beta (n_i n_i^T + n_k n_k^T)] (x_i - x_k). \f]

Every \f$ W_i \f$ is positive. Self neighbors are symmetric:
\f$ k \in N_i \Leftrightarrow i \in N_k \f$, and \f$ i \notin N_i \f$. Lengths are in units of the
working frame, where the radius \f$ r_p \f$ is 1.

\tparam FT `float` or `double`
*/
template <typename FT>
struct Quadratic_problem
{
  /// one number for each sample or pair
  using Scalars = Eigen::Map<const Eigen::Matrix<FT, Eigen::Dynamic, 1>>;
  /// one column for each sample
  using Vectors = Eigen::Map<const Matrix_3X<FT>>;
  /// one symmetric 3 x 3 matrix for each sample, by its upper triangle
  using Spreads = Eigen::Map<const Eigen::Matrix<FT, 6, Eigen::Dynamic>>;

  Scalars fit_weights;               ///< \f$ W_i \f$, m entries
  Neighborhoods_view self_neighbors; ///< \f$ N_i \f$, m lists
  Vectors sample_normals;            ///< \f$ n_i \f$, 3 x m, unit length
  Scalars pair_weights;    ///< \f$ a_{ik} \f$, one for each entry of `self_neighbors.indices`
  Vectors right_hand_side; ///< \f$ g_i \f$, 3 x m
  FT penalty;              ///< \f$ \beta \f$ of this iteration
  /// 6 x m: upper triangles xx, xy, xz, yy, yz, zz of
  /// \f$ \sum_{k \in N_i} (n_i n_i^T + n_k n_k^T) \f$. With \f$ \beta \f$ before it, and
  /// \f$ W_i + \sum_k a_{ik} \f$ on its diagonal, it is the diagonal block of \f$ H \f$.
  Spreads normal_spreads;
  const Explicit_rows<FT>* rows; ///< null unless the solver declares `needs_explicit_rows`

  /// The largest \f$ \|g\| \f$ of the solves before this one in the same call, or what does not
  /// matter: solvers take their tolerance relative to this or to that of their own \f$ g \f$,
  /// whichever is larger. Where the samples have come a long way, what is left of it need not be
  /// known better than the way itself.
  double right_hand_side_scale = 0;

  /// Where a solver may book its arrays, so that they count for the caller's `maximum_memory`; may
  /// be null.
  internal::Memory_counter* memory = nullptr;

  /// Few of the eigenvalues of \f$ D^{-1} H \f$ are smaller than this, where \f$ D \f$ is the block
  /// diagonal of \f$ H \f$. It is in (0, 1), and follows from \f$ \alpha \f$ and \f$ \beta \f$
  /// without a look at the samples.
  double low_end_of_spectrum = 0.2;

  /// m
  std::size_t number_of_samples() const { return self_neighbors.size; }
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_QUADRATIC_PROBLEM_H
