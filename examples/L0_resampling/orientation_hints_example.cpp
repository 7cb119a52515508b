// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Oriented_point = std::pair<Kernel::Point_3, Kernel::Vector_3>;

// A bowl, scanned from above: it has no inside, so that nothing but the scanner tells which side
// its normals shall be on.
int main()
{
  std::vector<Oriented_point> scan;
  const Kernel::Point_3 scanner(0, 0, 3);
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j)
    {
      const double x = i / 30. - 1, y = j / 30. - 1;
      scan.emplace_back(Kernel::Point_3(x, y, (x * x + y * y) / 2),
                        Kernel::Vector_3(0, 0, 1)); // a rough normal
    }

  //! [hints]
  using Points = CGAL::First_of_pair_property_map<Oriented_point>;
  using Normals = CGAL::Second_of_pair_property_map<Oriented_point>;
  namespace parameters = CGAL::parameters;
  CGAL::L0_resampling::Report report;
  std::vector<Oriented_point> seen, hinted;

  // to the side of the scanner ...
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    scan, std::back_inserter(seen),
    parameters::viewpoint(scanner).resampling_report(&report).point_map(Points()));
  std::cout << 100 * report.hinted_share << " % of the points were turned to the viewpoint"
            << std::endl;

  // ... or of normals that somebody has, however rough they are
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    scan, std::back_inserter(hinted),
    parameters::orientation_hint_map(Normals()).point_map(Points()));
  //! [hints]

  for (const std::vector<Oriented_point>& result : {seen, hinted})
    for (const Oriented_point& point : result)
      if (point.second.z() < 0)
        return EXIT_FAILURE;
  return seen.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
