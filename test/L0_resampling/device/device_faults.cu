// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device/device_faults.h"

#include <cuda_runtime.h>

#include <atomic>
#include <stdexcept>

namespace {

std::atomic<std::size_t> calls_until_failure{0};

__global__ void write_to_nowhere() { *reinterpret_cast<volatile int*>(alignof(int)) = 0; }

} // namespace

// The linker puts the first of these in the place of all calls of `cudaMalloc()`, and that function
// in the place of the second.
extern "C" cudaError_t __wrap_cudaMalloc(void** data, std::size_t bytes);
extern "C" cudaError_t __real_cudaMalloc(void** data, std::size_t bytes);

cudaError_t __wrap_cudaMalloc(void** data, std::size_t bytes)
{
  if (calls_until_failure > 0 && --calls_until_failure == 0)
    return cudaErrorMemoryAllocation;
  return __real_cudaMalloc(data, bytes);
}

namespace test_cuda {

void fail_allocation(std::size_t countdown) { calls_until_failure = countdown; }

void break_device()
{
  cudaStream_t stream;
  if (cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking) != cudaSuccess)
    throw std::runtime_error("there is no stream for a kernel that fails");
  write_to_nowhere<<<1, 1, 0, stream>>>();
  if (cudaGetLastError() != cudaSuccess)
    throw std::runtime_error("a kernel that is to fail does not start");
}

} // namespace test_cuda
