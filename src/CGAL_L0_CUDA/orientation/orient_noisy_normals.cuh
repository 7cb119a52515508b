// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_ORIENT_NOISY_NORMALS_CUH
#define CGAL_L0_CUDA_ORIENT_NOISY_NORMALS_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// `orient_normals()` of points whose heights over each other are noise, as on the CPU.
/// \param noise_of_heights heights within it tell nothing of a fold, as those within the spacing
void orient_noisy_normals(const Workplace& workplace, const double (&low)[3],
                          const double (&high)[3], unsigned number_of_neighbors, double spacing,
                          double noise_of_heights, const Side_hints& hints, const Samples& samples,
                          Sample_counts* counts);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_ORIENT_NOISY_NORMALS_CUH
