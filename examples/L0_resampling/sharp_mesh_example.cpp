// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/l0_resample_point_set.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Crease = CGAL::L0_resampling::Crease<Kernel>;

// Makes a mesh of a noisy part. As points lie on its creases, a spacing apart, edges of the mesh
// join them, and the mesh is as sharp as the part.
int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/bracket_noisy.ply";
  const std::string output_file = argc > 2 ? argv[2] : "sharp.off";
  std::vector<Point> points;
  if (!CGAL::IO::read_points(input_file, std::back_inserter(points)))
  {
    std::cerr << "Error: cannot read " << input_file << std::endl;
    return EXIT_FAILURE;
  }

  //! [mesh]
  std::vector<Point> result;
  std::vector<Crease> creases;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result),
    CGAL::parameters::select_percentage(100)
      | CGAL::parameters::crease_output_iterator(std::back_inserter(creases)));
  std::vector<std::array<std::size_t, 3>> triangles;
  CGAL::advancing_front_surface_reconstruction(result.begin(), result.end(),
                                               std::back_inserter(triangles));
  //! [mesh]

  std::ofstream file(output_file);
  file.precision(17);
  file << "OFF\n" << result.size() << " " << triangles.size() << " 0\n";
  for (const Point& point : result)
    file << point << "\n";
  for (const auto& [a, b, c] : triangles)
    file << "3 " << a << " " << b << " " << c << "\n";
  std::cout << triangles.size() << " triangles, " << creases.size() << " creases" << std::endl;
  return file && !triangles.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}
