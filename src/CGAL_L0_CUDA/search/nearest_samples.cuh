// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_NEAREST_SAMPLES_CUH
#define CGAL_L0_CUDA_NEAREST_SAMPLES_CUH

#include "driver/stages.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// In place of a neighbor where there are fewer than k.
constexpr unsigned nobody = 0xffffffffu;

/// Finds the k nearest other samples of each sample; where even a ball of 1000 times
/// `spacing_guess` holds fewer, `nobody` fills up.
/// \returns k indices a sample, from the arena; waits for the device
unsigned* find_nearest_samples(const Execution_context& context, const double (&low)[3],
                               const double (&high)[3], unsigned k, double spacing_guess,
                               const Samples& samples);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_NEAREST_SAMPLES_CUH
