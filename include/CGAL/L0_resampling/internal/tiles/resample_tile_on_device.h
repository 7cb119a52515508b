// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_ON_DEVICE_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_ON_DEVICE_H

#include <CGAL/L0_resampling/internal/device/Device_progress.h>
#include <CGAL/L0_resampling/internal/device/Device_session.h>
#include <CGAL/L0_resampling/internal/device/cuda_tiles.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What tiles may take of the current device, in bytes: what is free there, but for what the driver
/// needs.
/// \throws Device_error if no device can be used
inline std::uint64_t device_memory_for_tiles()
{
  std::size_t bytes = 0;
  throw_if_failed(cuda::free_memory(bytes));
  return std::uint64_t(bytes) / 16 * 15;
}

/// All samples that start on points of a tile and its halo.
inline std::size_t number_of_starts(const std::vector<Point_in_cloud>& points)
{
  std::size_t sum = 0;
  for (const Point_in_cloud& point : points)
    sum += point.number_of_samples;
  return sum;
}

inline cuda::Facts_of_tiles facts_for_device(const Facts_of_cloud& facts,
                                             const std::vector<Point_in_cloud>& points)
{
  cuda::Facts_of_tiles result = {};
  result.exponent_of_frame = facts.frame->exponent;
  std::copy_n(facts.frame->origin.data(), 3, result.origin_of_frame);
  result.extents = *facts.extents;
  result.extents.scales = *facts.scales;
  result.area = *facts.area;
  result.number_of_points = *facts.number_of_points;
  result.mean_number_of_neighbors = facts.mean_number_of_neighbors.value_or(0.);
  Numbers_of_starts own = {0, 0};
  std::vector<float> scales;
  for (const Point_in_cloud& point : points)
  {
    own.on_points += point.number_of_samples > 0;
    own.all += point.number_of_samples;
    scales.push_back(point.scale);
  }
  const Numbers_of_starts numbers = facts.numbers_of_starts.value_or(own);
  result.number_of_starts = numbers.all;
  result.number_of_point_starts = numbers.on_points;
  result.range_of_scales = facts.range_of_scales.value_or(
    range_of(Buffer<float>(scales.begin(), scales.end())));
  return result;
}

/// As `resample_tile()`, on the current CUDA device.
/// \param points of a tile and its halo, in the unit of the input
/// \param callback of the user, or none
/// \throws Device_error if no device can be used, or it fails
/// \throws std::bad_alloc if memory of the device does not suffice
/// \throws Interrupted if the callback cancels
inline Samples_of_tile<float> resample_tile_on_device(const Buffer<Vector>& points,
                                                      const std::vector<Point_in_cloud>& known,
                                                      const Facts_of_cloud& facts,
                                                      const Parameters& parameters,
                                                      const std::function<bool(double)>& callback,
                                                      Report& report)
{
  report.device = "cuda";
  report.device_reason = "asked for";
  const Device_session session = new_device_session();
  const cuda::Tile_of_cloud tile = {known.data(), number_of_starts(known),
                                    facts_for_device(facts, known)};
  Device_progress progress(callback);
  cuda::Call_report call;
  const cuda::Answer answer = cuda::resample_tile(*session, coordinates(points), points.size(),
                                                  tile, parameters, progress.as_callback(), call);
  fill_report(call, report);
  progress.rethrow_exception_of_callback();
  throw_if_failed(answer);
  if (answer.status == cuda::Status::CANCELLED)
    throw Interrupted();
  const std::size_t m = tile.number_of_samples;
  Oriented_points<float> samples;
  samples.positions.resize(m);
  samples.normals.resize(m);
  Samples_of_tile<float> result = {std::move(samples), Buffer<unsigned char>(m, 0),
                                   Buffer<Index>(m, 0), Buffer<float>(m, 0.f)};
  throw_if_failed(cuda::download(*session, coordinates(result.points.positions),
                                 coordinates(result.points.normals)));
  throw_if_failed(cuda::download_tile(*session, result.confidences.data(), result.trees.data(),
                                      result.are_own.data()));
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_TILE_ON_DEVICE_H
