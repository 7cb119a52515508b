// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_orient_normals.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;

// A sphere, with every third normal inwards.
int main()
{
  std::vector<Point_with_normal> points;
  const int number_of_points = 5000;
  for (int i = 0; i < number_of_points; ++i)
  {
    const double z = (2 * i + 1.) / number_of_points - 1, r = std::sqrt(1 - z * z);
    const double angle = 2.399963 * i; // the golden one
    const Kernel::Vector_3 normal(r * std::cos(angle), r * std::sin(angle), z);
    points.emplace_back(CGAL::ORIGIN + normal, i % 3 == 0 ? -normal : normal);
  }

  //! [orient]
  CGAL::L0_resampling::Report report;
  CGAL::l0_orient_normals<CGAL::Parallel_if_available_tag>(
    points, CGAL::parameters::resampling_report(&report)
              .point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
              .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  //! [orient]

  std::cout << "One sign was propagated to " << 100 * report.oriented_share << " % of the points"
            << std::endl;
  for (const auto& [point, normal] : points)
    if (normal * (point - CGAL::ORIGIN) < 0)
      return EXIT_FAILURE;
  return EXIT_SUCCESS;
}
