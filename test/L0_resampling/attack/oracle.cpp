// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "oracle.h"

#include "hostile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace attack {
namespace {

constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

bool is_positive(double x) { return std::isfinite(x) && x > 0; }
bool is_not_negative(double x) { return std::isfinite(x) && x >= 0; }
bool is_count(double x, double low, double high) { return x >= low && x < high + 1; }

double rounded_to_float(double x)
{
  const volatile float rounded = float(
    x); // GCC 12 leaves the rounding of three numbers at once out
  return rounded;
}

/// As the caller's kernel has it.
Vector given(const Attack& attack, const Vector& p)
{
  return attack.parameters.in_single_precision
           ? Vector(rounded_to_float(p[0]), rounded_to_float(p[1]), rounded_to_float(p[2]))
           : p;
}

std::vector<Vector> finite_points(const Attack& attack)
{
  std::vector<Vector> points;
  for (const Vector& p : attack.points)
    if (given(attack, p).allFinite())
      points.push_back(given(attack, p));
  return points;
}

bool parameters_are_good(const Attack& attack)
{
  const Parameters& p = attack.parameters;
  const double steps = number_of_growths(p);
  const Vector up = given(attack, up_direction(p));
  return p.method >= 0 && p.method <= 2
         && int(p.viewpoint.has_value()) + int(p.up_direction.has_value()) + int(p.with_hints) <= 1
         && (p.viewpoint_by_map || given(attack, viewpoint(p)).allFinite()) && up.allFinite()
         && !up.isZero(0)
         && (!p.number_of_output_points || is_count(*p.number_of_output_points, 0, 4294967294.))
         && is_positive(p.neighbor_radius.value_or(1)) && is_positive(p.noise.value_or(1))
         && (p.method == 0 || !p.noise) && is_positive(p.normal_filter_radius.value_or(1))
         && is_not_negative(p.regularization_weight.value_or(1))
         && is_positive(p.penalty_growth.value_or(2) - 1) && p.select_percentage > 0
         && p.select_percentage <= 100 && p.sharpness_angle > 0 && p.sharpness_angle <= 90
         && is_count(p.number_of_normal_filter_iterations, 0, 10000)
         && p.outlier_sensitivity.value_or(1) >= 0 && p.outlier_sensitivity.value_or(1) <= 3
         && is_not_negative(p.normal_weight) && is_positive(p.initial_penalty)
         && is_positive(p.maximum_penalty) && !(std::isfinite(steps) && steps > 10000)
         && is_count(p.number_of_orientation_neighbors, 3, 1000);
}

/// Weights with which the paper's system is far from what double precision holds: the solver may
/// say that it has no answer.
bool weights_are_extreme(const Parameters& p)
{
  const auto is_extreme = [](double x) { return x != 0 && !(x > 1e-12 && x < 1e12); };
  return is_extreme(p.normal_weight) || is_extreme(p.regularization_weight.value_or(1))
         || is_extreme(p.initial_penalty) || is_extreme(p.maximum_penalty);
}

std::size_t number_of_distinct(const std::vector<Vector>& points)
{
  std::vector<std::array<double, 3>> rows;
  for (const Vector& p : points)
    rows.push_back({p[0], p[1], p[2]});
  std::sort(rows.begin(), rows.end());
  return std::size_t(std::unique(rows.begin(), rows.end()) - rows.begin());
}

/// Whether the point of the input is as near to `query` as any, but for rounding, and for distances
/// whose squares, in the unit of the cloud, are none.
bool is_nearest(const std::vector<Vector>& points, std::size_t index, const Vector& query)
{
  const auto distance = [&](const Vector& p) {
    const Vector half = p / 2 - query / 2; // as the largest numbers have no difference
    return half.stableNorm();
  };
  if (index >= points.size() || !points[index].allFinite())
    return false;
  double largest = 0;
  for (const Vector& p : points)
    if (p.allFinite())
      largest = (std::max)(largest, p.cwiseAbs().maxCoeff());
  const double tolerance = 4 * std::numeric_limits<double>::epsilon() * query.cwiseAbs().maxCoeff()
                           + 1e-150 * largest + 8 * std::numeric_limits<double>::denorm_min();
  const double bound = distance(points[index]);
  return std::none_of(points.begin(), points.end(), [&](const Vector& p) {
    return p.allFinite() && distance(p) * (1 + 1e-9) + tolerance < bound;
  });
}

std::string faults_of_point_data(const Attack& attack, const Answer& answer)
{
  std::ostringstream faults;
  const std::size_t size = attack.parameters.with_point_data ? answer.points.size() : 0;
  if (answer.sources.size() != size || answer.confidences.size() != size)
  {
    faults << "; " << answer.sources.size() << " nearest points and " << answer.confidences.size()
           << " confidences instead of " << size;
    return faults.str();
  }
  std::vector<Vector> input;
  for (const Vector& p : attack.points)
    input.push_back(given(attack, p));
  std::size_t not_nearest = 0, out_of_range = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    not_nearest += std::size_t(!is_nearest(input, answer.sources[i], answer.points[i]));
    out_of_range += std::size_t(!(answer.confidences[i] >= 0 && answer.confidences[i] <= 1));
  }
  if (not_nearest + out_of_range > 0)
    faults << "; " << not_nearest << " points are not the nearest, " << out_of_range
           << " confidences out of [0, 1]";
  return faults.str();
}

std::string faults_of_result(const Attack& attack, const Answer& answer)
{
  std::ostringstream faults;
  const std::vector<Vector> input = finite_points(attack);
  const std::size_t size = documented_size(attack);
  if (answer.points.size() != size)
    faults << "; " << answer.points.size() << " points instead of " << size;
  if (answer.report.number_of_output_points != size)
    faults << "; the report says " << answer.report.number_of_output_points << " points";
  if (answer.report.number_of_dropped_points != attack.points.size() - input.size())
    faults << "; the report says that " << answer.report.number_of_dropped_points
           << " were dropped";
  if (answer.points.empty())
    return faults.str();

  Vector low = input.front(), high = input.front();
  for (const Vector& p : input)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double epsilon = attack.parameters.in_single_precision
                           ? double(std::numeric_limits<float>::epsilon())
                           : std::numeric_limits<double>::epsilon();
  const Vector radius = Vector::Constant(answer.report.neighbor_radius);
  const Vector margin = radius + epsilon * (low.cwiseAbs().cwiseMax(high.cwiseAbs()) + radius);
  std::size_t not_finite = 0, outside = 0, not_unit = 0;
  for (std::size_t i = 0; i < answer.points.size(); ++i)
  {
    const Vector& p = answer.points[i];
    not_finite += std::size_t(!p.allFinite() || !answer.normals[i].allFinite());
    outside += std::size_t(!((p.array() >= (low - margin).array()).all()
                             && (p.array() <= (high + margin).array()).all()));
    not_unit += std::size_t(!(std::abs(answer.normals[i].norm() - 1) <= 1e-6));
  }
  if (not_finite + not_unit > 0)
    faults << "; " << not_finite << " not finite, " << not_unit << " normals not of length 1";

  // points that differ keep inside where there is room for them, at distances of some units in the
  // last place
  const double least = attack.parameters.in_single_precision
                         ? double(std::numeric_limits<float>::denorm_min())
                         : std::numeric_limits<double>::denorm_min();
  const Vector spacing =
    (epsilon * (low - radius).cwiseAbs().cwiseMax((high + radius).cwiseAbs())).cwiseMax(least);
  const double room = ((high - low + 2 * radius).cwiseQuotient(spacing) / 8)
                        .array()
                        .floor()
                        .cwiseMax(1)
                        .cwiseMin(1e6)
                        .prod();
  if (outside > 0 && room > double(size))
    faults << "; " << outside << " outside of the box";

  const std::size_t distinct_input = number_of_distinct(input),
                    distinct = number_of_distinct(answer.points);
  const bool may_repeat = distinct_input < input.size() && distinct_input < size;
  if (!may_repeat && distinct != size)
    faults << "; " << size - distinct << " points come twice, of an input with " << distinct_input
           << " distinct points";
  return faults.str();
}

} // namespace

std::size_t documented_size(const Attack& attack)
{
  const std::size_t n = finite_points(attack).size();
  const Parameters& p = attack.parameters;
  if (n == 0)
    return 0;
  if (p.number_of_output_points)
    return std::size_t(*p.number_of_output_points);
  return (std::max)(std::size_t(1), std::size_t(std::floor(double(n) * p.select_percentage / 100)));
}

std::string broken_promises(const Attack& attack, const Answer& answer)
{
  const Parameters& p = attack.parameters;
  const auto ended = [&](Ending ending) { return answer.ending == ending; };
  std::ostringstream faults;
  if (!answer.input_is_unchanged)
    faults << "; the input has changed";
  if (!answer.progress_is_sound)
    faults << "; progress fell or left [0, 1]";
  if (ended(Ending::ANOTHER_EXCEPTION))
    faults << "; an exception that is not documented";
  if (answer.ending != Ending::COMPLETED && !answer.points.empty()
      && answer.points.size() != p.throwing_write)
    faults << "; points were written although the call failed";

  // Refusals come first, and name what is wrong.
  const auto is_bad = [&](const Vector& v) { return !given(attack, v).allFinite(); };
  const std::size_t first_bad =
    p.drop_non_finite ? unlimited
                      : std::size_t(std::find_if(attack.points.begin(), attack.points.end(), is_bad)
                                    - attack.points.begin());
  const bool has_bad_point = first_bad < attack.points.size();
  const bool map_throws = p.throwing_access < (std::min)(attack.points.size(),
                                                         has_bad_point ? first_bad + 1 : unlimited);
  const bool is_limited = p.maximum_memory != unlimited;
  if (ended(Ending::INVALID_ARGUMENT)
      && answer.message.compare(0, 23, "l0_resample_point_set: ") != 0)
    faults << "; the message does not say who refuses";
  if (!parameters_are_good(attack))
  {
    if (!ended(Ending::INVALID_ARGUMENT))
      faults << "; bad parameters were not refused";
    return faults.str();
  }
  if (ended(Ending::BAD_ALLOC))
  {
    if (!is_limited)
      faults << "; out of memory without a limit";
    return faults.str();
  }
  if (map_throws || has_bad_point)
  {
    if (!ended(map_throws ? Ending::EXCEPTION_OF_CALLER : Ending::INVALID_ARGUMENT))
      faults << (map_throws ? "; the exception of the map did not come through"
                            : "; a point that is not finite was not refused");
    return faults.str();
  }
  if (ended(Ending::INVALID_ARGUMENT))
    faults << "; good input was refused";

  const std::size_t n = finite_points(attack).size(), m = documented_size(attack);
  const bool may_end_by_map = p.throwing_access < maximum_number_of_readings * attack.points.size();
  const bool ended_by_map = ended(Ending::EXCEPTION_OF_CALLER) && may_end_by_map;
  const std::size_t room_needed = ended_by_map ? n : (std::max)(n, m); // what is read comes first
  if (n > 0 && m > 0 && p.maximum_memory / sizeof(Vector) < room_needed)
    faults << "; the limit of memory was passed";
  if (ended(Ending::SOLVER_ERROR) && p.solver == Solver::BLOCK_CHEBYSHEV && !weights_are_extreme(p))
    faults << "; the solver has no answer to sensible weights";
  if (p.throwing_write < m && !ended(Ending::EXCEPTION_OF_CALLER) && !ended(Ending::SOLVER_ERROR))
    faults << "; the exception of the output did not come through";
  if (ended(Ending::EXCEPTION_OF_CALLER) && !(p.throwing_write < m) && !may_end_by_map)
    faults << "; an exception that nobody threw";
  if (ended(Ending::COMPLETED))
    faults << faults_of_result(attack, answer) << faults_of_point_data(attack, answer);
  else if (!(p.throwing_write < m) && !(answer.sources.empty() && answer.confidences.empty()))
    faults << "; nearest points were written although the call failed";
  return faults.str();
}

} // namespace attack
