// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/resample.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "basis/signals.h"
#include "tasks/carry_properties.h"
#include "tasks/parameters_of.h"

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>
#include <CGAL/L0_resampling/find_near_points.h>
#include <CGAL/l0_estimate_scales.h>
#include <CGAL/l0_resample_point_set.h>
#include <CGAL/property_map.h>

#include <boost/range/irange.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

using CGAL::L0_resampling::Near_points;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

/// What --noise-property says of each point, if it is given.
class Known_noises
{
  bool m_are_given;
  std::vector<double> m_values;

public:
  Known_noises(const Point_cloud& cloud, const Options& options)
    : m_are_given(!options.noise_property.empty())
  {
    if (!m_are_given)
      return;
    const Property* const property = cloud.properties.find(options.noise_property);
    if (!property)
      throw Failure(INPUT_REFUSED, options.input_name()
                                     + ": --noise-property is given, but the points have no "
                                       "property "
                                     + printable(options.noise_property));
    m_values.reserve(cloud.points.size());
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      m_values.push_back(cloud.properties.value(i, *property));
  }

  /// For the named parameter `point_noise_map`.
  auto map() const
  {
    const auto values = CGAL::make_property_map(m_values.data());
    return m_are_given ? std::make_optional(values) : std::nullopt;
  }
};

template <typename Tag, typename NamedParameters>
void call(const Point_cloud& cloud, const Sides& sides, const Options& options,
          const NamedParameters& np, Resampled_points& result)
{
  using Normal_map = decltype(CGAL::make_property_map(cloud.normals.data()));
  const Normal_map normals = CGAL::make_property_map(cloud.normals.data());
  const auto if_asked_for = [&](bool is) {
    return is ? std::make_optional(normals) : std::nullopt;
  };
  // where they are asked for
  std::vector<Result_column> columns;
  const auto add_column = [&](bool is_wanted, const char* name,
                              bool is_known = true) -> std::optional<std::size_t> {
    if (!is_wanted && (options.page.empty() || !is_known))
      return std::nullopt;
    columns.push_back(
      {name, std::vector<float>(number_of_output_points(options, cloud.points.size()))});
    columns.back().is_written = is_wanted;
    return columns.size() - 1;
  };
  const bool is_default = options.method == CGAL::L0_resampling::Method::DEFAULT;
  const auto features = add_column(options.with_feature_confidences, "feature_confidence"),
             side_confidences = add_column(options.with_side_confidences, "side_confidence"),
             radii = add_column(options.with_neighbor_radii, "neighbor_radius"),
             noises = add_column(options.with_noises, "noise", is_default),
             position_deviations = add_column(options.with_deviations, "position_deviation",
                                              is_default),
             normal_deviations = add_column(options.with_deviations, "normal_deviation",
                                            is_default);
  const auto map_of = [&](const std::optional<std::size_t>& column) {
    return column ? std::make_optional(CGAL::make_property_map(columns[*column].values.data()))
                  : std::nullopt;
  };
  const bool with_outliers = !options.outliers.empty() || !options.page.empty();
  const auto viewpoint_map = CGAL::make_property_map(sides.viewpoints.data());
  const Known_noises known_noises(cloud, options);
  const auto whole_np =
    np.point_map(CGAL::make_property_map(cloud.points.data()))
      .normal_map(if_asked_for(options.use_normals))
      .orientation_hint_map(if_asked_for(options.orient_by_normals))
      .viewpoint_map(sides.viewpoints.empty() ? std::nullopt : std::make_optional(viewpoint_map))
      .point_noise_map(known_noises.map())
      .feature_confidence_map(map_of(features))
      .side_confidence_map(map_of(side_confidences))
      .neighbor_radius_map(map_of(radii))
      .noise_map(map_of(noises))
      .position_deviation_map(map_of(position_deviations))
      .normal_deviation_map(map_of(normal_deviations))
      .crease_output_iterator(options.creases.empty()
                                ? std::nullopt
                                : std::make_optional(std::back_inserter(result.creases)))
      .corner_output_iterator(options.creases.empty()
                                ? std::nullopt
                                : std::make_optional(std::back_inserter(result.corners)))
      .outlier_output_iterator(
        with_outliers ? std::make_optional(std::back_inserter(result.outliers)) : std::nullopt);
  const auto range = boost::irange(std::size_t(0), cloud.points.size());
  CGAL::l0_resample_point_set<Tag>(range, std::back_inserter(result.points), whole_np);
  const std::size_t size = result.points.size();
  if (!options.creases.empty())
    columns.push_back({name_of_crease_marks, marks_of_creases(result), Number_type::UINT8});

  const bool has_properties = !cloud.properties.properties().empty();
  Near_points near;
  if (size > 0 && (has_properties || options.with_source_indices))
    near = CGAL::L0_resampling::find_near_points<Concurrency_tag>(
      range, result.points,
      has_properties ? CGAL::L0_resampling::number_of_averaged_points : std::size_t(1),
      whole_np.query_point_map(CGAL::First_of_pair_property_map<Oriented_point>()));
  throw_if_interrupted();
  std::vector<std::uint32_t> sources(
    options.with_source_indices ? number_of_output_points(options, cloud.points.size()) : 0);
  if (options.with_source_indices)
    for (std::size_t i = 0; i < size; ++i)
      sources[i] = near.nearest(i);
  if (options.with_feature_confidences)
    result.feature_confidences = columns[*features].values;
  result.properties = carried_properties(cloud.properties, near, sources, columns, size);
  if (!options.page.empty())
    result.columns = std::move(columns);
}

/// \param tolerance the default of the solver
template <typename Solver_traits>
Solver_traits iterative_solver(const Method_options& options, double tolerance = 1e-5)
{
  return options.solver_iterations
           ? Solver_traits(tolerance, std::size_t(*options.solver_iterations))
           : Solver_traits();
}

template <typename NamedParameters>
void call_with_solver(const Point_cloud& cloud, const Sides& sides, const Options& options,
                      const NamedParameters& np, Resampled_points& result)
{
  using namespace CGAL::L0_resampling;
  using Block_chebyshev =
    Block_chebyshev_solver_traits<float, Concurrency_tag>; // the function's own default
  using Block_cg = Block_conjugate_gradient_solver_traits<float, Concurrency_tag>;
  using Rows_cg = Eigen_least_squares_solver_traits<double>;
  switch (options.solver) {
  case Solver::BLOCK_CHEBYSHEV:
    return call<Concurrency_tag>(cloud, sides, options,
                                 np.sparse_linear_solver(iterative_solver<Block_chebyshev>(
                                   options, Block_chebyshev::default_tolerance)),
                                 result);
  case Solver::BLOCK_CG:
    return call<Concurrency_tag>(
      cloud, sides, options, np.sparse_linear_solver(iterative_solver<Block_cg>(options)), result);
  case Solver::CHOLESKY:
    return call<Concurrency_tag>(cloud, sides, options,
                                 np.sparse_linear_solver(Eigen_cholesky_solver_traits<double>()),
                                 result);
  case Solver::ROWS_CG:
    return call<Concurrency_tag>(
      cloud, sides, options, np.sparse_linear_solver(iterative_solver<Rows_cg>(options)), result);
  }
}

/// Holds the number of threads that the options ask for.
class Limit_of_threads
{
  std::optional<tbb::global_control> m_control;

public:
  explicit Limit_of_threads(const Machine_options& options)
  {
    if (options.threads)
      m_control.emplace(tbb::global_control::max_allowed_parallelism,
                        std::size_t(*options.threads));
  }
};

void check_normals(const Point_cloud& cloud, const Options& options)
{
  const char* wanted_by = options.use_normals         ? "--use-normals"
                          : options.orient_by_normals ? "--orient-by-normals"
                                                      : nullptr;
  if (wanted_by && cloud.normals.empty() && !cloud.points.empty())
    throw Failure(INPUT_REFUSED, options.input_name() + ": " + wanted_by
                                   + " is given, but the file has no normals");
}

l0_common::Device_request device_request(const Options& options)
{
  l0_common::Device_request request = {options.device, "--device cuda", ""};
  if (options.solver != Solver::BLOCK_CHEBYSHEV || options.solver_iterations)
    request.obstacle = "the device has a solver of its own, and --solver or --solver-iterations "
                       "asks for another";
  else if (!options.noise_property.empty())
    request.obstacle = "the device takes one noise for all points, and --noise-property gives each "
                       "its own";
  return request;
}

} // namespace

std::vector<float> marks_of_creases(const Resampled_points& result)
{
  std::vector<float> marks(result.points.size(), 0);
  for (const Crease& crease : result.creases)
    for (const std::size_t point : crease.points)
      marks[point] = 1;
  for (const Crease_corner& corner : result.corners)
    marks[corner.point] = 2;
  return marks;
}

void rethrow_as_failure(const std::string& task, const std::string& name,
                        std::size_t number_of_points, const Options& options)
{
  try {
    throw;
  } catch (const CGAL::L0_resampling::Device_error& error) {
    throw Failure(RUN_TIME_FAILURE, error.what());
  } catch (const std::bad_alloc&) {
    if (options.device == Device::CUDA)
      throw Failure(RUN_TIME_FAILURE, "--device cuda: the device has too little memory");
    throw Failure(RUN_TIME_FAILURE,
                  name + ": not enough memory to " + task + " " + std::to_string(number_of_points)
                    + " points"
                    + (options.max_memory < Options().max_memory ? " within --max-memory" : ""));
  } catch (const std::invalid_argument& error) {
    throw Failure(INPUT_REFUSED, name + ": " + error.what());
  }
}

void check_device(const Options& options)
{
  if (options.device != Device::CUDA)
    return;
  try {
    std::string reason;
    l0_common::can_use_device(device_request(options), reason);
  } catch (const CGAL::L0_resampling::Device_error& error) {
    throw Failure(RUN_TIME_FAILURE, error.what());
  }
}

std::size_t number_of_output_points(const Options& options, std::size_t number_of_input_points)
{
  if (options.number_of_points)
    return std::size_t(*options.number_of_points);
  const double number = double(number_of_input_points) * options.percentage / 100;
  if (number > double(max_number_of_output_points))
    throw Failure(INPUT_REFUSED, options.input_name() + ": --percentage asks for more than "
                                   + std::to_string(max_number_of_output_points) + " points");
  return (std::max)(std::size_t(1), std::size_t(number));
}

CGAL::L0_resampling::Report estimate_scales(const Point_cloud& cloud, const Options& options)
{
  const Limit_of_threads limit(options);
  check_normals(cloud, options);
  CGAL::L0_resampling::Report report;
  if (cloud.points.empty())
    return report;
  try {
    const Known_noises noises(cloud, options);
    const auto range = boost::irange(std::size_t(0), cloud.points.size());
    const auto np = parameters_of(options, number_of_output_points(options, cloud.points.size()),
                                  options.viewpoint)
                      .point_map(CGAL::make_property_map(cloud.points.data()))
                      .point_noise_map(noises.map())
                      .callback([](double) { return !is_interrupted(); });
    const bool is_in_double = options.solver == Solver::CHOLESKY
                              || options.solver == Solver::ROWS_CG;
    report = is_in_double ? CGAL::l0_estimate_scales<Concurrency_tag>(
               range,
               np.sparse_linear_solver(CGAL::L0_resampling::Eigen_cholesky_solver_traits<double>()))
                          : CGAL::l0_estimate_scales<Concurrency_tag>(range, np);
  } catch (...) {
    Options on_cpu = options;
    on_cpu.device = Device::CPU;
    rethrow_as_failure("resample", options.input_name(), cloud.points.size(), on_cpu);
  }
  throw_if_interrupted();
  return report;
}

Resampled_points resample(const Point_cloud& cloud, const Sides& sides, const Options& options,
                          const std::function<bool(double)>& callback,
                          CGAL::L0_resampling::Report& report)
{
  const Limit_of_threads limit(options);
  check_normals(cloud, options);
  Resampled_points result;
  result.viewpoint = sides.viewpoint;
  result.las = cloud.las;
  try {
    double shown = 0; // near points are found by a call of their own, which begins at 0 again
    const auto monotonic = [&](double share) {
      shown = (std::max)(shown, share);
      return callback(shown);
    };
    const auto np = parameters_of(options, number_of_output_points(options, cloud.points.size()),
                                  sides.viewpoint)
                      .callback(monotonic)
                      .resampling_report(&report);
    const auto on_device = [&]() {
#ifdef CGAL_L0_LINKED_WITH_CUDA
      call<CGAL::CUDA_tag>(cloud, sides, options, np, result);
#endif
    };
    const auto on_cpu = [&]() { call_with_solver(cloud, sides, options, np, result); };
    const l0_common::Device_request request = device_request(options);
    report.device_reason = l0_common::run_on_chosen(request, on_device, on_cpu);
  } catch (...) {
    rethrow_as_failure("resample", options.input_name(), cloud.points.size(), options);
  }
  return result;
}

} // namespace l0_tool
