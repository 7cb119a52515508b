// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "carry_out.h"

#include "call.h"
#include "hostile.h"
#include "oracle.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace attack {
namespace {

bool are_same_bits(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
  return a.size() == b.size()
         && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Vector)) == 0);
}

/// All that the report says and that is neither time, memory nor text.
std::vector<double> numbers(const CGAL::L0_resampling::Report& report)
{
  std::vector<double> result{double(report.number_of_distinct_points),
                             double(report.number_of_outliers),
                             double(report.number_of_degenerate_neighborhoods),
                             double(report.number_of_lonely_samples),
                             double(report.number_of_self_neighbor_pairs),
                             report.neighbor_radius,
                             report.oriented_share};
  for (const CGAL::L0_resampling::Iteration_report& iteration : report.iterations)
    result.insert(result.end(), {iteration.fit_energy, iteration.active_pair_share,
                                 double(iteration.solver.iterations)});
  return result;
}

/// A limit of memory may be passed by the arrays of one thread more.
bool may_differ(const Answer& a, const Answer& b)
{
  return a.ending == Ending::BAD_ALLOC || b.ending == Ending::BAD_ALLOC;
}

std::string difference(const Answer& a, const Answer& b)
{
  if (may_differ(a, b))
    return "";
  if (a.ending != b.ending || a.message != b.message)
    return "another ending: " + b.message;
  if (!are_same_bits(a.points, b.points))
    return "other points";
  if (!are_same_bits(a.normals, b.normals))
    return "other normals";
  if (a.sources != b.sources)
    return "other nearest points";
  if (a.confidences != b.confidences)
    return "other confidences";
  return numbers(a.report) == numbers(b.report) ? "" : "another report";
}

constexpr int exponent = 40;

Vector larger(const Vector& v)
{
  return {std::ldexp(v[0], exponent), std::ldexp(v[1], exponent), std::ldexp(v[2], exponent)};
}

/// Whether all numbers of the attack keep their digits when they become larger, with some room for
/// the radii. A cloud at the origin has no length to scale.
bool can_be_larger(const Attack& attack)
{
  const auto has_room = [](double x) {
    return x == 0 || !std::isfinite(x) || std::abs(std::ilogb(x)) < 900;
  };
  return !attack.parameters.in_single_precision
         && std::any_of(attack.points.begin(), attack.points.end(),
                        [](const Vector& p) { return p.allFinite() && !p.isZero(0); })
         && std::all_of(attack.points.begin(), attack.points.end(),
                        [&](const Vector& p) {
                          return has_room(p[0]) && has_room(p[1]) && has_room(p[2]);
                        })
         && has_room(attack.parameters.viewpoint.value_or(1))
         && has_room(attack.parameters.neighbor_radius.value_or(1))
         && has_room(attack.parameters.noise.value_or(1))
         && has_room(attack.parameters.normal_filter_radius.value_or(1));
}

std::string difference_of_larger(const Attack& attack, Answer answer)
{
  Attack large = attack;
  std::transform(large.points.begin(), large.points.end(), large.points.begin(), larger);
  for (std::optional<double>* length :
       {&large.parameters.neighbor_radius, &large.parameters.normal_filter_radius,
        &large.parameters.noise, &large.parameters.viewpoint})
    if (*length)
      **length = std::ldexp(**length, exponent);
  const Answer answer_of_large = call(large, false);
  if (may_differ(answer, answer_of_large))
    return "";
  if (answer.ending != answer_of_large.ending)
    return "another ending: " + answer_of_large.message;
  std::transform(answer.points.begin(), answer.points.end(), answer.points.begin(), larger);
  if (!are_same_bits(answer.points, answer_of_large.points))
    return "other points";
  if (answer.sources != answer_of_large.sources)
    return "other nearest points";
  if (answer.confidences != answer_of_large.confidences)
    return "other confidences";
  return are_same_bits(answer.normals, answer_of_large.normals) ? "" : "other normals";
}

/// Whether each point of `a`, with its normal, is in `b` too.
bool is_contained(const Answer& a, const Answer& b, double tolerance)
{
  for (std::size_t i = 0; i < a.points.size(); ++i)
  {
    bool is_there = false;
    for (std::size_t k = 0; k < b.points.size() && !is_there; ++k)
      is_there = (a.points[i] - b.points[k]).cwiseAbs().maxCoeff() <= tolerance
                 && (a.normals[i] - b.normals[k]).norm() <= 1e-6;
    if (!is_there)
      return false;
  }
  return true;
}

std::string difference_of_shuffled(const Attack& attack, const Answer& answer)
{
  Generator generator(1);
  std::vector<std::size_t> order(attack.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), generator);
  Attack shuffled = attack;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    shuffled.points[i] = attack.points[order[i]];
    const bool sign_matters = attack.parameters.with_hints;
    shuffled.normals[i] = (sign_matters || i % 2 ? 1. : -1.) * attack.normals[order[i]];
  }
  const Answer answer_of_shuffled = call(shuffled, false);
  if (may_differ(answer, answer_of_shuffled))
    return "";
  if (answer.ending != answer_of_shuffled.ending)
    return "another ending: " + answer_of_shuffled.message;
  const double tolerance = 1e-9 * diagonal_of(attack.points);
  return is_contained(answer, answer_of_shuffled, tolerance)
             && is_contained(answer_of_shuffled, answer, tolerance)
           ? ""
           : "another set";
}

} // namespace

std::string carry_out(const Attack& attack)
{
  const Parameters& p = attack.parameters;
  const Answer answer = call(attack, false);
  std::string faults = broken_promises(attack, answer);
  const auto add = [&](const std::string& what, const std::string& difference) {
    if (!difference.empty())
      faults += "; " + what + " gives " + difference;
  };
  add("the parallel call", difference(answer, call(attack, true)));
  if (can_be_larger(attack))
    add("the larger cloud", difference_of_larger(attack, answer));
  // which point is the first that is refused, or at which a map throws, does depend on the order
  if (answer.ending == Ending::COMPLETED
      && p.throwing_access >= maximum_number_of_readings * attack.points.size())
    add("another order", difference_of_shuffled(attack, answer));
  return faults.empty()
           ? faults
           : faults.substr(2) + (answer.message.empty() ? "" : " (" + answer.message + ")");
}

} // namespace attack
