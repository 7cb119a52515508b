// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_ON_CPU_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_ON_CPU_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/driver/least_memory.h>
#include <CGAL/L0_resampling/internal/driver/resample.h>
#include <CGAL/L0_resampling/internal/interface/Point_data.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/named_parameters.h>
#ifndef CGAL_L0_LINKED_WITH_COMPILED
#include <CGAL/L0_resampling/internal/driver/resample_impl.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <new>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The caller's solver, which may come wrapped in a `std::reference_wrapper`, or else
/// `default_solver`.
template <typename NamedParameters, typename DefaultSolver>
decltype(auto) choose_solver(const NamedParameters& np, DefaultSolver& default_solver)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::sparse_linear_solver_t>::value)
    return (default_solver);
  else
    return parameters::get_parameter(np, internal_np::sparse_linear_solver); // a copy
}

template <typename Solver>
Solver& unwrapped(Solver& solver)
{
  return solver;
}
template <typename Solver>
Solver& unwrapped(std::reference_wrapper<Solver>& solver)
{
  return solver.get();
}

/// The whole function on the CPU, once the property maps are known. `NormalMap` may be `bool`, for
/// none, or an optional.
/// \tparam DefaultSolver of callers that name none
/// \param near_count how many near points of the input `write` wants to know of each point, if the
/// maps among the parameters want fewer
/// \param write called once if there is a result: with its size, a function that gives its i-th
/// pair, and the `Point_data` asked for
template <typename ConcurrencyTag, typename Kernel, typename DefaultSolver, typename PointRange,
          typename PointMap, typename NormalMap, typename Write, typename NamedParameters>
void resample_on_cpu(const PointRange& range, PointMap point_map, NormalMap normal_map,
                     std::size_t near_count, const Write& write, const NamedParameters& np)
{
  using FT = typename Kernel::FT;
  Report unwanted_report;
  Report& report = report_of_call(np, unwanted_report);
  report.device_reason = "compiled for the CPU";

  std::function<bool(double)> callback;
  read_parameter(np, internal_np::callback, callback);
  bool drop_non_finite = false;
  read_parameter(np, internal_np::drop_non_finite, drop_non_finite);

  DefaultSolver default_solver;
  decltype(auto) chosen_solver = choose_solver(np, default_solver);
  using Solver = std::decay_t<decltype(unwrapped(chosen_solver))>;

  // Checked before any point is looked at, and read again below: a percentage is one of the points
  // that are used.
  const std::size_t size = std::size_t(std::distance(range.begin(), range.end()));
  const Parameters checked_for_all = checked_parameters(np, size);
  const std::size_t maximum_memory = checked_for_all.maximum_memory;
  if (!drop_non_finite && least_memory<typename Solver::FT>(size, checked_for_all) > maximum_memory)
    throw std::bad_alloc();
  Memory_counter memory(maximum_memory);
  Input input(&memory);
  Progress progress(callback, report, memory);
  Buffer<std::array<FT, 3>> positions(&memory);
  Buffer<Eigen::Matrix<typename Solver::FT, 3, 1>> normals(&memory);
  Point_data data{{number_of_near_points(np, near_count), Buffer<Index>(&memory),
                   Buffer<float>(&memory)},
                  Buffer<float>(&memory),
                  Buffer<float>(&memory),
                  Buffer<float>(&memory),
                  Buffer<float>(&memory)};
  try
  {
    read_points<ConcurrencyTag>(range, point_map, drop_non_finite, report, input);
    const Parameters checked = checked_parameters(np, input.points.size());
    if (checked.number_of_output_points == 0)
      return;
    if (least_memory<typename Solver::FT>(input.points.size(), checked) > maximum_memory)
      throw std::bad_alloc();
    read_normals_if_given<ConcurrencyTag>(range, normal_map, input);
    read_hints_if_given<ConcurrencyTag>(range, point_map, np, input);
    release(input.is_kept);

    std::size_t n = input.points.size();
    const std::size_t m = checked.number_of_output_points;
    Any_solver<typename Solver::FT> solver(unwrapped(chosen_solver));
    Facts_of_cloud facts; // the points are the whole cloud
    Oriented_points<typename Solver::FT> result = resample<ConcurrencyTag>(
      input.points, input.normals, input.hints, checked, solver, progress, report, facts);
    n -= report.number_of_outliers;
    if (report.number_of_distinct_points < (std::min)(n, m))
      report.number_of_distinct_points = number_of_distinct_points(range, point_map, memory);
    positions =
      rounded_positions<ConcurrencyTag, FT>(result.positions, input, report.neighbor_radius,
                                            report.number_of_distinct_points >= (std::min)(n, m));
    normals = std::move(result.normals);
    data.feature_confidences = std::move(result.feature_confidences);
    data.side_confidences = std::move(result.side_confidences);
    if (checked.with_neighbor_radii)
      data.neighbor_radii = neighbor_radii(std::move(result.scales), result.positions.size(),
                                           report.neighbor_radius);
    data.noises = lengths_of_input(std::move(result.noises), report.neighbor_radius);
    release(result.positions);
    if (data.near_points.count > 0)
    {
      progress.begin_stage("near points", 0.05, positions.size());
      nearest_input_points<ConcurrencyTag>(tree_of_range(range, point_map, memory), positions,
                                           progress, data.near_points);
      progress.end_stage();
    }
  }
  catch (const Interrupted&)
  {
    progress.rethrow_exception_of_callback();
    report.outcome = Outcome::CANCELLED;
    return;
  }

  report.number_of_output_points = positions.size();
  const auto pair_of = [&](std::size_t i) {
    const Vector normal = normals[i].template cast<double>().normalized();
    return std::make_pair(typename Kernel::Point_3(positions[i][0], positions[i][1],
                                                   positions[i][2]),
                          typename Kernel::Vector_3(FT(normal[0]), FT(normal[1]), FT(normal[2])));
  };
  write(positions.size(), pair_of, data);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_ON_CPU_H
