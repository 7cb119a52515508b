// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_TEST_REPORT_OF_TILES_H
#define L0_TEST_REPORT_OF_TILES_H

#include "tiles/Results_in_memory.h"
#include "tiles/points_in_memory.h"
#include "tiles/tiles_as_one.h"

#include <CGAL/L0_resampling/warnings.h>
#include <CGAL/l0_resample_tiles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <vector>

namespace test {

/// A call by several tiles reports of points and samples what one in memory does, has the same
/// warnings, and leaves out the same points.
/// \param bytes_per_point of memory
/// \param has_counts_of_one whether counts are those of one call to the last sample
template <typename ConcurrencyTag>
void check_report_of_tiles(double bytes_per_point, bool has_counts_of_one)
{
  using namespace CGAL::L0_resampling;
  const double length = 1500;
  Scene scene(length); // and a noisy sheet above it, which becomes one with it
  for (double i = 0; i < 20 * length; ++i)
    scene.add({i / 20, std::fmod(7.3 * i, 20.), 1.2}, 0.5);
  for (int part = 0; part < 3; ++part)
    scene.add_outliers(length);
  const std::vector<Place>& points = scene.points();
  const std::size_t m = number_of_samples(scene, 0.4);
  // so small that some balls hold too few points for a plane
  const auto np =
    CGAL::parameters::drop_outliers(true).number_of_output_points(m).neighbor_radius(3).noise(0.1);

  std::vector<Kernel::Point_3> input;
  for (const Place& p : points)
    input.emplace_back(p[0], p[1], p[2]);
  std::vector<std::size_t> outliers;
  std::vector<Oriented> output;
  Report expected, found;
  CGAL::l0_resample_point_set<ConcurrencyTag>(
    input, std::back_inserter(output),
    np.resampling_report(&expected).outlier_output_iterator(std::back_inserter(outliers)));
  Results_in_memory sink;
  CGAL::l0_resample_tiles<ConcurrencyTag>(Points_in_memory{points}, sink,
                                          std::uint64_t(bytes_per_point * double(points.size())),
                                          np.resampling_report(&found));
  CHECK(sink.results.size() >= 2);

  std::vector<Place> left_out, left_out_by_tiles;
  for (const std::size_t i : outliers)
    left_out.push_back(points[i]);
  for (const auto& [tile, result] : sink.results)
    left_out_by_tiles.insert(left_out_by_tiles.end(), result.outliers.begin(),
                             result.outliers.end());
  std::sort(left_out.begin(), left_out.end());
  std::sort(left_out_by_tiles.begin(), left_out_by_tiles.end());
  CHECK(left_out.size() > 100 && left_out_by_tiles == left_out);
  CHECK(found.number_of_outliers == expected.number_of_outliers);
  CHECK(found.number_of_input_points == points.size() && found.number_of_output_points == m);

  const double tolerance = has_counts_of_one ? 0 : 0.01;
  const auto is_close = [&](std::size_t number, std::size_t to) {
    return std::abs(double(number) - double(to)) <= tolerance * double(to);
  };
  std::cout << sink.results.size() << " tiles: degenerate "
            << found.number_of_degenerate_neighborhoods << " of "
            << expected.number_of_degenerate_neighborhoods << ", lonely "
            << found.number_of_lonely_samples << " of " << expected.number_of_lonely_samples
            << ", unexplained " << found.number_of_unexplained_samples << " of "
            << expected.number_of_unexplained_samples << ", there "
            << found.number_of_unexplained_samples_there << " of "
            << expected.number_of_unexplained_samples_there << std::endl;
  CHECK(expected.number_of_degenerate_neighborhoods > 0
        && is_close(found.number_of_degenerate_neighborhoods,
                    expected.number_of_degenerate_neighborhoods));
  CHECK(is_close(found.number_of_lonely_samples, expected.number_of_lonely_samples));
  CHECK(expected.number_of_unexplained_samples > m / 10
        && is_close(found.number_of_unexplained_samples, expected.number_of_unexplained_samples));
  CHECK(expected.number_of_unexplained_samples_there > 0
        && is_close(found.number_of_unexplained_samples_there,
                    expected.number_of_unexplained_samples_there));
  CHECK(!has_counts_of_one || found.unexplained_center == expected.unexplained_center);
  CHECK(found.unexplained_radius == expected.unexplained_radius);
  CHECK(found.estimated_noise == expected.estimated_noise
        && found.estimated_spacing == expected.estimated_spacing
        && found.neighbor_radius == expected.neighbor_radius);
  const std::vector<Warning> warnings_of_one = warnings(expected);
  CHECK(warnings_of_one.size() >= 2 && warnings(found) == warnings_of_one);
}

} // namespace test

#endif // L0_TEST_REPORT_OF_TILES_H
