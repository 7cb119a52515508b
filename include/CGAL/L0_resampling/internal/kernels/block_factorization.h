// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_BLOCK_FACTORIZATION_H
#define CGAL_L0_RESAMPLING_INTERNAL_BLOCK_FACTORIZATION_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The factors of a symmetric positive definite 3 x 3 block, D = L diag(pivots) L^T with ones on
/// the diagonal of L. One copy serves the product with D and with its inverse, and takes no more
/// room than D. Unlike the determinant of an explicit inverse, no value in it is of the third power
/// of the block's scale, so `float` does not underflow.
template <typename FT>
struct Block_factorization
{
  FT pivots[3];
  FT l10, l20, l21;
};

/// Factorizes the positive definite block with the upper triangle (xx, xy, xz, yy, yz, zz). Pivots
/// are held well above the rounding of the block's trace: each step of a solver rounds its product
/// with the system to that, and dividing by the pivot turns it into displacements. Samples in one
/// place all round alike, as if the system had an eigenvalue below 0: with c units of rounding, and
/// pivots held at h units, they grow by \f$ e^{s \sqrt{2 c / h}} \f$ in s steps, at most a hundred.
/// A held pivot is that of D with more on its diagonal: the system stays positive definite, and is
/// solved for a step that is shorter where it is that weak.
template <typename FT>
CGAL_L0_HOST_DEVICE inline Block_factorization<FT> factorize_block(const FT (&upper)[6])
{
  const FT least = 4096 * std::numeric_limits<FT>::epsilon() * (upper[0] + upper[3] + upper[5]);
  const auto held = [least](FT pivot) { return pivot < least ? least : pivot; };
  Block_factorization<FT> f;
  f.pivots[0] = held(upper[0]);
  f.l10 = upper[1] / f.pivots[0];
  f.l20 = upper[2] / f.pivots[0];
  f.pivots[1] = held(upper[3] - f.l10 * upper[1]);
  const FT below = upper[4] - f.l20 * upper[1];
  f.l21 = below / f.pivots[1];
  f.pivots[2] = held(upper[5] - f.l20 * upper[2] - f.l21 * below);
  return f;
}

/// y = D x
template <typename FT>
CGAL_L0_HOST_DEVICE inline void multiply_block(const Block_factorization<FT>& f, const FT* x, FT* y)
{
  const FT s0 = f.pivots[0] * (x[0] + f.l10 * x[1] + f.l20 * x[2]);
  const FT s1 = f.pivots[1] * (x[1] + f.l21 * x[2]);
  y[0] = s0;
  y[1] = s1 + f.l10 * s0;
  y[2] = f.pivots[2] * x[2] + f.l21 * s1 + f.l20 * s0;
}

/// y = D^{-1} x
template <typename FT>
CGAL_L0_HOST_DEVICE inline void solve_block(const Block_factorization<FT>& f, const FT* x, FT* y)
{
  const FT s1 = x[1] - f.l10 * x[0];
  const FT s2 = x[2] - f.l20 * x[0] - f.l21 * s1;
  y[2] = s2 / f.pivots[2];
  y[1] = s1 / f.pivots[1] - f.l21 * y[2];
  y[0] = x[0] / f.pivots[0] - f.l10 * y[1] - f.l20 * y[2];
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_BLOCK_FACTORIZATION_H
