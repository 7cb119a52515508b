// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/l0_resample_point_set.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/bracket_noisy.ply";
  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_points(input_file, std::back_inserter(points)))
  {
    std::cerr << "Error: cannot read " << input_file << std::endl;
    return EXIT_FAILURE;
  }

  //! [wlop]
  std::vector<Kernel::Point_3> simplified;
  // CGAL::wlop_simplify_and_regularize_point_set<Concurrency_tag>(
  CGAL::l0_resample_point_set<Concurrency_tag>(points, std::back_inserter(simplified),
                                               CGAL::parameters::select_percentage(20));
  //! [wlop]

  std::vector<Point_with_normal> points_with_normals;
  CGAL::l0_resample_point_set<Concurrency_tag>(points, std::back_inserter(points_with_normals));

  //! [ear]
  std::vector<Point_with_normal> upsampled;
  // CGAL::edge_aware_upsample_point_set<Concurrency_tag>(
  CGAL::l0_resample_point_set<Concurrency_tag>(
    points_with_normals, std::back_inserter(upsampled),
    CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
      .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>())
      .sharpness_angle(25)
      .number_of_output_points(points.size()));
  //! [ear]

  std::cout << points.size() << " points, simplified to " << simplified.size() << ", and from "
            << points_with_normals.size() << " upsampled to " << upsampled.size() << std::endl;
  return simplified.size() == points.size() / 5 && upsampled.size() == points.size() ? EXIT_SUCCESS
                                                                                     : EXIT_FAILURE;
}
