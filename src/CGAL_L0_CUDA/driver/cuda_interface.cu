// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/guarded.cuh"

#include <CGAL/L0_resampling/internal/device/cuda_device_arrays.h>
#include <CGAL/L0_resampling/internal/device/cuda_orientation.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void do_nothing() {}

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

} // namespace

Answer find_device()
{
  return guarded(nullptr, []() { usable_device(); });
}

Answer create(Session*& session)
{
  session = nullptr;
  return guarded(nullptr,
                 [&]() { session = std::make_unique<Session>(usable_device()).release(); });
}

Answer create_on(int device, Session*& session)
{
  session = nullptr;
  return guarded(nullptr, [&]() {
    const Device_scope scope(device);
    session = std::make_unique<Session>(usable_device()).release();
  });
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

Answer upload(Session& session, const double* points, std::size_t size, const float* normals,
              const float* hints, std::size_t maximum_memory)
{
  return guarded(&session, [&]() {
    const Session::Input_arrays arrays = session.reserve_input(size, normals, hints,
                                                               maximum_memory);
    const auto copy = [&](void* target, const void* source, std::size_t bytes) {
      if (target)
        CGAL_L0_CUDA_CHECK(
          cudaMemcpyAsync(target, source, bytes, cudaMemcpyHostToDevice, session.stream));
    };
    copy(arrays.points, points, 3 * sizeof(double) * size);
    copy(arrays.normals, normals, 3 * sizeof(float) * size);
    copy(arrays.hints, hints, 3 * sizeof(float) * size);
    session.filter_input(arrays, unsigned(size));
  });
}

namespace {

using Run = void(Session&, const Parameters&, Stages&, Call_report&);

/// A call that works with the points of the session.
Answer call(Run& run, Session& session, const Parameters& parameters, Progress_callback progress,
            Call_report& report)
{
  report = Call_report();
  return guarded(&session, [&]() {
    if (session.size == 0)
      throw Failure(Status::DEVICE_FAILED, "there are no points on the device");
    session.memory_limit.limit = parameters.maximum_memory;
    Stages stages(session, progress, report);
    run(session, parameters, stages, report);
  });
}

} // namespace

Answer resample(Session& session, const Parameters& parameters, Progress_callback progress,
                Call_report& report)
{
  return call(run_stages, session, parameters, progress, report);
}

Answer orient(Session& session, const Parameters& parameters, Progress_callback progress,
              Call_report& report, std::size_t& number_of_representatives)
{
  const Answer answer = call(run_orientation, session, parameters, progress, report);
  number_of_representatives = answer.status == Status::DONE ? session.representatives.size : 0;
  return answer;
}

Answer download_representatives(Session& session, std::uint32_t* of_points, float* normals,
                                float* mean_normals)
{
  return guarded(&session, [&]() {
    const Oriented_representatives& from = session.representatives;
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(of_points, from.of_points, session.size * sizeof(*of_points),
                                       cudaMemcpyDeviceToHost, session.stream));
    for (const auto& [to, vectors] :
         {std::pair(normals, from.normals), std::pair(mean_normals, from.mean_normals)})
      if (to)
        CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(to, vectors, 3 * sizeof(float) * from.size,
                                           cudaMemcpyDeviceToHost, session.stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

Answer download(Session& session, double* positions, float* normals)
{
  return guarded(&session, [&]() {
    const std::size_t m = session.number_of_samples;
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(positions, session.positions, 3 * m * sizeof(double),
                                       cudaMemcpyDeviceToHost, session.stream));
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(normals, session.sample_normals, 3 * m * sizeof(float),
                                       cudaMemcpyDeviceToHost, session.stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

Answer download_values(Session& session, const Values_of_result& wanted)
{
  return guarded(&session, [&]() {
    const std::size_t m = session.number_of_samples;
    const auto copy_if_wanted = [&](float* to, const float* from) {
      if (to)
        CGAL_L0_CUDA_CHECK(
          cudaMemcpyAsync(to, from, m * sizeof(float), cudaMemcpyDeviceToHost, session.stream));
    };
    copy_if_wanted(wanted.side_confidences, session.side_confidences);
    copy_if_wanted(wanted.noises, session.sample_noises);
    copy_if_wanted(wanted.position_deviations, session.position_deviations);
    copy_if_wanted(wanted.normal_deviations, session.normal_deviations);
    if (session.sample_scales)
      copy_if_wanted(wanted.scales, session.sample_scales);
    else if (wanted.scales)
      std::fill_n(wanted.scales, m, 1.f);
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

const unsigned* outliers(const Session& session) { return session.outliers.data(); }

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
