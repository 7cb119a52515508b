// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MATRIX_FREE_SOLVER_H
#define CGAL_L0_RESAMPLING_INTERNAL_MATRIX_FREE_SOLVER_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/energy/solver_settings.h>
#include <CGAL/L0_resampling/internal/kernels/block_factorization.h>
#include <CGAL/L0_resampling/internal/kernels/matrix_free_product.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What solvers that never form the matrix H have in common: their settings, the arrays of a solve
/// and the loops over samples.
template <typename FT, typename ConcurrencyTag>
class Matrix_free_solver
{
protected:
  double m_tolerance;
  std::size_t m_maximum_number_of_iterations;

  Buffer<FT> m_residuals;                   // r, 3 m
  Buffer<FT> m_products;                    // of what a solver needs it for; 3 m, or none
  Buffer<Block_factorization<FT>> m_blocks; // D, m
  Buffer<FT> m_directions;                  // see `numbers_of_direction`

  Matrix_free_solver(double tolerance, std::size_t maximum_number_of_iterations)
    : m_tolerance(checked_tolerance(tolerance)),
      m_maximum_number_of_iterations(maximum_number_of_iterations)
  {}

  /// Holds the arrays for as long as it lives.
  struct Arrays_of_one_solve
  {
    Matrix_free_solver& solver;

    explicit Arrays_of_one_solve(Matrix_free_solver& s) : solver(s) {}

    // Where one of the allocations throws, the destructor runs, since the constructor called first
    // has ended.
    Arrays_of_one_solve(Matrix_free_solver& s, std::size_t m, bool with_products,
                        Memory_counter* memory)
      : Arrays_of_one_solve(s)
    {
      const Counting_allocator<FT> allocator(memory);
      solver.m_residuals = Buffer<FT>(3 * m, allocator);
      if (with_products)
        solver.m_products = Buffer<FT>(3 * m, allocator);
      solver.m_blocks = Buffer<Block_factorization<FT>>(m, allocator);
      solver.m_directions = Buffer<FT>(numbers_of_direction * m, allocator);
    }
    ~Arrays_of_one_solve()
    {
      release(solver.m_residuals);
      release(solver.m_products);
      release(solver.m_blocks);
      release(solver.m_directions);
    }
  };

  // Large enough to hide the cost of a task, small enough to keep every thread busy.
  static constexpr std::size_t block_size = 1024;

  template <typename F>
  static void for_each_block(std::size_t m, const F& f)
  {
    internal::for_each_block<ConcurrencyTag>(m, block_size, f);
  }

  template <typename F>
  static auto sum_over_blocks(std::size_t m, const F& f)
  {
    return block_sum<ConcurrencyTag>(m, block_size, f);
  }

  FT* direction(std::size_t i) { return &m_directions[numbers_of_direction * i]; }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MATRIX_FREE_SOLVER_H
