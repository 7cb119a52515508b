// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device/test_cuda_support.h"

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <string>

// P4, P5 on the device. Small enough to run under compute-sanitizer; for that, the first argument
// may be the number of points, and the second one the shape, so that processes can share the
// clouds.

namespace {

using namespace test_cuda;
using CGAL::L0_resampling::Method;
namespace parameters = CGAL::parameters;

const Method methods[] = {Method::LOR, Method::ALOR, Method::DEFAULT};

template <typename NamedParameters>
Result resample(const Points& points, const NamedParameters& np)
{
  Result result;
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(result), np);
  return result;
}

bool is_clean(const Result& result, const Points& points, double margin)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  for (const auto& [p, n] : result)
  {
    if (!(std::abs(n.squared_length() - 1) < 1e-6))
      return false;
    for (int axis = 0; axis < 3; ++axis)
      if (!(p[axis] >= (box.min)(axis)-margin && p[axis] <= (box.max)(axis) + margin))
        return false;
  }
  return true;
}

/// P4, P5: smallest clouds.
/// \param only_size, only_shape 0 and "" for all
/// \returns whether there are such clouds
bool check_small_clouds(std::size_t only_size, const std::string& only_shape)
{
  bool is_any = false;
  for (const std::size_t n : {1, 2, 3, 31, 32, 33, 1000})
  {
    if (only_size != 0 && n != only_size)
      continue;
    Points line, plane, lattice, one_place(n, Point(1, 2, 3)), clusters;
    for (std::size_t i = 0; i < n; ++i)
    {
      line.emplace_back(double(i), 0, 0);
      plane.emplace_back(double(i % 7), double(i / 7), 0);
      lattice.emplace_back(double(i % 10), double(i / 10 % 10), double(i / 100));
      clusters.emplace_back(i % 2 ? 1e9 : 0., 0.001 * double(i), 0.001 * double(i % 3));
    }
    const std::pair<const char*, Points> shapes[] = {
      {"cube", noisy_cube(n, 0.01, unsigned(n))},
      {"line", line},
      {"plane", plane},
      {"lattice", lattice},
      {"one place", one_place},
      {"clusters", clusters},
      {"crowd", with_crowd(noisy_sphere(n - n / 3, 0.1, 3), n / 3, 1.3, 4)}};
    for (const auto& [name, points] : shapes)
    {
      if (!only_shape.empty() && name != only_shape)
        continue;
      is_any = true;
      for (const Method method : methods)
      {
        const std::size_t failures_before = test::number_of_failures();
        Report report;
        const auto np = parameters::resampling_method(method).resampling_report(&report);
        const Result less = resample(points, np.select_percentage(60));
        Report cpu_report;
        Result on_cpu;
        CGAL::l0_resample_point_set<CGAL::Sequential_tag>(points, std::back_inserter(on_cpu),
                                                          parameters::resampling_method(method)
                                                            .resampling_report(&cpu_report)
                                                            .select_percentage(60));
        CHECK(report.number_of_outliers == cpu_report.number_of_outliers);
        CHECK(report.number_of_distinct_points == cpu_report.number_of_distinct_points);
        CHECK(less.size() == (std::max)(std::size_t(1), n * 60 / 100));
        CHECK(is_clean(less, points, report.neighbor_radius));
        const Result more = resample(points, np.number_of_output_points(2 * n));
        CHECK(more.size() == 2 * n);
        CHECK(is_clean(more, points, report.neighbor_radius));
        if (test::number_of_failures() > failures_before)
          for (const auto& [p, normal] : more)
            std::cout << std::setprecision(17) << p << " | " << normal << " | "
                      << CGAL::bbox_3(points.begin(), points.end()) << std::endl;
        if (test::number_of_failures() > failures_before)
          std::cout << name << " of " << n << " points, method " << int(method) << ", radius "
                    << report.neighbor_radius << std::endl;
      }
    }
  }
  return is_any;
}

} // namespace

int main(int argc, char* argv[])
{
  if (!has_device())
    return number_of_skip;
  CHECK(check_small_clouds(argc > 1 ? std::stoul(argv[1]) : 0, argc > 2 ? argv[2] : ""));
  return test::result();
}
