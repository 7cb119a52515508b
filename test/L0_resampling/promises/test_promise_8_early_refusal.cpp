// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 8: `maximum_memory` refuses before the work: with clearly less than a call takes, it ends
// before the normals, whatever the cloud; and no call is refused that would do.

#include "promise_support.h"

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <new>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Pair = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)(),
                      number_of_points = 6000;

struct Cloud
{
  std::string name;
  test::Oriented_points points;
};

/// What a laser that turns sees of the ground and of a wall around it: rings, dense ones nearby and
/// sparse ones far away.
test::Oriented_points rings_of_laser(std::size_t n, test::Generator& generator)
{
  const double pi = 3.141592653589793, height = 1.8, distance_of_wall = 20;
  test::Oriented_points rings;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double slope = std::tan((2 + 0.8 * double(i % 32)) * pi / 180),
                 angle = test::random_number(0, 2 * pi, generator),
                 distance = (std::min)(height / slope, distance_of_wall);
    rings.points.emplace_back(distance * std::cos(angle), distance * std::sin(angle),
                              height - distance * slope);
  }
  test::add_gaussian_noise(rings.points, 0.01, generator);
  rings.normals.assign(n, Vector::UnitZ());
  return rings;
}

std::vector<Cloud> clouds()
{
  test::Generator generator(1);
  const std::size_t n = number_of_points;
  const test::Oriented_points sphere = test::sphere_points(n, 1, generator),
                              plane = test::plane_points(n, 1, generator);
  test::Oriented_points noisy_cube = test::cube_points(n, 1, generator), crowd = sphere,
                        patch = plane, gradient = plane;
  test::add_gaussian_noise(noisy_cube.points, 0.01, generator);
  for (std::size_t i = 0; i < n; i += 2)
  {
    crowd.points[i] = sphere.points.front();
    crowd.normals[i] = sphere.normals.front();
    patch.points[i] *= 0.05;
  }
  for (Vector& p : gradient.points)
    p[0] = std::pow(p[0] + 0.5, 3);
  return {{"sphere", sphere},
          {"noisy cube", noisy_cube},
          {"plane", plane},
          {"sphere with half of its points in one place", crowd},
          {"plane with half of its points in a patch", patch},
          {"rings of a laser", rings_of_laser(n, generator)},
          {"plane of rising density", gradient}};
}

/// What a call may differ in as far as memory is concerned.
struct Setting
{
  Method method;
  double samples_per_point;
  bool keep_density = false, with_normals = false;
};

/// A call that may end in `std::bad_alloc`.
struct Attempt
{
  test::Pairs<Kernel> result;
  Report report;
  bool is_refused = false;

  bool reached(const std::string& stage) const
  {
    return std::any_of(report.stages.begin(), report.stages.end(),
                       [&](const auto& s) { return s.name == stage; });
  }
};

Attempt attempt(const std::vector<Pair>& input, const Setting& setting, std::size_t limit)
{
  Attempt attempt;
  const auto np = params::resampling_method(setting.method)
                    .number_of_output_points(
                      std::size_t(setting.samples_per_point * double(input.size())))
                    .keep_density(setting.keep_density)
                    .maximum_memory(limit)
                    .resampling_report(&attempt.report)
                    .point_map(CGAL::First_of_pair_property_map<Pair>());
  const auto out = std::back_inserter(attempt.result);
  try
  {
    if (setting.with_normals)
      CGAL::l0_resample_point_set<CGAL::Sequential_tag>(
        input, out, np.normal_map(CGAL::Second_of_pair_property_map<Pair>()));
    else
      CGAL::l0_resample_point_set<CGAL::Sequential_tag>(input, out, np);
  }
  catch (const std::bad_alloc&)
  {
    attempt.is_refused = true;
  }
  return attempt;
}

void test_limits(const Cloud& cloud, const Setting& setting)
{
  std::vector<Pair> input;
  for (std::size_t i = 0; i < number_of_points; ++i)
  {
    const Vector &p = cloud.points.points[i], &n = cloud.points.normals[i];
    input.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  const Attempt free = attempt(input, setting, unlimited);
  const std::size_t peak = free.report.peak_bytes;

  // A call is never refused with what it takes.
  const Attempt limited = attempt(input, setting, peak);
  bool holds = CHECK(!limited.is_refused)
               && CHECK(test::are_identical<Kernel>(limited.result, free.result));
  holds &= CHECK(!free.reached("estimate memory") && limited.reached("estimate memory"));

  // With less by a sixth it is refused before the normals are found or filtered.
  const Attempt refused = attempt(input, setting, std::size_t(0.84 * double(peak)));
  holds &= CHECK(refused.is_refused && refused.result.empty())
           && CHECK(!refused.reached("PCA normals") && !refused.reached("filter normals"));
  if (!holds)
    std::cerr << "  " << cloud.name << ", method " << int(setting.method) << ", "
              << setting.samples_per_point << " samples a point, density kept "
              << setting.keep_density << ", normals given " << setting.with_normals << std::endl;
}

} // namespace

int main()
{
  for (const Cloud& cloud : clouds())
    for (const Setting& setting :
         {Setting{Method::DEFAULT, 0.1}, Setting{Method::DEFAULT, 0.5}, Setting{Method::DEFAULT, 2},
          Setting{Method::DEFAULT, 0.5, true}, Setting{Method::DEFAULT, 0.5, false, true},
          Setting{Method::LOR, 0.5}, Setting{Method::LOR, 2, false, true},
          Setting{Method::ALOR, 1}})
      test_limits(cloud, setting);
  return test::result();
}
