// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;

// Resamples twice, the second time with twice the radius of the first, and looks at what was done.
int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/bracket_noisy.ply";
  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_points(input_file, std::back_inserter(points)))
    return EXIT_FAILURE;
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;

  //! [chain]
  namespace parameters = CGAL::parameters;
  CGAL::L0_resampling::Report report;

  // A name of this package starts a chain, which goes on with any name.
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result),
    parameters::resampling_report(&report).select_percentage(30).sharpness_angle(20));

  // A chain that a name of CGAL has started goes on with ours behind a bar.
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> smoother;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(smoother),
    parameters::neighbor_radius(2 * report.neighbor_radius) | parameters::normal_weight(2));
  //! [chain]

  //! [report]
  std::cout << "radius " << report.neighbor_radius << ", noise " << report.estimated_noise
            << ", spacing " << report.estimated_spacing << "\n"
            << report.number_of_degenerate_neighborhoods
            << " points with too few neighbors for a plane, " << 100 * report.oriented_share
            << " % of the normals have a propagated sign\n"
            << (report.converged ? "every solve converged" : "a solve ran out of iterations")
            << "\n";
  for (const CGAL::L0_resampling::Stage_report& stage : report.stages)
    std::cout << "  " << stage.name << ": " << 1000 * stage.seconds << " ms, " << stage.peak_bytes
              << " bytes\n";
  //! [report]

  //! [refusal]
  try
  {
    CGAL::l0_resample_point_set<CGAL::Sequential_tag>(points, std::back_inserter(result),
                                                      parameters::neighbor_radius(-1.));
  }
  catch (const std::invalid_argument& error)
  {
    std::cout << error.what() << std::endl; // names the parameter, its value and what was expected
  }
  //! [refusal]
  return result.empty() || smoother.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
