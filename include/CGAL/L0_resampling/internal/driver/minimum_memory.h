// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MINIMUM_MEMORY_H
#define CGAL_L0_RESAMPLING_INTERNAL_MINIMUM_MEMORY_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/samples/Samples.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the arrays of a call take at their peak, at the least: known from the counts alone, so that
/// a limit that cannot suffice is refused before anything is read or allocated. How many neighbors
/// there are, which most of the rest goes to, only the call itself finds out.
/// \tparam FT the number type of the solver
/// \param n number of points that are used, fewer than 2^32, as are those of the result: nothing
/// here leaves 64 bits
template <typename FT>
std::size_t minimum_memory(std::size_t n, const Parameters& parameters)
{
  using Local_vector = Eigen::Matrix<FT, 3, 1>;
  const std::size_t m = parameters.number_of_output_points;
  if (n == 0 || m == 0)
    return 0;
  const std::size_t sorting =
    n * (2 * sizeof(Vector) + sizeof(Index)); // the points twice, and their order
  const std::size_t samples =
    m * (2 * sizeof(Vector) + sizeof(Local_vector) + sizeof(FT)); // what `Samples` always holds
  const std::size_t kept = parameters.outlier_sensitivity > 0
                             ? 1
                             : n; // the number of outliers is not known yet
  const std::size_t sampling =
    samples + kept * (sizeof(Vector) + 4 * sizeof(float)); // and points, normals and weights
  return (std::max)(sorting, sampling);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MINIMUM_MEMORY_H
