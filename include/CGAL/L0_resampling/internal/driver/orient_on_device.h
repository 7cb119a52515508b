// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENT_ON_DEVICE_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENT_ON_DEVICE_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/cloud/are_all_given.h>
#include <CGAL/L0_resampling/internal/device/Device_progress.h>
#include <CGAL/L0_resampling/internal/device/Device_session.h>
#include <CGAL/L0_resampling/internal/device/cuda_orientation.h>
#include <CGAL/L0_resampling/internal/driver/orient_point_set.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Makes it an array of `n` values that the device writes. All threads touch its memory first, as
/// the copy would do so on one thread.
template <typename T>
void resize_to_download(std::size_t n, Buffer<T>& values)
{
  const std::size_t block_size = 65536, page_size = 4096; // bytes; at the least
  values.resize(n);
  char* const bytes = reinterpret_cast<char*>(values.data());
  for_each_block<Parallel_if_available_tag>(n * sizeof(T), block_size,
                                            [&](std::size_t begin, std::size_t end) {
                                              for (std::size_t i = begin; i < end; i += page_size)
                                                bytes[i] = 0;
                                            });
}

/// Finds the sides of the normals of a point set on a CUDA device, as `orient_point_set()` does on
/// the CPU; unlike there, nothing is used up.
/// \param parameters checked, for as many output points as there are points; `maximum_memory` is of
/// the device
/// \returns nothing if the callback cancelled, which the report says
/// \throws Device_error if no device can be used, or it fails
/// \throws std::bad_alloc if memory of the device does not suffice
inline Oriented_representatives orient_on_device(const Buffer<Vector>& positions,
                                                 const Buffer<Local_vector>& given_normals,
                                                 const Buffer<Local_vector>& hints,
                                                 const Parameters& parameters,
                                                 const std::function<bool(double)>& callback,
                                                 Report& report)
{
  report.device = "cuda";
  report.device_reason = "asked for";
  const std::size_t n = positions.size();
  const Device_session session = new_device_session();
  throw_if_failed(cuda::upload(*session, coordinates(positions), n, coordinates(given_normals),
                               coordinates(hints), parameters.maximum_memory));
  Device_progress progress(callback);
  cuda::Call_report call;
  std::size_t number_of_representatives = 0;
  const cuda::Answer answer = cuda::orient(*session, parameters, progress.as_callback(), call,
                                           number_of_representatives);
  fill_report(call, report);
  progress.rethrow_exception_of_callback();
  throw_if_failed(answer);
  Oriented_representatives result;
  if (answer.status == cuda::Status::CANCELLED)
  {
    report.outcome = Outcome::CANCELLED;
    return result;
  }
  resize_to_download(n, result.of_points);
  if (!are_all_given<Parallel_if_available_tag>(given_normals))
    resize_to_download(number_of_representatives, result.normals);
  resize_to_download(number_of_representatives, result.mean_normals);
  throw_if_failed(cuda::download_representatives(*session, result.of_points.data(),
                                                 coordinates(result.normals),
                                                 coordinates(result.mean_normals)));
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENT_ON_DEVICE_H
