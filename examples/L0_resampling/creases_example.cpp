// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/read_points.h>
#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Crease = CGAL::L0_resampling::Crease<Kernel>;
using Corner = CGAL::L0_resampling::Crease_corner<Kernel>;

// Writes the creases of a part as lines of an OBJ file, for a drawing, and says what they are.
int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/bracket_noisy.ply";
  const std::string output_file = argc > 2 ? argv[2] : "creases.obj";
  std::vector<Point> points;
  if (!CGAL::IO::read_points(input_file, std::back_inserter(points)))
  {
    std::cerr << "Error: cannot read " << input_file << std::endl;
    return EXIT_FAILURE;
  }

  //! [creases]
  std::vector<std::pair<Point, Kernel::Vector_3>> result;
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result),
    CGAL::parameters::crease_output_iterator(std::back_inserter(creases))
      | CGAL::parameters::corner_output_iterator(std::back_inserter(corners)));

  std::ofstream file(output_file);
  file.precision(17);
  for (const auto& [point, normal] : result)
    file << "v " << point << "\n";
  for (const Crease& crease : creases)
  {
    file << "l";
    for (const std::size_t i : crease.points)
      file << " " << i + 1;
    if (crease.is_closed)
      file << " " << crease.points.front() + 1;
    file << "\n";
  }
  //! [creases]

  for (const Crease& crease : creases)
    std::cout << (crease.is_convex ? "convex" : "concave") << (crease.is_closed ? " loop" : " line")
              << " of " << crease.points.size() << " points, " << crease.angles.front()
              << " degrees, confidence " << crease.confidence << "\n";
  std::cout << creases.size() << " creases and " << corners.size() << " corners" << std::endl;
  return file ? EXIT_SUCCESS : EXIT_FAILURE;
}
