// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_ESTIMATE_MEMORY_CUH
#define CGAL_L0_CUDA_ESTIMATE_MEMORY_CUH

#include <CGAL/L0_resampling/internal/core/Parameters.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Bytes for n points and m samples with as many neighbors as is usual; what is missing is added on
/// the way, once.
std::size_t estimate_memory(std::size_t n, std::size_t m, const Parameters& parameters,
                            bool has_hints);

/// The same for a call that only orients n points.
std::size_t estimate_memory_to_orient(std::size_t n, const Parameters& parameters, bool has_normals,
                                      bool has_hints);

/// The same for a call that finds the sides of m samples of tiles.
std::size_t estimate_memory_to_orient_tiles(std::size_t m, const Parameters& parameters);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_ESTIMATE_MEMORY_CUH
