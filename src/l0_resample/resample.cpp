// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "resample.h"

#include "Failure.h"

#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>
#include <CGAL/l0_resample_point_set.h>
#include <CGAL/property_map.h>

#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/CUDA_resampler.h>
#endif

#include <boost/range/irange.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>

namespace l0_tool {
namespace {

namespace parameters = CGAL::parameters;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

// The names of a chain are known to the compiler, so what the user leaves open needs a chain of its own: a step each.

template <typename Tag, typename NamedParameters>
void call(const Point_cloud& cloud, const NamedParameters& np, std::vector<Oriented_point>& result)
{
  CGAL::l0_resample_point_set<Tag>(boost::irange(std::size_t(0), cloud.points.size()), std::back_inserter(result), np);
}

template <typename Tag, typename NamedParameters>
void call_with_normals(const Point_cloud& cloud, const Options& options, const NamedParameters& np,
                       std::vector<Oriented_point>& result)
{
  if (options.use_normals)
    call<Tag>(cloud, np.normal_map(CGAL::make_property_map(cloud.normals.data())), result);
  else
    call<Tag>(cloud, np, result);
}

template <typename Tag = Concurrency_tag, typename NamedParameters>
void call_with_radius(const Point_cloud& cloud, const Options& options, const NamedParameters& np,
                      std::vector<Oriented_point>& result)
{
  if (options.neighbor_radius)
    call_with_normals<Tag>(cloud, options, np.neighbor_radius(*options.neighbor_radius), result);
  else
    call_with_normals<Tag>(cloud, options, np, result);
}

template <typename Solver_traits>
Solver_traits iterative_solver(const Options& options)
{
  constexpr double tolerance = 1e-5;    // as by default
  return options.solver_iterations ? Solver_traits(tolerance, std::size_t(*options.solver_iterations))
                                   : Solver_traits();
}

template <typename NamedParameters>
void call_with_solver(const Point_cloud& cloud, const Options& options, const NamedParameters& np,
                      std::vector<Oriented_point>& result)
{
  using namespace CGAL::L0_resampling;
  using Block_cg = Block_conjugate_gradient_solver_traits<float, Concurrency_tag>;   // the function's own default
  using Rows_cg = Eigen_least_squares_solver_traits<double>;
  switch (options.solver) {
  case Solver::BLOCK_CG:
    return call_with_radius(cloud, options, np.sparse_linear_solver(iterative_solver<Block_cg>(options)), result);
  case Solver::CHOLESKY:
    return call_with_radius(cloud, options, np.sparse_linear_solver(Eigen_cholesky_solver_traits<double>()), result);
  case Solver::ROWS_CG:
    return call_with_radius(cloud, options, np.sparse_linear_solver(iterative_solver<Rows_cg>(options)), result);
  }
}

/// Whether a CUDA device can do what the options ask for.
/// \param reason out: why not
bool is_device_usable(const Options& options, std::string& reason)
{
#ifdef CGAL_L0_LINKED_WITH_CUDA
  if (options.solver != Solver::BLOCK_CG || options.solver_iterations)
    reason = "the device has a solver of its own, and --solver or --solver-iterations asks for another";
  else
    return CGAL::L0_resampling::is_cuda_device_usable(&reason);
#else
  static_cast<void>(options);
  reason = "this program was built without CUDA";
#endif
  return false;
}

#ifdef CGAL_L0_LINKED_WITH_CUDA
/// Runs on the device.
/// \returns whether it did; if not, and the options leave the choice to the program, `reason` says why
template <typename NamedParameters>
bool call_on_device(const Point_cloud& cloud, const Options& options, const NamedParameters& np, std::vector<Oriented_point>& result,
                    std::string& reason)
{
  if (options.device == Device::CPU || (options.device == Device::AUTO && !is_device_usable(options, reason)))
    return false;
  try {
    call_with_radius<CGAL::CUDA_tag>(cloud, options, np, result);
    return true;
  } catch (const CGAL::L0_resampling::Device_error& error) {
    reason = error.what();
  } catch (const std::bad_alloc&) {
    reason = "the device has too little memory";
  }
  if (options.device == Device::CUDA)
    throw Failure(RUN_TIME_FAILURE, "--device cuda: " + reason);
  return false;
}
#endif

} // namespace

void check_device(const Options& options)
{
  std::string reason;
  if (options.device == Device::CUDA && !is_device_usable(options, reason))
    throw Failure(RUN_TIME_FAILURE, "--device cuda: " + reason);
}

std::size_t number_of_output_points(const Options& options, std::size_t number_of_input_points)
{
  if (options.number_of_points)
    return std::size_t(*options.number_of_points);
  return (std::max)(std::size_t(1), std::size_t(double(number_of_input_points) * options.percentage / 100));
}

std::vector<Oriented_point> resample(const Point_cloud& cloud, const Options& options,
                                     const std::function<bool(double)>& callback, CGAL::L0_resampling::Report& report)
{
  std::optional<tbb::global_control> limit;
  if (options.threads)
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(*options.threads));
  if (options.use_normals && cloud.normals.empty() && !cloud.points.empty())
    throw Failure(INPUT_REFUSED, options.input + ": --use-normals is given, but the file has no normals");

  std::vector<Oriented_point> result;
  std::string reason = "asked for";
  try {
    const auto np = parameters::resampling_method(options.method)
                      .normal_weight(options.normal_weight)
                      .sharpness_angle(options.sharpness_angle)
                      .random_seed(options.seed)
                      .drop_outliers(options.method == CGAL::L0_resampling::Method::DEFAULT && !options.keep_outliers)
                      .number_of_output_points(number_of_output_points(options, cloud.points.size()))
                      .maximum_memory(options.max_memory)
                      .callback(callback)
                      .resampling_report(&report)
                      .point_map(CGAL::make_property_map(cloud.points.data()));
#ifdef CGAL_L0_LINKED_WITH_CUDA
    const bool is_done = call_on_device(cloud, options, np, result, reason);
#else
    const bool is_done = false;
    if (options.device == Device::AUTO)
      is_device_usable(options, reason);
#endif
    if (!is_done)
      call_with_solver(cloud, options, np, result);
    if (is_done && options.device == Device::AUTO)
      reason = "a device can be used";
    report.device_reason = reason;
  } catch (const std::bad_alloc&) {
    throw Failure(RUN_TIME_FAILURE, options.input + ": not enough memory to resample "
                                      + std::to_string(cloud.points.size()) + " points"
                                      + (options.max_memory < Options().max_memory ? " within --max-memory" : ""));
  } catch (const std::invalid_argument& error) {
    throw Failure(INPUT_REFUSED, options.input + ": " + error.what());
  }
  return result;
}

} // namespace l0_tool
