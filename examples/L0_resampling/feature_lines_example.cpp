// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

using Point_set = CGAL::Point_set_3<CGAL::Simple_cartesian<double>::Point_3>;

// Writes the points with those on feature lines in red, and says how many they are.
int main(int argc, char* argv[])
{
  const std::string input_file = argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/bracket_noisy.ply";
  const std::string output_file = argc > 2 ? argv[2] : "feature_lines.ply";
  Point_set points, result;
  if (!CGAL::IO::read_point_set(input_file, points))
  {
    std::cerr << "Error: cannot read " << input_file << std::endl;
    return EXIT_FAILURE;
  }

  //! [features]
  const auto confidence = result.add_property_map<float>("feature_confidence", 0).first;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, result, CGAL::parameters::feature_confidence_map(confidence));

  result.add_property_map<std::uint8_t>("red", 200);
  const auto green = result.add_property_map<std::uint8_t>("green", 200).first;
  const auto blue = result.add_property_map<std::uint8_t>("blue", 200).first;
  std::size_t number_on_lines = 0;
  for (const Point_set::Index& i : result)
    if (confidence[i] >= 0.5f)
    {
      green[i] = blue[i] = 0;
      ++number_on_lines;
    }
  //! [features]

  std::cout << number_on_lines << " of " << result.size() << " points on feature lines"
            << std::endl;
  return CGAL::IO::write_point_set(output_file, result) ? EXIT_SUCCESS : EXIT_FAILURE;
}
