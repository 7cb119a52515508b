// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "call.h"

#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

namespace attack {
namespace {

namespace params = CGAL::parameters;

struct Exception_of_caller
{};

/// The points or normals of a range of indices, in the caller's number type.
template <typename Value>
struct Map_of_indices
{
  using key_type = std::size_t;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;

  const std::vector<Value>* values;
  std::size_t* accesses_left;

  friend Value get(const Map_of_indices& map, std::size_t i)
  {
    if ((*map.accesses_left)-- == 0)
      throw Exception_of_caller();
    return (*map.values)[i];
  }
};

/// Takes values in the order of their keys.
template <typename Value>
struct Map_to_vector
{
  using key_type = std::size_t;
  using value_type = Value;
  using reference = Value&;
  using category = boost::writable_property_map_tag;

  std::vector<Value>* values;

  friend void put(const Map_to_vector& map, std::size_t i, Value value)
  {
    map.values->resize((std::max)(map.values->size(), i + 1));
    (*map.values)[i] = value;
  }
};

/// A parameter that is passed, or not.
template <typename Value>
std::optional<Value> given_if(bool is_given, const Value& value)
{
  return is_given ? std::optional<Value>(value) : std::nullopt;
}

template <typename Value>
std::vector<Value> converted(const std::vector<Vector>& vectors)
{
  std::vector<Value> result;
  for (const Vector& v : vectors)
    result.emplace_back(v[0], v[1], v[2]);
  return result;
}

template <typename Value>
bool are_same_bits(const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() == b.size()
         && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

template <typename ConcurrencyTag, typename Kernel, typename SolverTraits>
void call_with(const Attack& attack, const SolverTraits& solver, Answer& answer)
{
  using Point = typename Kernel::Point_3;
  using Normal = typename Kernel::Vector_3;
  using FT = typename Kernel::FT;
  const Parameters& p = attack.parameters;
  const std::vector<Point> points = converted<Point>(attack.points), points_before = points;
  const std::vector<Normal> normals = converted<Normal>(attack.normals), normals_before = normals;
  std::vector<std::size_t> range(points.size());
  std::iota(range.begin(), range.end(), std::size_t(0));
  std::size_t accesses_left = p.throwing_access,
              normals_left = (std::numeric_limits<std::size_t>::max)();

  double last_progress = 0;
  const std::function<bool(double)> callback = [&](double progress) {
    answer.progress_is_sound = answer.progress_is_sound && progress >= last_progress
                               && progress <= 1;
    last_progress = progress;
    return true;
  };
  const auto write = boost::make_function_output_iterator(
    [&](const std::pair<Point, Normal>& pair) {
      if (answer.points.size() == p.throwing_write)
        throw Exception_of_caller();
      answer.points.emplace_back(pair.first.x(), pair.first.y(), pair.first.z());
      answer.normals.emplace_back(pair.second.x(), pair.second.y(), pair.second.z());
    });

  const Vector eye = viewpoint(p), up = up_direction(p);
  const Point eye_of_caller = Point(FT(eye[0]), FT(eye[1]), FT(eye[2]));
  const Map_of_indices<Normal> directions{&normals, &normals_left};
  const auto np =
    params::resampling_method(CGAL::L0_resampling::Method(p.method))
      .point_map(Map_of_indices<Point>{&points, &accesses_left})
      .normal_map(given_if(p.with_normals, directions))
      .orientation_hint_map(given_if(p.with_hints, directions))
      .viewpoint(given_if(p.viewpoint && !p.viewpoint_by_map, eye_of_caller))
      .viewpoint_map(given_if(p.viewpoint && p.viewpoint_by_map,
                              CGAL::Constant_property_map<std::size_t, Point>(eye_of_caller)))
      .up_direction(given_if(p.up_direction.has_value(), Normal(FT(up[0]), FT(up[1]), FT(up[2]))))
      .geom_traits(Kernel())
      .sparse_linear_solver(solver)
      .number_of_output_points(p.number_of_output_points)
      .neighbor_radius(p.neighbor_radius)
      .noise(p.noise)
      .normal_filter_radius(p.normal_filter_radius)
      .select_percentage(p.select_percentage)
      .sharpness_angle(p.sharpness_angle)
      .number_of_normal_filter_iterations(p.number_of_normal_filter_iterations)
      .normal_weight(p.normal_weight)
      .regularization_weight(p.regularization_weight)
      .initial_penalty(p.initial_penalty)
      .maximum_penalty(p.maximum_penalty)
      .penalty_growth(p.penalty_growth)
      .number_of_orientation_neighbors(p.number_of_orientation_neighbors)
      .random_seed(p.random_seed)
      .drop_non_finite(p.drop_non_finite)
      .drop_outliers(p.drop_outliers)
      .outlier_sensitivity(p.outlier_sensitivity)
      .keep_density(p.keep_density)
      .source_index_map(given_if(p.with_point_data, Map_to_vector<std::size_t>{&answer.sources}))
      .feature_confidence_map(
        given_if(p.with_point_data, Map_to_vector<float>{&answer.confidences}))
      .maximum_memory(p.maximum_memory)
      .callback(callback)
      .resampling_report(&answer.report);
  try
  {
    CGAL::l0_resample_point_set<ConcurrencyTag>(range, write, np);
  }
  catch (const std::invalid_argument& e)
  {
    answer.ending = Ending::INVALID_ARGUMENT;
    answer.message = e.what();
  }
  catch (const CGAL::L0_resampling::Solver_error& e)
  {
    answer.ending = Ending::SOLVER_ERROR;
    answer.message = e.what();
  }
  catch (const std::bad_alloc&)
  {
    answer.ending = Ending::BAD_ALLOC;
  }
  catch (const Exception_of_caller&)
  {
    answer.ending = Ending::EXCEPTION_OF_CALLER;
  }
  catch (const std::exception& e)
  {
    answer.ending = Ending::ANOTHER_EXCEPTION;
    answer.message = e.what();
  }

  answer.input_is_unchanged = are_same_bits(points, points_before)
                              && are_same_bits(normals, normals_before);
}

#ifdef L0_ATTACKS_ONLY_IN_PARALLEL // by ThreadSanitizer: where one thread runs there is no race
using Tag_of_one_thread = CGAL::Parallel_tag;
#else
using Tag_of_one_thread = CGAL::Sequential_tag;
#endif

template <typename ConcurrencyTag, typename SolverTraits>
void call_with(const Attack& attack, const SolverTraits& solver, Answer& answer)
{
  if (attack.parameters.in_single_precision)
    call_with<ConcurrencyTag, CGAL::Simple_cartesian<float>>(attack, solver, answer);
  else
    call_with<ConcurrencyTag, CGAL::Simple_cartesian<double>>(attack, solver, answer);
}

} // namespace

Vector viewpoint(const Parameters& parameters)
{
  const double x = parameters.viewpoint.value_or(0);
  return {x, -x, x / 2};
}

Vector up_direction(const Parameters& parameters)
{
  const double x = parameters.up_direction.value_or(1);
  return {x, -x, x / 2};
}

Answer call(const Attack& attack, bool in_parallel)
{
  using namespace CGAL::L0_resampling;
  Answer answer;
  switch (attack.parameters.solver)
  {
  case Solver::CHOLESKY:
    call_with<Tag_of_one_thread>(attack, Eigen_cholesky_solver_traits<double>(), answer);
    break;
  case Solver::LEAST_SQUARES:
    call_with<Tag_of_one_thread>(attack, Eigen_least_squares_solver_traits<double>(), answer);
    break;
  default:
    // as a call without a solver does
    if (in_parallel)
      call_with<CGAL::Parallel_if_available_tag>(
        attack, Block_chebyshev_solver_traits<float, CGAL::Parallel_if_available_tag>(), answer);
    else
      call_with<Tag_of_one_thread>(
        attack, Block_chebyshev_solver_traits<float, Tag_of_one_thread>(), answer);
  }
  return answer;
}

} // namespace attack
