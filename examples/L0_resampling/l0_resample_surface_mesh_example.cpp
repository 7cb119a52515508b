// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/l0_resample_point_set.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// More points than the mesh has vertices: the further ones start between vertices.
int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/torus.off";
  std::ifstream in(input_file);
  Mesh mesh;
  if (!(in >> mesh))
  {
    std::cerr << "Error: cannot read " << input_file << std::endl;
    return EXIT_FAILURE;
  }

  //! [call]
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(mesh.vertices(), std::back_inserter(result),
                                                    CGAL::parameters::point_map(mesh.points())
                                                      .number_of_output_points(
                                                        2 * mesh.number_of_vertices()));
  //! [call]

  std::cout << result.size() << " points from " << mesh.number_of_vertices() << " vertices"
            << std::endl;
  return EXIT_SUCCESS;
}
