// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points that lie on lines, as those of a scanner that turns: along a line they are much denser
// than across, and the lines are farther apart the farther away they are.

#include "promise_support.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using CGAL::L0_resampling::Report;
using CGAL::L0_resampling::Warning;

namespace {

constexpr double height_of_scanner = 1.7;

/// A laser that turns above flat ground.
struct Scanner
{
  int beams;
  double minimum_slope, maximum_slope; ///< of the beams, in degrees
  int points_of_beam;
  double noise;             ///< of the distances from the scanner
  double noise_of_axis = 0; ///< of each coordinate besides

  Points rings_on_ground() const
  {
    std::mt19937 generator(5);
    std::normal_distribution<double> normal;
    const double degree = 3.141592653589793 / 180;
    Points points;
    for (int beam = 0; beam < beams; ++beam)
      for (int step = 0; step < points_of_beam; ++step)
      {
        const double angle = 6.283185307179586 * step / points_of_beam,
                     slope = (minimum_slope + (maximum_slope - minimum_slope) * beam / (beams - 1))
                             * degree,
                     distance = height_of_scanner / std::sin(slope) + noise * normal(generator),
                     across = distance * std::cos(slope);
        const auto off = [&] { return noise_of_axis > 0 ? noise_of_axis * normal(generator) : 0; };
        points.emplace_back(across * std::cos(angle) + off(), across * std::sin(angle) + off(),
                            -distance * std::sin(slope) + off());
      }
    return points;
  }
};

/// The normals of the ground are up within two degrees, in the mean, within this distance.
void test_rings(const Scanner& scanner, double distance)
{
  const Points points = scanner.rings_on_ground();
  test::Pairs<Kernel> result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result), CGAL::parameters::viewpoint(Kernel::Point_3(0, 0, 0)));
  double sum = 0, number = 0;
  for (const auto& [point, n] : result)
    if (std::hypot(point.x(), point.y()) < distance)
    {
      sum += std::acos((std::min)((std::max)(n.z(), -1.), 1.)) * 180 / 3.141592653589793;
      ++number;
    }
  CHECK(number > 1000);
  if (!CHECK(sum < 2 * number))
    std::cerr << "  " << scanner.beams << " beams, noise " << scanner.noise << ", "
              << scanner.noise_of_axis << ": " << sum / number << " degrees off" << std::endl;
}

/// Where no radius reaches from one line to the next, a warning says that the normals are not to be
/// trusted, and none where it does.
void test_lines_far_apart()
{
  std::mt19937 generator(7);
  for (const double way : {1., 3.})
    for (const double noise : {0.001, 0.003, 0.01})
    {
      std::normal_distribution<double> normal(0, noise);
      Points points;
      for (int line = 0; line < 10; ++line)
        for (int i = 0; i < 3000; ++i)
          points.emplace_back(0.01 * i + normal(generator), way * line + normal(generator),
                              normal(generator));
      Report report;
      test::Pairs<Kernel> result;
      CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
        points, std::back_inserter(result), CGAL::parameters::resampling_report(&report));
      double upright = 0;
      for (const auto& [point, n] : result)
        upright += std::abs(n.z()) / double(result.size());
      const std::vector<Warning> found = warnings(report);
      const bool is_said = std::find(found.begin(), found.end(), Warning::SMALL_RADIUS)
                           != found.end();
      if (!CHECK(is_said || upright > 0.999) || !CHECK(is_said == (way > 2 || noise > 0.005)))
        std::cerr << "  " << way << " apart, noise " << noise << ": " << upright << std::endl;
    }
}

} // namespace

int main()
{
  for (const double noise : {0.0003, 0.005, 0.02})
    test_rings({21, 4, 30.67, 500, noise}, 10);
  test_rings({16, 1, 15, 900, 0.02}, 20);
  test_rings({16, 1, 15, 900, 0, 0.02}, 20);
  test_rings({16, 1, 15, 4000, 0, 0.005}, 20);
  test_lines_far_apart();
  return test::result();
}
