// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;

// Gives up after a number of seconds.
int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/staircase_noisy.ply";
  const std::chrono::duration<double> patience(argc > 2 ? std::atof(argv[2]) : 60.);
  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_points(input_file, std::back_inserter(points)))
    return EXIT_FAILURE;

  //! [callback]
  const auto start = std::chrono::steady_clock::now();
  const auto callback = [&](double progress) {
    std::cout << "\r" << int(100 * progress) << " %" << std::flush;
    return std::chrono::steady_clock::now() - start < patience;
  };
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;
  CGAL::L0_resampling::Report report;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result),
    CGAL::parameters::resampling_report(&report).callback(callback));

  const bool is_cancelled = report.outcome == CGAL::L0_resampling::Outcome::CANCELLED;
  //! [callback]
  std::cout << "\r" << (is_cancelled ? "cancelled, " : "") << result.size() << " points"
            << std::endl;
  return EXIT_SUCCESS;
}
