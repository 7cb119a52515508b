// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/IO/write_points.h>
#include <CGAL/l0_resample_point_set.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;

int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/bracket_noisy.ply";
  const std::string output_file = argc > 2 ? argv[2] : "bracket_resampled.ply";

  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_points(input_file, std::back_inserter(points)))
  {
    std::cerr << "Error: cannot read " << input_file << std::endl;
    return EXIT_FAILURE;
  }

  //! [call]
  std::vector<Point_with_normal> result;
  CGAL::L0_resampling::Report report;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result),
    CGAL::parameters::resampling_report(&report).number_of_output_points(points.size() / 2));
  //! [call]

  std::cout << result.size() << " of " << points.size() << " points\n";
  for (const CGAL::L0_resampling::Warning warning : CGAL::L0_resampling::warnings(report))
    std::cout << "warning: " << message_of(warning, report) << "\n";
  const auto np = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
                    .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>());
  return CGAL::IO::write_points(output_file, result, np) ? EXIT_SUCCESS : EXIT_FAILURE;
}
