// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NORMAL_MATRIX_H
#define CGAL_L0_RESAMPLING_INTERNAL_NORMAL_MATRIX_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/checked_count.h>

#include <Eigen/SparseCore>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Both triangles are stored. Indices have 64 bits.
template <typename FT>
using Normal_matrix = Eigen::SparseMatrix<FT, Eigen::ColMajor, std::ptrdiff_t>;

/// \f$ H = A^T A \f$ of `Quadratic_problem` from its collapsed form, 3m x 3m, xyz interleaved.
/// \throws std::length_error if H has more entries than a 64-bit index counts
/// \throws std::bad_alloc if there is no memory for H
template <typename FT>
Normal_matrix<FT> assemble_normal_matrix(const Quadratic_problem<FT>& problem)
{
  using Matrix_3 = Eigen::Matrix<FT, 3, 3>;
  const Neighborhoods_view& neighbors = problem.self_neighbors;
  const std::size_t m = neighbors.size;
  const Eigen::Index size = Checked_count().add(m, 3).index();
  const Eigen::Index number_of_entries =
    Checked_count().add(m, 9).add(neighbors.offsets[m], 9).index();
  const auto outer_product = [&](std::size_t i) -> Matrix_3 {
    const auto normal = problem.sample_normals.col(Eigen::Index(i));
    return problem.penalty * (normal * normal.transpose());
  };

  Normal_matrix<FT> matrix(size, size);
  matrix.resizeNonZeros(number_of_entries);
  FT* const values = matrix.valuePtr();
  std::ptrdiff_t* const rows = matrix.innerIndexPtr();
  std::ptrdiff_t* const column_starts = matrix.outerIndexPtr();
  for (std::size_t i = 0; i < m; ++i)
  {
    const std::size_t first = neighbors.offsets[i], last = neighbors.offsets[i + 1];
    const std::size_t blocks_per_column = last - first + 1;
    const std::size_t start = 9 * (first + i); // entries of the samples before
    const auto write_block = [&](std::size_t place, std::size_t k, const Matrix_3& block) {
      for (std::size_t column = 0; column < 3; ++column)
        for (std::size_t row = 0; row < 3; ++row)
        {
          const std::size_t entry = start + 3 * (column * blocks_per_column + place) + row;
          rows[entry] = std::ptrdiff_t(3 * k + row);
          values[entry] = block(Eigen::Index(row), Eigen::Index(column));
        }
    };
    for (std::size_t column = 0; column < 3; ++column)
      column_starts[3 * i + column] = std::ptrdiff_t(start + 3 * column * blocks_per_column);

    // The block of i itself stands among those of its neighbors, which come by increasing index.
    Matrix_3 diagonal = problem.fit_weights[Eigen::Index(i)] * Matrix_3::Identity();
    std::size_t number_before = 0;
    for (std::size_t e = first; e < last; ++e)
    {
      const std::size_t k = neighbors.indices[e];
      const Matrix_3 block = problem.pair_weights[Eigen::Index(e)] * Matrix_3::Identity()
                             + outer_product(i) + outer_product(k);
      diagonal += block;
      number_before += std::size_t(k < i);
      write_block(e - first + std::size_t(k > i), k, -block);
    }
    write_block(number_before, i, diagonal);
  }
  column_starts[3 * m] = number_of_entries;
  return matrix;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NORMAL_MATRIX_H
