// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Poisson reconstruction of oriented points, as the paper's figures have it, by CGAL. Writes the
// mesh, and another one for pictures, in which edges are collapsed until it has so many triangles.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_surface_reconstruction.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_with_normal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

/// A stop predicate of `edge_collapse()`. Those of CGAL count edges, under names that differ from
/// version to version.
struct Few_triangles
{
  std::size_t largest_number;

  template <typename Cost, typename Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_faces() <= largest_number;
  }
};

bool write_mesh(const Mesh& mesh, const std::string& path)
{
  std::ofstream out(path);
  out.precision(9);
  return bool(out << mesh);
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 6) {
    std::cerr << "usage: reconstruct_surface POINTS_WITH_NORMALS.ply MESH.off DISTANCE_IN_SPACINGS "
                 "PICTURE.off TRIANGLES"
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
  constexpr double angle = 20, largest_triangle = 30;
  const double distance = std::atof(argv[3]);
  Mesh mesh;
  if (!CGAL::poisson_surface_reconstruction_delaunay(points.begin(), points.end(), point_map,
                                                     normal_map, mesh, spacing, angle,
                                                     largest_triangle, distance)) {
    std::cerr << argv[1] << ": Poisson reconstruction failed" << std::endl;
    return EXIT_FAILURE;
  }
  if (!write_mesh(mesh, argv[2]))
    return EXIT_FAILURE;
  CGAL::Surface_mesh_simplification::edge_collapse(mesh,
                                                   Few_triangles{std::size_t(std::atoll(argv[5]))});
  mesh.collect_garbage();
  return write_mesh(mesh, argv[4]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
