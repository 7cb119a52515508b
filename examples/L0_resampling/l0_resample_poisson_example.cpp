// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/l0_resample_point_set.h>
#include <CGAL/poisson_surface_reconstruction.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;

// From noisy points without normals to a mesh.
int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/torus_noisy.ply";
  const std::string output_file = argc > 2 ? argv[2] : "torus_mesh.off";
  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_points(input_file, std::back_inserter(points)))
    return EXIT_FAILURE;

  //! [reconstruct]
  std::vector<Point_with_normal> clean;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(points, std::back_inserter(clean));

  const CGAL::First_of_pair_property_map<Point_with_normal> point_map;
  const CGAL::Second_of_pair_property_map<Point_with_normal> normal_map;
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(
    clean, 6, CGAL::parameters::point_map(point_map));
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  if (!CGAL::poisson_surface_reconstruction_delaunay(clean.begin(), clean.end(), point_map,
                                                     normal_map, mesh, spacing))
    return EXIT_FAILURE;
  //! [reconstruct]
  std::cout << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces() << " faces"
            << std::endl;
  std::ofstream out(output_file);
  return (out << mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
