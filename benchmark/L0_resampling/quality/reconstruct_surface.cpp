// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Poisson reconstruction of oriented points, as the paper's figures have it, by CGAL.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  if (argc != 4) {
    std::cerr << "usage: reconstruct_surface POINTS_WITH_NORMALS.ply MESH.off DISTANCE_IN_SPACINGS"
              << std::endl;
    return EXIT_FAILURE;
  }
  CGAL::get_default_random() = CGAL::Random(
    1); // else it begins with the time, and each run gives another mesh
  const CGAL::First_of_pair_property_map<Point_with_normal> point_map;
  const CGAL::Second_of_pair_property_map<Point_with_normal> normal_map;
  std::vector<Point_with_normal> points;
  if (!CGAL::IO::read_points(argv[1], std::back_inserter(points),
                             CGAL::parameters::point_map(point_map).normal_map(normal_map))) {
    std::cerr << argv[1] << ": cannot be read" << std::endl;
    return EXIT_FAILURE;
  }
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(
    points, 6, CGAL::parameters::point_map(point_map));
  // CGAL's defaults for angle and size of the triangles
  constexpr double angle = 20, maximum_triangle_size = 30;
  const double distance = std::atof(argv[3]);
  Mesh mesh;
  if (!CGAL::poisson_surface_reconstruction_delaunay(points.begin(), points.end(), point_map,
                                                     normal_map, mesh, spacing, angle,
                                                     maximum_triangle_size, distance)) {
    std::cerr << argv[1] << ": Poisson reconstruction failed" << std::endl;
    return EXIT_FAILURE;
  }
  std::ofstream out(argv[2]);
  out.precision(9);
  return out << mesh ? EXIT_SUCCESS : EXIT_FAILURE;
}
