// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CUDA_ORIENTATION_H
#define CGAL_L0_RESAMPLING_INTERNAL_CUDA_ORIENTATION_H

#include <CGAL/L0_resampling/internal/device/cuda_interface.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

// For callers that only orient the points of a session.

/// Finds the sides of the points of the session, as `orient_point_set()` on the CPU. What stands
/// for them stays on the device until the next call.
/// \param parameters checked, for as many output points as there are points
/// \param number_of_representatives out: 0 unless DONE
Answer orient(Session& session, const Parameters& parameters, Progress_callback progress,
              Call_report& report, std::size_t& number_of_representatives);

/// Brings the result of `orient()` to the host.
/// \param of_points out: for each point of the session, the place of what stands for it
/// \param normals out: of what stands for others, of unit length, xyz interleaved; may be null
/// \param mean_normals out: of those around, which tell the sides, likewise
Answer download_representatives(Session& session, std::uint32_t* of_points, float* normals,
                                float* mean_normals);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CUDA_ORIENTATION_H
