// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/Cuda_backend.cuh"
#include "driver/estimate_memory.cuh"

#include <CGAL/L0_resampling/internal/driver/run.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

void run_stages(Session& session, const Parameters& parameters, Stages& stages, Call_report& report)
{
  session.reserve(estimate_memory(session.size, parameters.number_of_output_points, parameters,
                                  session.hints != nullptr));
  Cuda_backend backend(session, parameters, unsigned(parameters.number_of_output_points), stages,
                       report);
  run(plan_call(parameters, backend), backend);
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
