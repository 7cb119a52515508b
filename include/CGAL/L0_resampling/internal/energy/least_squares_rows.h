// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_LEAST_SQUARES_ROWS_H
#define CGAL_L0_RESAMPLING_INTERNAL_LEAST_SQUARES_ROWS_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/checked_count.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Eq. (11), \f$ \min_x \|Ax - b\|^2 \f$, for the displacements x from the current positions o.
/// Indices have 64 bits: the entries of \f$ A_f \f$ pass 2^31 where points are many.
template <typename FT>
struct Least_squares_system
{
  Eigen::SparseMatrix<FT, Eigen::RowMajor, std::ptrdiff_t> matrix; ///< A, three columns a sample
  Eigen::Matrix<FT, Eigen::Dynamic, 1> rhs;                        ///< b
  Eigen::Index number_of_rows = 0;                                 ///< rows added so far

  /// Starts a row; its entries follow by increasing column.
  void start_row(FT b)
  {
    matrix.startVec(number_of_rows);
    rhs[number_of_rows++] = b;
  }

  void add_entry(Eigen::Index column, FT value)
  {
    matrix.insertBackByOuterInner(number_of_rows - 1, column) = value;
  }
};

/// \f$ A_f \f$: three rows \f$ \sqrt{1/v_j}\, x_i = \sqrt{1/v_j}\, (q_j - o_i) \f$ for each
/// \f$ q_j \in M_{p_i} \f$.
template <typename FT>
void add_fit_rows(const Quadratic_problem<FT>& problem, Least_squares_system<FT>& system)
{
  const Explicit_rows<FT>& rows = *problem.rows;
  for (std::size_t i = 0; i < problem.number_of_samples(); ++i)
    for (std::size_t j = rows.fit_offsets[i]; j < rows.fit_offsets[i + 1]; ++j)
    {
      const FT scale = std::sqrt(rows.fit_weights[j]);
      for (std::size_t c = 0; c < 3; ++c)
      {
        system.start_row(scale * (rows.fit_positions[3 * j + c] - rows.origins[3 * i + c]));
        system.add_entry(Eigen::Index(3 * i + c), scale);
      }
    }
}

/// \f$ A_r \f$: three rows \f$ \sqrt{a_{ik}}\, (x_i - x_k) = -\sqrt{a_{ik}}\, (o_i - o_k) \f$ for
/// each unordered pair, none where \f$ a_{ik} = 0 \f$, so that an iteration without regularization
/// does without \f$ A_r \f$.
template <typename FT>
void add_regularization_rows(const Quadratic_problem<FT>& problem, Least_squares_system<FT>& system)
{
  const Neighborhoods_view& neighbors = problem.self_neighbors;
  const FT* const origins = problem.rows->origins;
  for (std::size_t i = 0; i < neighbors.size; ++i)
    for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
    {
      const std::size_t k = neighbors.indices[e];
      if (k < i || !(problem.pair_weights[Eigen::Index(e)] > 0))
        continue;
      const FT scale = std::sqrt(problem.pair_weights[Eigen::Index(e)]);
      for (std::size_t c = 0; c < 3; ++c)
      {
        system.start_row(-scale * (origins[3 * i + c] - origins[3 * k + c]));
        system.add_entry(Eigen::Index(3 * i + c), scale);
        system.add_entry(Eigen::Index(3 * k + c), -scale);
      }
    }
}

/// \f$ A_n \f$: one row
/// \f$ \sqrt\beta\, n_i^T (x_i - x_k) = \sqrt\beta\, (\delta_{ik} - n_i^T (o_i - o_k)) \f$ for each
/// ordered pair.
template <typename FT>
void add_normal_rows(const Quadratic_problem<FT>& problem, Least_squares_system<FT>& system)
{
  using Vectors = typename Quadratic_problem<FT>::Vectors;
  const Neighborhoods_view& neighbors = problem.self_neighbors;
  const Vectors origins(problem.rows->origins, 3, Eigen::Index(neighbors.size));
  const FT scale = std::sqrt(problem.penalty);
  for (std::size_t i = 0; i < neighbors.size; ++i)
    for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
    {
      const std::size_t k = neighbors.indices[e];
      const auto normal = problem.sample_normals.col(Eigen::Index(i));
      const FT distance = normal.dot(origins.col(Eigen::Index(i)) - origins.col(Eigen::Index(k)));
      system.start_row(scale * (problem.rows->normal_offsets[e] - distance));

      const std::size_t low = (std::min)(i, k), high = (std::max)(i, k);
      const FT low_scale = low == i ? scale : -scale;
      for (std::size_t c = 0; c < 3; ++c)
        system.add_entry(Eigen::Index(3 * low + c), low_scale * normal[Eigen::Index(c)]);
      for (std::size_t c = 0; c < 3; ++c)
        system.add_entry(Eigen::Index(3 * high + c), -low_scale * normal[Eigen::Index(c)]);
    }
}

/// The paper's \f$ A = \{A_f; A_r; A_n\} \f$ and \f$ b \f$ of a problem that has `rows`.
/// \throws std::length_error if A has more rows or entries than a 64-bit index counts
/// \throws std::bad_alloc if there is no memory for A
template <typename FT>
Least_squares_system<FT> least_squares_system(const Quadratic_problem<FT>& problem)
{
  const std::size_t number_of_fit_terms = problem.rows->fit_offsets[problem.number_of_samples()];
  const std::size_t number_of_pairs = problem.self_neighbors.offsets[problem.number_of_samples()];
  const std::size_t number_of_active_pairs =
    std::size_t((problem.pair_weights.array() > FT(0)).count()) / 2;

  Checked_count rows, entries;
  rows.add(number_of_fit_terms, 3).add(number_of_active_pairs, 3).add(number_of_pairs, 1);
  entries.add(number_of_fit_terms, 3).add(number_of_active_pairs, 6).add(number_of_pairs, 6);

  Least_squares_system<FT> system;
  system.matrix.resize(rows.index(), Checked_count().add(problem.number_of_samples(), 3).index());
  system.matrix.reserve(entries.index());
  system.rhs.resize(rows.index());
  add_fit_rows(problem, system);
  add_regularization_rows(problem, system);
  add_normal_rows(problem, system);
  system.matrix.finalize();
  return system;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_LEAST_SQUARES_ROWS_H
