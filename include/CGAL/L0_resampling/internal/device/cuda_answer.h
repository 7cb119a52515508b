// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CUDA_ANSWER_H
#define CGAL_L0_RESAMPLING_INTERNAL_CUDA_ANSWER_H

#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/L0_resampling/internal/device/cuda_interface.h>

#include <new>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// \throws what a failed answer of the device stands for
inline void throw_if_failed(const cuda::Answer& answer)
{
  switch (answer.status)
  {
  case cuda::Status::DONE:
  case cuda::Status::CANCELLED: return;
  case cuda::Status::OUT_OF_MEMORY: throw std::bad_alloc();
  case cuda::Status::NOT_FINITE: throw Solver_error(answer.message);
  case cuda::Status::NO_DEVICE:
  case cuda::Status::DEVICE_FAILED: throw Device_error(answer.message);
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CUDA_ANSWER_H
