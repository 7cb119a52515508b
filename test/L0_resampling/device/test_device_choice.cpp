// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../../src/common/device_choice.h"
#include "test_support.h"

#include <functional>
#include <new>
#include <stdexcept>
#include <string>

using namespace test;
using CGAL::L0_resampling::Device_error;
using l0_common::Device;

using Action = std::function<void()>;

/// Where a call ran, what it says of it, and what it threw.
struct Outcome
{
  std::string calls, reason, device_error;
  bool has_too_little_memory = false;
};

Outcome outcome(Device device, bool is_usable, const Action& on_device = Action(),
                const std::string& obstacle = "")
{
  Outcome result;
  const auto usable = [&](std::string& reason) {
    result.calls += "asked ";
    if (!is_usable)
      reason = "there is none";
    return is_usable;
  };
  const auto run_on_device = [&]() {
    result.calls += "device ";
    if (on_device)
      on_device();
  };
  const auto run_on_cpu = [&]() { result.calls += "cpu "; };
  try
  {
    const l0_common::Device_request request = {device, "--device cuda", obstacle};
    result.reason = l0_common::run_on_chosen(request, run_on_device, run_on_cpu, usable);
  }
  catch (const Device_error& error)
  {
    result.device_error = error.what();
  }
  catch (const std::bad_alloc&)
  {
    result.has_too_little_memory = true;
  }
  return result;
}

const Action fails = []() { throw Device_error("it failed"); };
const Action has_no_memory = []() { throw std::bad_alloc(); };

void test_cpu_asks_for_no_device()
{
  const Outcome cpu = outcome(Device::CPU, true);
  CHECK(cpu.calls == "cpu " && cpu.reason == "asked for");
}

void test_auto_falls_back()
{
  const Outcome usable = outcome(Device::AUTO, true);
  CHECK(usable.calls == "asked device " && usable.reason == "a device can be used");
  const Outcome unusable = outcome(Device::AUTO, false);
  CHECK(unusable.calls == "asked cpu " && unusable.reason == "there is none");
  const Outcome failed = outcome(Device::AUTO, true, fails);
  CHECK(failed.calls == "asked device cpu " && failed.reason == "it failed");
  const Outcome full = outcome(Device::AUTO, true, has_no_memory);
  CHECK(full.calls == "asked device cpu " && full.reason == "the device has too little memory");
  const Outcome impossible = outcome(Device::AUTO, true, Action(), "another solver");
  CHECK(impossible.calls == "cpu " && impossible.reason == "another solver");
}

void test_cuda_never_falls_back()
{
  const Outcome usable = outcome(Device::CUDA, true);
  CHECK(usable.calls == "asked device " && usable.reason == "asked for");
  const Outcome unusable = outcome(Device::CUDA, false);
  CHECK(unusable.calls == "asked " && unusable.device_error == "--device cuda: there is none");
  const Outcome failed = outcome(Device::CUDA, true, fails);
  CHECK(failed.calls == "asked device " && failed.device_error == "--device cuda: it failed");
  const Outcome full = outcome(Device::CUDA, true, has_no_memory);
  CHECK(full.calls == "asked device " && full.has_too_little_memory);
  const Outcome impossible = outcome(Device::CUDA, true, Action(), "another solver");
  CHECK(impossible.calls.empty() && impossible.device_error == "--device cuda: another solver");
}

/// What is wrong on any device is no reason to try another.
void test_other_exceptions_pass_through()
{
  for (Device device : {Device::AUTO, Device::CUDA})
  {
    bool is_thrown = false;
    try
    {
      outcome(device, true, []() { throw std::invalid_argument("wrong"); });
    }
    catch (const std::invalid_argument&)
    {
      is_thrown = true;
    }
    CHECK(is_thrown);
  }
}

int main()
{
  test_cpu_asks_for_no_device();
  test_auto_falls_back();
  test_cuda_never_falls_back();
  test_other_exceptions_pass_through();
  return result();
}
