// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Point_set = CGAL::Point_set_3<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/torus_noisy.ply";
  const std::string output_file = argc > 2 ? argv[2] : "torus_resampled.ply";

  Point_set points, result;
  if (!CGAL::IO::read_point_set(input_file, points))
  {
    std::cerr << "Error: cannot read " << input_file << std::endl;
    return EXIT_FAILURE;
  }

  //! [call]
  // A chain that one of CGAL's names has started goes on with ours behind a bar.
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, result,
    CGAL::parameters::select_percentage(60)
      | CGAL::parameters::resampling_method(CGAL::L0_resampling::Method::LOR));
  //! [call]

  std::cout << result.size() << " of " << points.size()
            << " points, with normals: " << result.has_normal_map() << std::endl;
  return CGAL::IO::write_point_set(output_file, result) ? EXIT_SUCCESS : EXIT_FAILURE;
}
