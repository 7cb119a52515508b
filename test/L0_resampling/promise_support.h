// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_PROMISE_SUPPORT_H
#define CGAL_L0_RESAMPLING_TEST_PROMISE_SUPPORT_H

#include "test_support.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test {

template <typename Kernel>
using Pairs = std::vector<std::pair<typename Kernel::Point_3, typename Kernel::Vector_3>>;

/// What one call gave.
template <typename Kernel>
struct Resampled
{
  Pairs<Kernel> pairs;
  CGAL::L0_resampling::Report report;
};

template <typename Kernel>
std::vector<typename Kernel::Point_3> kernel_points(const std::vector<Vector>& vectors)
{
  using FT = typename Kernel::FT;
  std::vector<typename Kernel::Point_3> points;
  for (const Vector& v : vectors)
    points.emplace_back(FT(v[0]), FT(v[1]), FT(v[2]));
  return points;
}

template <typename Point_or_vector>
Vector as_vector(const Point_or_vector& p)
{
  return Vector(double(p.x()), double(p.y()), double(p.z()));
}

/// Calls the function, with a report added to the named parameters.
template <typename Kernel, typename ConcurrencyTag, typename NamedParameters>
Resampled<Kernel> resample(const std::vector<typename Kernel::Point_3>& points,
                           const NamedParameters& np)
{
  Resampled<Kernel> result;
  CGAL::l0_resample_point_set<ConcurrencyTag>(
    points, std::back_inserter(result.pairs),
    np | CGAL::parameters::resampling_report(&result.report));
  return result;
}

/// Whether positions and normals are equal bit by bit, in the same order.
template <typename Kernel>
bool are_identical(const Pairs<Kernel>& a, const Pairs<Kernel>& b)
{
  const auto numbers = [](const Pairs<Kernel>& pairs) {
    std::vector<typename Kernel::FT> result;
    for (const auto& [p, n] : pairs)
      result.insert(result.end(), {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()});
    return result;
  };
  const auto equal_bits = [](typename Kernel::FT x, typename Kernel::FT y) {
    return x == y && std::signbit(x) == std::signbit(y);
  };
  const auto x = numbers(a), y = numbers(b);
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), equal_bits);
}

template <typename Kernel>
std::size_t number_of_distinct(const std::vector<typename Kernel::Point_3>& points)
{
  std::vector<std::array<double, 3>> rows;
  for (const auto& p : points)
    rows.push_back({double(p.x()), double(p.y()), double(p.z())});
  std::sort(rows.begin(), rows.end());
  return std::size_t(std::unique(rows.begin(), rows.end()) - rows.begin());
}

/*!
What promise 4 forbids and `result` has, as text; empty for a clean result: every point finite and
in the bounding box of the finite points grown by one radius, up to the rounding of the kernel's
numbers; normals of unit length within 1e-6; `expected_size` points, no two of them equal unless the
input had fewer distinct points.
*/
template <typename Kernel>
std::string fault_of(const std::vector<typename Kernel::Point_3>& points,
                     const Resampled<Kernel>& result, std::size_t expected_size)
{
  std::ostringstream fault;
  if (result.pairs.size() != expected_size)
    fault << result.pairs.size() << " points instead of " << expected_size;
  if (result.report.number_of_output_points != expected_size)
    fault << "; the report has " << result.report.number_of_output_points << " points";

  const double infinity = std::numeric_limits<double>::infinity();
  Vector low = Vector::Constant(infinity), high = -low;
  for (const auto& point : points)
    if (as_vector(point).allFinite())
    {
      low = low.cwiseMin(as_vector(point));
      high = high.cwiseMax(as_vector(point));
    }
  const Vector radius = Vector::Constant(result.report.neighbor_radius);
  const Vector rounding = double(std::numeric_limits<typename Kernel::FT>::epsilon())
                          * (low.cwiseAbs().cwiseMax(high.cwiseAbs()) + radius);
  const Vector margin = radius + rounding;

  std::size_t not_finite = 0, outside = 0, not_unit = 0;
  std::vector<typename Kernel::Point_3> positions;
  for (const auto& [point, normal] : result.pairs)
  {
    const Vector p = as_vector(point), n = as_vector(normal);
    positions.push_back(point);
    not_finite += !p.allFinite() || !n.allFinite();
    outside += !((p.array() >= (low - margin).array()).all()
                 && (p.array() <= (high + margin).array()).all());
    not_unit += !(std::abs(n.norm() - 1) <= 1e-6);
  }
  if (not_finite + outside + not_unit > 0)
    fault << "; " << not_finite << " not finite, " << outside << " outside of the box, " << not_unit
          << " normals not of length 1";

  const std::size_t distinct_inputs = number_of_distinct<Kernel>(points);
  const bool may_repeat = distinct_inputs < points.size() && distinct_inputs < expected_size;
  const std::size_t distinct_results = number_of_distinct<Kernel>(positions);
  if (!may_repeat && distinct_results != positions.size())
    fault << "; " << positions.size() - distinct_results << " points come twice";
  return fault.str();
}

/// Checks that the result is clean, and says which case it is if not.
template <typename Kernel>
void check_clean(const std::string& name, const std::vector<typename Kernel::Point_3>& points,
                 const Resampled<Kernel>& result, std::size_t expected_size)
{
  const std::string fault = fault_of<Kernel>(points, result, expected_size);
  if (!CHECK(fault.empty()))
    std::cerr << "  " << name << ": " << fault << std::endl;
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_PROMISE_SUPPORT_H
