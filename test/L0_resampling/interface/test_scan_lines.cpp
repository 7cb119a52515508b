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

namespace {

constexpr double height_of_scanner = 1.7;

/// The rings of a laser that turns above flat ground, of beams that are 4/3 degrees apart.
/// \param noise of the distances from the scanner
Points rings_on_ground(double noise)
{
  std::mt19937 generator(5);
  std::normal_distribution<double> normal(0, noise);
  const double degree = 3.141592653589793 / 180;
  Points points;
  for (int beam = 0; beam <= 20; ++beam)
    for (int step = 0; step < 500; ++step)
    {
      const double angle = 6.283185307179586 * step / 500, slope = (4 + beam * 4. / 3) * degree,
                   distance = height_of_scanner / std::sin(slope) + normal(generator),
                   across = distance * std::cos(slope);
      points.emplace_back(across * std::cos(angle), across * std::sin(angle),
                          -distance * std::sin(slope));
    }
  return points;
}

/// The normals of the ground are up within two degrees, in the mean, within ten meters.
void test_rings(double noise)
{
  const Points points = rings_on_ground(noise);
  test::Pairs<Kernel> result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result), CGAL::parameters::viewpoint(Kernel::Point_3(0, 0, 0)));
  double sum = 0, number = 0;
  for (const auto& [point, n] : result)
    if (std::hypot(point.x(), point.y()) < 10)
    {
      sum += std::acos((std::min)((std::max)(n.z(), -1.), 1.)) * 180 / 3.141592653589793;
      ++number;
    }
  CHECK(number > 1000);
  if (!CHECK(sum < 2 * number))
    std::cerr << "  noise " << noise << ": " << sum / number << " degrees off" << std::endl;
}

} // namespace

int main()
{
  for (const double noise : {0.0003, 0.005})
    test_rings(noise);
  return test::result();
}
