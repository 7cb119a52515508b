// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_CUDA_CHECK_CUH
#define CGAL_L0_CUDA_CUDA_CHECK_CUH

#include <CGAL/L0_resampling/internal/device/cuda_interface.h>

#include <cuda_runtime.h>

#include <stdexcept>
#include <string>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Travels within the library; the functions of the interface turn it into an `Answer`.
class Failure : public std::runtime_error
{
  Status m_status;

public:
  Failure(Status status, const std::string& message) : std::runtime_error(message), m_status(status)
  {}

  Status status() const { return m_status; }
};

inline Status status_of(cudaError_t error)
{
  switch (error)
  {
  case cudaErrorMemoryAllocation: return Status::OUT_OF_MEMORY;
  case cudaErrorNoDevice:
  case cudaErrorInsufficientDriver:
  case cudaErrorNoKernelImageForDevice:
  case cudaErrorUnsupportedPtxVersion:
  case cudaErrorInvalidDeviceFunction:
  case cudaErrorInitializationError:
  case cudaErrorDevicesUnavailable:
  case cudaErrorStubLibrary:
  case cudaErrorSystemDriverMismatch: return Status::NO_DEVICE;
  default: return Status::DEVICE_FAILED;
  }
}

/// Takes a failed call out of CUDA's memory, so that the caller's own next call does not find it,
/// and throws it.
inline void check(cudaError_t error, const char* call)
{
  if (error == cudaSuccess)
    return;
  cudaGetLastError();
  throw Failure(status_of(error), std::string(call) + ": " + cudaGetErrorString(error));
}

/// After a launch.
inline void check_launch(const char* kernel) { check(cudaGetLastError(), kernel); }

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#define CGAL_L0_CUDA_CHECK(call) ::CGAL::L0_resampling::internal::cuda::check((call), #call)

#endif // CGAL_L0_CUDA_CUDA_CHECK_CUH
