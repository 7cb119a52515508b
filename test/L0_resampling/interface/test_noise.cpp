// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters noise and point_noise_map, which take the place of what is estimated.

#include "promise_support.h"

#include <CGAL/L0_resampling/internal/plan/Plan.h>
#include <CGAL/l0_estimate_scales.h>

#include <boost/range/irange.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using CGAL::L0_resampling::Report;
namespace params = CGAL::parameters;

namespace {

/// Points of the unit square times `unit`, with Gaussian noise across it that is four times as
/// large where x is above the middle.
Points noisy_square(double noise, double unit)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < 20000; ++i)
  {
    const double x = uniform(generator), y = uniform(generator),
                 z = (x < 0.5 ? noise : 4 * noise) * normal(generator);
    points.emplace_back(unit * x, unit * y, unit * z);
  }
  return points;
}

template <typename Tag, typename NamedParameters>
test::Pairs<Kernel> result_of(const Points& points, const NamedParameters& np, Report& report)
{
  test::Pairs<Kernel> result;
  CGAL::l0_resample_point_set<Tag>(points, std::back_inserter(result),
                                   np.resampling_report(&report).select_percentage(10));
  return result;
}

/// What `l0_estimate_scales()` says before a call is what the call does.
template <typename NamedParameters>
void check_estimate(const Points& points, const NamedParameters& np, const Report& report)
{
  const Report estimate = CGAL::l0_estimate_scales<CGAL::Sequential_tag>(points,
                                                                         np.select_percentage(10));
  CHECK(estimate.number_of_input_points == points.size());
  CHECK(estimate.neighbor_radius == report.neighbor_radius);
  CHECK(estimate.least_neighbor_radius == report.least_neighbor_radius);
  CHECK(estimate.largest_neighbor_radius == report.largest_neighbor_radius);
  CHECK(estimate.estimated_noise == report.estimated_noise);
  CHECK(estimate.estimated_spacing == report.estimated_spacing);
  CHECK(estimate.iterations.empty());
}

/// The radius follows from the noise that is given and the spacing, and is the same everywhere, as
/// the spacing is. Without it, the radius follows the noise of each half.
void test_radius()
{
  for (const double unit : {1., 1e5})
  {
    const Points points = noisy_square(0.005, unit);
    for (const double noise : {0.002, 0.005, 0.02, 0.04})
    {
      Report report;
      result_of<CGAL::Parallel_if_available_tag>(points, params::noise(noise * unit), report);
      CHECK(report.estimated_noise == noise * unit);
      check_estimate(points, params::noise(noise * unit), report);
      const double radius = CGAL::L0_resampling::internal::wanted_radius(report.estimated_spacing,
                                                                         noise * unit);
      CHECK(std::abs(report.neighbor_radius - radius) < 0.005 * radius); // rounded
      CHECK(report.least_neighbor_radius == report.largest_neighbor_radius);
    }
    Report report;
    result_of<CGAL::Parallel_if_available_tag>(points, params::normal_weight(0.9), report);
    CHECK(report.largest_neighbor_radius > 1.5 * report.least_neighbor_radius);
    check_estimate(points, params::normal_weight(0.9), report);
  }
  const Report cancelled = CGAL::l0_estimate_scales<CGAL::Parallel_if_available_tag>(
    noisy_square(0.005, 1), params::callback([](double) { return false; }));
  CHECK(cancelled.outcome == CGAL::L0_resampling::Outcome::CANCELLED);
}

/// Where the noise is that of the points, the result is about as near to the surface as with the
/// estimated one; where it is far too small, it is not.
void test_distance()
{
  const double noise = 0.01;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < 20000; ++i)
  {
    const double x = uniform(generator), y = uniform(generator);
    points.emplace_back(x, y, noise * normal(generator));
  }
  Report report;
  const auto distance = [&](const auto& np) {
    double sum = 0;
    const test::Pairs<Kernel> result = result_of<CGAL::Parallel_if_available_tag>(points, np,
                                                                                  report);
    for (const auto& sample : result)
      sum += std::abs(sample.first.z());
    return sum / double(result.size());
  };
  const double estimated = distance(params::normal_weight(0.9)),
               known = distance(params::noise(noise)), too_small = distance(params::noise(1e-4));
  if (!CHECK(known < 1.1 * estimated && too_small > 2 * known))
    std::cerr << "  " << known << " with the noise, " << estimated << " with the estimate, "
              << too_small << " with a hundredth" << std::endl;
}

/// A sphere of radius `unit` whose noise rises from the south to the north.
struct Sphere
{
  Points points;
  std::vector<double> noises;

  /// \param fold the noise of the north, per that of the south
  Sphere(double fold, double unit)
  {
    std::mt19937 generator(11);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < 30000; ++i)
    {
      Kernel::Vector_3 v{normal(generator), normal(generator), normal(generator)};
      v = v / std::sqrt(v.squared_length());
      noises.push_back(0.01 * unit * std::pow(fold, v.z() / 2));
      points.push_back(CGAL::ORIGIN + (unit + noises.back() * normal(generator)) * v);
    }
  }

  /// \param noises of the points
  template <typename Tag = CGAL::Parallel_if_available_tag>
  test::Pairs<Kernel> result(const std::vector<double>& noises_of_points, Report& report) const
  {
    const auto range = boost::irange(std::size_t(0), points.size());
    const auto np = params::point_noise_map(CGAL::make_property_map(noises_of_points))
                      .point_map(CGAL::make_property_map(points));
    test::Pairs<Kernel> pairs;
    CGAL::l0_resample_point_set<Tag>(range, std::back_inserter(pairs),
                                     np.number_of_output_points(10000).resampling_report(&report));
    const Report estimate =
      CGAL::l0_estimate_scales<CGAL::Sequential_tag>(range, np.number_of_output_points(10000));
    CHECK(estimate.neighbor_radius == report.neighbor_radius);
    CHECK(estimate.largest_neighbor_radius == report.largest_neighbor_radius);
    CHECK(estimate.estimated_noise == report.estimated_noise);
    return pairs;
  }

  /// The mean distance of the result from the surface, per its radius.
  static double distance(const test::Pairs<Kernel>& result, double unit)
  {
    double sum = 0;
    for (const auto& sample : result)
      sum += std::abs(std::sqrt((sample.first - CGAL::ORIGIN).squared_length()) / unit - 1);
    return sum / double(result.size());
  }
};

/// With the noise of each point the result is nearer to the surface than with that of all, which is
/// nearer than with the estimate.
void test_noise_of_points()
{
  Report report;
  for (const double unit : {1., 1e5})
  {
    const Sphere sphere(3, unit);
    const auto known = sphere.result(sphere.noises, report);
    CHECK(std::abs(report.estimated_noise - 0.01 * unit) < 0.0003 * unit); // the median
    test::Pairs<Kernel> with_one, with_estimate;
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
      sphere.points, std::back_inserter(with_one),
      params::noise(report.estimated_noise).number_of_output_points(10000));
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
      sphere.points, std::back_inserter(with_estimate), params::number_of_output_points(10000));
    const double of_known = Sphere::distance(known, unit),
                 of_one = Sphere::distance(with_one, unit),
                 of_estimate = Sphere::distance(with_estimate, unit);
    if (!CHECK(of_known < 0.9 * of_one && of_known < 0.9 * of_estimate))
      std::cerr << "  " << of_known << " with the noise of each point, " << of_one
                << " with one for all, " << of_estimate << " with the estimate" << std::endl;
    CHECK(test::are_identical<Kernel>(known,
                                      sphere.result<CGAL::Sequential_tag>(sphere.noises, report)));
  }
}

/// Where the noise of the points differs much, so do the radii.
void test_radii_of_points()
{
  Report report;
  const Sphere sphere(12, 1);
  sphere.result(sphere.noises, report);
  CHECK(report.largest_neighbor_radius > 1.4 * report.least_neighbor_radius);
}

/// The same noise for all is that of `noise`, to the bit; numbers that are no noise say nothing,
/// and none but such leave the estimate.
void test_unusual_noises()
{
  Report report;
  const Sphere sphere(1, 1);
  const auto result_of_call = [&](const auto& np) {
    test::Pairs<Kernel> result;
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
      sphere.points, std::back_inserter(result), np.number_of_output_points(10000));
    return result;
  };
  std::vector<double> noises(sphere.points.size(), 0.01);
  const auto with_one = result_of_call(params::noise(0.01));
  CHECK(test::are_identical<Kernel>(sphere.result(noises, report), with_one));
  const double not_a_number = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const double no_noises[] = {not_a_number, 0, -1, infinity};
  for (std::size_t i = 0; i < noises.size(); i += 7)
    noises[i] = no_noises[i % 4];
  CHECK(test::are_identical<Kernel>(sphere.result(noises, report), with_one));
  for (std::size_t i = 0; i < noises.size(); ++i)
    noises[i] = no_noises[i % 4];
  CHECK(test::are_identical<Kernel>(sphere.result(noises, report),
                                    result_of_call(params::normal_weight(0.9))));
}

/// Neither the order of the points matters, nor, among those at one place, which has which noise.
void test_order()
{
  Report report;
  Sphere sphere(3, 1);
  for (std::size_t i = 0; i < sphere.points.size(); i += 10)
  {
    sphere.points.push_back(sphere.points[i]);
    sphere.noises.push_back(2 * sphere.noises[i]);
  }
  const auto result = sphere.result(sphere.noises, report);
  std::reverse(sphere.points.begin(), sphere.points.end());
  std::reverse(sphere.noises.begin(), sphere.noises.end());
  CHECK(test::are_identical<Kernel>(sphere.result(sphere.noises, report), result));
}

void test_that_processors_agree()
{
  const Points points = noisy_square(0.005, 1);
  Report report;
  CHECK(test::are_identical<Kernel>(
    result_of<CGAL::Sequential_tag>(points, params::noise(0.01), report),
    result_of<CGAL::Parallel_if_available_tag>(points, params::noise(0.01), report)));
}

} // namespace

int main()
{
  test_radius();
  test_distance();
  test_noise_of_points();
  test_radii_of_points();
  test_unusual_noises();
  test_order();
  test_that_processors_agree();
  return test::result();
}
