// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_COMMON_DEVICE_CHOICE_H
#define L0_COMMON_DEVICE_CHOICE_H

#include <CGAL/L0_resampling/Solver_report.h>

#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/CUDA_resampler.h>
#endif

#include <new>
#include <string>

/// What the tool and the Python package have in common.
namespace l0_common {

enum class Device
{
  CPU,
  CUDA,
  AUTO ///< a CUDA device if there is one that can be used, else the CPU
};

/// The device that a user asks for.
struct Device_request
{
  Device device = Device::AUTO;
  std::string option;   ///< how the user asks for `Device::CUDA`, for messages
  std::string obstacle; ///< why no device can do what else is asked for, or empty
};

/// Whether a CUDA device can be used by this program.
/// \param reason out: why not
inline bool is_device_usable(std::string& reason)
{
#ifdef CGAL_L0_LINKED_WITH_CUDA
  return CGAL::L0_resampling::is_cuda_device_usable(&reason);
#else
  reason = "there is no CUDA in this build";
  return false;
#endif
}

/// Whether the request can be met by a CUDA device.
/// \param reason out: why not
/// \throws Device_error if it cannot, and the request is for `Device::CUDA`
template <typename Is_usable = bool (*)(std::string&)>
bool can_use_device(const Device_request& request, std::string& reason,
                    const Is_usable& is_usable = is_device_usable)
{
  if (request.obstacle.empty() && is_usable(reason))
    return true;
  if (!request.obstacle.empty())
    reason = request.obstacle;
  if (request.device == Device::CUDA)
    throw CGAL::L0_resampling::Device_error(request.option + ": " + reason);
  return false;
}

/*!
Calls `on_device()` or `on_cpu()`, as the request says.

With `Device::AUTO`, `on_cpu()` is called where no device can be used, and where the device fails or
has too little memory. With `Device::CUDA` it is never called.

\returns why the call ran where it did, for `Report::device_reason`
\throws Device_error with `Device::CUDA`, if no device can be used or the device failed
\throws std::bad_alloc with `Device::CUDA`, if the device has too little memory
*/
template <typename On_device, typename On_cpu, typename Is_usable = bool (*)(std::string&)>
std::string run_on_chosen(const Device_request& request, const On_device& on_device,
                          const On_cpu& on_cpu, const Is_usable& is_usable = is_device_usable)
{
  std::string reason = "asked for";
  if (request.device != Device::CPU && can_use_device(request, reason, is_usable))
  {
    try
    {
      on_device();
      return request.device == Device::AUTO ? "a device can be used" : "asked for";
    }
    catch (const CGAL::L0_resampling::Device_error& error)
    {
      if (request.device == Device::CUDA)
        throw CGAL::L0_resampling::Device_error(request.option + ": " + error.what());
      reason = error.what();
    }
    catch (const std::bad_alloc&)
    {
      if (request.device == Device::CUDA)
        throw;
      reason = "the device has too little memory";
    }
  }
  on_cpu();
  return reason;
}

} // namespace l0_common

#endif // L0_COMMON_DEVICE_CHOICE_H
