// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/l0_resample_point_set.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Halves the points of a sphere: the exit status is 0 if as many come out, all of them near it.
int main()
{
  CGAL::Random random(1);
  CGAL::Random_points_on_sphere_3<Kernel::Point_3> sphere(1., random);
  std::vector<Kernel::Point_3> points;
  std::copy_n(sphere, 2000, std::back_inserter(points));
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result), CGAL::parameters::number_of_output_points(1000));
  for (const auto& [point, normal] : result)
    if (std::abs(CGAL::to_double((point - CGAL::ORIGIN).squared_length()) - 1) > 0.05
        || normal * (point - CGAL::ORIGIN) < 0.9)
      return 1;
  return result.size() == 1000 ? 0 : 1;
}
