// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_DEVICE_PROGRESS_H
#define CGAL_L0_RESAMPLING_INTERNAL_DEVICE_PROGRESS_H

#include <CGAL/L0_resampling/internal/device/cuda_interface.h>

#include <exception>
#include <functional>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The caller's callback behind the C interface: what it throws waits until the device is done.
class Device_progress
{
  std::function<bool(double)> m_callback;
  std::exception_ptr m_exception;

public:
  explicit Device_progress(std::function<bool(double)> callback) : m_callback(std::move(callback))
  {}

  cuda::Progress_callback as_callback()
  {
    cuda::Progress_callback callback;
    if (m_callback)
    {
      callback.function = [](void* context, double share) {
        return static_cast<Device_progress*>(context)->ask(share);
      };
      callback.context = this;
    }
    return callback;
  }

  void rethrow_exception_of_callback() const
  {
    if (m_exception)
      std::rethrow_exception(m_exception);
  }

private:
  bool ask(double share)
  {
    try
    {
      return m_callback(share);
    }
    catch (...)
    {
      m_exception = std::current_exception();
      return false;
    }
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_DEVICE_PROGRESS_H
