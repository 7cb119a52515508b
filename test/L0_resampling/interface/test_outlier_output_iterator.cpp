// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameter outlier_output_iterator.

#include "promise_support.h"

#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using Places = std::vector<std::size_t>;
using CGAL::L0_resampling::Report;
namespace params = CGAL::parameters;

namespace {

/// A sphere, and behind it points far away, one from the other as well.
Points sphere_and_outliers(std::size_t number_of_outliers)
{
  test::Generator generator(5);
  std::vector<test::Vector> points = test::sphere_points(3000, 1, generator).points;
  for (std::size_t i = 0; i < number_of_outliers; ++i)
    points.push_back(double(10 + 10 * i) * test::random_unit_vector(generator));
  return test::kernel_points<Kernel>(points);
}

template <typename Tag, typename NamedParameters>
Places outliers_of(const Points& points, const NamedParameters& np, Report& report)
{
  test::Pairs<Kernel> result;
  Places outliers;
  CGAL::l0_resample_point_set<Tag>(
    points, std::back_inserter(result),
    np.resampling_report(&report).select_percentage(20).outlier_output_iterator(
      std::back_inserter(outliers)));
  CHECK(outliers.size() == report.number_of_outliers);
  return outliers;
}

/// They are places in the range, also behind points that are not finite, and in any order of it.
template <typename Tag>
void check_places()
{
  const std::size_t number = 5;
  Points points = sphere_and_outliers(number);
  Report report;
  Places expected(number);
  std::iota(expected.begin(), expected.end(), std::size_t(3000));
  const auto np = params::drop_non_finite(true);
  CHECK(outliers_of<Tag>(points, np, report) == expected);

  std::swap(points[0], points[3001]);
  std::swap(points[1200], points[3004]);
  CHECK(outliers_of<Tag>(points, np, report) == (Places{0, 1200, 3000, 3002, 3003}));

  const double nan = std::numeric_limits<double>::quiet_NaN();
  points.insert(points.begin(), Kernel::Point_3(0, nan, 0));
  points.insert(points.begin() + 1500, Kernel::Point_3(nan, 0, 0));
  CHECK(outliers_of<Tag>(points, np, report) == (Places{1, 1201, 3002, 3004, 3005}));
  CHECK(report.number_of_dropped_points == 2);
}

/// Nothing is told where nothing is left out, and the result is the same.
void check_none()
{
  using Tag = CGAL::Sequential_tag;
  const Points points = sphere_and_outliers(5);
  Report report;
  CHECK(outliers_of<Tag>(points, params::drop_outliers(false), report).empty());
  CHECK(
    outliers_of<Tag>(points, params::resampling_method(CGAL::L0_resampling::Method::LOR), report)
      .empty());
  CHECK(outliers_of<Tag>(sphere_and_outliers(0), params::drop_outliers(true), report).empty());

  test::Pairs<Kernel> with, without;
  Places outliers;
  const auto np = params::select_percentage(20);
  CGAL::l0_resample_point_set<Tag>(
    points, std::back_inserter(with),
    np | params::outlier_output_iterator(std::back_inserter(outliers)));
  CGAL::l0_resample_point_set<Tag>(points, std::back_inserter(without), np);
  CHECK(with == without);
}

/// A surface loses hardly anything where it becomes 16 times as sparse from one place to the next.
void check_sparse_beside_dense()
{
  test::Generator generator(5);
  std::vector<test::Vector> points;
  for (const test::Vector& p : test::sphere_points(20000, 1, generator).points)
    if (p[2] > 0.3 || test::random_number(0, 1, generator) < 1. / 16)
      points.push_back(p);
  Report report;
  const Places outliers = outliers_of<CGAL::Parallel_if_available_tag>(
    test::kernel_points<Kernel>(points), params::drop_outliers(true), report);
  if (!CHECK(1000 * outliers.size() < points.size()))
    std::cerr << "  " << outliers.size() << " of " << points.size() << std::endl;
}

} // namespace

int main()
{
  check_places<CGAL::Sequential_tag>();
  check_places<CGAL::Parallel_if_available_tag>();
  check_none();
  check_sparse_beside_dense();
  return test::result();
}
