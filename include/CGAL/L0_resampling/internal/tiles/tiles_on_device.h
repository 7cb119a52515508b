// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TILES_ON_DEVICE_H
#define CGAL_L0_RESAMPLING_INTERNAL_TILES_ON_DEVICE_H

#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/internal/cloud/estimate_scale_field.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/device/Device_progress.h>
#include <CGAL/L0_resampling/internal/device/Device_session.h>
#include <CGAL/L0_resampling/internal/device/cuda_tiles.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

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

/// After a call on the device.
/// \throws what the callback has thrown, Interrupted if it has cancelled the call, and what
/// `throw_if_failed()` does
inline void take_report(const cuda::Answer& answer, const cuda::Call_report& call,
                        Device_progress& progress, Report& report)
{
  fill_report(call, report);
  progress.rethrow_exception_of_callback();
  throw_if_failed(answer);
  if (answer.status == cuda::Status::CANCELLED)
    throw Interrupted();
}

/// How many samples start on points of a tile and its halo, or near them.
inline std::size_t number_of_starts(const Buffer<Point_in_cloud>& points)
{
  std::size_t number = 0;
  for (const Point_in_cloud& point : points)
    number += point.number_of_samples;
  return number;
}

inline Range_of_scales range_of_scales(const Buffer<Point_in_cloud>& points)
{
  Buffer<float> scales;
  scales.reserve(points.size());
  for (const Point_in_cloud& point : points)
    scales.push_back(point.scale);
  return range_of(scales);
}

inline cuda::Facts_of_tiles facts_for_device(const Facts_of_cloud& facts,
                                             const Buffer<Point_in_cloud>& points)
{
  cuda::Facts_of_tiles result = {};
  result.exponent_of_frame = facts.frame->exponent;
  std::copy_n(facts.frame->origin.data(), 3, result.origin_of_frame);
  result.extents = *facts.extents;
  result.extents.scales = *facts.scales;
  result.area = *facts.area;
  result.number_of_points = facts.number_of_points.value_or(std::size_t(0)); // if it is needed
  result.number_of_places = *facts.number_of_places;
  result.mean_number_of_neighbors = facts.mean_number_of_neighbors.value_or(0.);
  result.range_of_scales = facts.range_of_scales ? *facts.range_of_scales : range_of_scales(points);
  return result;
}

/// As `facts_of_points()`, on the current CUDA device.
/// \param points all points of a cloud
/// \param callback of the user, or none
/// \throws Device_error if no device can be used, or it fails
/// \throws std::bad_alloc if memory of the device does not suffice
/// \throws Interrupted if the callback cancels
inline Facts_of_cloud facts_on_device(const Buffer<Vector>& points, const Parameters& parameters,
                                      const std::function<bool(double)>& callback, Report& report,
                                      Buffer<Point_in_cloud>& points_in_cloud)
{
  const Device_session session = new_device_session();
  Buffer<Point_in_cloud> found_points(points.size());
  Device_progress progress(callback);
  cuda::Call_report call;
  cuda::Facts_of_tiles found;
  const cuda::Answer answer = cuda::find_facts(*session, coordinates(points), points.size(),
                                               parameters, progress.as_callback(), call, found,
                                               found_points.data());
  take_report(answer, call, progress, report);
  points_in_cloud = std::move(found_points);
  Facts_of_cloud facts;
  facts.frame = Place_of_frame{found.exponent_of_frame, Vector(found.origin_of_frame)};
  facts.extents = found.extents;
  facts.scales = found.extents.scales;
  facts.range_of_scales = found.range_of_scales;
  facts.mean_number_of_neighbors = found.mean_number_of_neighbors;
  facts.area = found.area;
  facts.number_of_points = found.number_of_points;
  facts.number_of_places = found.number_of_places;
  return facts;
}

/// What a tile has found, if its sides are found later: each tree, which is a sample.
inline void take_unoriented(cuda::Session& session, std::size_t number_of_trees,
                            Samples_of_tile<float>& samples)
{
  Buffer<Vector> positions(number_of_trees, Vector::Zero());
  Buffer<Local_vector> normals(number_of_trees, Local_vector::Zero());
  samples.are_trees_own.resize(number_of_trees);
  throw_if_failed(cuda::download_unoriented(session, coordinates(positions), coordinates(normals),
                                            samples.are_trees_own.data()));
  samples.unoriented.reserve(number_of_trees);
  for (std::size_t i = 0; i < number_of_trees; ++i)
  {
    const Vector& p = positions[i];
    const Local_vector& n = normals[i];
    samples.unoriented.push_back({{p[0], p[1], p[2]}, {n[0], n[1], n[2]}, 0});
  }
}

/// As `resample_tile()`, on the current CUDA device.
/// \param points of a tile and its halo, in the unit of the input
/// \param callback of the user, or none
/// \throws Device_error if no device can be used, or it fails
/// \throws std::bad_alloc if memory of the device does not suffice
/// \throws Interrupted if the callback cancels
inline Samples_of_tile<float> resample_tile_on_device(const Buffer<Vector>& points,
                                                      const Buffer<Point_in_cloud>& known,
                                                      const Facts_of_cloud& facts, bool finds_sides,
                                                      const Parameters& parameters,
                                                      const std::function<bool(double)>& callback,
                                                      Report& report)
{
  report.device = "cuda";
  report.device_reason = "asked for";
  const Device_session session = new_device_session();
  const cuda::Tile_of_cloud tile = {known.data(), number_of_starts(known), finds_sides,
                                    facts_for_device(facts, known)};
  std::size_t number_of_unoriented = 0;
  Device_progress progress(callback);
  cuda::Call_report call;
  const cuda::Answer answer = cuda::resample_tile(*session, coordinates(points), points.size(),
                                                  tile, parameters, progress.as_callback(), call,
                                                  number_of_unoriented);
  take_report(answer, call, progress, report);
  const std::size_t m = tile.number_of_samples;
  Oriented_points<float> samples;
  samples.positions.resize(m);
  samples.normals.resize(m);
  Samples_of_tile<float> result = {std::move(samples),
                                   Buffer<unsigned char>(m, 0),
                                   Buffer<Index>(m, 0),
                                   Buffer<float>(m, 0.f),
                                   {},
                                   {}};
  throw_if_failed(cuda::download(*session, coordinates(result.points.positions),
                                 coordinates(result.points.normals)));
  throw_if_failed(cuda::download_tile(*session, result.confidences.data(), result.trees.data(),
                                      result.are_own.data()));
  if (!finds_sides)
    take_unoriented(*session, number_of_unoriented, result);
  return result;
}

/// As `orient_tiles()`, on the current CUDA device.
/// \param box of the points of the cloud, in the unit of the input
/// \param callback of the user, or none
/// \throws Device_error if no device can be used, or it fails
/// \throws std::bad_alloc if memory of the device does not suffice
/// \throws Interrupted if the callback cancels
inline void orient_tiles_on_device(const Facts_of_cloud& facts, const Plan& plan,
                                   const Source_box& box, const Parameters& parameters,
                                   const std::function<bool(double)>& callback, Report& report,
                                   Samples_to_orient& samples)
{
  const Device_session session = new_device_session();
  cuda::Place_of_cloud place = {};
  place.exponent_of_frame = facts.frame->exponent;
  std::copy_n(facts.frame->origin.data(), 3, place.origin_of_frame);
  std::copy_n(box.low.data(), 3, place.low);
  std::copy_n(box.high.data(), 3, place.high);
  Device_progress progress(callback);
  cuda::Call_report call;
  const cuda::Answer answer =
    cuda::orient_tiles(*session, coordinates(samples.places), samples.places.size(), place, plan,
                       parameters, progress.as_callback(), call, coordinates(samples.normals));
  take_report(answer, call, progress, report);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TILES_ON_DEVICE_H
