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

template <typename NamedParameters>
void call(const Point_cloud& cloud, const NamedParameters& np, std::vector<Oriented_point>& result)
{
  CGAL::l0_resample_point_set<Concurrency_tag>(
    boost::irange(std::size_t(0), cloud.points.size()), std::back_inserter(result), np);
}

template <typename NamedParameters>
void call_with_normals(const Point_cloud& cloud, const Options& options, const NamedParameters& np,
                       std::vector<Oriented_point>& result)
{
  if (options.use_normals)
    call(cloud, np.normal_map(CGAL::make_property_map(cloud.normals.data())), result);
  else
    call(cloud, np, result);
}

template <typename NamedParameters>
void call_with_radius(const Point_cloud& cloud, const Options& options, const NamedParameters& np,
                      std::vector<Oriented_point>& result)
{
  if (options.neighbor_radius)
    call_with_normals(cloud, options, np.neighbor_radius(*options.neighbor_radius), result);
  else
    call_with_normals(cloud, options, np, result);
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
  using Block_cg = Block_conjugate_gradient_solver_traits<double, Concurrency_tag>;
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

} // namespace

void check_device(Device device)
{
  if (device == Device::CUDA)
    throw Failure(RUN_TIME_FAILURE, "--device cuda: this program was built without CUDA");
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
  try {
    call_with_solver(cloud, options,
                     parameters::resampling_method(options.method)
                       .normal_weight(options.normal_weight)
                       .sharpness_angle(options.sharpness_angle)
                       .random_seed(options.seed)
                       .number_of_output_points(number_of_output_points(options, cloud.points.size()))
                       .maximum_memory(options.max_memory)
                       .callback(callback)
                       .resampling_report(&report)
                       .point_map(CGAL::make_property_map(cloud.points.data())),
                     result);
  } catch (const std::bad_alloc&) {
    throw Failure(RUN_TIME_FAILURE, options.input + ": not enough memory to resample "
                                      + std::to_string(cloud.points.size()) + " points"
                                      + (options.max_memory < Options().max_memory ? " within --max-memory" : ""));
  } catch (const std::invalid_argument& error) {
    throw Failure(INPUT_REFUSED, options.input + ": " + error.what());
  }
  if (options.device == Device::AUTO)
    report.device_reason = "built without CUDA";
  return result;
}

} // namespace l0_tool
