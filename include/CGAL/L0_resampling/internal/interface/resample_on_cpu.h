// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_ON_CPU_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_ON_CPU_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/creases/find_creases.h>
#include <CGAL/L0_resampling/internal/driver/minimum_memory.h>
#include <CGAL/L0_resampling/internal/driver/resample.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/interface/Point_data.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/internal/interface/rounded_positions.h>
#include <CGAL/L0_resampling/named_parameters.h>
#ifndef CGAL_L0_LINKED_WITH_COMPILED
#include <CGAL/L0_resampling/internal/creases/find_creases_impl.h>
#include <CGAL/L0_resampling/internal/driver/resample_impl.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
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

/// A call without the types of its range and maps.
struct Call_of_any_types
{
  const Given_parameters& parameters;
  Report* report;         ///< null if the caller wants none
  std::size_t near_count; ///< as of `resample_range_on_cpu()`
  std::size_t size_of_range;
  Function_view<Report&, Input&> read_points; ///< as `read_points()`
  Function_view<Input&> read_values;          ///< normals, hints and noises that are given
  Each_point for_each_point;
};

/// \tparam FT of the caller's kernel
/// \tparam SolverFT the number type of the solver
template <typename FT, typename SolverFT>
struct Result_of_call
{
  Buffer<std::array<FT, 3>> positions;
  Buffer<Eigen::Matrix<SolverFT, 3, 1>> normals;
  Point_data data;
};

template <typename FT, typename SolverFT>
using Result_function = Function_view<const Result_of_call<FT, SolverFT>&>;

/// A function that gives the i-th pair of a result, of the same type for all calls of a kernel.
template <typename Kernel, typename FT, typename SolverFT>
auto pairs_of(const Result_of_call<FT, SolverFT>& result)
{
  return [&result](std::size_t i) {
    const std::array<FT, 3>& position = result.positions[i];
    const auto& n = result.normals[i];
    // a sum that is written out is the same for all instruction sets
    const Triple normal = {double(n[0]), double(n[1]), double(n[2])};
    const double length = std::sqrt(dot(normal, normal));
    return std::make_pair(typename Kernel::Point_3(position[0], position[1], position[2]),
                          typename Kernel::Vector_3(FT(normal.x / length), FT(normal.y / length),
                                                    FT(normal.z / length)));
  };
}

/// What of a call does not depend on the types of its range and maps.
/// \param write called once if there is a result
template <typename ConcurrencyTag, typename FT, typename SolverFT>
void resample_on_cpu(const Call_of_any_types& call, Any_solver<SolverFT>& solver,
                     const Result_function<FT, SolverFT>& write)
{
  const Given_parameters& given = call.parameters;
  Report unwanted_report;
  Report& report = call.report ? *call.report : unwanted_report;
  report.device_reason = "compiled for the CPU";
  const bool drop_non_finite = given.drop_non_finite.value_or(false);

  // Checked before any point is looked at, and again below: a percentage is one of the points that
  // are used.
  const Parameters checked_for_all = checked_parameters(given, call.size_of_range);
  const std::size_t maximum_memory = checked_for_all.maximum_memory;
  if (!drop_non_finite
      && minimum_memory<SolverFT>(call.size_of_range, checked_for_all) > maximum_memory)
    throw std::bad_alloc();
  Memory_counter memory(maximum_memory);
  Input input(&memory);
  Progress progress(given.callback, report, memory);
  Result_of_call<FT, SolverFT> result{Buffer<std::array<FT, 3>>(&memory),
                                      Buffer<Eigen::Matrix<SolverFT, 3, 1>>(&memory),
                                      Point_data{{number_of_near_points(given, call.near_count),
                                                  Buffer<Index>(&memory), Buffer<float>(&memory)},
                                                 Buffer<float>(&memory),
                                                 Buffer<float>(&memory),
                                                 Buffer<float>(&memory),
                                                 Buffer<float>(&memory),
                                                 Buffer<float>(&memory),
                                                 Buffer<float>(&memory),
                                                 Placed_creases(),
                                                 Buffer<Index>(&memory)}};
  Point_data& data = result.data;
  try
  {
    call.read_points(report, input);
    Parameters checked = checked_parameters(given, input.points.size());
    if (checked.number_of_output_points == 0)
      return;
    if (minimum_memory<SolverFT>(input.points.size(), checked) > maximum_memory)
      throw std::bad_alloc();
    call.read_values(input);
    if (input.noise > 0)
      checked.noise = input.noise;
    if (!checked.with_outliers)
      release(input.is_kept);

    std::size_t n = input.points.size();
    const std::size_t m = checked.number_of_output_points;
    Facts_of_cloud facts; // the points are the whole cloud
    Oriented_points<SolverFT> samples =
      resample<ConcurrencyTag>(input.points, input.normals, input.hints, checked, solver, progress,
                               report, facts, std::move(input.noise_ratios));
    n -= report.number_of_outliers;
    if (report.number_of_distinct_points < (std::min)(n, m))
      report.number_of_distinct_points = number_of_distinct_points(call.size_of_range,
                                                                   call.for_each_point, memory);
    if (checked.with_creases)
    {
      progress.begin_stage("creases", 0.05, 2 * samples.positions.size());
      data.creases = find_creases<ConcurrencyTag>(spacing_of_creases(report.sample_spacing,
                                                                     report.estimated_spacing),
                                                  progress, samples.positions, samples.normals);
      progress.end_stage();
    }
    result.positions =
      rounded_positions<ConcurrencyTag, FT>(samples.positions, input, report.neighbor_radius,
                                            report.number_of_distinct_points >= (std::min)(n, m));
    result.normals = std::move(samples.normals);
    data.feature_confidences = std::move(samples.feature_confidences);
    data.side_confidences = std::move(samples.side_confidences);
    if (checked.with_neighbor_radii)
      data.neighbor_radii = neighbor_radii(std::move(samples.scales), samples.positions.size(),
                                           report.neighbor_radius);
    data.noises = lengths_of_input(std::move(samples.noises), report.neighbor_radius);
    data.position_deviations = lengths_of_input(std::move(samples.position_deviations),
                                                report.neighbor_radius);
    data.normal_deviations = std::move(samples.normal_deviations);
    data.outliers = places_in_range(std::move(samples.outliers), input);
    release(samples.positions);
    if (data.near_points.count > 0)
    {
      progress.begin_stage("near points", 0.05, result.positions.size());
      const Point_tree_3 tree = tree_of_range<ConcurrencyTag>(call.size_of_range,
                                                              call.for_each_point, memory);
      nearest_input_points<ConcurrencyTag>(tree, result.positions, progress, data.near_points);
      progress.end_stage();
    }
  }
  catch (const Interrupted&)
  {
    progress.rethrow_exception_of_callback();
    report.outcome = Outcome::CANCELLED;
    return;
  }

  report.number_of_output_points = result.positions.size();
  write(result);
}

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template void resample_on_cpu<Sequential_tag, float, float>(
  const Call_of_any_types&, Any_solver<float>&, const Result_function<float, float>&);
extern template void resample_on_cpu<Sequential_tag, float, double>(
  const Call_of_any_types&, Any_solver<double>&, const Result_function<float, double>&);
extern template void resample_on_cpu<Sequential_tag, double, float>(
  const Call_of_any_types&, Any_solver<float>&, const Result_function<double, float>&);
extern template void resample_on_cpu<Sequential_tag, double, double>(
  const Call_of_any_types&, Any_solver<double>&, const Result_function<double, double>&);
#ifdef CGAL_LINKED_WITH_TBB
extern template void resample_on_cpu<Parallel_tag, float, float>(
  const Call_of_any_types&, Any_solver<float>&, const Result_function<float, float>&);
extern template void resample_on_cpu<Parallel_tag, float, double>(
  const Call_of_any_types&, Any_solver<double>&, const Result_function<float, double>&);
extern template void resample_on_cpu<Parallel_tag, double, float>(
  const Call_of_any_types&, Any_solver<float>&, const Result_function<double, float>&);
extern template void resample_on_cpu<Parallel_tag, double, double>(
  const Call_of_any_types&, Any_solver<double>&, const Result_function<double, double>&);
#endif
#endif

/// The whole function on the CPU, once the property maps are known. `NormalMap` may be `bool`, for
/// none, or an optional.
/// \tparam DefaultSolver of callers that name none
/// \param near_count how many near points of the input `write` wants to know of each point, if the
/// maps among the parameters want fewer
/// \param write called once if there is a result: with its size, a function that gives its i-th
/// pair, and the `Point_data` asked for
template <typename ConcurrencyTag, typename Kernel, typename DefaultSolver, typename PointRange,
          typename PointMap, typename NormalMap, typename Write, typename NamedParameters>
void resample_range_on_cpu(const PointRange& range, PointMap point_map, NormalMap normal_map,
                           std::size_t near_count, const Write& write, const NamedParameters& np)
{
  Report* const report = report_of_call(np);
  const Given_parameters given(np);
  DefaultSolver default_solver;
  decltype(auto) chosen_solver = choose_solver(np, default_solver);
  using Solver = std::decay_t<decltype(unwrapped(chosen_solver))>;
  using FT = typename Kernel::FT;
  using SolverFT = typename Solver::FT;
  Any_solver<SolverFT> solver(unwrapped(chosen_solver));

  const auto read_positions = [&](Report& r, Input& input) {
    read_points<ConcurrencyTag>(range, point_map, given.drop_non_finite.value_or(false), r, input);
  };
  const auto read_values = [&](Input& input) {
    read_normals_if_given<ConcurrencyTag>(range, normal_map, input);
    read_hints_if_given<ConcurrencyTag>(range, point_map, np, input);
    read_noises_if_given<ConcurrencyTag>(range, np, input);
  };
  const auto for_each = [&](const Point_function& f) { for_each_point(range, point_map, f); };
  const auto write_pairs = [&](const Result_of_call<FT, SolverFT>& result) {
    write(result.positions.size(), pairs_of<Kernel>(result), result.data);
  };
  const std::size_t size = std::size_t(std::distance(range.begin(), range.end()));
  resample_on_cpu<ConcurrencyTag>(Call_of_any_types{given, report, near_count, size,
                                                    Function_view<Report&, Input&>(read_positions),
                                                    Function_view<Input&>(read_values),
                                                    Each_point(for_each)},
                                  solver, Result_function<FT, SolverFT>(write_pairs));
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_ON_CPU_H
