// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device/device_faults.h"
#include "device/test_cuda_support.h"

#include <CGAL/L0_resampling/Solver_report.h>

#include <cuda_runtime_api.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>

// G4, G5, G7 of what is owed where the device fails: exceptions, no memory lost, no hang; and what
// works afterwards.

namespace {

using namespace test_cuda;
using CGAL::L0_resampling::CUDA_resampler;
using CGAL::L0_resampling::Device_error;
using CGAL::L0_resampling::Method;
namespace parameters = CGAL::parameters;

const Method methods[] = {Method::LOR, Method::ALOR, Method::DEFAULT};

std::size_t free_memory()
{
  std::size_t free = 0, total = 0;
  CHECK(cudaMemGetInfo(&free, &total) == cudaSuccess);
  return free;
}

Result resample(const Points& points, Method method)
{
  Result result;
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(
    points, std::back_inserter(result),
    parameters::resampling_method(method).select_percentage(60));
  return result;
}

/// Whatever `f` is called for runs in a process of its own: the device is lost for that process.
/// \returns its exit status; 124 if it does not end
template <typename F>
int status_of_child(const F& f)
{
  const pid_t child = fork();
  if (child == 0)
  {
    alarm(60);
    f();
    std::_Exit(test::result());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 124;
}

/// G5: an error of a kernel is an exception that names a call, and so is everything that comes
/// after it.
void check_kernel_error()
{
  CHECK(status_of_child([]() {
          const Points points = noisy_cube(2000, 0.01, 1);
          CUDA_resampler<Kernel> resampler;
          resampler.upload(points);
          Result result;
          int number_of_calls = 0;
          const auto break_at_first_call = [&](double) {
            if (number_of_calls++ == 0)
              break_device();
            return true;
          };
          std::string message;
          try
          {
            resampler.resample(std::back_inserter(result),
                               parameters::select_percentage(60).callback(break_at_first_call));
          }
          catch (const Device_error& error)
          {
            message = error.what();
          }
          std::cout << "kernel error: " << message << std::endl;
          CHECK(number_of_calls > 0);
          CHECK(message.find(": ") != std::string::npos); // the call, and the error
          CHECK(result.empty());
          for (int attempt = 0; attempt < 2; ++attempt)
          {
            CHECK_THROWS(resampler.resample(std::back_inserter(result),
                                            parameters::select_percentage(60)),
                         Device_error);
            CHECK_THROWS(resample(points, Method::LOR), Device_error);
            CHECK_THROWS(CUDA_resampler<Kernel>(), Device_error);
          }
          for (int attempt = 0; attempt < 2; ++attempt)
          {
            CHECK_THROWS(resampler.upload(points), Device_error);
            // it holds no points now, and of none there is nothing to resample
            resampler.resample(std::back_inserter(result), parameters::select_percentage(60));
          }
          CHECK(result.empty());
        })
        == 0);
}

/// G4: whichever allocation fails, the memory is there again, and the next call works.
void check_allocations()
{
  const Points points = noisy_cube(20000, 0.01, 2);
  for (const Method method : methods)
  {
    const Result expected = resample(points, method);
    const std::size_t free_before = free_memory();
    std::size_t number_of_allocations = 0;
    for (std::size_t k = 1; k < 200; ++k)
    {
      fail_allocation(k);
      bool has_failed = false;
      try
      {
        CHECK(resample(points, method) == expected);
      }
      catch (const std::bad_alloc&)
      {
        has_failed = true;
      }
      fail_allocation(0);
      CHECK(free_memory() == free_before);
      if (!has_failed)
        break;
      number_of_allocations = k;
    }
    std::cout << "method " << int(method) << ": " << number_of_allocations << " allocations"
              << std::endl;
    CHECK(number_of_allocations >= 2);
    CHECK(resample(points, method) == expected);

    // and with an object that is used again
    CUDA_resampler<Kernel> resampler;
    const auto np = parameters::resampling_method(method).select_percentage(60);
    for (std::size_t k = 1; k <= number_of_allocations; ++k)
    {
      Result result;
      try
      {
        fail_allocation(k);
        resampler.upload(points);
        resampler.resample(std::back_inserter(result), np);
      }
      catch (const std::bad_alloc&)
      {
        CHECK(result.empty());
      }
      fail_allocation(0);
      result.clear();
      resampler.upload(points);
      resampler.resample(std::back_inserter(result), np);
      CHECK(result == expected);
    }
  }
}

/// A hundred calls hold no more memory than the second one did, and none once the object is gone.
void check_memory_of_many_calls()
{
  const Points points = noisy_cube(20000, 0.01, 3), fewer(points.begin(), points.begin() + 5000);
  resample(points, Method::DEFAULT);
  const std::size_t free_before = free_memory();
  {
    CUDA_resampler<Kernel> resampler;
    std::size_t free_early = 0;
    for (int call = 0; call < 100; ++call)
    {
      Result result;
      resampler.upload(call % 3 == 2 ? fewer : points);
      resampler.resample(
        std::back_inserter(result),
        parameters::resampling_method(methods[call % 3]).number_of_output_points(3000 + call));
      if (call == 11)
        free_early = free_memory();
    }
    CHECK(free_memory() >= free_early);
  }
  CHECK(free_memory() == free_before);
  for (int call = 0; call < 100; ++call)
    resample(fewer, methods[call % 3]);
  CHECK(free_memory() == free_before);
}

/// P8: the limit holds, in the first call and in those that find memory from the last. A call after
/// one that failed at its limit needs what the first one did, which did not know how much it would
/// need and may have held its memory in pieces.
void check_limit()
{
  const Points points = noisy_cube(20000, 0.01, 4);
  const auto np = parameters::resampling_method(Method::LOR).select_percentage(60);
  const Result expected = resample(points, Method::LOR);
  CUDA_resampler<Kernel> resampler;
  resampler.upload(points);
  const auto peak_bytes_within = [&](std::size_t limit) {
    Report report;
    Result result;
    resampler.resample(std::back_inserter(result), np | parameters::maximum_memory(limit)
                                                     | parameters::resampling_report(&report));
    CHECK(result == expected && report.peak_bytes <= limit);
    return report.peak_bytes;
  };
  const std::size_t of_first = peak_bytes_within((std::numeric_limits<std::size_t>::max)());
  const std::size_t of_second = peak_bytes_within(of_first);
  std::cout << "peak of first call " << of_first << ", of second " << of_second << std::endl;
  CHECK(of_second <= of_first && peak_bytes_within(of_second) == of_second);
  for (const double share : {0.5, 0.75, 0.95})
  {
    Result result;
    CHECK_THROWS(
      resampler.resample(std::back_inserter(result),
                         np | parameters::maximum_memory(std::size_t(share * double(of_second)))),
      std::bad_alloc);
    CHECK(result.empty());
    resampler.upload(points);
    CHECK(peak_bytes_within(of_first) == of_first);
  }
}

/// G7: CUDA does not survive a fork; a call in the child says so. Exit runs in the child as in any
/// process.
void check_fork()
{
  const Points points = noisy_cube(2000, 0.01, 5);
  CUDA_resampler<Kernel> resampler;
  resampler.upload(points);
  const Result expected = resample(points, Method::LOR);
  CHECK(status_of_child([&]() {
          Result result;
          CHECK_THROWS(resampler.resample(std::back_inserter(result),
                                          parameters::select_percentage(60)),
                       Device_error);
          CHECK_THROWS(resampler.upload(points), Device_error);
          CHECK_THROWS(resample(points, Method::LOR), Device_error);
          CHECK_THROWS(CUDA_resampler<Kernel>(), Device_error);
          std::string reason;
          CHECK(!CGAL::L0_resampling::is_cuda_device_usable(&reason));
          std::cout << "after a fork: " << reason << std::endl;
          CGAL::l0_resample_point_set<CGAL::Sequential_tag>(points, std::back_inserter(result));
          CHECK(!result.empty());
          { // the child's copy of an object of the parent may be destroyed
            CUDA_resampler<Kernel> moved(std::move(resampler));
          }
        })
        == 0);
  CHECK(resample(points, Method::LOR) == expected);
}

} // namespace

int main()
{
  // Before this process has touched the device, which would be lost for its children.
  if (status_of_child([]() {
        if (!has_device())
          std::_Exit(number_of_skip);
      })
      == number_of_skip)
    return number_of_skip;
  check_kernel_error();
  check_allocations();
  check_memory_of_many_calls();
  check_limit();
  check_fork();
  return test::result();
}
