// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/IO/read_points.h>
#include <CGAL/L0_resampling/CUDA_resampler.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;

int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/bracket_noisy.ply";
  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_points(input_file, std::back_inserter(points)))
    return EXIT_FAILURE;
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;

  std::string reason;
  if (!CGAL::L0_resampling::is_cuda_device_usable(&reason))
  {
    std::cout << "No device: " << reason << std::endl;
    return EXIT_SUCCESS;
  }

  //! [once]
  // Every stage on the device
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(result));
  //! [once]

  //! [again]
  // As somebody moves a slider: the points stay on the device.
  CGAL::L0_resampling::CUDA_resampler<Kernel> resampler;
  resampler.upload(points);
  for (const double angle : {10., 15., 20.})
  {
    result.clear();
    resampler.resample(std::back_inserter(result), CGAL::parameters::sharpness_angle(angle));
    std::cout << result.size() << " points at " << angle << " degrees" << std::endl;
  }
  //! [again]
  return EXIT_SUCCESS;
}
