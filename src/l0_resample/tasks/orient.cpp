// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/tasks.h"

#include "basis/Failure.h"

#include <CGAL/l0_orient_normals.h>
#include <CGAL/property_map.h>

#include <boost/range/irange.hpp>
#include <tbb/global_control.h>

#include <cstddef>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace l0_tool {

namespace {

template <typename ConcurrencyTag>
void call(const Sides& sides, const Options& options, const std::function<bool(double)>& callback,
          Point_cloud& cloud, CGAL::L0_resampling::Report& report)
{
  const auto normal_map = CGAL::make_property_map(cloud.normals);
  const auto viewpoint_map = CGAL::make_property_map(sides.viewpoints.data());
  auto range = boost::irange(std::size_t(0), cloud.points.size());
  CGAL::l0_orient_normals<ConcurrencyTag>(
    range,
    CGAL::parameters::maximum_memory(options.max_memory)
      .resampling_report(&report)
      .neighbor_radius(options.neighbor_radius)
      .viewpoint(sides.viewpoint)
      .viewpoint_map(sides.viewpoints.empty() ? std::nullopt : std::make_optional(viewpoint_map))
      .up_direction(options.up_direction)
      .orientation_hint_map(options.orient_by_normals ? std::make_optional(normal_map)
                                                      : std::nullopt)
      .callback(callback)
      .point_map(CGAL::make_property_map(cloud.points))
      .normal_map(normal_map));
}

} // namespace

void orient(const Sides& sides, const Options& options, const std::function<bool(double)>& callback,
            Point_cloud& cloud, CGAL::L0_resampling::Report& report)
{
  std::optional<tbb::global_control> limit;
  if (options.threads)
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(*options.threads));
  const std::string name = options.input_name();
  if (options.orient_by_normals && cloud.normals.empty() && !cloud.points.empty())
    throw Failure(INPUT_REFUSED,
                  name + ": --orient-by-normals is given, but the file has no normals");
  try {
    cloud.normals.resize(cloud.points.size(), CGAL::NULL_VECTOR);
    const auto on_device = [&]() {
#ifdef CGAL_L0_LINKED_WITH_CUDA
      call<CGAL::CUDA_tag>(sides, options, callback, cloud, report);
#endif
    };
    const auto on_cpu = [&]() {
      call<CGAL::Parallel_if_available_tag>(sides, options, callback, cloud, report);
    };
    report.device_reason = l0_common::run_on_chosen({options.device, "--device cuda", ""},
                                                    on_device, on_cpu);
  } catch (...) {
    rethrow_as_failure("orient", name, cloud.points.size(), options);
  }
}

} // namespace l0_tool
