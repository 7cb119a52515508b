// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Session.cuh"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <exception>
#include <memory>
#include <new>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

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

std::atomic<Fault> planted_fault{Fault::NONE};
std::atomic<std::size_t> planted_countdown{0};

__global__ void do_nothing() {}

__global__ void write_to_nowhere() { *reinterpret_cast<volatile int*>(alignof(int)) = 0; }

/// \returns the caller's device, once a kernel of ours has run there
int usable_device()
{
  int count = 0, device = 0;
  CGAL_L0_CUDA_CHECK(cudaGetDeviceCount(&count));
  if (count == 0)
    throw Failure(Status::NO_DEVICE, "cudaGetDeviceCount: there is no device");
  CGAL_L0_CUDA_CHECK(cudaGetDevice(&device));
  cudaFuncAttributes attributes;
  CGAL_L0_CUDA_CHECK(cudaFuncGetAttributes(&attributes, do_nothing));
  int is_cooperative = 0;
  CGAL_L0_CUDA_CHECK(cudaDeviceGetAttribute(&is_cooperative, cudaDevAttrCooperativeLaunch, device));
  if (!is_cooperative)
    throw Failure(Status::NO_DEVICE, "the device has no cooperative launches");
  return device;
}

/// Whether this process is a child of one that has used CUDA, which only that one can go on with. The first call tells which process that is.
bool is_forked()
{
  static const pid_t process_of_cuda = getpid();
  return getpid() != process_of_cuda;
}

Answer answer(Status status, const char* message)
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
      return answer(Status::NO_DEVICE, "the device was used before fork(), so that this process cannot use it");
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
        session->number_of_samples = 0;
        session->arena.clear();
        session->scratch.clear();
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

} // namespace

void plant_fault(Fault fault, std::size_t countdown)
{
  planted_fault = fault;
  planted_countdown = countdown;
}

bool is_fault_due(Fault fault)
{
  if (planted_fault != fault || --planted_countdown > 0)
    return false;
  planted_fault = Fault::NONE;
  return true;
}

Answer find_device()
{
  return guarded(nullptr, []() { usable_device(); });
}

Answer create(Session*& session)
{
  session = nullptr;
  return guarded(nullptr, [&]() { session = std::make_unique<Session>(usable_device()).release(); });
}

void destroy(Session* session) noexcept
{
  if (!session || is_forked()) // what a child cannot give back, its end does
    return;
  int previous = 0;
  const bool has_previous = cudaGetDevice(&previous) == cudaSuccess;
  cudaSetDevice(session->device);
  delete session;
  if (has_previous)
    cudaSetDevice(previous);
  cudaGetLastError();
}

Answer upload(Session& session, const double* points, std::size_t size, const float* normals, const float* hints,
              std::size_t maximum_memory)
{
  return guarded(&session, [&]() {
    session.size = 0;
    session.has_scales = false;
    session.memory_limit.limit = maximum_memory;
    const std::size_t bytes_of_points = 3 * sizeof(double) * size,
                      bytes_of_normals = normals ? 3 * sizeof(float) * size : 0,
                      bytes_of_hints = hints ? 3 * sizeof(float) * size : 0;
    session.input.clear();
    session.input_memory.reserve(bytes_of_points + bytes_of_normals + bytes_of_hints + 1024);
    double* const device_points = session.input.take<double>(3 * size);
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(device_points, points, bytes_of_points, cudaMemcpyHostToDevice, session.stream));
    session.points = device_points;
    session.normals = nullptr;
    session.all_normals_given = false;
    session.hints = nullptr;
    session.reserve(34 * size + (std::size_t(1) << 20));
    if (normals)
    {
      float* const device_normals = session.input.take<float>(3 * size);
      CGAL_L0_CUDA_CHECK(
        cudaMemcpyAsync(device_normals, normals, bytes_of_normals, cudaMemcpyHostToDevice, session.stream));
      session.normals = device_normals;
      session.all_normals_given = !has_zero(session.workplace(), device_normals, unsigned(size));
    }
    if (hints)
    {
      float* const device_hints = session.input.take<float>(3 * size);
      CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(device_hints, hints, bytes_of_hints, cudaMemcpyHostToDevice, session.stream));
      session.hints = device_hints;
    }
    session.extent = find_extent(session.workplace(), device_points, unsigned(size));
    session.size = unsigned(size);
  });
}

Answer resample(Session& session, const Parameters& parameters, Progress_callback progress, Call_report& report)
{
  report = Call_report();
  return guarded(&session, [&]() {
    if (session.size == 0)
      throw Failure(Status::DEVICE_FAILED, "there are no points on the device");
    session.memory_limit.limit = parameters.maximum_memory;
    if (is_fault_due(Fault::KERNEL))
    {
      write_to_nowhere<<<1, 1, 0, session.stream>>>();
      check_launch("write_to_nowhere");
    }
    Stages stages(session, progress, report);
    run(session, parameters, stages, report);
  });
}

Answer download(Session& session, double* positions, float* normals)
{
  return guarded(&session, [&]() {
    const std::size_t m = session.number_of_samples;
    CGAL_L0_CUDA_CHECK(
      cudaMemcpyAsync(positions, session.positions, 3 * m * sizeof(double), cudaMemcpyDeviceToHost, session.stream));
    CGAL_L0_CUDA_CHECK(
      cudaMemcpyAsync(normals, session.sample_normals, 3 * m * sizeof(float), cudaMemcpyDeviceToHost, session.stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
