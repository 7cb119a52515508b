// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 11: what the report says of the cloud, its radii and its outliers, and what is warned of.

#include "promise_support.h"

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using CGAL::Sequential_tag;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;
using CGAL::L0_resampling::Warning;
using test::noisy_cube;
using test::Vector;
namespace params = CGAL::parameters;

using Warnings = std::vector<Warning>;

namespace {

/// Of two squares, of which one is sixteen times as dense, and holds most of the points.
void test_radii_that_follow_the_spacing()
{
  std::mt19937 generator(5);
  const auto number = [&]() { return double(generator()) / 4294967296.; };
  std::vector<Vector> points;
  for (int k = 0; k < 17000; ++k)
    points.push_back(k < 16000 ? Vector(number(), number(), 0) : Vector(1 + number(), number(), 0));
  for (const Method method : {Method::LOR, Method::DEFAULT})
  {
    const Report report = test::resample<Kernel, Sequential_tag>(
                            test::kernel_points<Kernel>(points), params::resampling_method(method))
                            .report;
    const double least = report.least_neighbor_radius, median = report.median_neighbor_radius,
                 largest = report.largest_neighbor_radius;
    CHECK(least <= report.neighbor_radius && report.neighbor_radius <= largest);
    if (method == Method::LOR)
      CHECK(least == largest && median == least);
    else
      CHECK(largest > 2 * least && median < 1.5 * least);
  }
}

/// A radius of the caller takes the place of that of the cloud, and follows the spacing likewise:
/// the one that the call would take changes nothing.
void test_radius_of_the_caller()
{
  std::mt19937 generator(5);
  const auto number = [&]() { return double(generator()) / 4294967296.; };
  std::normal_distribution<double> noise(0, 0.005);
  std::vector<Vector> squares;
  for (int k = 0; k < 17000; ++k)
    squares.emplace_back(k < 16000 ? number() : 1 + number(), number(), noise(generator));
  const auto points = test::kernel_points<Kernel>(squares);
  const auto run = [&](const auto& np) {
    return test::resample<Kernel, Sequential_tag>(points, np.number_of_output_points(4000));
  };
  const auto estimated = run(params::random_seed(0));
  const double radius = estimated.report.neighbor_radius;
  CHECK(estimated.report.largest_neighbor_radius > 1.5 * radius);
  const auto same = run(params::neighbor_radius(radius));
  CHECK(test::are_identical<Kernel>(estimated.pairs, same.pairs));
  const Report twice = run(params::neighbor_radius(2 * radius)).report;
  CHECK(twice.neighbor_radius == 2 * radius
        && twice.largest_neighbor_radius > 1.5 * twice.neighbor_radius
        && twice.estimated_noise == estimated.report.estimated_noise);
}

/// Points off the cloud are left out by the default method only, unless it is told otherwise;
/// either way the count is what was asked for.
void test_outliers()
{
  std::vector<Vector> cube = noisy_cube(3000);
  test::Generator generator(3);
  for (int i = 0; i < 150; ++i)
    cube.push_back(test::random_vector(3, generator));
  const auto points = test::kernel_points<Kernel>(cube);
  for (const Method method : {Method::DEFAULT, Method::LOR, Method::ALOR})
    for (const bool drops : {true, false})
    {
      const auto run = test::resample<Kernel, Sequential_tag>(
        points,
        params::resampling_method(method).number_of_output_points(1000).drop_outliers(drops));
      CHECK(run.report.number_of_output_points == 1000
            && run.report.number_of_input_points == 3150);
      CHECK(drops ? run.report.number_of_outliers > 120 && run.report.number_of_outliers <= 150
                  : run.report.number_of_outliers == 0);
      const Report by_default = test::resample<Kernel, Sequential_tag>(
                                  points,
                                  params::resampling_method(method).number_of_output_points(1000))
                                  .report;
      if (drops == (method == Method::DEFAULT))
        CHECK(by_default.number_of_outliers == run.report.number_of_outliers);
      // a sensitivity leaves points out unless the switch says otherwise; 1 is that of the switch
      for (const double sensitivity : {0., 0.2, 1., 2.})
      {
        const auto np =
          params::resampling_method(method).number_of_output_points(1000).outlier_sensitivity(
            sensitivity);
        const std::size_t number = test::resample<Kernel, Sequential_tag>(points, np)
                                     .report.number_of_outliers,
                          of_switch = test::resample<Kernel, Sequential_tag>(
                                        points, np | params::drop_outliers(drops))
                                        .report.number_of_outliers;
        CHECK(of_switch == (drops ? number : 0) && (sensitivity == 0) == (number == 0));
        if (drops)
          CHECK(sensitivity < 1    ? number <= run.report.number_of_outliers
                : sensitivity == 1 ? number == run.report.number_of_outliers
                                   : number > run.report.number_of_outliers);
      }
    }
}

/// The limits, and that nothing is said where no result was written.
void test_limits_of_warnings()
{
  Report report;
  report.number_of_input_points = 1000;
  report.number_of_output_points = 500;
  const auto check = [&](auto& fact, auto good, auto bad, Warning warning) {
    const auto kept = fact;
    fact = good;
    CHECK(warnings(report).empty());
    fact = bad;
    CHECK(warnings(report) == Warnings{warning});
    fact = kept;
  };
  check(report.number_of_outliers, 10u, 11u, Warning::MANY_OUTLIERS);
  check(report.extent_share, 0.95, 0.949, Warning::SHRUNKEN_EXTENT);
  check(report.number_of_degenerate_neighborhoods, 250u, 251u, Warning::SMALL_RADIUS);
  check(report.number_of_lonely_samples, 25u, 26u, Warning::UNSUPPORTED_SAMPLES);
  check(report.number_of_unexplained_samples, 50u, 51u, Warning::UNEXPLAINED_POINTS);
  report.number_of_outliers = 32;
  report.extent_share = 0.5;
  CHECK((warnings(report) == Warnings{Warning::MANY_OUTLIERS, Warning::SHRUNKEN_EXTENT}));
  CHECK(
    message_of(Warning::MANY_OUTLIERS, report)
    == "3.2 % of the points were left out as outliers, which outlier_output_iterator tells, and "
       "--outliers of the tool");
  report.number_of_output_points = 0;
  CHECK(warnings(report).empty());
  CHECK(warnings(Report()).empty());
}

/// Good results have no warnings, whatever the noise and the number of points.
void test_good_results_without_warnings()
{
  test::Generator generator(6);
  for (double noise : {0., 0.005, 0.04})
  {
    std::vector<Vector> cube = test::cube_points(6000, 1, generator).points;
    std::vector<Vector> plane = test::plane_points(3000, 1, generator).points;
    test::add_gaussian_noise(cube, noise, generator);
    test::add_gaussian_noise(plane, noise, generator);
    for (const auto& points : {cube, plane})
      for (std::size_t size : {1, 10, 100, 3000, 12000})
      {
        const Report report =
          test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(points),
                                                 params::number_of_output_points(size))
            .report;
        if (!CHECK(warnings(report).empty()))
          std::cerr << "  noise " << noise << ", " << size << " points, extent "
                    << report.extent_share << std::endl;
      }
  }
}

void test_warnings()
{
  const std::vector<Vector> cube = noisy_cube(3000);
  test::Generator generator(3);
  const auto random_vector = [&] { return test::random_vector(1, generator); };
  const auto has = [](const Report& report, Warning warning) {
    const Warnings found = warnings(report);
    return std::find(found.begin(), found.end(), warning) != found.end();
  };

  std::vector<Vector> with_outliers = cube;
  for (int i = 0; i < 150; ++i)
    with_outliers.push_back(3 * random_vector());
  const auto of_outliers = [&](bool drops) {
    return test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(with_outliers),
                                                  params::number_of_output_points(1000)
                                                    | params::drop_outliers(drops))
      .report;
  };
  CHECK(has(of_outliers(true), Warning::MANY_OUTLIERS)
        && !has(of_outliers(false), Warning::MANY_OUTLIERS));

  // a far part that is left out, of fewer points than would be many
  std::vector<Vector> with_far_part = cube;
  for (int i = 0; i < 28; ++i)
    with_far_part.push_back(Vector(4, 0, 0) + random_vector());
  const Report far_part =
    test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(with_far_part),
                                           params::number_of_output_points(1000))
      .report;
  CHECK(warnings(far_part) == Warnings{Warning::SHRUNKEN_EXTENT});
  CHECK(far_part.extent_share > 0.2 && far_part.extent_share < 0.6);

  // hardly a point within the radius, with PCA normals and with given ones
  std::vector<Oriented> oriented;
  for (const Kernel::Point_3& p : test::kernel_points<Kernel>(cube))
    oriented.emplace_back(p, Kernel::Vector_3(p.x(), p.y(), p.z()));
  for (Method method : {Method::DEFAULT, Method::LOR})
    for (double radius : {1e-4, 0.2})
    {
      const auto np = params::neighbor_radius(radius) | params::resampling_method(method);
      CHECK(
        has(test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(cube), np).report,
            Warning::SMALL_RADIUS)
        == (radius < 0.1));
      Report report;
      test::Pairs<Kernel> result;
      CGAL::l0_resample_point_set<Sequential_tag>(
        oriented, std::back_inserter(result),
        np.point_map(CGAL::First_of_pair_property_map<Oriented>())
            .normal_map(CGAL::Second_of_pair_property_map<Oriented>())
          | params::resampling_report(&report));
      CHECK(has(report, Warning::SMALL_RADIUS) == (radius < 0.1));
    }

  // half of the samples start around a point that is alone, which is as near as that
  for (Method method : {Method::DEFAULT, Method::LOR})
  {
    const auto np = params::neighbor_radius(1e-6).number_of_output_points(6000)
                    | params::resampling_method(method);
    const Report report =
      test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(cube), np).report;
    CHECK(report.number_of_lonely_samples == 0 && has(report, Warning::SMALL_RADIUS)
          && !has(report, Warning::UNSUPPORTED_SAMPLES));
  }
  // as many as fits of the default method may leave without points, or one more
  for (const std::size_t lonely : {5, 6})
  {
    Report report;
    report.number_of_input_points = report.number_of_output_points = 100;
    report.number_of_lonely_samples = lonely;
    CHECK(has(report, Warning::UNSUPPORTED_SAMPLES) == (lonely == 6));
    CHECK(message_of(Warning::UNSUPPORTED_SAMPLES, report).find(std::to_string(lonely) + ".0 %")
          == 0);
  }
}

/// Two sheets that noise joins are said to be, and two that it leaves apart are not.
void test_sheets_that_become_one()
{
  test::Generator generator(8);
  for (const double noise : {0.02, 0.07})
  {
    std::vector<Vector> plate = test::plane_points(6000, 3, generator).points;
    for (const Vector& p : test::plane_points(6000, 3, generator).points)
      plate.push_back(p + Vector(0, 0, 0.2));
    test::add_gaussian_noise(plate, noise, generator);
    const Report report =
      test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(plate),
                                             params::number_of_output_points(4000))
        .report;
    CHECK(warnings(report) == (noise > 0.05 ? Warnings{Warning::UNEXPLAINED_POINTS} : Warnings{}));
  }
}

/// Of a plane whose one half is far noisier than the other: what the result does not explain lies
/// there, and the sentence says where, in the coordinates of the input.
void test_place_of_unexplained_points()
{
  test::Generator generator(9);
  std::normal_distribution<double> noise;
  const Vector middle(500000, 0, 0);
  std::vector<Vector> halves;
  for (const Vector& p : test::plane_points(20000, 2, generator).points)
    halves.push_back(middle + p + Vector(0, 0, (p[0] > 0 ? 0.05 : 0.01) * noise(generator)));
  const Report report = test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(halves),
                                                               params::random_seed(0))
                          .report;
  const double radius = report.unexplained_radius;
  const Vector center(report.unexplained_center[0], report.unexplained_center[1],
                      report.unexplained_center[2]);
  CHECK(radius == 4 * report.neighbor_radius);
  CHECK(center[0] - middle[0] > radius / 2 && center[0] - middle[0] < 1);
  CHECK(std::abs(center[1]) < 1 && std::abs(center[2]) < 0.2);
  const Warnings found = warnings(report);
  CHECK(!found.empty() && found.back() == Warning::UNEXPLAINED_POINTS);
  const std::string sentence = message_of(Warning::UNEXPLAINED_POINTS, report);
  double told[4];
  const char* const format = "within %lf of (%lf, %lf, %lf)";
  const std::size_t begin = sentence.find("within");
  CHECK(begin != std::string::npos
        && std::sscanf(sentence.c_str() + begin, format, told, told + 1, told + 2, told + 3) == 4);
  CHECK(std::abs(told[0] / radius - 1) < 0.01
        && (Vector(told[1], told[2], told[3]) - center).norm() < 0.1 * radius);

  Report without_place = report;
  without_place.unexplained_radius = 0; // as a program may have filled it
  CHECK(message_of(Warning::UNEXPLAINED_POINTS, without_place).find("within") == std::string::npos);
  const Report explained =
    test::resample<Kernel, Sequential_tag>(test::kernel_points<Kernel>(noisy_cube(3000)),
                                           params::resampling_method(Method::LOR))
      .report;
  CHECK(explained.unexplained_radius == 0);
}

} // namespace

int main()
{
  test_place_of_unexplained_points();
  test_sheets_that_become_one();
  test_radii_that_follow_the_spacing();
  test_radius_of_the_caller();
  test_outliers();
  test_limits_of_warnings();
  test_good_results_without_warnings();
  test_warnings();
  return test::result();
}
