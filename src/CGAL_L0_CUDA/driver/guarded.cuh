// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_GUARDED_CUH
#define CGAL_L0_CUDA_GUARDED_CUH

#include "driver/Session.cuh"

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <mutex>
#include <new>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Restores the caller's device at the end of a call.
class Device_scope
{
  int m_previous = 0;

public:
  explicit Device_scope(int device)
  {
    CGAL_L0_CUDA_CHECK(cudaGetDevice(&m_previous));
    CGAL_L0_CUDA_CHECK(cudaSetDevice(device));
  }
  Device_scope(const Device_scope&) = delete;
  Device_scope& operator=(const Device_scope&) = delete;
  ~Device_scope() { cudaSetDevice(m_previous); }
};

/// Whether this process is a child of one that has used CUDA, which only that one can go on with.
/// The first call tells which process that is.
inline bool is_forked()
{
  static const pid_t process_of_cuda = getpid();
  return getpid() != process_of_cuda;
}

inline Answer answer(Status status, const char* message)
{
  Answer result;
  result.status = status;
  std::snprintf(result.message, sizeof(result.message), "%s", message);
  return result;
}

/// Runs `f`, and turns what it throws into an answer.
template <typename F>
Answer guarded(Session* session, const F& f)
{
  try
  {
    if (is_forked())
      return answer(Status::NO_DEVICE,
                    "the device was used before fork(), so that this process cannot use it");
    if (!session)
    {
      f();
      return Answer();
    }
    const std::lock_guard<std::mutex> lock(session->mutex);
    if (session->is_broken)
      return answer(Status::DEVICE_FAILED, "the device failed in an earlier call");
    const Device_scope device(session->device);
    try
    {
      f();
    }
    catch (const Failure& failure)
    {
      // Only an error of a kernel outlives its call, and shows in the next one.
      session->is_broken = cudaStreamSynchronize(session->stream) != cudaSuccess;
      cudaGetLastError();
      if (failure.status() == Status::OUT_OF_MEMORY)
      {
        session->forget_result();
        session->working_memory.free_all();
      }
      throw;
    }
    return Answer();
  }
  catch (const Cancelled&)
  {
    return answer(Status::CANCELLED, "");
  }
  catch (const Failure& failure)
  {
    return answer(failure.status(), failure.what());
  }
  catch (const std::bad_alloc&)
  {
    return answer(Status::OUT_OF_MEMORY, "the host has no memory");
  }
  catch (const std::exception& error)
  {
    return answer(Status::DEVICE_FAILED, error.what());
  }
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_GUARDED_CUH
